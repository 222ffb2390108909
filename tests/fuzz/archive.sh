#!/bin/sh
# SPDX-License-Identifier: MIT
# archive.sh unpack ARCHIVE FOLDER    Replaces FOLDER by the inputs of a fuzz target.
# archive.sh pack FOLDER ARCHIVE      The other way; the same inputs give the same bytes.
set -eu
case $1 in
unpack)
    rm -rf "$3"
    mkdir -p "$3"
    tar xzf "$2" -C "$3"
    ;;
pack)
    tar cf - -C "$2" --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner --mode=0644 \
        $(cd "$2" && LC_ALL=C ls) | gzip -9n >"$3.new"
    mv "$3.new" "$3"
    ;;
*)
    echo "archive.sh: unknown action '$1'; use unpack or pack" >&2
    exit 1
    ;;
esac
