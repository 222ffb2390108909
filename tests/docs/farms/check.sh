# SPDX-License-Identifier: MIT
# shellcheck shell=sh disable=SC2034 # who sources it uses them
#
# What the checks of docs/farms share: a folder of their own, and a film that all of them make.
# Sourced, with the arguments CHECKOUT PROGRAM.
set -eu
checkout=$1
BOXREEL=$2
FILM='tumbler --size 160x90 --camera follow:3 --group 50'
FRAMES=170
PART=50
export BOXREEL FILM FRAMES PART

work=$(mktemp -d)
# What a check started is ended here, too.
clean_up() {
    status=$?
    if command -v stop_daemons >/dev/null; then
        stop_daemons
    fi
    rm -rf "$work"
    exit $status
}
trap clean_up EXIT
trap 'exit 1' INT TERM
cd "$work"

skip() {
    echo "skipped: $*"
    exit 77
}
fail() {
    echo "FAILED: $*" >&2
    exit 1
}

# The frames of a film, one checksum each.
frames_of() {
    ffmpeg -v error -i "$1" -fps_mode passthrough -f framemd5 - | grep -v '^#' | sed 's/.*, //'
}

# fails_once CODE RANGE: from now on the program ends with this code when it makes this part the first time.
fails_once() {
    cat >"$work/boxreel" <<SCRIPT
#!/bin/sh
case " \$* " in
    *" $2 "*)
        echo run >>"$work/attempts"
        [ "\$(wc -l <"$work/attempts")" -gt 1 ] || exit $1
        ;;
esac
exec "$BOXREEL" "\$@"
SCRIPT
    chmod +x "$work/boxreel"
    BOXREEL=$work/boxreel
}

# expect_whole FILM: it has the frames of the film made in one go.
expect_whole() {
    # shellcheck disable=SC2086 # a list of words
    [ -f whole.mkv ] || "$BOXREEL" record $FILM --frames "$FRAMES" -o whole.mkv --progress none
    frames_of whole.mkv >whole.frames
    frames_of "$1" >film.frames
    [ "$(wc -l <whole.frames)" -ge 100 ] || fail 'the film has too few frames to be compared'
    cmp whole.frames film.frames || fail "$1 has other frames than the film made in one go"
}
