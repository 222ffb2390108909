# SPDX-License-Identifier: MIT
#
# Sourced with $suite, the name of a Debian release, $work, a folder, and $tools, what else is needed of this
# machine: unpacks a minimal Debian with git, sh and apt into $work/root, kept as $work/base*.tar for the next
# time. Packages come from the archives that this machine's own apt asks. Exits with 77 where this machine
# cannot do that.
#
# BOXREEL_FRESHROOT_CACHE: a folder for ccache, which is then in the root. Without it everything is compiled.
# shellcheck shell=sh disable=SC2016,SC2034,SC2154 # $(…) is apt's, "$@" the inner shell's; see above
root=$work/root
cache=${BOXREEL_FRESHROOT_CACHE-}
base=$work/base${cache:+.ccache}.tar

skip() {
    echo "skipped: $*"
    exit 77
}
fail() {
    echo "FAILED: $*" >&2
    exit 1
}

[ "$(id -u)" -eq 0 ] || skip 'only root can make a Debian root and enter it'
for tool in mmdebstrap chroot unshare apt-get $tools; do
    command -v "$tool" >/dev/null || skip "$tool is not installed"
done
unshare --mount true 2>/dev/null || skip 'this system lets nobody mount anything'

# archives: a line of sources.list for each of Debian's that this machine knows, for $suite: where the host asks
# bookworm, bookworm-updates and bookworm-security, these are trixie, trixie-updates and trixie-security.
archives() {
    host=$(apt-get indextargets --format '$(RELEASE)' 'Created-By: Packages' 'Origin: Debian' 'Label: Debian' |
        sed 's/-.*//' | sort -u | head -n 1)
    [ -n "$host" ] || return 0
    apt-get indextargets --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' |
        sed -n "s/ $host\\([- ]\\)/ $suite\\1/p" | grep ' main$' | sort -u
}

# ------------------------------------------------------------------------------ an empty system

mkdir -p "$work"
archives >"$work/sources.list"
[ -s "$work/sources.list" ] || skip "this machine's apt knows no archive of Debian; run apt-get update once"
# The same way to the archives. They are signed with the key of the release before, too, so that the host's
# keys are enough for a release after its own.
apt-config dump Acquire | grep -Ei '^Acquire::(https?|ftp|Check-|Retries)' >"$work/apt.conf" || true
if [ ! -f "$base" ]; then
    mmdebstrap --mode=root --variant=minbase --include="git,ca-certificates${cache:+,ccache}" --aptopt="$work/apt.conf" \
        "$suite" "$work/base.part.tar" "$work/sources.list" >"$work/mmdebstrap.log" 2>&1 ||
        { grep '^E: ' "$work/mmdebstrap.log"; skip "mmdebstrap could not make a Debian $suite"; }
    mv "$work/base.part.tar" "$base"
fi
rm -rf "$root"
mkdir "$root"
tar -C "$root" -xf "$base"
mkdir -p "$root/var/cache/ccache" ${cache:+"$cache"}
cp /etc/resolv.conf /etc/hosts "$root/etc/"

# inside COMMAND…: in the root, in a shell's own words, with nothing of this session around it. Processes
# and terminals are there as on any running system.
inside() {
    unshare --mount --fork sh -c 'mount -t proc proc "$1/proc" &&
        mount -t devpts -o newinstance,ptmxmode=0666,mode=620 devpts "$1/dev/pts" &&
        { [ -z "$2" ] || mount --bind "$2" "$1/var/cache/ccache"; } &&
        shift 2 && exec "$@"' sh "$root" "$cache" \
        env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp LANG=C.UTF-8 \
        ${http_proxy+"http_proxy=$http_proxy"} ${https_proxy+"https_proxy=$https_proxy"} \
        ${cache:+CMAKE_CXX_COMPILER_LAUNCHER=ccache CXXFLAGS=-fpch-preprocess} \
        ${cache:+CCACHE_DIR=/var/cache/ccache CCACHE_DEPEND=1} \
        ${cache:+CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime} \
        chroot "$root" sh -c "$1" </dev/null
}
# The last commit of the checkout as /tmp/boxreel.bundle of the root.
bundle() {
    git -C "$checkout" rev-parse --verify -q HEAD >/dev/null || skip "$checkout is no git checkout, so there is nothing to clone"
    git -C "$checkout" bundle create -q "$root/tmp/boxreel.bundle" HEAD
}
# paste FOLDER PAGE FIRST_LINE: runs the block of a page of the checkout that begins with FIRST_LINE, in FOLDER of the
# root. sudo does nothing there, and apt does not ask.
paste() {
    printf '#!/bin/sh\nexec "$@"\n' >"$root/usr/local/bin/sudo"
    chmod +x "$root/usr/local/bin/sudo"
    echo 'APT::Get::Assume-Yes "true";' >"$root/etc/apt/apt.conf.d/99yes"
    awk -v first="$3" '/^```/ { on = 0 } before ~ /^```/ && index($0, first) == 1 { on = 1 } on { print } { before = $0 }' \
        "$checkout/$2" >"$root/tmp/block.sh"
    [ -s "$root/tmp/block.sh" ] || fail "$2 has no block that begins with \"$3\""
    inside "export DEBIAN_FRONTEND=noninteractive PATH=/usr/local/bin:\$PATH && cd $1 && sh -e /tmp/block.sh" >"$work/block.log" 2>&1 ||
        { tail -n 40 "$work/block.log"; fail "the block of $2 that begins with \"$3\""; }
}
seconds() {
    date +%s.%N
}
since() {
    awk -v a="$1" -v b="$(seconds)" 'BEGIN { printf "%.1f", b - a }'
}
