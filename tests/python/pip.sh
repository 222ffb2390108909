#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Usage: pip.sh CHECKOUT PYTHON
# Makes a virtual environment, installs the checkout into it by the command of docs/python.md, and makes the film of the
# first example there. A copy of the checkout is built, because setuptools writes beside the sources.
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

"$python" -m venv --system-site-packages "$folder/environment"
cd "$folder/copy"
CMAKE_BUILD_PARALLEL_LEVEL=$(nproc) "$folder/environment/bin/pip" install --no-build-isolation --no-index .

cd "$folder" # so that nothing is imported from the copy
rm -r copy/python/Box2D copy/python/boxreel
"$folder/environment/bin/python" copy/python/examples/hello.py hello.mp4
frames=$(ffprobe -v error -count_frames -select_streams v -show_entries stream=nb_read_frames -of csv=p=0 hello.mp4)
if [ "$frames" != 300 ]; then
    echo "hello.mp4 has $frames frames, not 300" >&2
    exit 1
fi
"$folder/environment/bin/python" -c 'import Box2D, boxreel, boxreel_golden; print("installed", Box2D.__file__)'
