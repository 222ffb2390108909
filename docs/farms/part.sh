#!/bin/sh
# SPDX-License-Identifier: MIT
#
# part.sh NUMBER
#
# Makes one part of a film, the first of which is number 0. Any scheduler may call it for any part, on any
# machine that sees the folder, and again when it has failed: this very part is not made twice, what
# was stopped is gone on with, and a part of another film is refused. Ends with the exit code of boxreel.
#
#   BOXREEL   the program (boxreel)
#   FILM      what is filmed: the arguments of `boxreel record`, without spaces in them (pyramid)
#   FRAMES    of the whole film (600)
#   PART      frames of a part, a multiple of the film's --group (100)
#   FOLDER    where the parts go, and the snapshots (parts)
set -eu
number=$1
: "${BOXREEL:=boxreel}" "${FILM:=pyramid}" "${FRAMES:=600}" "${PART:=100}" "${FOLDER:=parts}"

first=$((number * PART))
film=$FOLDER/$(printf 'part-%05d.mkv' "$number")
mkdir -p "$FOLDER"
if [ -f "$film" ] && [ ! -f "$film.json" ]; then
    # Killed between the film and its manifest, or another program's film: kept under another name.
    aside=$(mktemp "$film.aside-XXXXXX")
    mv "$film" "$aside"
    echo "part.sh: $film has no manifest, so it is recorded again; what was there is now $aside" >&2
fi
# shellcheck disable=SC2086 # a list of words
exec "$BOXREEL" record $FILM --frames "$FRAMES" --frame-range "$first-$((first + PART - 1))" \
    -o "$film" --resume --skip-done --snapshots "$FOLDER/snapshots" --progress "${PROGRESS:-lines}"
