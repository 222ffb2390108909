#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""site.py CHECKOUT OUTPUT_FOLDER

Makes a static site of the Markdown pages (docs/, and those at the top) with pandoc, one template and one
style sheet. Links between pages become links between the site's pages; a file that a page links to or
shows is copied beside it, a folder without a page of its own is named and not linked. The chapters of the manual
come in the order of its contents (docs/manual/README.md), each with the way to the one before and the next. Called
by the target `site`, which puts the API reference into OUTPUT_FOLDER/api first. Exit codes: 0, or 1 with a sentence for
each link that leads nowhere.
"""
import html
import os
import pathlib
import re
import shutil
import subprocess
import sys

# Title, and the pages below it in this order; chapters in that of the contents.
CONTENTS = pathlib.Path("docs/manual/README.md")
GROUPS = [
    ("boxreel", ["README.md", "docs/first-steps.md", "docs/gallery.md", "docs/cheat-sheet.md",
                 "docs/troubleshooting.md", "docs/versions.md"]),
    ("Manual: the engine", ["docs/manual/**/*.md"]),
    ("Manual: pictures, films and tests", ["docs/*.md"]),
    ("Examples and figures", ["docs/examples/**/*.md", "docs/figures/**/*.md", "docs/[!n]*/**/*.md"]),
    ("Project", ["ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md"]),
    ("Decisions", ["docs/notes/*.md"]),
]
ELSEWHERE = re.compile(r"^([a-z][a-z0-9+.-]*:|//|#)", re.IGNORECASE)
LINK = re.compile(r'<a href="([^"]*)"[^>]*>(.*?)</a>', re.DOTALL)
CHAPTER = re.compile(r"^(\d+\.) \[([^]]*)\]\(([^)]+)\)", re.MULTILINE)
PICTURE = re.compile(r'\b(src|srcset)="([^"]*)"')


def title_of(page):
    """The first heading outside a block of code; pages without one are called like their file."""
    in_code = False
    for line in page.read_text(encoding="utf-8").splitlines():
        in_code ^= line.startswith("```")
        if line.startswith("# ") and not in_code:
            return re.sub(r"[`*]", "", line[2:]).strip()
    return page.stem


def url_of(page):
    """Of a page's path in the checkout: its path in the site."""
    return page.with_name("index.html") if page.name == "README.md" else page.with_suffix(".html")


def chapters_of(checkout):
    """The pages of the manual in the order of its contents, with the number and name that each has there."""
    found = CHAPTER.findall((checkout / CONTENTS).read_text(encoding="utf-8"))
    return {pathlib.Path(os.path.normpath(CONTENTS.parent / link)): f"{number} {name}" for number, name, link in found}


class Site:
    def __init__(self, checkout, output):
        self.checkout, self.output = checkout, output
        self.names = chapters_of(checkout)
        self.chapters = list(self.names)
        places = {page: place for place, page in enumerate([CONTENTS] + self.chapters)}
        self.groups, self.problems = [], []
        seen = set()
        for title, patterns in GROUPS:
            pages = []
            for pattern in patterns:
                # README first: it is the contents of its folder.
                found = [path.relative_to(checkout) for path in checkout.glob(pattern)]
                for page in sorted(found, key=lambda p: (places.get(p, len(places)), p.parent, p.name != "README.md", p.name)):
                    if page not in seen:
                        seen.add(page)
                        pages.append((page, title_of(checkout / page)))
            if pages:
                self.groups.append((title, pages))
        self.pages = seen

    def navigation(self, current):
        lines = []
        for title, pages in self.groups:
            lines.append(f"<p>{html.escape(title)}</p>\n<ul>")
            for page, name in pages:
                here = ' aria-current="page"' if page == current else ""
                name = "Overview" if page == pathlib.Path("README.md") else self.names.get(page, name)
                lines.append(f'<li><a href="{self.relative(url_of(page), current)}"{here}>{html.escape(name)}</a></li>')
            lines.append("</ul>")
        if (self.output / "api" / "index.html").exists():
            lines.append(f'<p>Reference</p>\n<ul><li><a href="{self.relative("api/index.html", current)}">API</a></li></ul>')
        return "\n".join(lines)

    def turn(self, page):
        """At the end of a chapter: the one before and the next."""
        if page not in self.chapters:
            return ""
        place = self.chapters.index(page)
        links = ""
        for kind, words, there in (("prev", "Before", place - 1), ("next", "Next", place + 1)):
            if 0 <= there < len(self.chapters):
                other = self.chapters[there]
                links += (f'<a rel="{kind}" href="{self.relative(url_of(other), page)}"><span>{words}</span> '
                          f'{html.escape(self.names[other])}</a>\n')
        return f'<p class="turn">\n{links}</p>\n'

    @staticmethod
    def relative(target, page):
        return os.path.relpath(target, page.parent)

    def target(self, link, page):
        """Where a link of a page leads in the site; None: to a folder that has no page."""
        if ELSEWHERE.match(link) or not link:
            return link
        path, mark, anchor = html.unescape(link).partition("#")
        found = pathlib.Path(os.path.normpath(page.parent / path))
        source = self.checkout / found
        if source.is_dir() and found / "README.md" in self.pages:
            found /= "README.md"
        if found in self.pages:
            return html.escape(self.relative(url_of(found), page) + mark + anchor)
        if source.is_dir():
            return None
        if found.parts[0] == ".." or not source.is_file():
            self.problems.append(f"{page} links to {path}, which is not there; mend the link.")
            return None
        copy = self.output / found
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, copy)
        return html.escape(self.relative(found, page) + mark + anchor)

    def link(self, match, page):
        target = self.target(match[1], page)
        return match[2] if target is None else match[0].replace(f'"{match[1]}"', f'"{target}"', 1)

    def make(self, page, title):
        made = subprocess.run(
            ["pandoc", "--from=gfm", "--to=html5", "--standalone", "--toc", "--toc-depth=2", "--wrap=preserve",
             f"--template={self.checkout}/docs/site/template.html", f"--metadata=pagetitle:{title}",
             f"--variable=root:{self.relative('.', page)}/", f"--variable=navigation:{self.navigation(page)}",
             str(self.checkout / page)],
            check=True, capture_output=True, text=True, encoding="utf-8").stdout
        head, start, body = made.partition("<main>")
        body = LINK.sub(lambda match: self.link(match, page), body)
        body = PICTURE.sub(lambda match: f'{match[1]}="{self.target(match[2], page)}"', body)
        body, end, tail = body.rpartition("</main>")
        body += self.turn(page) + end + tail
        target = self.output / url_of(page)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(head + start + body, encoding="utf-8")


def mend_api(folder):
    """Of each page of Doxygen's: the project's name leads back to the site, and there is no link to a list of
    nested classes where all are private (Doxygen 1.9.4 has one to a list that is not there)."""
    for page in folder.glob("*.html"):
        made = page.read_text(encoding="utf-8")
        text = re.sub(r'(<div id="projectname">)(\w+)', r'\1<a href="../index.html">\2</a>', made)
        if 'name="nested-classes"' not in text:
            text = re.sub(r'<a href="#nested-classes">[^<]*</a>(\s*&#124;)?', "", text)
        if text != made:
            page.write_text(text, encoding="utf-8")


def main():
    checkout, output = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    output.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(checkout / "docs/site/style.css", output / "style.css")
    mend_api(output / "api")
    site = Site(checkout, output)
    for _, pages in site.groups:
        for page, title in pages:
            site.make(page, title)
    for problem in site.problems:
        print(problem, file=sys.stderr)
    return 1 if site.problems else 0


if __name__ == "__main__":
    sys.exit(main())
