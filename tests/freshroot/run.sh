#!/bin/sh
# SPDX-License-Identifier: MIT
#
# run.sh CHECKOUT WORK_DIR
#
# Tries the README's two commands where nothing is installed: a minimal Debian 12 in a folder, with
# git, sh and apt, in which the checkout's last commit is cloned. Reports how long the first film, the
# second one and the tests took; fails on what goes wrong, never on a time. Packages come from wherever
# this machine's own apt gets them.
#
# Exit codes: 0 all is well, 77 this machine cannot try it, anything else a failure. After a failure
# the folder stays for a look.
# shellcheck disable=SC2016 # $(…) is apt's, "$@" the inner shell's
set -eu
checkout=$1
work=$2
tools='ffmpeg ffprobe git'
. "$(dirname "$0")/root.sh"

git -C "$checkout" rev-parse --verify -q HEAD >/dev/null || skip "$checkout is no git checkout, so there is nothing to clone"
git -C "$checkout" bundle create -q "$root/tmp/boxreel.bundle" HEAD

inside 'git -c advice.detachedHead=false clone -q /tmp/boxreel.bundle /srv/boxreel && cd /srv/boxreel && ! command -v cmake && ! command -v g++' ||
    fail 'the fresh root is not what it should be'

# ------------------------------------------------------------------------------ where it cannot

says() { # CODE PATTERN COMMAND: ends with that code and one line that matches
    status=0
    inside "$3" >"$work/says.log" 2>&1 || status=$?
    [ "$status" -eq "$1" ] && grep -q "$2" "$work/says.log" && return 0
    cat "$work/says.log"
    fail "expected exit code $1 and a line with \"$2\", got exit code $status"
}
says 3 'there is no sudo to install them; as root run: apt-get install g++' \
    'cd /srv/boxreel && chroot --userspec=nobody --skip-chdir / env BOXREEL_BUILD_DIR=/tmp/nobody ./boxreel list'
says 3 'apt-get failed .*check the network' \
    'cd /srv/boxreel && BOXREEL_BUILD_DIR=/tmp/offline unshare --net ./boxreel list'
inside 'rm -rf /tmp/nobody /tmp/offline'

# ------------------------------------------------------------------------------ the two films

started=$(seconds)
inside 'cd /srv/boxreel && ./boxreel record pyramid -o pyramid.mp4' || fail 'the first film was not made'
first=$(since "$started")
started=$(seconds)
inside 'cd /tmp && /srv/boxreel/boxreel record pyramid -o second.mp4' || fail 'the second film was not made'
second=$(since "$started")

for film in "$root/srv/boxreel/pyramid.mp4" "$root/tmp/second.mp4"; do
    codec=$(ffprobe -v error -select_streams v -show_entries stream=codec_name -of csv=p=0 "$film")
    # A picture that stays is held, so there are fewer frames in the file than are shown.
    shown=$(ffmpeg -v error -i "$film" -vf fps=60 -f framecrc - | grep -vc '^#')
    [ "$codec,$shown" = h264,600 ] || fail "$film should show 600 frames of H.264, not $codec,$shown"
done
cmp "$root/srv/boxreel/pyramid.mp4" "$root/tmp/second.mp4" || fail 'the two films are not the same'
echo "first film after $first s (packages, build, film), second after $second s"

# ------------------------------------------------------------------------------ the tests

started=$(seconds)
inside 'cd /srv/boxreel && ./boxreel test' >"$work/tests.log" 2>&1 ||
    { grep -A 100 'The following tests FAILED' "$work/tests.log" || tail -n 40 "$work/tests.log"; fail 'the tests there'; }
count=$(sed -n 's/^100% tests passed, 0 tests failed out of //p' "$work/tests.log")
[ "${count:-0}" -ge 3000 ] || fail "only ${count:-0} tests were run"
rm -rf "$root"
echo "$count tests passed there after $(since "$started") s (packages, build, tests)"
