#!/bin/sh
# SPDX-License-Identifier: MIT
#
# run.sh BUILD_DIR WORK_DIR
#
# Makes the Debian packages of a build and installs them with apt in a minimal Debian 12 in a folder, so
# that a dependency which is not named is not there. The program lists, records, finds all well
# (doctor), shows its manual page and completes words; a program of somebody else's is compiled with the
# libraries; removed, nothing is left. Packages come from wherever this machine's own apt gets them.
#
# Exit codes: 0 all is well, 77 this machine cannot try it, anything else a failure. After a failure
# the folder stays for a look.
# shellcheck disable=SC2016 # $(…) is apt's, "$@" the inner shell's
set -eu
build=$1
work=$2
root=$work/root

skip() {
    echo "skipped: $*"
    exit 77
}
fail() {
    echo "FAILED: $*" >&2
    exit 1
}

[ "$(id -u)" -eq 0 ] || skip 'only root can make a Debian root and enter it'
for tool in debootstrap chroot unshare apt-get dpkg-shlibdeps ffprobe; do
    command -v $tool >/dev/null || skip "$tool is not installed"
done
unshare --mount true 2>/dev/null || skip 'this system lets nobody mount anything'
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Codename: bookworm' 'Origin: Debian' | sort -u | head -n 1)
[ -n "$mirror" ] || skip "this machine's apt knows no Debian 12 (bookworm) main archive; run apt-get update once"

rm -f "$build"/boxreel_*.deb "$build"/libboxreel-dev_*.deb
mkdir -p "$work"
cmake --build "$build" --target deb >"$work/deb.log" 2>&1 || { cat "$work/deb.log"; fail 'the packages were not made'; }

# ------------------------------------------------------------------------------ an empty system

if [ ! -f "$work/base.tar" ]; then
    rm -rf "$work/base"
    debootstrap --variant=minbase bookworm "$work/base" "$mirror" >"$work/debootstrap.log" 2>&1 ||
        { tail -n 3 "$work/debootstrap.log"; skip 'debootstrap could not fetch a Debian 12'; }
    rm -rf "$work"/base/var/lib/apt/lists/* "$work"/base/var/cache/apt/archives/*.deb
    tar -C "$work/base" -cf "$work/base.tar.part" . && mv "$work/base.tar.part" "$work/base.tar"
    rm -rf "$work/base"
fi
rm -rf "$root"
mkdir "$root"
tar -C "$root" -xf "$work/base.tar"

# The same archives, the same way there.
apt-get indextargets --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' |
    sort -u >"$root/etc/apt/sources.list"
apt-config dump Acquire | grep -Ei '^Acquire::(https?|ftp|Check-|Retries)' >"$root/etc/apt/apt.conf.d/90host" || true
cp /etc/resolv.conf /etc/hosts "$root/etc/"
cp "$build"/boxreel_*.deb "$build"/libboxreel-dev_*.deb "$root/tmp/"
chmod 644 "$root"/tmp/*.deb

# inside COMMAND…: in the root, in a shell's own words, with nothing of this session around it.
inside() {
    unshare --mount --fork sh -c 'mount -t proc proc "$1/proc" && shift && exec "$@"' sh "$root" \
        env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
        ${http_proxy+"http_proxy=$http_proxy"} ${https_proxy+"https_proxy=$https_proxy"} \
        chroot "$root" sh -c "$1" </dev/null
}
apt() { # ARGUMENT…: quiet but when it fails
    inside "apt-get -q -y --no-install-recommends $*" >"$work/apt.log" 2>&1 || { tail -n 20 "$work/apt.log"; return 1; }
}

apt update || skip 'the archives cannot be reached'

# ------------------------------------------------------------------------------ the program

# Debian's small images leave manual pages out, which is no fault of the package's.
rm -f "$root"/etc/dpkg/dpkg.cfg.d/*
apt install /tmp/boxreel_*.deb || fail 'boxreel was not installed'
inside 'boxreel list' | grep -q '^Stacking  *Pyramid ' || fail '`boxreel list` does not name Pyramid'
inside 'cd /tmp && boxreel record pyramid -o p.mp4 --seconds 1 && boxreel record pyramid -o p.webp --frames 3' ||
    fail 'no film was recorded'
found=$(ffprobe -v error -count_frames -select_streams v -show_entries stream=codec_name,nb_read_frames -of csv=p=0 "$root/tmp/p.mp4")
[ "$found" = h264,60 ] || fail "the film should hold 60 frames of H.264, ffprobe says: $found"
inside 'cd /tmp && boxreel shot pyramid --at 1s -o p.pdf && boxreel doctor' || fail 'doctor found something that does not work'
apt install man-db zsh bash-completion || fail 'man-db, zsh and bash-completion were not installed'
inside 'MANPAGER=cat man boxreel' | grep -q '^NAME' || fail '`man boxreel` shows nothing'
# As a shell does it when the first TAB is pressed after the program's name.
inside 'bash -c ". /usr/share/bash-completion/bash_completion; _completion_loader boxreel; complete -p boxreel"' |
    grep -q 'complete .*boxreel' || fail 'bash does not find the completion'
inside 'zsh -c "autoload -Uz compinit && compinit -u && echo \$_comps[boxreel]"' | grep -q '^_boxreel' ||
    fail 'zsh does not find the completion'

# ------------------------------------------------------------------------------ the libraries

apt install g++ cmake make pkg-config /tmp/libboxreel-dev_*.deb || fail 'libboxreel-dev was not installed'
mkdir "$root/tmp/program"
cat >"$root/tmp/program/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(program LANGUAGES CXX)
find_package(boxreel REQUIRED COMPONENTS engine render recorder golden)
add_executable(program program.cpp)
target_link_libraries(program PRIVATE boxreel::engine boxreel::recorder boxreel::golden)
END
cat >"$root/tmp/program/program.cpp" <<'END'
#include <Box2D/Box2D.h>
#include <recorder/VideoWriter.h>
int main()
{
    b2World world(b2Vec2(0.0f, -10.0f));
    world.Step(1.0f / 60.0f, 8, 3);
    boxreel::VideoSettings settings;
    settings.width = settings.height = 64;
    return boxreel::VideoWriter::Open("program.gif", settings) ? 0 : 1;
}
END
inside 'cd /tmp/program && cmake -S . -B build && cmake --build build && ./build/program' >"$work/program.log" 2>&1 ||
    { cat "$work/program.log"; fail 'a program that uses the libraries was not built'; }
inside 'pkg-config --exists --print-errors boxreel-recorder boxreel-golden' || fail 'pkg-config does not find the libraries'

# ------------------------------------------------------------------------------ and gone

apt purge boxreel libboxreel-dev || fail 'the packages were not removed'
left=$(cd "$root" && find usr etc var/lib/dpkg -name '*boxreel*')
[ -z "$left" ] || fail "removing the packages left $left"
rm -rf "$root"
echo 'installed, tried and removed'
