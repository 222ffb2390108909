#!/bin/sh
# SPDX-License-Identifier: MIT
#
# run.sh CHECKOUT WORK_DIR SUITE
#
# Tries the README's two commands where nothing is installed: a minimal Debian of that release in a folder,
# with git, sh and apt, in which the checkout's last commit is cloned into a folder whose name has a space.
# Reports how long the first film, the second one and the tests took; fails on what goes wrong, never on a
# time. Packages come from the archives that this machine's own apt asks.
#
# Exit codes: 0 all is well, 77 this machine cannot try it, anything else a failure. After a failure
# the folder stays for a look.
# shellcheck disable=SC2016,SC2034,SC2154 # $(…) is apt's, "$@" the inner shell's; root.sh has the others
set -eu
checkout=$1
work=$2
suite=$3
tools='ffmpeg ffprobe git'
# shellcheck source=tests/freshroot/root.sh
. "$(dirname "$0")/root.sh"

bundle

# The README's address stands for the bundle.
clone=$(sed -n 's/^\(git clone [^ ]*\).*/\1/p' "$checkout/README.md")
inside "git config --global url./tmp/boxreel.bundle.insteadOf https://example.org/boxreel.git &&
    git config --global advice.detachedHead false && $clone '/srv/box reel' && ! command -v cmake && ! command -v g++" ||
    fail 'the fresh root is not what it should be'

# says CODE LINES PATTERN COMMAND: run in the checkout, it ends with that code and that many lines, one of which
# matches.
says() {
    status=0
    inside "cd '/srv/box reel' && $4" >"$work/says.log" 2>&1 || status=$?
    [ "$status" -eq "$1" ] && [ "$(wc -l <"$work/says.log")" -eq "$2" ] && grep -q "$3" "$work/says.log" && return 0
    cat "$work/says.log"
    fail "expected exit code $1 and $2 lines, one with \"$3\", got exit code $status"
}
nobody='chroot --userspec=nobody --skip-chdir / env'
readOnly='mount --bind . . && mount -o remount,ro,bind . && cd "$PWD" &&'
elsewhere='mount --bind . /mnt && mount -o remount,ro,bind /mnt && cd /mnt &&'

# ------------------------------------------------------------------------------ where it cannot

says 3 1 'there is no sudo to install them; as root run: apt-get install g++' \
    "$nobody BOXREEL_BUILD_DIR=/tmp/nobody ./boxreel list"
says 3 2 'sudo was refused.*; as root run: apt-get install g++' \
    "mkdir /tmp/bin && ln -s /bin/false /tmp/bin/sudo && $nobody PATH=/tmp/bin:/usr/bin BOXREEL_BUILD_DIR=/tmp/nobody ./boxreel list"
says 4 1 'build/release cannot be written; set BOXREEL_BUILD_DIR' "$nobody ./boxreel list"
says 4 1 'build/release cannot be written; set BOXREEL_BUILD_DIR' "$readOnly ./boxreel list"
says 3 3 'apt-get failed .*check the network' 'BOXREEL_BUILD_DIR=/tmp/offline unshare --net ./boxreel list'
inside 'rm -rf /tmp/nobody /tmp/bin /tmp/offline'

# ------------------------------------------------------------------------------ the two films

started=$(seconds)
inside 'cd "/srv/box reel" && ./boxreel record pyramid -o pyramid.mp4' 2>"$work/first.log" || { cat "$work/first.log"; fail 'the first film was not made'; }
first=$(since "$started")
started=$(seconds)
inside 'cd /tmp && "/srv/box reel/boxreel" record pyramid -o second.mp4' || fail 'the second film was not made'
second=$(since "$started")

for film in "$root/srv/box reel/pyramid.mp4" "$root/tmp/second.mp4"; do
    codec=$(ffprobe -v error -select_streams v -show_entries stream=codec_name -of csv=p=0 "$film")
    # A picture that stays is held, so there are fewer frames in the file than are shown.
    shown=$(ffmpeg -v error -i "$film" -vf fps=60 -f framecrc - | grep -vc '^#')
    [ "$codec,$shown" = h264,600 ] || fail "$film should show 600 frames of H.264, not $codec,$shown"
done
cmp "$root/srv/box reel/pyramid.mp4" "$root/tmp/second.mp4" || fail 'the two films are not the same'
echo "first film after $first s (packages, build, film), second after $second s"

# The script says what draws where there is no OSMesa, and the doctor says the same.
{ inside 'cd /tmp && "/srv/box reel/boxreel" doctor' >"$work/doctor.log" 2>&1 && ! grep -q '^FAIL' "$work/doctor.log"; } ||
    { cat "$work/doctor.log"; fail 'the doctor finds something wrong'; }
if inside 'apt-cache madison libosmesa6-dev | grep -q .'; then
    grep -q '^ok    OSMesa' "$work/doctor.log" || fail 'OSMesa does not draw'
else
    [ "$(grep -c 'no OSMesa, so EGL is used instead' "$work/first.log")" -eq 1 ] || fail 'the script does not say that EGL draws'
    grep -q '^none  OSMesa  *EGL is used instead' "$work/doctor.log" || fail 'the doctor does not say that EGL draws'
fi
inside 'cd "/srv/box reel" && ./boxreel golden verify' >"$work/golden.log" 2>&1 ||
    { tail -n 40 "$work/golden.log"; fail 'golden verify'; }

# A built checkout may be read-only, and another user's. In another place it says that it does not build there.
says 0 1 '^Pyramid$' "$readOnly ./boxreel list --names | grep -x Pyramid"
says 0 2 'build/release cannot be written; running the program as it was built' "$elsewhere ./boxreel list --names | grep -x Pyramid"
says 0 1 '^Pyramid$' "$nobody ./boxreel list --names | grep -x Pyramid"

# ------------------------------------------------------------------------------ the tests

started=$(seconds)
inside 'cd "/srv/box reel" && ./boxreel test' >"$work/tests.log" 2>&1 ||
    { grep -A 100 'The following tests FAILED' "$work/tests.log" || tail -n 40 "$work/tests.log"; fail 'the tests there'; }
count=$(sed -n 's/^100% tests passed, 0 tests failed out of //p' "$work/tests.log")
[ "${count:-0}" -ge 3000 ] || fail "only ${count:-0} tests were run"
rm -rf "$root"
echo "$count tests passed there after $(since "$started") s (packages, build, tests)"
