#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Usage: pip.sh CHECKOUT PYTHON
# Runs the lines of docs/python.md that install the checkout into a virtual environment, which docs/first-steps.md has
# too, and makes the film of the first example there. Nothing is downloaded: the environment sees this machine's packages.
# A copy of the checkout is built, because setuptools writes beside the sources.
set -euo pipefail
checkout=$1 python=$2

if ! "$python" -c 'import setuptools, wheel, ensurepip, pip' 2>/dev/null; then
    echo "skipped: $python lacks venv, pip, setuptools or wheel (apt install python3-venv python3-pip)"
    exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/copy"
git -C "$checkout" ls-files -z | tar -C "$checkout" --null --files-from=- -cf - | tar -C "$folder/copy" -xf -

for page in python first-steps; do
    awk -v test=tests/python/pip.sh -f "$checkout/tests/docs/block.awk" "$checkout/docs/$page.md" >"$folder/$page"
done
if [ ! -s "$folder/python" ] || ! cmp "$folder/python" "$folder/first-steps"; then
    echo "docs/first-steps.md and docs/python.md install with pip in different ways" >&2
    exit 1
fi
python3() {
    if [ "$1 $2 $#" = '-m venv 3' ]; then
        "$python" -m venv --system-site-packages "$3"
    else
        command python3 "$@"
    fi
}
cd "$folder/copy"
export PIP_NO_INDEX=1 CMAKE_BUILD_PARALLEL_LEVEL
CMAKE_BUILD_PARALLEL_LEVEL=$(nproc)
# shellcheck source=/dev/null
. "$folder/python"


cd "$folder" # so that nothing is imported from the copy
rm -r copy/python/Box2D copy/python/boxreel
"$folder/copy/environment/bin/python" copy/python/examples/hello.py hello.mp4
frames=$(ffprobe -v error -count_frames -select_streams v -show_entries stream=nb_read_frames -of csv=p=0 hello.mp4)
if [ "$frames" != 300 ]; then
    echo "hello.mp4 has $frames frames, not 300" >&2
    exit 1
fi
"$folder/copy/environment/bin/python" -c 'import Box2D, boxreel, boxreel_golden; print("installed", Box2D.__file__)'
