#!/bin/sh
# Renders share I of N of a picture into a folder. This is what each machine does, whoever starts it there.
#
#   shard.sh I N FOLDER SCENE [settings of halfdisk render]
#
# With BY=seeds the share is the whole picture with seed I, for `halfdisk merge --seeds`.
# Started again, it goes on with what was begun, and does nothing where the share is finished. So a task that was killed
# or moved to another machine is simply started again.
set -eu
i=$1 n=$2 part=$3/part-$1.exr
mkdir -p "$3"
shift 3
if [ -e "$part" ]; then
    said=$(halfdisk info "$part")
    case $said in
        *"
interrupted: "*) exec halfdisk render --resume "$part" --checkpoint 5m --threads "${THREADS:-1}" --quiet ;;
        *) exit 0 ;;
    esac
fi
case ${BY:-shards} in
    seeds) set -- "$@" --seed "$i" ;;
    *) set -- "$@" --shard "$i/$n" ;;
esac
exec halfdisk render "$@" --out "$part" --checkpoint 5m --threads "${THREADS:-1}" --quiet
