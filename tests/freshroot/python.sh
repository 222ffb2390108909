#!/bin/sh
# SPDX-License-Identifier: MIT
#
# python.sh CHECKOUT WORK_DIR SUITE
#
# Tries docs/python.md's commands with another Python than this machine's: in a minimal Debian of that release, the
# checkout's last commit runs the first example by `./boxreel python`, then tests/python/pip.sh makes a wheel for
# that Python by pip, installs it, and runs the example again.
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
inside 'git -c advice.detachedHead=false clone -q /tmp/boxreel.bundle /srv/boxreel && ! command -v python3' ||
    fail 'the fresh root is not what it should be'

inside 'cd /srv/boxreel && ./boxreel python python/examples/hello.py' >"$work/script.log" 2>&1 ||
    { tail -n 40 "$work/script.log"; fail './boxreel python does not run the first example'; }
[ -s "$root/srv/boxreel/hello.mp4" ] || fail 'the first example made no film'
paste /srv/boxreel docs/first-steps.md 'sudo apt install python3-venv'
# What the page's pip fetches from elsewhere.
inside 'apt-get install -y --no-install-recommends python3-pip python3-setuptools python3-wheel ffmpeg' >"$work/apt.log" 2>&1 ||
    { tail -n 40 "$work/apt.log"; fail 'the packages of pip cannot be installed'; }
inside 'cd /srv/boxreel && tests/python/pip.sh . /usr/bin/python3' >"$work/pip.log" 2>&1 ||
    { tail -n 40 "$work/pip.log"; fail 'pip'; }
version=$(inside 'python3 --version')
grep '^installed ' "$work/pip.log"
rm -rf "$root"
echo "$version: ./boxreel python and pip are well there"
