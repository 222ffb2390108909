#!/bin/sh
# SPDX-License-Identifier: MIT
# fuzz.sh SOURCE WORK SECONDS
# Builds the engine with clang's fuzzer, AddressSanitizer and UndefinedBehaviorSanitizer, asserts off, and lets it
# look for that long, starting from the corpus. What it finds new stays in WORK/corpus; a finding is in
# WORK/finding-*. Exits 77 (skipped) when clang's fuzzer is absent.
set -eu
source=$1 work=$2 seconds=$3

mkdir -p "$work/corpus"
echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' >"$work/probe.cpp"
if ! clang++ -fsanitize=fuzzer "$work/probe.cpp" -o "$work/probe" 2>/dev/null; then
    echo "skipped: clang++ with libFuzzer is not installed (packages clang and libclang-rt-dev)"
    exit 77
fi
cmake -S "$source" -B "$work/build" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=None \
    -DCMAKE_CXX_FLAGS='-O1 -g -DBOXREEL_ASSERTS=0' -DBOXREEL_SANITIZE=address,undefined -DBOXREEL_FUZZ=ON \
    -DBOXREEL_BUILD_TOOLKIT=OFF -DBOXREEL_BUILD_TESTBED=OFF -DBOXREEL_WERROR=ON >"$work/build.log" 2>&1 &&
    cmake --build "$work/build" --target boxreel_world_fuzz >>"$work/build.log" 2>&1 || {
    tail -n 40 "$work/build.log"
    exit 1
}
exec "$work/build/tests/fuzz/boxreel_world_fuzz" -max_total_time="$seconds" -max_len=2048 -timeout=20 -print_final_stats=1 -error_exitcode=1 \
    -artifact_prefix="$work/finding-" "$work/corpus" "$source/tests/fuzz/corpus"
