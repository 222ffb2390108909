#!/bin/sh
# SPDX-License-Identifier: MIT
#
# packages.sh CHECKOUT: the packages of docs/first-steps.md are those that ./boxreel installs to build.
set -eu
checkout=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sed -n "/^find_missing/,/goal.* = test/s/^ *need ['\"][^'\"]*['\"] //p" "$checkout/boxreel" |
    sed 's/\$drawing/libosmesa6-dev/' | tr ' ' '\n' | sort >"$work/script"
sed -n '/^sudo apt install g++/,/^```/p' "$checkout/docs/first-steps.md" | grep -v '```' |
    sed 's/sudo apt install//; s/\\//' | tr -s ' ' '\n' | sed '/^$/d' | sort >"$work/page"
[ "$(wc -l <"$work/script")" -ge 18 ] || { echo 'FAILED: the boxreel script names its packages in another way' >&2; exit 1; }
diff "$work/script" "$work/page" || { echo 'FAILED: docs/first-steps.md names other packages than the script' >&2; exit 1; }
