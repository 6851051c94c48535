#!/bin/sh
# Runs a program of this folder by the lab's own Node, one at a time: they share the boot partition.
program=$1
shift
mkdir -p -m 711 /run/botgarten
exec flock /run/botgarten/lock /opt/botgarten/node/node "/opt/botgarten/pi/$program.js" "$@"
