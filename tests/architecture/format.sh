#!/bin/sh
# SPDX-License-Identifier: MIT
# format.sh SOURCE: every C++ file is as clang-format 14 writes it. Exit codes: 0 all are, 1 some are not,
# 77 there is no clang-format 14; others format in other ways.
set -eu
cd "$1"
format=$(command -v clang-format-14 || command -v clang-format) && "$format" --version | grep -q 'version 14\.' || {
    echo 'skipped: there is no clang-format 14; install the package clang-format-14'
    exit 77
}
folders='base debugdraw docs engine golden recorder render testbed tests'
# shellcheck disable=SC2086 # a list of words
find $folders -type f \( -name '*.cpp' -o -name '*.h' \) -print0 |
    xargs -0 -n 40 -P "$(nproc)" "$format" --dry-run -Werror
