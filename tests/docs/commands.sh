#!/bin/bash
# SPDX-License-Identifier: MIT
#
# commands.sh CHECKOUT PROGRAM PREFIX PAGE [slow|accept]: runs what a page tells its readers to type, block by block, from
# the top, in a folder of its own that looks like a checkout; what is installed in PREFIX is in its ~/.local.
# Blocks of commands have no language, or `sh`; in those of `console` the commands stand behind `$ `. Comments
# before a block say what else there is to do:
#
#   <!-- first: COMMAND -->    what comes before it, such as a film of the reader's own
#   <!-- needs: COMMAND -->    what must succeed, else it is passed over
#   <!-- not run: REASON -->   it is not run at all; the reason names the file of the tests that runs it
#   <!-- slow: REASON -->      it is only run with `slow`, and then it alone is
#   <!-- exit code N -->       what it ends with, when not with 0
#   <!-- file: FILE -->        before a block of other text: it is written to this file, as a reader pastes it
#   <!-- makes: FILE -->       a picture or film that docs/examples/pictures keeps, for the page to show it: it must
#                              be the same, pixels by the limits for another machine; with `accept` it is stored
#
# CHECKOUT is the folder of the sources. A command that fails fails the page; a block that cannot be tried is passed
# over, and the page is skipped in the end. `./boxreel test` would run this very test, and is passed over. Exit code 77:
# this machine cannot try all of the page, and why.
set -eu
checkout=$1
program=$2
prefix=$3
page=$4
pace=${5:-quick}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM
blocks=$work/blocks
folder=$work/checkout
mkdir -p "$blocks" "$folder" "$work/bin" "$work/home/.config"

# ------------------------------------------------------------------------------ what the page says

