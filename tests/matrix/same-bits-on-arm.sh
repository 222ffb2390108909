#!/bin/sh
# SPDX-License-Identifier: MIT
# same-bits-on-arm.sh SOURCE WORK PROGRAM
# Builds the engine for 64-bit ARM, where NEON takes the place of SSE2, and compares the states that an emulated
# processor comes to with those of PROGRAM, the same sources built for this one.
# Exits 77 (skipped) when clang++, lld, the emulator or the headers for that processor are absent.
set -eu
source=$1 work=$2 program=$3
target=aarch64-linux-gnu

mkdir -p "$work"
if ! command -v qemu-aarch64 >/dev/null ||
    ! echo '#include <vector>
            int main() { return int(std::vector<int>().size()); }' |
        clang++ --target=$target -fuse-ld=lld -x c++ - -o "$work/probe" 2>/dev/null; then
    echo 'skipped: clang++, lld and the packages libstdc++-12-dev-arm64-cross and qemu-user are not all installed, so ARM cannot be tried here'
    exit 77
fi
flags='-std=c++20 -O2 -ffp-contract=off'
cmake -S "$source" -B "$work" -G Ninja -DBOXREEL_BUILD_TOOLKIT=OFF -DBOXREEL_WERROR=ON \
    -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_CXX_COMPILER=clang++ \
    -DCMAKE_CXX_COMPILER_TARGET=$target -DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=lld -DCMAKE_BUILD_TYPE=None \
    -DCMAKE_CXX_FLAGS=-O2 >"$work.log" 2>&1 &&
    cmake --build "$work" --target boxreel_engine >>"$work.log" 2>&1 &&
    clang++ --target=$target -fuse-ld=lld -static $flags -I"$source/engine/include" -I"$source/debugdraw/include" \
        -I"$source/golden/include" -I"$source/base/include" -I"$source/testbed" "$source/tests/matrix/PrintStates.cpp" "$source/golden/src/StateHash.cpp" \
        "$source"/testbed/scenes/*.cpp "$work/engine/libboxreel_engine.a" -o "$work/print-states" >>"$work.log" 2>&1 || {
    tail -n 40 "$work.log"
    exit 1
}
qemu-aarch64 "$work/print-states" >"$work/states-arm.txt"
"$program" >"$work/states-here.txt"
exec diff "$work/states-here.txt" "$work/states-arm.txt"
