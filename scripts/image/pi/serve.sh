#!/bin/bash
# Serves the lab, and tells systemd's watchdog that it answers for as long as it does.
/opt/botgarten/botgarten.sh serve --port 80 --lang "${BOTGARTEN_LANGUAGE:-de}" $BOTGARTEN_FLAGS &
lab=$!
trap 'kill -TERM $lab; wait $lab; exit 0' TERM INT

answers() (
  exec 3<>/dev/tcp/127.0.0.1/80 || return 1
  printf 'GET /https.json HTTP/1.0\r\nHost: localhost\r\n\r\n' >&3
  read -r -t 30 line <&3 && [[ $line == HTTP/1.* ]]
)

while kill -0 $lab 2>/dev/null; do
  answers 2>/dev/null && systemd-notify --ready WATCHDOG=1
  sleep 5 &
  wait $!
done
wait $lab
