#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""public_headers.py CHECKOUT

Sees that each public header has a comment of its own (@file): of one without, Doxygen leaves out functions, constants
and enumerations, and says nothing.
"""
import pathlib
import sys

headers = [path for path in pathlib.Path(sys.argv[1]).glob("*/include/**/*.h") if "Internal" not in path.parts]
bare = [str(path) for path in headers if "\n/// @file\n" not in path.read_text(encoding="utf-8")]
assert len(headers) > 50, headers
assert not bare, bare
