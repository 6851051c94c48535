#!/bin/sh
# The image is small, the card is not: the last partition, that of the data, takes the rest. $1: id of the partition table
set -e
part=$(basename "$(readlink -f "/dev/disk/by-partuuid/$1-04")")
place=/sys/class/block/$part
disk=$(basename "$(dirname "$(readlink -f "$place")")")
behind=$(($(cat "/sys/class/block/$disk/size") - $(cat "$place/start") - $(cat "$place/size")))
# Less than 8 MiB is not worth a write.
[ "$behind" -gt 16384 ] || exit 0
echo ', +' | sfdisk --no-reread --force --no-tell-kernel -N 4 "/dev/$disk"
partx --update --nr 4 "/dev/$disk"
# udev looks at the disk anew; what is mounted before that is unmounted by it, and what stands on it stopped.
udevadm settle --timeout=300
