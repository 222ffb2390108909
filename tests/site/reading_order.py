#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""reading_order.py CHECKOUT

Sees that the site's list of pages leads through the manual as its contents do, that it names every page once, and that
Markdown, anchors and names of the API become what MkDocs needs.
"""
import importlib.util
import json
import pathlib
import re
import sys
import tempfile

sys.dont_write_bytecode = True
checkout = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(checkout / "docs/site"))
spec = importlib.util.spec_from_file_location("site_py", checkout / "docs/site/site.py")
site_py = importlib.util.module_from_spec(spec)
spec.loader.exec_module(site_py)
import site_slug  # noqa: E402

with tempfile.TemporaryDirectory() as output:
    site = site_py.Site(checkout, pathlib.Path(output))
    listed = re.findall(r"^(\d+)\. \[", (checkout / site_py.CONTENTS).read_text(encoding="utf-8"), re.MULTILINE)
    assert [int(number) for number in listed] == list(range(1, len(site.chapters) + 1)), listed
    assert len(site.chapters) == len(set(site.chapters)) > 20, site.chapters

    settings = json.loads(site.configuration(pathlib.Path("sources")).replace("!!python/name:site_slug.github ", "0"))
    pages = [(title, page) for group in settings["nav"] for title, entries in group.items() for entry in entries for page in entry.values()]
    manual = [pathlib.Path(page) for title, page in pages if title.startswith("Manual")]
    assert manual == [site_py.CONTENTS] + site.chapters, manual
    assert len({page for _, page in pages}) == len(pages) == len(site.pages)

    site.api = {"b2World": "classb2_world.html", "b2World::Step": "classb2_world.html#step"}
    body = "<p><code>b2World</code>, <code>b2World</code>, <code>b2World::Step()</code>, <a>in <code>b2World::Step</code></a></p>"
    referred = site.referred(body, pathlib.Path("docs/manual/a.md"))
    assert re.findall(r'href="([^"]*)"', referred) == ["../../api/classb2_world.html", "../../api/classb2_world.html#step"], referred
    assert re.sub(r'<a class="api"[^>]*>(.*?)</a>', r"\1", referred) == body

assert site_py.for_mkdocs("Text:\n- a\n  - b\n    more\n- c\n") == "Text:\n\n- a\n    - b\n        more\n- c\n"
assert site_py.for_mkdocs("1. a\n   ```\n   - code\n   ```\n\nend\n") == "1. a\n    ```\n    - code\n    ```\n\nend\n"
assert site_slug.github("12. What `b2Body::SetType` costs, and why", "-") == "12-what-b2bodysettype-costs-and-why"
