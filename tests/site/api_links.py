#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""api_links.py CHECKOUT

Sees that each page of the API reference leads back to the site, however often that is seen to, and keeps no link to a
list of nested classes that is not there.
"""
import importlib.util
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
spec = importlib.util.spec_from_file_location("site_py", pathlib.Path(sys.argv[1]) / "docs/site/site.py")
site_py = importlib.util.module_from_spec(spec)
spec.loader.exec_module(site_py)

HEAD = '<div id="projectname">boxreel<span id="projectnumber">&#160;1.0</span>'
NESTED = '<a href="#nested-classes">Classes</a> &#124;\n<a href="#members">Functions</a>'
WHOLE = '<h2><a id="x" name="nested-classes"></a>Classes</h2>'
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    (folder / "a.html").write_text(HEAD + NESTED)
    (folder / "b.html").write_text(HEAD + NESTED + WHOLE)
    for _ in range(2):
        site_py.fix_api(folder)
        back = '<div id="projectname"><a href="../index.html">boxreel</a><span id="projectnumber">&#160;1.0</span>'
        assert (folder / "a.html").read_text() == back + '\n<a href="#members">Functions</a>'
        assert (folder / "b.html").read_text() == back + NESTED + WHOLE
