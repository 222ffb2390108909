#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""chapter_links.py SITE_FOLDER

Sees that each chapter of the manual's part on the engine links into the API reference, also where it names members
without their class, and at most once in a section to each name.
"""
import pathlib
import re
import sys

LINK = re.compile(r'<a class="api" href="([^"]*)"')
LEAST = 10
EXPECTED = {
    "02-hello-world": ["b2World", "b2PolygonShape", "SetAsBox", "CreateFixture", "SetSubStepCount"],
    "07-joints": ["b2RevoluteJoint", "GetJointAngle()", "EnableLimit(flag)", "SetLength(length)"],
    "08-contacts": ["world.SetContactListener(&amp;listener)", "PreSolve", "IsTouching", "SetFriction(f)"],
    "09-world": ["SetSubStepCount", "QueryAABB", "RayCast", "GetProfile"],
    "12-limitations": ["world.SetSubStepCount(4)", "GetAnchorA"],
}

chapters = sorted(pathlib.Path(sys.argv[1]).glob("docs/manual/[0-9]*.html"))
assert len(chapters) == 13, chapters
problems = []
for chapter in chapters:
    text = chapter.read_text(encoding="utf-8")
    count = len(LINK.findall(text))
    if count < LEAST:
        problems.append(f"{chapter.stem}: {count} links into the API reference, not {LEAST}")
    names = {re.sub(r"<[^>]*>", "", name) for name in re.findall(r'<a class="api" [^>]*>(.*?)</a>', text, re.DOTALL)}
    problems += [f"{chapter.stem}: no link at {name}" for name in EXPECTED.get(chapter.stem, []) if name not in names]
    for section in re.split(r"<h[23]\b", text):
        links = LINK.findall(section)
        problems += [f"{chapter.stem}: a section links to {link} twice" for link in set(links) if links.count(link) > 1]
assert not problems, "\n".join(problems)
