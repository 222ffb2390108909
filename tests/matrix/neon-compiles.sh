#!/bin/sh
# SPDX-License-Identifier: MIT
# neon-compiles.sh SOURCE
# Whether the sources that use the processor's wide instructions compile for NEON, and do use it.
# Exits 77 (skipped) when clang++ or the headers for that processor are absent.
set -eu
engine=$1/engine
flags='--target=aarch64-linux-gnu -std=c++20 -Wall -Wextra -Werror -fsyntax-only'

compile() {
    # shellcheck disable=SC2086 # a list of words
    clang++ $flags -I"$engine/include" -I"$engine/src" "$@"
}
if ! echo '#include <vector>' | compile -x c++ - 2>/dev/null; then
    echo 'skipped: clang++ with the headers of the package libstdc++-12-dev-arm64-cross is not installed, so NEON cannot be tried here'
    exit 77
fi
compile -x c++ - <<'END'
#include "Common/Simd.h"
#ifndef BOX2D_NEON
#error "Simd.h does not know the processor."
#endif
END
for source in "$engine"/src/Collision/CollidePolygons.cpp "$engine"/src/Dynamics/*/*Blocks.cpp; do
    compile "$source"
done
