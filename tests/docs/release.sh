#!/bin/sh
# SPDX-License-Identifier: MIT
#
# release.sh CHECKOUT VERSION: the changelog has a dated section of this version, of at most 40 lines, and CITATION.cff
# names the same version and date.
set -eu
cd "$1"
version=$2
fail() {
    echo "FAILED: $*" >&2
    exit 1
}
date=$(sed -n "s/^## \[$version\] - \([0-9]\{4\}-[0-9][0-9]-[0-9][0-9]\)$/\1/p" CHANGELOG.md)
[ -n "$date" ] || fail "CHANGELOG.md has no dated section of $version"
lines=$(sed -n "/^## \[$version\]/,/^## \[/p" CHANGELOG.md | grep -vc '^## \[' || true)
[ "$lines" -le 40 ] || fail "the section of $version in CHANGELOG.md has $lines lines, more than 40"
grep -qx "version: $version" CITATION.cff || fail "CITATION.cff is not of version $version"
grep -qx "date-released: $date" CITATION.cff || fail "CITATION.cff is not of $date, as CHANGELOG.md is"
minor=${version%.*}
grep -q "^| $minor | yes |" SECURITY.md || fail "SECURITY.md does not list version $minor"
