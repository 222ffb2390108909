#!/bin/bash
# SPDX-License-Identifier: MIT
#
# install.sh CHECKOUT: runs the lines by which pages install boxreel from a checkout, in a copy of CHECKOUT and for a
# home of its own. The pages have the same lines. The installed program draws a picture, and CMake finds the package.
set -euo pipefail
checkout=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM

fail() {
    echo "FAILED: $*" >&2
    exit 1
}
for page in docs/first-steps.md docs/golden.md docs/examples/README.md; do
    awk -v test=tests/docs/install.sh -f "$checkout/tests/docs/block.awk" "$checkout/$page" >"$work/lines"
    [ -s "$work/lines" ] || fail "$page has no lines that install"
    [ -e "$work/first" ] || cp "$work/lines" "$work/first"
    cmp "$work/first" "$work/lines" || fail "$page installs in another way"
done

mkdir "$work/copy" "$work/home"
git -C "$checkout" ls-files -z | tar -C "$checkout" --null --files-from=- -cf - | tar -C "$work/copy" -xf -
export HOME="$work/home"
(cd "$work/copy" && bash -e "$work/first") >"$work/log" 2>&1 || { tail -n 40 "$work/log" >&2; fail 'these lines'; }

cd "$work"
"$HOME/.local/bin/boxreel" shot pyramid --at 0.1s -o pyramid.png
[ -s pyramid.png ] || fail 'the installed program draws nothing'
mkdir project
printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(found LANGUAGES CXX)' 'find_package(boxreel COMPONENTS engine recorder golden REQUIRED)' \
    >project/CMakeLists.txt
cmake -S project -B found -DCMAKE_PREFIX_PATH="$HOME/.local" >"$work/log" 2>&1 || { cat "$work/log" >&2; fail 'find_package'; }
