#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_links.py FOLDER

Fails unless every link, picture and style sheet of the pages below FOLDER that is no other site's is there, and
every anchor too. Links to other sites are not followed; pictures and styles from there are findings, for a page
must be whole without a network. Doxygen's pages (api/) are looked at as well. Prints a line for each finding.
"""
import html.parser
import pathlib
import sys
import urllib.parse

RESOURCES = {"src", "srcset"}


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.anchors, self.links = set(), []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (name == "name" and tag == "a"):
                self.anchors.add(value)
            elif name in ("href", "src", "srcset") and value is not None:
                self.links.append((value, name in RESOURCES or tag == "link"))


def findings(root):
    pages = {path.resolve(): Page(path) for path in sorted(root.rglob("*.html"))}
    if not pages:
        yield f"{root} holds no pages"
    for path, page in pages.items():
        for link, is_resource in page.links:
            url = urllib.parse.urlsplit(link)
            if url.scheme or url.netloc:
                if is_resource and url.scheme not in ("javascript", "data"):
                    yield f"{path}: {link} comes from outside"
                continue
            target = (path.parent / urllib.parse.unquote(url.path)).resolve() if url.path else path
            if not target.is_file():
                yield f"{path}: {link} is not there"
            elif target in pages and url.fragment:
                if urllib.parse.unquote(url.fragment) not in pages[target].anchors:
                    yield f"{path}: {link} names no anchor of that page"


def main():
    found = sorted(set(findings(pathlib.Path(sys.argv[1]))))
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
