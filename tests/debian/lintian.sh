#!/bin/sh
# SPDX-License-Identifier: MIT
#
# lintian.sh BUILD_DIR: makes the Debian packages of a build and fails on an error that lintian finds.
# Exit codes: 0 none, 77 there is no lintian here, anything else a failure.
set -eu
command -v lintian >/dev/null || { echo 'skipped: lintian is not installed'; exit 77; }
command -v dpkg-shlibdeps >/dev/null || { echo 'skipped: dpkg-dev is not installed'; exit 77; }
cmake --build "$1" --target deb
# Errors only: of the warnings, that no manual page for a library's header is there is no fault.
lintian --fail-on error --tag-display-limit 0 "$1"/boxreel_*.deb "$1"/libboxreel-dev_*.deb
