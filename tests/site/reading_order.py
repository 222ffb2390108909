#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""reading_order.py CHECKOUT

Sees that the site leads through the manual as its contents do: in the lists of pages, and from the end of each
chapter to the next one.
"""
import importlib.util
import pathlib
import re
import sys
import tempfile

sys.dont_write_bytecode = True
checkout = pathlib.Path(sys.argv[1])
spec = importlib.util.spec_from_file_location("site_py", checkout / "docs/site/site.py")
site_py = importlib.util.module_from_spec(spec)
spec.loader.exec_module(site_py)

with tempfile.TemporaryDirectory() as output:
    site = site_py.Site(checkout, pathlib.Path(output))

    listed = re.findall(r"^(\d+)\. \[", (checkout / site_py.CONTENTS).read_text(encoding="utf-8"), re.MULTILINE)
    assert [int(number) for number in listed] == list(range(1, len(site.chapters) + 1)), listed
    assert len(site.chapters) == len(set(site.chapters)) > 20, site.chapters

    manual = [page for title, pages in site.groups if title.startswith("Manual") for page, _ in pages]
    assert manual == [site_py.CONTENTS] + site.chapters, manual

    walked, page = [], site.chapters[0]
    while page is not None:
        walked.append(page)
        links = dict(re.findall(r'rel="(\w+)" href="([^"]*)"', site.turn(page)))
        before = site_py.url_of(walked[-2]) if len(walked) > 1 else None
        assert links.get("prev") == (before and site.relative(before, page)), (page, links)
        here = [other for other in site.chapters if site.relative(site_py.url_of(other), page) == links.get("next")]
        page = here[0] if here else None
    assert walked == site.chapters, walked
    assert site.turn(pathlib.Path("CHANGELOG.md")) == ""
