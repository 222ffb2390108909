#!/bin/bash
# SPDX-License-Identifier: MIT
#
# closed-window.sh PROGRAM ARGUMENTS…: `boxreel ui` on a display without a screen, until its window can be seen;
# then Esc is pressed. Ends with the program's exit code, 1 when no window appears, 77 when none can be tried.
set -eu
for tool in Xvfb xdotool; do
    command -v $tool >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
coproc screen { exec Xvfb -displayfd 1 -screen 0 1920x1080x24 -nolisten tcp 2>/dev/null; }
# shellcheck disable=SC2154 # coproc sets it
server=$screen_PID
trap 'kill "$server"' EXIT
read -r number <&"${screen[0]}"
export DISPLAY=:$number
"$@" &
window=$!
if ! timeout 60 xdotool search --sync --onlyvisible --name boxreel >/dev/null; then
    kill "$window" 2>/dev/null || true
    echo 'no window appears' >&2
    exit 1
fi
while kill -0 "$window" 2>/dev/null; do # the first key may come before the window listens
    xdotool search --onlyvisible --name boxreel key Escape >/dev/null 2>&1 || true
    sleep 0.2
done
wait "$window"
