#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Sees that check_links.py finds each kind of link that leads nowhere, and none in pages that are whole."""
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
import check_links

WHOLE = '<h1 id="top">A</h1><a href="#top">a</a><a href="b/c.html#x%20y">b</a><a href="https://example.org/d">d</a>'
BROKEN = {
    '<a href="gone.html">': "gone.html is not there",
    '<a href="#gone">': "#gone names no anchor of that page",
    '<a href="b/c.html#gone">': "b/c.html#gone names no anchor of that page",
    '<source srcset="gone.svg">': "gone.svg is not there",
    '<img src="https://example.org/e.png">': "https://example.org/e.png comes from outside",
    '<link rel="stylesheet" href="//example.org/f.css">': "//example.org/f.css comes from outside",
}

with tempfile.TemporaryDirectory() as name:
    root = pathlib.Path(name)
    assert list(check_links.findings(root)) == [f"{root} holds no pages"]
    (root / "b").mkdir()
    (root / "b" / "c.html").write_text('<p id="x y"><a href="../a.html">a</a>')
    (root / "a.html").write_text(WHOLE)
    assert not list(check_links.findings(root)), list(check_links.findings(root))
    for planted, said in BROKEN.items():
        (root / "a.html").write_text(WHOLE + planted)
        found = list(check_links.findings(root))
        assert found == [f"{(root / 'a.html').resolve()}: {said}"], (planted, found)
