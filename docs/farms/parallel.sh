#!/bin/sh
# SPDX-License-Identifier: MIT
#
# parallel.sh OUTPUT.mkv
#
# A film made by all cores of this machine with GNU parallel; FILM, FRAMES, PART and FOLDER as in
# part.sh. `--sshlogin` of parallel adds machines that see the same folder.
set -eu
here=$(dirname "$0")
output=$1
: "${FRAMES:=600}" "${PART:=100}"

seq 0 $(((FRAMES - 1) / PART)) | parallel --will-cite --quote --retries 3 --halt soon,fail=1 "$here/part.sh" {}
exec "$here/merge.sh" "$output"
