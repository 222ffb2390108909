#!/bin/sh
# SPDX-License-Identifier: MIT
#
# repository.sh CHECKOUT URL: git finds the sources of CHECKOUT, as they are now, at URL, on the branch main. For tests,
# whose HOME is a folder of their own.
set -eu
checkout=$1
url=$2
repository=$HOME/repository
mkdir "$repository"
tar -C "$checkout" --exclude=./build --exclude=./.git --exclude=./golden/references -cf - . | tar -C "$repository" -xf -
cd "$repository"
git init -q -b main
git add -A
git -c user.name=test -c user.email=test@example.invalid commit -q -m 'The sources under test'
git config --global "url.file://$repository.insteadOf" "$url"
