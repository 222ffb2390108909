#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""site.py CHECKOUT OUTPUT_FOLDER [PROGRAM]

Makes a static site of the Markdown pages (docs/, and those at the top) with MkDocs and its theme Material, which bring
the search, the lists of pages and the dark colours. PROGRAM, boxreel, records the scenes that the gallery lets one
play. What this file adds: the order of the pages, files that pages link to or show, links from the manual's chapters into
the API reference, which the target `site` puts into OUTPUT_FOLDER/api first. Exit codes: 0, or 1 with one line for each
link that leads nowhere.
"""
import html
import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

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
API = "https://api.invalid/"  # in the list of pages, until the depth of a page is known
ELSEWHERE = re.compile(r"^([a-z][a-z0-9+.-]*:|//|#)", re.IGNORECASE)
LINK = re.compile(r'<a ([^>]*?)href="([^"]*)"([^>]*)>(.*?)</a>', re.DOTALL)
CHAPTER = re.compile(r"^(\d+\.) \[([^]]*)\]\(([^)]+)\)", re.MULTILINE)
PICTURE = re.compile(r'\b(src|srcset)="([^"]*)"')
# Where names of the API may stand: links, headings, listings, code in text, and text. Only the last three get links.
PARTS = re.compile(r"(<a\b.*?</a>|<h[1-6]\b.*?</h[1-6]>|<pre\b.*?</pre>|<code>.*?</code>|<[^>]*>)", re.DOTALL)
MENTION = re.compile(r"([\w.]+?(?:\.|->))?([A-Za-z_]\w*(?:::\w+)?)(?:\(.*\))?")
TOKEN = re.compile(r'((?:<span class="[op]">(?:\.|-&gt;)</span>)?)(<span class="n[a-z]?">)(\w+)(</span>)')
# What members without a class mean in chapters about one class.
SUBJECTS = {"05-bodies": "b2Body", "06-fixtures": "b2Fixture", "08-contacts": "b2Contact", "09-world": "b2World"}
CLASS = re.compile(r"\bb2[A-Z]\w+")
ITEM = re.compile(r"^( *)([-*]|\d+\.)( +)(?=\S)")


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


def for_mkdocs(text):
    """What GitHub reads and MkDocs does not: lists within lists by less than four spaces, lists right after a line."""
    lines, levels, in_code, before = [], [], False, ""
    for line in text.splitlines():
        indent, was_list = len(line) - len(line.lstrip(" ")), bool(levels)
        while levels and line.strip() and indent < levels[-1]:
            levels.pop()
        item = None if in_code else ITEM.match(line)
        if item and not was_list and before.strip():
            lines.append("")
        base = levels[-1] if levels else 0
        lines.append(" " * (4 * len(levels)) + line[base:] if levels and line.strip() else line)
        if item:
            levels.append(len(item[0]))
        if line.strip().startswith("```"):
            in_code = not in_code
        before = line
    return "\n".join(lines) + "\n"


class Api:
    """The public names of the API reference with their pages, and which classes have a member of a name."""

    def __init__(self, urls=(), bases=()):
        self.urls, self.owners, self.bases = dict(urls), {}, dict(bases)
        for name in self.urls:
            owner, scoped, member = name.rpartition("::")
            # A member that overrides a base's is found at the base.
            if scoped and not any(f"{base}::{member}" in self.urls for base in self.bases.get(owner, ())):
                self.owners.setdefault(member, []).append(owner)

    @classmethod
    def read(cls, folder):
        """From Doxygen's tag file; empty if there is none."""
        urls, bases, tags = {}, {}, folder / "boxreel.tag"
        for compound in xml.etree.ElementTree.parse(tags).getroot() if tags.is_file() else []:
            name = compound.findtext("name").removeprefix("boxreel::")
            is_class = compound.get("kind") in ("class", "struct")
            if is_class:
                urls.setdefault(name, compound.findtext("filename"))
                bases[name] = [base.text.removeprefix("boxreel::") for base in compound.findall("base")]
            for member in compound.findall("member"):
                url = f"{member.findtext('anchorfile')}#{member.findtext('anchor')}"
                urls.setdefault(f"{name}::{member.findtext('name')}" if is_class else member.findtext("name"), url)
        return cls(urls, bases)


