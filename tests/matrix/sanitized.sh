#!/bin/sh
# SPDX-License-Identifier: MIT
# sanitized.sh SOURCE WORK PRESET [CMAKE OPTION]…
# Builds everything with the sanitizers of a preset and runs the quick tests under them.
set -eu
source=$1 work=$2 preset=$3
shift 3

cd "$source"
cmake --preset "$preset" -B "$work" -DBOXREEL_WERROR=ON "$@" >"$work.log" 2>&1 &&
    cmake --build "$work" >>"$work.log" 2>&1 || {
    tail -n 40 "$work.log"
    exit 1
}
exec ctest --test-dir "$work" --label-regex '^quick$' --parallel "$(nproc)" --output-on-failure --no-tests=error
