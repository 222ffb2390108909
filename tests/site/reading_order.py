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

    site.api = site_py.Api({f"{name}": f"{name.replace('::', '.html#')}" for name in (
        "b2World", "b2World::Step", "b2World::Dump", "b2Body", "b2Body::Dump", "b2Body::SetType", "b2_dynamicBody", "b2Joint",
        "b2Joint::GetAnchorA", "b2RopeJoint", "b2RopeJoint::GetAnchorA", "b2RopeJoint::SetMaxLength", "b2RopeJointDef",
        "b2DistanceJoint", "b2DistanceJoint::SetMaxLength", "Recording", "Recording::Add")}, {"b2RopeJoint": ["b2Joint"]})

    def check(body, *links, page="docs/manual/a.md"):
        referred = site.referred(body, pathlib.Path(page))
        found = re.findall(r'href="../../api/([^"]*)"', referred)
        assert found == list(links), (body, found)
        assert re.sub(r'<a class="api"[^>]*>(.*?)</a>', r"\1", referred) == body

    # Once in a section; not in links and headings; also without code.
    check("<p><code>b2World</code>, <code>b2World</code>, <code>b2World::Step()</code>, <a>in <code>b2World::Step</code></a></p>",
          "b2World", "b2World.html#Step")
    check("<h2><code>b2World</code></h2>a b2World<h2>B</h2><code>b2World</code>", "b2World", "b2World")
    # A member that one class has, with its arguments, and of an object.
    check("<code>SetType</code> <code>SetType(a)</code>", "b2Body.html#SetType")
    check("<code>body-&gt;SetType(b2_dynamicBody)</code>", "b2Body.html#SetType")
    check("<code>Add</code>")
    check("<code>Add</code>", "Recording.html#Add", page="docs/examples/a.md")
    # A member that several have: that of the chapter's subject, of the class named last, of the only one named; or none.
    check("<code>b2Body</code><code>Dump</code>", "b2Body", "b2World.html#Dump", page="docs/manual/09-world.md")
    check("<code>b2World</code><code>b2Body</code><code>Dump</code>", "b2World", "b2Body", "b2Body.html#Dump")
    check("<code>b2RopeJointDef</code><code>SetMaxLength(m)</code>", "b2RopeJointDef", "b2RopeJoint.html#SetMaxLength")
    check("<code>Dump</code><h2>A</h2><code>b2Body</code>", "b2Body.html#Dump", "b2Body")
    check("<code>Dump</code><h2>A</h2><code>b2Body</code><code>b2World</code>", "b2Body", "b2World")
    check("<code>b2Body</code><code>it.Dump()</code>", "b2Body")
    # A member that overrides its base's is that of the base.
    check("<code>GetAnchorA</code>", "b2Joint.html#GetAnchorA")
    # In a listing: classes and members that one class has, in C++ only.
    listing = '<pre><span class="n">b2World</span> <span class="nf">Dump</span><span class="o">-&gt;</span><span class="n">Step</span></pre>'
    check(f'<div class="language-cpp highlight">{listing}</div>', "b2World", "b2World.html#Step")
    check(f'<div class="language-py highlight">{listing}</div>')

assert site_py.for_mkdocs("Text:\n- a\n  - b\n    more\n- c\n") == "Text:\n\n- a\n    - b\n        more\n- c\n"
assert site_py.for_mkdocs("1. a\n   ```\n   - code\n   ```\n\nend\n") == "1. a\n    ```\n    - code\n    ```\n\nend\n"
assert site_slug.github("12. What `b2Body::SetType` costs, and why", "-") == "12-what-b2bodysettype-costs-and-why"
