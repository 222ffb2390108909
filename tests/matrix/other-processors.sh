#!/bin/sh
# SPDX-License-Identifier: MIT
# other-processors.sh SOURCE WORK BOXREEL PANEL-TESTS PRINT-PICTURES
# Draws on emulated processors, from one without AVX to one with all that the emulator knows: every moment of every
# scene with --preset exact, and the pictures of scripts and panels, whose files must be those of SOURCE to the byte.
# Scripts are played with all that they expect. What PRINT-PICTURES prints must be what it prints here. Mesa and LLVM
# compile shaders for each of these processors.
# Exits 77 (skipped) when the emulator or OSMesa is absent.
set -eu
source=$1 work=$2 boxreel=$3 panels=$4 print=$5
processors='max Nehalem Haswell EPYC'

if ! command -v qemu-x86_64 >/dev/null; then
    echo 'skipped: the package qemu-user is not installed, so other processors cannot be tried here'
    exit 77
fi
if [ "$(uname -m)" != x86_64 ]; then
    echo 'skipped: the program is built for another architecture than the processors that are tried'
    exit 77
fi
# Shaders that were compiled for this processor are not to be found.
export MESA_SHADER_CACHE_DISABLE=true BOXREEL_BACKEND=osmesa
if ! "$boxreel" shot pyramid --step 0 -o "$work.probe.png" --force >/dev/null 2>&1; then
    echo 'skipped: OSMesa is not here'
    exit 77
fi

fail() {
    echo "$processor: $1"
    exit 1
}

"$print" >"$work.pictures.txt"
for processor in $processors; do
    here=$work/$processor
    rm -rf "$here"
    mkdir -p "$here"
    qemu-x86_64 -cpu "$processor" "$print" 2>"$here/print.log" | diff "$work.pictures.txt" - ||
        fail 'pictures at other scales differ'
    qemu-x86_64 -cpu "$processor" "$boxreel" golden verify --preset exact --references "$source/golden/references" \
        --output "$here/output" >"$here/verify.log" 2>&1 || {
        grep -v '^same ' "$here/verify.log"
        fail 'the scenes differ'
    }
    # Pictures of scripts are accepted into a folder that has none, to be compared to the byte.
    cp "$source"/testbed/scripts/*.play "$here"
    for script in "$here"/*.play; do
        qemu-x86_64 -cpu "$processor" "$boxreel" play "$script" --test --accept >"$here/play.log" 2>&1 || {
            cat "$here/play.log"
            fail "$(basename "$script") does not do what it expects"
        }
    done
    BOXREEL_GOLDEN_REFERENCES=$here/references BOXREEL_GOLDEN_ACCEPT=missing qemu-x86_64 -cpu "$processor" "$panels" \
        --gtest_filter='PanelPictures.*' >"$here/panels.log" 2>&1 || {
        cat "$here/panels.log"
        fail 'the pictures of panels cannot be drawn'
    }
    diff -r "$source/testbed/scripts/references/frames" "$here/references/frames" || fail 'the panels differ'
    echo "$processor: $(tail -n 1 "$here/verify.log"); $(ls "$here"/*.play | wc -l) scripts," \
        "$(find "$here/references/frames" -name '*.png' | wc -l) pictures with panels"
done