class References:
    """Finds the page of the API reference that a name of a chapter means. Of a member that several classes have, it takes
    the chapter's subject, the class named last before it in the section, or the only one that the chapter names."""

    def __init__(self, api, body, page):
        self.api, self.is_engine, self.subject = api, page.parent == CONTENTS.parent, SUBJECTS.get(page.stem)
        self.in_chapter = {name for name in re.findall(r"\w+", re.sub(r"<[^>]*>", " ", body)) if name in api.urls}
        self.section()

    def section(self):
        self.linked, self.named = set(), []

    def owner(self, member, is_certain):
        owners = [name for name in self.api.owners.get(member, ()) if name.startswith("b2") or not self.is_engine]
        if is_certain or len(owners) < 2:
            return owners[0] if len(owners) == 1 and (member[0].isupper() or owners[0] in self.in_chapter) else None
        if self.subject in owners:
            return self.subject
        for named in reversed(self.named):
            # A definition names its joint too, and a class its base.
            for name in (named, named.removesuffix("Def"), *self.api.bases.get(named, ())):
                if name in owners:
                    return name
        owners = [name for name in owners if name in self.in_chapter]
        return owners[0] if len(owners) == 1 else None

    def url(self, name, is_member, in_listing):
        """Of a name; None if it is not of the API, or has a link in this section. Of an object's member, and in a listing,
        only what is certain counts: which class the object has, a compiler knows."""
        if is_member or name not in self.api.urls:
            if "::" in name or (in_listing and not is_member) or len(name) < 3 or not (self.is_engine or name[0].isupper()):
                return None
            name = f"{self.owner(name, is_member)}::{name}"
        elif in_listing and not (name.startswith("b2") or ("#" not in self.api.urls[name] and not self.is_engine)):
            return None
        elif name != "b2Vec2":  # It stands in most listings, and is seldom what they are about.
            self.named.append(name.partition("::")[0])
        url = self.api.urls.get(name)
        if url is None or url in self.linked:
            return None
        self.linked.add(url)
        return url


