#!/bin/bash
# SPDX-License-Identifier: MIT
#
# commands-find.sh CHECKOUT PROGRAM: pages that are wrong, each in one way, are seen to fail.
set -eu
checkout=$1
program=$2
planted=$(mktemp -d)
trap 'rm -rf "$planted"' EXIT
mkdir -p "$planted/docs/examples/pictures" "$planted/golden/references" "$planted/tests"
touch "$planted/README.md"
ln -s "$checkout/tests/docs" "$planted/tests/docs"

# ends CODE TEXT [PACE]: how the page that is read from standard input ends, and what is said then.
ends() {
    cat >"$planted/docs/page.md"
    status=0
    "$checkout/tests/docs/commands.sh" "$planted" "$program" /nowhere docs/page.md "${3-}" >"$planted/said" 2>&1 || status=$?
    if [ "$status" -ne "$1" ] || ! grep -q -- "$2" "$planted/said"; then
        cat "$planted/docs/page.md" "$planted/said" >&2
        echo "FAILED: this page should end with $1 and say: $2; it ended with $status" >&2
        exit 1
    fi
}

ends 0 'docs/page.md:3: ' <<'PAGE'
Text.

```
boxreel list --names >scenes
test -s scenes
```
PAGE
ends 1 'page.md:1: these commands end with 1 instead of 0' <<'PAGE'
```
boxreel list --nmaes
boxreel list
```
PAGE
ends 1 'page.md:3: these commands end with 1' <<'PAGE'
* In a list:

  ```sh
  boxreel shot no-such-scene --at 1s -o a.png | cat
  ```
PAGE
ends 1 'page.md:1: these commands end with 1' <<'PAGE'
```console
$ boxreel list --nmaes
what it prints
```
PAGE
ends 0 'page.md:2: ' <<'PAGE'
<!-- exit code 1 -->
```
boxreel list --nmaes
```
PAGE
ends 1 'page.md:2: these commands end with 0 instead of 1' <<'PAGE'
<!-- exit code 1 -->
```
boxreel list
```
PAGE
ends 0 'page.md:3: ' <<'PAGE'
<!-- first: echo one >made -->
<!-- first: echo two >>made -->
```
test "$(wc -l <made)" = 2
```
PAGE
ends 1 'page.md:2: what is to be done first ends with' <<'PAGE'
<!-- first: boxreel shot no-such-scene --at 1s -o a.png -->
```
true
```
PAGE
ends 77 'skipped: docs/page.md:2 cannot be tried here: command -v no-such-tool' <<'PAGE'
<!-- needs: command -v no-such-tool -->
```
false
```
PAGE
# What is passed over leaves the next block to be run.
for comment in 'needs: command -v no-such-tool' 'not run: tests/docs/commands-find.sh does it' 'slow: it would fail'; do
    ends 1 'page.md:5: these commands' < <(printf '<!-- %s -->\n```\nexit 3\n```\n```\nfalse\n```\n' "$comment")
done
ends 1 'page.md:2 is not run, and no file of the tests is named that does it: it would fail' <<'PAGE'
<!-- not run: it would fail -->
```
false
```
PAGE
ends 1 'page.md:2 is not run, and no file of the tests is named' <<'PAGE'
<!-- not run: tests/docs/no-such-file.sh does it -->
```
false
```
PAGE
ends 1 'page.md:2: these commands end with 3' slow <<'PAGE'
<!-- slow: it would fail -->
```
exit 3
```
```
false
```
PAGE
"$program" record pyramid --frames 10 --size 160x90 --progress none -o "$planted/docs/examples/pictures/a.webp"
"$program" shot pyramid --at 1s -o "$planted/docs/examples/pictures/a.svg"
ends 0 'page.md:3: ' <<'PAGE'
<!-- makes: a.svg -->
<!-- makes: a.webp -->
```
boxreel shot pyramid --at 1s -o a.svg
boxreel record pyramid --frames 10 --size 160x90 -o a.webp
```
PAGE
ends 1 'page.md:2 makes another a.svg' <<'PAGE'
<!-- makes: a.svg -->
```
boxreel shot pyramid --at 1.1s -o a.svg
```
PAGE
ends 1 'page.md:2 makes another a.webp' <<'PAGE'
<!-- makes: a.webp -->
```
boxreel record dominos --frames 10 --size 160x90 -o a.webp
```
PAGE
ends 1 'page.md:1: cannot be read: <!-- not run -->' <<'PAGE'
<!-- not run -->
```
true
```
PAGE
ends 1 'a comment for commands stands before a block of other text' <<'PAGE'
<!-- not run: it is no command -->
```cpp
int i;
```
PAGE
ends 1 'its last block has no end' <<'PAGE'
```
true
PAGE
