#!/bin/sh
# SPDX-License-Identifier: MIT
#
# parallel.sh CHECKOUT PROGRAM: docs/farms/parallel.sh makes the film of a single run, also when a part
# was killed on the way. Exit code 77: GNU parallel is not installed.
. "$(dirname "$0")/check.sh"
parallel --version 2>/dev/null | grep -q GNU || skip 'GNU parallel is not installed'

fails_once 75 100-149
"$checkout/docs/farms/parallel.sh" film.mkv 2>log || { cat log >&2; fail 'parallel.sh did not end well'; }
[ "$(wc -l <attempts)" -eq 2 ] || fail 'the part that was stopped was not tried again'
expect_whole film.mkv

# Removes a part, and the metadata file of another: only these are made again, from snapshots.
rm parts/part-00003.mkv parts/part-00001.mkv.json film.mkv
cp parts/part-00001.mkv unknown.mkv
touch -d '2001-01-01' parts/part-0000[02].mkv
"$checkout/docs/farms/parallel.sh" film.mkv 2>log || { cat log >&2; fail 'it did not go on'; }
expect_whole film.mkv
[ -z "$(find parts -name 'part-0000[02].mkv' -newermt 2002-01-01)" ] || fail 'whole parts were made again'

# A part without a metadata file may belong to somebody else: it is kept and reported.
cmp unknown.mkv parts/part-00001.mkv.aside-* || fail 'a part without a metadata file was not kept'
grep -q 'parts/part-00001.mkv.aside-' log || { cat log >&2; fail 'it does not say so'; }

# A leftover and a part of another film with the same names are neither taken nor kept in silence.
cp parts/part-00000.mkv parts/part-00099.mkv
cp parts/part-00000.mkv parts/part-00007.part.mkv
rm film.mkv
"$checkout/docs/farms/parallel.sh" film.mkv 2>log || { cat log >&2; fail 'other files in the folder are in the way'; }
expect_whole film.mkv
code=0
FILM='dominos --size 160x90 --group 50' "$checkout/docs/farms/part.sh" 0 2>log || code=$?
[ $code -eq 1 ] || fail "a part of another film ends with $code"
grep -q 'parts/part-00000.mkv' log || { cat log >&2; fail 'it does not say that it is another film'; }

# What cannot work ends with its exit code, and no film.
code=0
FILM='tumbler --colour blue' FOLDER=others "$checkout/docs/farms/part.sh" 0 2>/dev/null || code=$?
[ $code -eq 1 ] || fail "an unknown option ends with $code"