# A file NUMBER.sh for each block of commands, with the comments before it as lines `#: …`.
awk -v blocks="$blocks" '
    function mark(text) { marks = marks "#: " text "\n" }
    isInside && /^ *```[ ]*$/ { isInside = isFile = 0; marks = ""; next }
    isInside && isFile { print >text; next }
    isInside && isCommands { print >file; next }
    isInside && isConsole && /^\$ / { print substr($0, 3) >file; next }
    isInside { next }
    /^ *```/ { # those of a list are indented
        isInside = 1
        language = $0
        sub(/^ *```/, "", language)
        isCommands = language == "" || language == "sh"
        isConsole = language == "console"
        if (isCommands || isConsole) {
            file = sprintf("%s/%03d.sh", blocks, FNR)
            printf "%s", marks >file
        } else if (marks ~ /^#: file: [A-Za-z0-9_.\/-]+\n$/) {
            isFile = 1
            name = substr(marks, 10, length(marks) - 10)
            text = sprintf("%s/%03d.text", blocks, FNR)
            printf "" >text
            printf "%smkdir -p \"$(dirname %s)\"\ncp %s %s\n", marks, name, text, name >sprintf("%s/%03d.sh", blocks, FNR)
        } else if (marks != "") {
            print FILENAME ":" FNR ": a comment for commands stands before a block of other text" >"/dev/stderr"
            exit 1
        }
        next
    }
    /^ *<!-- (file|first|makes|needs|not run|slow): .+ -->$/ || /^ *<!-- exit code [0-9]+ -->$/ {
        sub(/^ *<!-- /, "")
        sub(/ -->$/, "")
        mark($0)
        next
    }
    /^ *<!-- (file|first|makes|needs|not run|slow|exit code)/ { print FILENAME ":" FNR ": cannot be read: " $0 >"/dev/stderr"; exit 1 }
    NF { marks = "" }
    END { if (isInside) { print FILENAME ": its last block has no end" >"/dev/stderr"; exit 1 } }
' "$checkout/$page"
[ -n "$(ls "$blocks")" ] || exit 0 # a page without commands

# ------------------------------------------------------------------------------ what a reader has

cp -R "$checkout/README.md" "$checkout/docs" "$folder/"
mkdir "$folder/tests"
ln -s "$checkout/tests/benchmark" "$folder/tests/benchmark"
if grep -q golden "$blocks"/*; then
    mkdir "$folder/golden"
    cp -R "$checkout/golden/references" "$folder/golden/"
fi
python=/usr/bin/python3 # as the script does: another one that comes first may lack matplotlib
[ -x "$python" ] || python=python3
BOXREEL_BUILD_DIR=$(dirname "$program")
cat >"$work/bin/boxreel" <<SCRIPT
#!/bin/bash
case "\${1-}" in
    test) exit 0 ;;
    bench) shift && exec "$python" "$checkout/tests/benchmark/bench.py" "\$@" ;;
    python) shift && PYTHONPATH=$BOXREEL_BUILD_DIR/python exec "$python" "\$@" ;;
    ui) exec "$checkout/tests/docs/closed-window.sh" "$program" "\$@" ;;
    *) exec "$program" "\$@" ;;
esac
SCRIPT
chmod +x "$work/bin/boxreel"
ln -s "$work/bin/boxreel" "$folder/boxreel"
ln -s "$prefix" "$work/home/.local"
CHECKOUT=$checkout
export CHECKOUT BOXREEL_BUILD_DIR PATH="$work/bin:$PATH" HOME="$work/home" XDG_CONFIG_HOME="$work/home/.config"
unset CI BOXREEL_GOLDEN_ACCEPT BOXREEL_GOLDEN_REFERENCES BOXREEL_GOLDEN_OUTPUT

# ------------------------------------------------------------------------------ what happens

# marked BLOCK KIND: what its comments of this kind say.
marked() {
    sed -n "s/^#: $2:* //p" "$1"
}

# keep FILE: what a page shows is what its commands make today.
keep() {
    shown=$checkout/docs/examples/pictures/${1##*/}
    golden=$work/golden/${1##*/} # folders of references and of what differs
    mkdir -p "$golden"
    case $pace-$1 in
        accept-*) cp "$1" "$shown" ;;
        *.svg) cmp "$1" "$shown" ;;
        *)
            "$program" golden accept shown --film "$shown" --references "$golden" --output "$golden/out" &&
                "$program" golden verify shown --film "$1" --references "$golden" --output "$golden/out" --preset cross-machine
            ;;
    esac
}

cd "$folder"
end=0
for block in "$blocks"/*.sh; do
    line=$(basename "$block" .sh)
    line=$((10#$line))
    reason=$(marked "$block" 'not run')
    if [ -n "$reason" ]; then
        other=$(grep -o 'tests/[A-Za-z0-9_./-]*[A-Za-z0-9]' <<<"$reason" || true)
        missing=$(cd "$checkout" && for file in $other; do [ -e "$file" ] || echo "$file"; done)
        if [ -z "$other" ] || [ -n "$missing" ]; then
            echo "FAILED: $page:$line is not run, and no file of the tests is named that does it: $reason" >&2
            exit 1
        fi
        continue
    fi
    isSlow=$(marked "$block" slow)
    [ "$pace" = slow ] || [ -z "$isSlow" ] || continue
    [ "$pace" != slow ] || [ -n "$isSlow$(marked "$block" file)" ] || continue # slow blocks may use files of the page
    marked "$block" needs >"$work/needs"
    if ! bash -e "$work/needs" >/dev/null 2>&1 </dev/null; then
        echo "skipped: $page:$line cannot be tried here: $(cat "$work/needs")"
        end=77
        continue
    fi
    marked "$block" first >"$work/first"
    expected=$(marked "$block" 'exit code')
    begun=$EPOCHREALTIME
    status=0
    bash -e -o pipefail "$work/first" >"$work/said" 2>&1 </dev/null || status=$?
    if [ "$status" -ne 0 ]; then
        tail -n 30 "$work/said" >&2
        echo "FAILED: $page:$line: what is to be done first ends with $status" >&2
        exit 1
    fi
    bash -e -o pipefail "$block" >"$work/said" 2>&1 </dev/null || status=$?
    if [ "$status" -eq 77 ]; then
        cat "$work/said"
        exit 77
    fi
    if [ "$status" -ne "${expected:-0}" ]; then
        tail -n 30 "$work/said" >&2
        echo "FAILED: $page:$line: these commands end with $status instead of ${expected:-0}:" >&2
        grep -v '^#: ' "$block" >&2
        exit 1
    fi
    for file in $(marked "$block" makes); do
        if ! keep "$file" >"$work/said" 2>&1; then
            cat "$work/said" >&2
            echo "FAILED: $page:$line makes another ${file##*/} than docs/examples/pictures has; look at it, then run: cmake --build build/release --target example_pictures" >&2
            exit 1
        fi
    done
    awk -v page="$page:$line" -v a="$begun" -v b="$EPOCHREALTIME" 'BEGIN { printf "%s: %.1f s\n", page, b - a }'
done
exit $end
