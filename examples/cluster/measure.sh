#!/bin/bash
# What parts cost: the numbers of the page "Many machines". Takes `halfdisk` on the PATH and a few minutes.
#
#   bash examples/cluster/measure.sh
#
# Runs that are compared take turns, so that whatever else the machine does slows both alike.
set -euo pipefail
cd "$(mktemp -d)"
trap 'rm -r "$PWD"' EXIT
TIMEFORMAT='%R %U %S'

# Seconds by the clock and of all processors that a command takes.
seconds() { { time "$@" > /dev/null 2>&1; } 2>&1 | awk '{ print $1, $2 + $3 }'; }
# The same over N turns, as means.
mean() { awk '{ a += $1; b += $2; n++ } END { printf "%.2f %.2f\n", a / n, b / n }'; }

whole() { halfdisk render "${@:2}" --threads "$1" --quiet --out whole.exr; }
# N shards, some of them at a time.
shards() {
    local at=$1 n=$2
    shift 2
    seq "$n" | xargs -P "$at" -I{} halfdisk render "$@" --threads 1 --quiet --shard {}/"$n" --out part-{}.exr
}

compare() {
    local turns=$1 at=$2 n=$3
    shift 3
    : > a; : > b
    for _ in $(seq "$turns"); do
        seconds whole 2 "$@" >> a
        seconds shards "$at" "$n" "$@" >> b
    done
    paste -d' ' <(mean < a) <(mean < b)
}

echo "8 shards, 2 at a time, against 1 run of 2 threads (clock, processors): path in cornell, 320x240, 64 samples"
compare 4 2 8 cornell --size 320x240 --spp 64 |
    awk '{ printf "  one run %s s, %s s; shards %s s, %s s; ratios %.3f, %.3f\n", $1, $2, $3, $4, $3 / $1, $4 / $2 }'

echo "8 shards, so many at a time (clock, processors): cornell, 240x160, 64 samples"
for _ in 1 2 3; do
    for at in 1 2 4 8; do
        seconds shards "$at" 8 cornell --size 240x160 --spp 64 >> "at-$at"
    done
done
for at in 1 2 4 8; do
    echo "  $at: $(mean < "at-$at") s"
done

echo "What every shard does again: processor time of 8 shards over that of one run, 200x150"
while read -r what; do
    # shellcheck disable=SC2086
    compare 2 2 8 $what --size 200x150 |
        awk -v what="$what" '{ printf "  %-55s %.2f\n", what, $4 / $2 }'
done << END
cornell --spp 64
caustic --spp 64
caustic --spp 32 --integrator light-tracer
caustic --spp 16 --integrator photons
END

echo "Bytes a pixel, cornell, 64 samples"
for sampler in sobol independent; do
    whole 2 cornell --size 320x240 --spp 64 --sampler "$sampler"
    stat -c %s whole.exr | awk -v s="$sampler" '{ printf "  %s: %.1f\n", s, $1 / 320 / 240 }'
done

echo "1920x1080, 4 independent samples"
whole 2 cornell --size 1920x1080 --spp 4 --sampler independent
stat -c %s whole.exr | awk '{ printf "  the whole: %.0f MB\n", $1 / 1e6 }'
for n in 8 64; do
    rm -f part-*
    shards 2 "$n" cornell --size 1920x1080 --spp 4 --sampler independent
    took=$(seconds halfdisk merge part-*.exr --out merged.exr)
    cmp merged.exr whole.exr
    stat -c %s part-1.exr | awk -v n="$n" -v took="$took" \
        '{ printf "  %d shards: %.1f MB each, merged in %s s (clock, processors), the same bytes\n", n, $1 / 1e6, took }'
done
for seed in 1 2 3 4; do
    halfdisk render cornell --size 1920x1080 --spp 1 --sampler independent --seed "$seed" --out "seed-$seed.exr" --quiet
done
echo "  4 seeds merged in $(seconds halfdisk merge --seeds seed-*.exr --out merged.exr) s"
