#!/bin/sh
# Starts the lab and its class server; closing the window stops both. With words behind it: that command of botgarten.
here=$(cd "$(dirname "$0")" && pwd)
if [ ! -e "$here/app/complete" ]; then
  echo 'This folder is not complete. Is the disk full? Make room, delete the folder and unpack the whole zip again.'
  echo 'Der Ordner ist nicht vollständig. Ist die Platte voll? Platz schaffen, den Ordner löschen, das ganze Zip neu entpacken.'
  exit 1
fi
export BOTGARTEN_DATA="${BOTGARTEN_DATA:-${XDG_DATA_HOME:-$HOME/.local/share}/botgarten}"
# The allocator is not to keep a store of memory for each thread, and gives back what a large save took.
export MALLOC_ARENA_MAX=2 MALLOC_MMAP_THRESHOLD_=131072
# From the second start on Node has its code compiled.
export NODE_COMPILE_CACHE="$BOTGARTEN_DATA/cache"
[ $# -gt 0 ] || set -- serve --open
exec "$here/node/node" --max-semi-space-size=2 --optimize-for-size \
  "$here/app/apps/cli/botgarten.js" "$@"
