# SPDX-License-Identifier: MIT
#
# Sourced with $work, a folder, and $tools, what else is needed of this machine: unpacks a minimal
# Debian 12 with git, sh and apt into $work/root, kept as $work/base.tar for the next time. Packages come
# from wherever this machine's own apt gets them. Exits with 77 where this machine cannot do that.
# shellcheck shell=sh disable=SC2016,SC2034,SC2154 # $(…) is apt's, "$@" the inner shell's; see above
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
for tool in debootstrap chroot unshare apt-get $tools; do
    command -v $tool >/dev/null || skip "$tool is not installed"
done
unshare --mount true 2>/dev/null || skip 'this system lets nobody mount anything'
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Codename: bookworm' 'Origin: Debian' | sort -u | head -n 1)
[ -n "$mirror" ] || skip "this machine's apt knows no Debian 12 (bookworm) main archive; run apt-get update once"

# ------------------------------------------------------------------------------ an empty system

mkdir -p "$work"
if [ ! -f "$work/base.tar" ]; then
    rm -rf "$work/base"
    debootstrap --variant=minbase --include=git bookworm "$work/base" "$mirror" >"$work/debootstrap.log" 2>&1 ||
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

# inside COMMAND…: in the root, in a shell's own words, with nothing of this session around it. Processes
# and terminals are there as on any running system.
inside() {
    unshare --mount --fork sh -c 'mount -t proc proc "$1/proc" &&
        mount -t devpts -o newinstance,ptmxmode=0666,mode=620 devpts "$1/dev/pts" && shift && exec "$@"' sh "$root" \
        env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp LANG=C.UTF-8 \
        ${http_proxy+"http_proxy=$http_proxy"} ${https_proxy+"https_proxy=$https_proxy"} \
        chroot "$root" sh -c "$1" </dev/null
}
seconds() {
    date +%s.%N
}
since() {
    awk -v a="$1" -v b="$(seconds)" 'BEGIN { printf "%.1f", b - a }'
}
