#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""links.py CHECKOUT

Every link and picture of the Markdown pages leads to a file that exists, and every anchor to a heading. Links to the web
are not followed. Prints a line for each that does not; exit code 1 then.
"""
import pathlib
import re
import sys

checkout = pathlib.Path(sys.argv[1])
LINK = re.compile(r'\]\(([^)\s]+)\)|(?:src|srcset)="([^"]+)"')


def text_of(page):
    """A page without its blocks of code and its code in lines."""
    text = re.sub(r"^ *```.*?^ *```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    return re.sub(r"`[^`\n]*`", lambda found: re.sub(r"[\[\]()]", "", found[0]), text)


def anchors_of(page):
    """Headings as GitHub names them."""
    words = (re.sub(r"[^\w\- ]", "", line.lstrip("# ").lower()) for line in text_of(page).splitlines() if line.startswith("#"))
    return {line.strip().replace(" ", "-") for line in words}


def findings(page):
    """A line for each link that leads nowhere."""
    for link in LINK.finditer(text_of(page)):
        target = link[1] or link[2]
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        there = (page.parent / path).resolve() if path else page
        if not there.exists():
            yield f"{page.relative_to(checkout)} links to {target}, which does not exist"
        elif anchor and there.suffix == ".md" and anchor not in anchors_of(there):
            yield f"{page.relative_to(checkout)} links to {target}, which is no heading of that page"


pages = [*checkout.glob("*.md"), *checkout.glob("docs/**/*.md"), *checkout.glob("golden/references/*.md")]
assert len(pages) > 60, pages
found = sorted(line for page in pages for line in findings(page))
print(*found, sep="\n", end="\n" if found else "")
sys.exit(1 if found else 0)
