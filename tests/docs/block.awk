# SPDX-License-Identifier: MIT
# awk -v test=PATH -f block.awk PAGE: the blocks of commands that a page says to be run by PATH.
index($0, "<!-- not run: " test " ") { isMarked = 1; next }
/^ *```/ && isInside { isInside = 0; next }
/^ *```/ { isInside = isMarked; isMarked = 0; next }
isInside
