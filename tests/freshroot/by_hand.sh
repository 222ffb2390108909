#!/bin/sh
# SPDX-License-Identifier: MIT
#
# by_hand.sh CHECKOUT WORK_DIR SUITE
#
# Pastes those blocks of docs/first-steps.md that need a machine of their own into a minimal Debian of that release:
# the packages for those who build by hand, the installed libraries, and the Debian packages. The last commit of
# CHECKOUT stands for the repository, and sudo does nothing.
#
# Exit codes: 0 all is well, 77 this machine cannot try it, anything else a failure.
# shellcheck disable=SC2016,SC2034,SC2154 # "$@" is the inner shell's; root.sh has the others
set -eu
checkout=$1
work=$2
suite=$3
tools='git'
# shellcheck source=tests/freshroot/root.sh
. "$(dirname "$0")/root.sh"

git -C "$checkout" rev-parse --verify -q HEAD >/dev/null || skip "$checkout is no git checkout, so there is nothing to clone"
git -C "$checkout" bundle create -q "$root/tmp/boxreel.bundle" HEAD
printf '#!/bin/sh\nexec "$@"\n' >"$root/usr/local/bin/sudo"
chmod +x "$root/usr/local/bin/sudo"
echo 'APT::Get::Assume-Yes "true";' >"$root/etc/apt/apt.conf.d/99yes"
inside 'git config --global url./tmp/boxreel.bundle.insteadOf https://example.org/boxreel.git &&
    git config --global advice.detachedHead false && ! command -v cmake && ! command -v g++ && apt-get -q update >/dev/null' ||
    fail 'the fresh root is not what it should be'

# paste FOLDER FIRST_LINE: runs the page's block that begins with FIRST_LINE, in FOLDER of the root.
paste() {
    awk -v first="$2" '/^```/ { on = 0 } on == 0 && before ~ /^```/ && index($0, first) == 1 { on = 1 } on { print } { before = $0 }' \
        "$checkout/docs/first-steps.md" >"$root/tmp/block.sh"
    [ -s "$root/tmp/block.sh" ] || fail "the page has no block that begins with \"$2\""
    inside "export DEBIAN_FRONTEND=noninteractive PATH=/usr/local/bin:\$PATH && cd $1 && sh -e /tmp/block.sh" >"$work/block.log" 2>&1 ||
        { tail -n 40 "$work/block.log"; fail "the block that begins with \"$2\""; }
}

paste /srv 'sudo apt install g++'
inside "cd /srv && git clone -q $(sed -n 's/^git clone \([^ ]*\).*/\1/p' "$checkout/docs/first-steps.md")" || fail 'the clone'
paste /srv/boxreel 'cmake -S . -B build/package'
inside 'cd /tmp && ~/.local/bin/boxreel record pyramid -o pyramid.mp4 --seconds 1 && test -s pyramid.mp4' >"$work/film.log" 2>&1 ||
    { cat "$work/film.log"; fail 'the installed program makes no film'; }
paste /srv/boxreel 'cmake --build build/package --parallel "$(nproc)" --target deb'
inside 'cd /tmp && /usr/bin/boxreel list --names | grep -qx Pyramid' || fail 'the installed package does not work'
rm -rf "$root"
echo 'the blocks work there'
