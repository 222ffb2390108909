#!/bin/bash
# SPDX-License-Identifier: MIT
# tidy.sh SOURCE WORK FOLDER: clang-tidy over the sources of one folder; each finding is printed. Exit codes: 0 none, 1 some,
# 77 there is no clang-tidy.
set -euo pipefail
source=$1 work=$2 folder=$3

command -v clang-tidy >/dev/null || {
    echo 'skipped: there is no clang-tidy; install the package clang-tidy'
    exit 77
}
# Without precompiled headers, which are GCC's, and a source at a time.
cmake -S "$source" -B "$work" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBOXREEL_BUILD_TESTS=ON \
    -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >"$work.log" 2>&1 || {
    tail -n 40 "$work.log"
    exit 1
}
sources=$(sed -n 's/^ *"file": "\(.*\)",*$/\1/p' "$work/compile_commands.json" | grep "^$source/$folder/" | sort -u)
[ -n "$sources" ] || {
    echo "no source of $folder is compiled"
    exit 1
}
# What this build does not compile: the fuzzers, which libFuzzer drives, and the projects of others that tests set up. Left out
# is one that is made to compile with its parent's flags only, and is else empty.
alone=$(cd "$source" && find "$folder" -name '*.cpp' ! -path tests/subproject/parent/plain.cpp | sort |
    while read -r file; do grep -qxF "$source/$file" <<<"$sources" || echo "$source/$file"; done)
includes=$(printf -- '-I%s ' "$source/engine/src" "$source/testbed" "$source"/*/include)

# What it says of suppressed findings goes to standard error.
status=0
tr '\n' '\0' <<<"$sources" | xargs -0 -n 1 -P "$(nproc)" clang-tidy -p "$work" -quiet 2>"$work.notes" || status=1
for file in $alone; do
    # shellcheck disable=SC2086 # a list of words
    clang-tidy -quiet "$file" -- -std=c++20 $includes 2>>"$work.notes" || status=1
done
[ $status -ne 0 ] || exit 0
grep 'error:' "$work.notes" || true
exit 1
