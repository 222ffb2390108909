#!/bin/sh
# SPDX-License-Identifier: MIT
#
# by_hand.sh CHECKOUT WORK_DIR SUITE
#
# Pastes docs/first-steps.md into a minimal Debian of that release: first the blocks that install packages, clone and
# build, then all others by tests/docs/commands.sh. Nothing is there but what the page installs. The last commit of
# CHECKOUT stands for the repository.
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

bundle
inside 'git config --global url./tmp/boxreel.bundle.insteadOf https://example.org/boxreel.git &&
    git config --global advice.detachedHead false && ! command -v cmake && ! command -v g++ && apt-get -q update >/dev/null' ||
    fail 'the fresh root is not what it should be'
page=docs/first-steps.md

# The packages for those who build by hand are all that the script needs.
paste /srv $page 'sudo apt install g++'
paste /srv $page 'git clone https://'
! grep 'installing what is missing' "$work/block.log" || fail 'the page leaves out packages that the script needs'
paste /srv/boxreel $page 'cmake -S . -B build/package'
inside 'cd /tmp && ~/.local/bin/boxreel record pyramid -o pyramid.mp4 --seconds 1 && test -s pyramid.mp4' >"$work/film.log" 2>&1 ||
    { cat "$work/film.log"; fail 'the installed program makes no film'; }
paste /srv/boxreel $page 'sudo apt install dpkg-dev file'
inside 'cd /tmp && /usr/bin/boxreel list --names | grep -qx Pyramid' || fail 'the installed package does not work'
inside 'dpkg-deb -f /srv/boxreel/build/package/boxreel_*.deb Depends | grep -q libc6' || fail 'the package names no library that it needs'
paste /srv/boxreel $page 'sudo apt install libgtest-dev'
for pace in quick slow; do
    inside "cd /srv/boxreel && tests/docs/commands.sh /srv/boxreel /srv/boxreel/build/release/boxreel ~/.local $page $pace" >"$work/blocks.log" 2>&1 ||
        { tail -n 40 "$work/blocks.log"; fail "the $pace blocks"; }
done
# Where nothing is installed, the README's program builds the libraries of the checkout.
inside 'rm -rf ~/.local && apt-get remove -y -q boxreel libboxreel-dev >/dev/null' || fail 'removing what was installed'
mkdir "$root/srv/boxreel/box"
for file in box/box.cpp box/CMakeLists.txt; do
    awk -v mark="<!-- file: $file -->" '/^```$/ { on = 0 } on { print } before == mark && /^```/ { on = 1 } { before = $0 }' \
        "$checkout/README.md" >"$root/srv/boxreel/$file"
done
paste /srv/boxreel README.md 'cmake -S box'
[ -s "$root/srv/boxreel/box.mp4" ] || fail 'the program of the README makes no film'
rm -rf "$root"
echo 'the page works there'
