#!/bin/sh
# SPDX-License-Identifier: MIT
# same-pictures-on-arm.sh SOURCE WORK PROGRAM
# Draws on an emulated 64-bit ARM, with the Mesa and LLVM that Debian has for it, and compares with what PROGRAM, the
# same sources built for this processor, prints. Debian's packages for ARM are unpacked into WORK, none is installed.
# Exits 77 (skipped) when tools, packages or OSMesa are absent.
set -eu
source=$1 work=$2 program=$3
target=aarch64-linux-gnu
libraries=libosmesa6,libimgui-dev,libstb-dev,fonts-dejavu-core,libglfw3-dev,libpng-dev,libavcodec-dev,libavformat-dev
libraries=$libraries,libavutil-dev,libswscale-dev,libwebp-dev,libcairo2-dev,libgl-dev,nlohmann-json3-dev
libraries=$libraries,libstdc++-12-dev,libc6-dev

for tool in qemu-aarch64 mmdebstrap clang++ ld.lld; do
    if ! command -v $tool >/dev/null; then
        echo "skipped: $tool is not here; install qemu-user, mmdebstrap, clang and lld"
        exit 77
    fi
done
export MESA_SHADER_CACHE_DISABLE=true BOXREEL_BACKEND=osmesa
mkdir -p "$work"
code=0
"$program" >"$work/pictures-here.txt" || code=$?
if [ $code -eq 3 ]; then
    echo 'skipped: OSMesa is not here'
    exit 77
fi
root=$work/root
if [ ! -e "$root.done" ]; then
    rm -rf "$root"
    if ! mmdebstrap --variant=extract --architectures=arm64 --include=$libraries bookworm "$root" >"$work/root.log" 2>&1; then
        tail -n 3 "$work/root.log"
        echo 'skipped: Debian packages for ARM cannot be had'
        exit 77
    fi
    touch "$root.done"
fi
cmake -S "$source" -B "$work/build" -G Ninja -DBOXREEL_BUILD_TESTBED=OFF -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O2 \
    -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_SYSROOT="$root" \
    -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_COMPILER_TARGET=$target -DCMAKE_CXX_COMPILER_LAUNCHER= \
    -DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=lld \
    -DCMAKE_FIND_ROOT_PATH_MODE_PROGRAM=NEVER -DCMAKE_FIND_ROOT_PATH_MODE_LIBRARY=ONLY \
    -DCMAKE_FIND_ROOT_PATH_MODE_INCLUDE=ONLY -DCMAKE_FIND_ROOT_PATH_MODE_PACKAGE=ONLY >"$work.log" 2>&1 &&
    cmake --build "$work/build" --target boxreel_render boxreel_drawlist >>"$work.log" 2>&1 &&
    clang++ --target=$target --sysroot="$root" -fuse-ld=lld -std=c++20 -O2 -ffp-contract=off -I"$source/base/include" -I"$source/render/include" \
        -I"$source/debugdraw/include" "$source/tests/matrix/PrintPictures.cpp" -Wl,--start-group \
        "$work"/build/render/*.a "$work"/build/debugdraw/*.a "$work"/build/base/*.a -Wl,--end-group -limgui -lstb -lpng -lz -ldl \
        -o "$work/print-pictures" >>"$work.log" 2>&1 || {
    tail -n 40 "$work.log"
    exit 1
}
qemu-aarch64 -L "$root" "$work/print-pictures" >"$work/pictures-arm.txt"
exec diff "$work/pictures-here.txt" "$work/pictures-arm.txt"
