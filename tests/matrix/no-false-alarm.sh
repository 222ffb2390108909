#!/bin/sh
# SPDX-License-Identifier: MIT
# no-false-alarm.sh BOXREEL REFERENCES WORK RUNS
# Verifies every moment of every scene RUNS times, with each back end and one and two raster threads in turn: a
# verdict that depends on chance, on what was in memory or on the order of threads shows here. A back end that
# is absent is left out, and said; exits 77 (skipped) when both are.
set -eu
boxreel=$1 references=$2 work=$3 runs=$4

backends=
for backend in osmesa egl; do
    code=0
    "$boxreel" golden verify add-pair-stress-test/0.5s --backend $backend --references "$references" \
        --output "$work" >/dev/null 2>&1 || code=$?
    if [ $code -eq 3 ]; then
        echo "$backend is not here and is left out"
    else
        backends="$backends $backend"
    fi
done
if [ -z "$backends" ]; then
    echo "skipped: neither OSMesa nor EGL is here"
    exit 77
fi
run=0
while [ $run -lt "$runs" ]; do
    for backend in $backends; do
        for threads in 1 2; do
            [ $run -lt "$runs" ] || break
            run=$((run + 1))
            if ! LP_NUM_THREADS=$threads "$boxreel" golden verify --backend $backend --references "$references" \
                --output "$work" >"$work.log" 2>&1; then
                echo "run $run of $runs, $backend, $threads raster threads:"
                grep -v '^same ' "$work.log"
                exit 1
            fi
        done
    done
done
echo "$run runs without a false alarm: $(tail -n 1 "$work.log")"
