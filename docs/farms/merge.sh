#!/bin/sh
# SPDX-License-Identifier: MIT
#
# merge.sh OUTPUT.mkv
#
# Joins the parts that part.sh has made, by their numbers: what else lies in the folder is not taken.
# BOXREEL, FRAMES, PART and FOLDER as there.
set -eu
output=$1
: "${BOXREEL:=boxreel}" "${FRAMES:=600}" "${PART:=100}" "${FOLDER:=parts}"

set --
number=0
while [ $((number * PART)) -lt "$FRAMES" ]; do
    set -- "$@" "$FOLDER/$(printf 'part-%05d.mkv' "$number")"
    number=$((number + 1))
done
exec "$BOXREEL" merge "$@" -o "$output"
