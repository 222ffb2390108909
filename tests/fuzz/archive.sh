#!/bin/sh
# SPDX-License-Identifier: MIT
# archive.sh unpack FOLDER    Replaces FOLDER by the stored inputs: a folder for each fuzz target.
# archive.sh pack FOLDER      The other way; the same inputs give the same bytes.
set -eu
archive=$(dirname "$0")/inputs.tar.gz
case $1 in
unpack)
    rm -rf "$2"
    mkdir -p "$2"
    tar xzf "$archive" -C "$2"
    ;;
pack)
    (cd "$2" && find world scene_file -type f) | LC_ALL=C sort |
        tar cf - -C "$2" -T - --mtime=@0 --owner=0 --group=0 --numeric-owner --mode=0644 | gzip -9n >"$archive.new"
    mv "$archive.new" "$archive"
    ;;
*)
    echo "archive.sh: unknown action '$1'; use unpack or pack" >&2
    exit 1
    ;;
esac
