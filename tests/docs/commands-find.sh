#!/bin/bash
# SPDX-License-Identifier: MIT
#
# commands-find.sh CHECKOUT PROGRAM: commands.sh fails on pages that are wrong, and skips what cannot be tried.
set -eu
checkout=$1
program=$2
planted=$(mktemp -d)
trap 'rm -rf "$planted"' EXIT
mkdir -p "$planted/docs/examples/pictures" "$planted/golden/references" "$planted/tests"
touch "$planted/README.md"
ln -s "$checkout/tests/docs" "$planted/tests/docs"

# ends CODE COMMENT COMMANDS [PACE]: the exit code for a page with one block, and the line of the comment before it.
ends() {
    printf '%s\n```\n%b\n```\n' "$2" "$3" >"$planted/docs/page.md"
    status=0
    "$checkout/tests/docs/commands.sh" "$planted" "$program" /nowhere docs/page.md "${4-}" >"$planted/said" 2>&1 || status=$?
    if [ "$status" -ne "$1" ] || ! grep -q "page.md:2\|cannot be read\|block of other text" "$planted/said"; then
        cat "$planted/docs/page.md" "$planted/said" >&2
        echo "FAILED: this page should end with $1, not $status, and name its line" >&2
        exit 1
    fi
}

"$program" shot pyramid --at 1s -o "$planted/docs/examples/pictures/a.svg"
ends 0 '' 'boxreel list --names >scenes\ntest -s scenes'
ends 1 '' 'boxreel list --nmaes\nboxreel list'
ends 0 '<!-- exit code 1 -->' 'boxreel list --nmaes'
ends 1 '<!-- exit code 1 -->' 'boxreel list'
ends 0 '<!-- first: echo one >made -->' 'test -s made'
ends 1 '<!-- first: false -->' 'true'
ends 77 '<!-- needs: command -v no-such-tool -->' 'false'
ends 1 '<!-- not run: tests/docs/no-such-file.sh does it -->' 'true'
ends 1 '<!-- not run: tests/docs/links.py and tests/docs/no-such-file.sh do it -->' 'true'
ends 1 '<!-- not run: the installation -->' 'true'
ends 1 '<!-- not run -->' 'true'
ends 1 '<!-- slow: it would fail -->' 'exit 3' slow
ends 0 '<!-- makes: a.svg -->' 'boxreel shot pyramid --at 1s -o a.svg'
ends 1 '<!-- makes: a.svg -->' 'boxreel shot pyramid --at 1.1s -o a.svg'

# A block of other text becomes a file.
ends 0 '' 'true\n```\n\n<!-- file: made/here.txt -->\n```text\nsome text\n```\n\n```\ngrep -x "some text" made/here.txt'
ends 1 '' 'true\n```\n\n<!-- first: true -->\n```text\nsome text\n```\n\n```\ntrue'