class Site:
    def __init__(self, checkout, output):
        self.checkout, self.output = checkout, output
        self.names = chapters_of(checkout)
        self.chapters = list(self.names)
        self.api = Api.read(output / "api")
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

    def configuration(self, sources):
        """Of MkDocs, as YAML; slugs as GitHub makes them."""
        groups = [{title: [{"Overview" if page.name == "README.md" and page.parent.name == "" else self.names.get(page, name):
                            page.as_posix()} for page, name in pages]} for title, pages in self.groups]
        groups += [{"API reference": API}] if self.api.urls else []
        schemes = (("light", "default", "weather-night", "Dark"), ("dark", "slate", "weather-sunny", "Light"))
        return json.dumps({
            "site_name": "boxreel", "docs_dir": str(sources), "site_dir": str(self.output), "use_directory_urls": False,
            "nav": groups, "plugins": ["search"], "extra_css": ["style.css"],
            "theme": {"name": "material", "font": False, "features": ["navigation.top", "search.highlight"],
                      "palette": [{"media": f"(prefers-color-scheme: {media})", "scheme": scheme, "primary": "blue grey", "accent": "deep orange",
                                   "toggle": {"icon": f"material/{icon}", "name": name}} for media, scheme, icon, name in schemes]},
            "markdown_extensions": ["tables", "pymdownx.superfences", {"pymdownx.highlight": {"pygments_lang_class": True}}, "pymdownx.tilde", {"toc": {"slugify": "SLUGIFY"}}],
        }).replace('"SLUGIFY"', "!!python/name:site_slug.github ")

    @staticmethod
    def relative(target, page):
        return os.path.relpath(target, page.parent)

    def target(self, link, page):
        """Where a link of a page leads in the site; None: to a folder that has no page."""
        if link.startswith(API):
            return self.relative("api/index.html", page)
        if ELSEWHERE.match(link) or not link:
            return link
        path, mark, anchor = html.unescape(link).partition("#")
        found = pathlib.Path(os.path.normpath(page.parent / path))
        if (self.output / found).is_file():
            return link
        source = self.checkout / found
        if source.is_dir() and found / "README.md" in self.pages:
            return html.escape(self.relative(url_of(found / "README.md"), page) + mark + anchor)
        if source.is_dir():
            return None
        if found.parts[0] == ".." or not source.is_file():
            self.problems.append(f"{page} links to {path}, which is not there; correct the link.")
            return None
        copy = self.output / found
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, copy)
        return html.escape(self.relative(found, page) + mark + anchor)

    def link(self, match, page):
        target = self.target(match[2], page)
        return match[4] if target is None else f'<a {match[1]}href="{target}"{match[3]}>{match[4]}</a>'

    def referred(self, body, page):
        """The body with a link into the API reference at the first mention of each name in a section."""
        found = References(self.api, body, page)

        def linked(text, name, is_member=False, in_listing=False):
            url = found.url(name, is_member, in_listing)
            return text if url is None else f'<a class="api" href="{self.relative(f"api/{url}", page)}">{text}</a>'

        def token(match):
            return match[1] + linked(match[2] + match[3] + match[4], match[3], bool(match[1]), True)

        parts = PARTS.split(body)
        for place, part in enumerate(parts):
            if re.match(r"<h[23]\b", part):
                found.section()
            elif part.startswith("<pre") and "language-cpp" in "".join(parts[max(0, place - 4):place]):
                parts[place] = TOKEN.sub(token, part)
            elif part.startswith("<code>"):
                mention = MENTION.fullmatch(html.unescape(part[6:-7]))
                parts[place] = linked(part, mention[2], bool(mention[1])) if mention else part
            elif place % 2 == 0:
                parts[place] = CLASS.sub(lambda match: linked(match[0], match[0]), part)
        return "".join(parts)

    def finish(self, page):
        """Files that the page links to and shows come beside it, and its links lead there."""
        file = self.output / url_of(page)
        text = LINK.sub(lambda match: self.link(match, page), file.read_text(encoding="utf-8"))
        text = PICTURE.sub(lambda match: f'{match[1]}="{self.target(match[2], page)}"', text)
        head, start, body = text.partition("<article")
        body, end, tail = body.partition("</article>")
        if page.parts[0] == "docs" and page.parts[1] != "notes":
            body = self.referred(body, page)
        file.write_text(head + start + body + end + tail, encoding="utf-8")

    def make(self):
        with tempfile.TemporaryDirectory() as name:
            sources = pathlib.Path(name) / "docs"
            for page in self.pages:
                copy = sources / page
                copy.parent.mkdir(parents=True, exist_ok=True)
                copy.write_text(for_mkdocs((self.checkout / page).read_text(encoding="utf-8")), encoding="utf-8")
            shutil.copyfile(self.checkout / "docs/site/style.css", sources / "style.css")
            settings = pathlib.Path(name) / "mkdocs.yml"
            settings.write_text(self.configuration(sources), encoding="utf-8")
            search = os.pathsep.join([str(self.checkout / "docs/site"), os.environ.get("PYTHONPATH", "")])
            subprocess.run(["mkdocs", "build", "--quiet", "--dirty", "--config-file", settings], check=True,
                           env={**os.environ, "PYTHONPATH": search, "PYTHONDONTWRITEBYTECODE": "1"})
        (self.output / "404.html").unlink(missing_ok=True)  # its links need the site's address
        for page in self.pages:
            self.finish(page)

    def play(self, program):
        """Records the gallery's interactive scenes, and links them beside their names."""
        spec = importlib.util.spec_from_file_location("gallery", self.checkout / "docs/gallery/make.py")
        gallery = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(gallery)
        page = self.output / "docs/gallery.html"
        text = page.read_text(encoding="utf-8")
        for scene in gallery.INTERACTIVE:
            name = gallery.file_name(scene)
            film = self.output / f"docs/gallery/{name}.html"
            subprocess.run([program, "record", scene, "-o", film, "--force", "--progress", "none"], check=True)
            found = re.search(rf"<strong><a [^>]*>{re.escape(html.escape(scene, quote=False))}</a></strong>", text)
            if found is None:
                self.problems.append(f"docs/gallery.md does not show {scene}, which is interactive; name another scene.")
                continue
            text = text[:found.end()] + f' (<a href="gallery/{name}.html">play it</a>)' + text[found.end():]
        page.write_text(text, encoding="utf-8")


def fix_api(folder):
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
    checkout, output = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    output.mkdir(parents=True, exist_ok=True)
    fix_api(output / "api")
    site = Site(checkout, output)
    site.make()
    if len(sys.argv) > 3:
        site.play(sys.argv[3])
    for problem in site.problems:
        print(problem, file=sys.stderr)
    return 1 if site.problems else 0


if __name__ == "__main__":
    sys.exit(main())
