#!/bin/sh
# SPDX-License-Identifier: MIT
# fuzz.sh SOURCE WORK SECONDS TARGET
# Builds a target with clang's fuzzer, AddressSanitizer and UndefinedBehaviorSanitizer, and runs it that long, from its
# stored inputs. TARGET: world (calls of the engine, asserts off, because it makes mistakes on purpose)
# or scene_file (texts for the loader of scene files, asserts on: no file may reach one). New inputs stay in
# WORK/corpus, a finding in WORK/finding-*. Exits 77 (skipped) when clang's fuzzer is absent.
set -eu
source=$1 work=$2 seconds=$3 target=$4
here=$source/tests/fuzz

case $target in
world)
    asserts=0
    set -- -DBOXREEL_BUILD_TOOLKIT=OFF -DBOXREEL_BUILD_TESTBED=OFF
    limits='-max_len=2048 -timeout=20'
    ;;
scene_file)
    asserts=1
    set --
    limits="-max_len=4096 -timeout=10 -rss_limit_mb=1024 -dict=$here/scene-files.dict"
    ;;
*)
    echo "fuzz.sh: there is no target '$target'; say world or scene_file." >&2
    exit 1
    ;;
esac

mkdir -p "$work/corpus"
"$here/archive.sh" unpack "$work/stored"
echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' >"$work/probe.cpp"
if ! clang++ -fsanitize=fuzzer "$work/probe.cpp" -o "$work/probe" 2>/dev/null; then
    echo "skipped: clang++ with libFuzzer is not installed (packages clang and libclang-rt-dev)"
    exit 77
fi
cmake -S "$source" -B "$work/build" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=None \
    -DCMAKE_CXX_FLAGS="-O1 -g -DBOXREEL_ASSERTS=$asserts" -DBOXREEL_SANITIZE=address,undefined -DBOXREEL_FUZZ=ON \
    -DBOXREEL_BUILD_TESTS=ON \
    -DBOXREEL_WERROR=ON "$@" >"$work/build.log" 2>&1 &&
    cmake --build "$work/build" --target "boxreel_${target}_fuzz" >>"$work/build.log" 2>&1 || {
    tail -n 40 "$work/build.log"
    exit 1
}
# shellcheck disable=SC2086 # the limits are words
exec "$work/build/tests/fuzz/boxreel_${target}_fuzz" -max_total_time="$seconds" $limits -print_final_stats=1 \
    -error_exitcode=1 -artifact_prefix="$work/finding-" "$work/corpus" "$work/stored/$target"
