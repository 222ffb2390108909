#!/bin/sh
# SPDX-License-Identifier: MIT
# same-pictures-on-arm.sh SOURCE WORK PROGRAM
# Draws on an emulated 64-bit ARM, with the Mesa and LLVM that Debian has for it: what PROGRAM, the same sources built
# for this processor, prints, every moment of every scene with --preset exact, and the scripts with all that they
# expect. Debian's packages for ARM are unpacked into WORK, none is installed.
# Exits 77 (skipped) when tools, packages or OSMesa are absent.
set -eu
source=$1 work=$2 program=$3
target=aarch64-linux-gnu
libraries=libosmesa6,libimgui-dev,libstb-dev,fonts-dejavu-core,libglfw3-dev,libpng-dev,libavcodec-dev,libavformat-dev
libraries=$libraries,libavutil-dev,libswscale-dev,libwebp-dev,libcairo2-dev,libgl-dev,nlohmann-json3-dev
libraries=$libraries,libcli11-dev,zlib1g-dev,libstdc++-12-dev,libc6-dev

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
fail() {
    tail -n 40 "$1"
    echo "$2"
    exit 1
}

# The root's /usr/include is the compiler's own, and named again it would hide headers of its C++ library.
cmake -S "$source" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O2 \
    -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_SYSROOT="$root" \
    -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_COMPILER_TARGET=$target -DCMAKE_CXX_COMPILER_LAUNCHER= \
    -DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=lld -DCMAKE_NO_SYSTEM_FROM_IMPORTED=ON \
    -DCMAKE_FIND_ROOT_PATH_MODE_PROGRAM=NEVER -DCMAKE_FIND_ROOT_PATH_MODE_LIBRARY=ONLY \
    -DCMAKE_FIND_ROOT_PATH_MODE_INCLUDE=ONLY -DCMAKE_FIND_ROOT_PATH_MODE_PACKAGE=ONLY >"$work.log" 2>&1 ||
    fail "$work.log" 'the build cannot be configured'
sed -i "s# -\(isystem \|I\)$root/usr/include\b\([ \r]\|\$\)#\2#g" "$work/build/build.ninja"
cmake --build "$work/build" --target boxreel >>"$work.log" 2>&1 || fail "$work.log" 'the program cannot be built'
clang++ --target=$target --sysroot="$root" -fuse-ld=lld -std=c++20 -O2 -ffp-contract=off -I"$source/base/include" \
    -I"$source/render/include" -I"$source/debugdraw/include" "$source/tests/matrix/PrintPictures.cpp" \
    -Wl,--start-group "$work"/build/render/*.a "$work"/build/debugdraw/*.a "$work"/build/base/*.a -Wl,--end-group \
    -limgui -lstb -lpng -lz -ldl -o "$work/print-pictures" >>"$work.log" 2>&1 || fail "$work.log" 'PrintPictures cannot be built'

qemu-aarch64 -L "$root" "$work/print-pictures" >"$work/pictures-arm.txt"
diff "$work/pictures-here.txt" "$work/pictures-arm.txt"
qemu-aarch64 -L "$root" "$work/build/boxreel" golden verify --preset exact --references "$source/golden/references" \
    --output "$work/output" >"$work/verify.log" 2>&1 || fail "$work/verify.log" 'the scenes differ'
# Pictures of scripts are accepted into a folder that has none, to be compared to the byte.
rm -rf "$work/scripts"
mkdir "$work/scripts"
cp "$source"/testbed/scripts/*.play "$work/scripts"
for script in "$work"/scripts/*.play; do
    qemu-aarch64 -L "$root" "$work/build/boxreel" play "$script" --test --accept >"$work/play.log" 2>&1 ||
        fail "$work/play.log" "$(basename "$script") does not do what it expects"
done
for picture in $(cd "$work/scripts/references/frames" && find . -name '*.png'); do
    cmp "$work/scripts/references/frames/$picture" "$source/testbed/scripts/references/frames/$picture"
done
echo "$(tail -n 1 "$work/verify.log"); $(ls "$work"/scripts/*.play | wc -l) scripts"
