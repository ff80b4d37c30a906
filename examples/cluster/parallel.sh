#!/bin/bash
# A picture by GNU parallel: N shards, as many at a time as there are cores, then their merge.
#
#   bash examples/cluster/parallel.sh N FILE.exr SCENE [settings of halfdisk render]
#   bash examples/cluster/parallel.sh 16 mine.exr mine.toml --spp 1024
#
# On several machines, which see this folder under the same path and have `halfdisk` on their PATH:
#   HOSTS=:,anna,bert bash examples/cluster/parallel.sh 16 mine.exr mine.toml --spp 1024
# Where much light is traced from the lights, as in caustics, divide the samples instead: 16 seeds of 64 samples each by
#   BY=seeds bash examples/cluster/parallel.sh 16 mine.exr mine.toml --spp 64
# Asked again, finished shards are not rendered again.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
n=$1 out=$2
shift 2
[ "${BY:-shards}" = seeds ] && by=--seeds || by=
parallel --quote --env BY --sshlogin "${HOSTS:-:}" --workdir . --retries 3 --joblog "$out.log" \
    "$here/shard.sh" {} "$n" "$out.parts" "$@" ::: $(seq "$n")
halfdisk merge $by "$out.parts"/part-*.exr --out "$out"
rm -r "$out.parts"
