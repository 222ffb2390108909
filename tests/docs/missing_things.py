#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""missing_things.py CHECKOUT

docs/troubleshooting.md explains every error of exit code 3 that the sources and the script have, and every line of
`boxreel doctor`. A part of each text counts as long as it stands between variable parts. Prints a line for each that is
missing; exit code 1 then.
"""
import pathlib
import re
import sys

checkout = pathlib.Path(sys.argv[1])
page = " ".join((checkout / "docs/troubleshooting.md").read_text(encoding="utf-8").split())
LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"')
ERROR = re.compile(r"Error\{\s*ErrorKind::Absent,(.*?)\};", re.DOTALL)
CALL = re.compile(r"(?<!Error )(?:WithCode|Absent|MissingError)\((?!const)(.*?)\);", re.DOTALL)


def problems(path, text):
    """Of each error: the longest of its texts that is neither a remedy nor a fallback."""
    for pattern in (ERROR, CALL):
        for found in pattern.finditer(text):
            texts = [one for one in LITERAL.findall(found[1]) if not re.match(r"install|start it|no reason|choose| or write|$", one)]
            if texts:
                yield path, max(texts, key=len).strip(" ,(")


sources = [path for folder in ("base", "render", "recorder", "debugdraw", "golden", "testbed")
           for path in sorted((checkout / folder).rglob("*.cpp"))]
wanted = [one for path in sources for one in problems(path, path.read_text(encoding="utf-8"))]
assert len(wanted) >= 15, "the sources write errors of exit code 3 in another way"

script = (checkout / "boxreel").read_text(encoding="utf-8")
says = re.findall(r"""say ['"]([^'"$(]*)[^\n]*(?:\n\s*say [^\n]*)?\n\s*exit 3""", script)
assert len(says) == 4, says
wanted += [(checkout / "boxreel", re.split(r"[,;]| so | to install", one)[0].strip()) for one in says]

doctor = checkout / "testbed/cli/Doctor.cpp"
names = re.findall(r'\{"([^"]+)", (?:film|Look)', doctor.read_text(encoding="utf-8"))
names += re.findall(r'add\("(\w+)"|report\.Add\("(\w+)"', doctor.read_text(encoding="utf-8"))
lines = ["".join(one) for one in names]
assert len(lines) >= 14, lines
wanted += [(doctor, f"`{one}`") for one in lines]

missing = [f"{path.relative_to(checkout)}: docs/troubleshooting.md does not have: {text}" for path, text in wanted
           if text not in page]
if "-v" in sys.argv:
    print(*wanted, sep="\n")
print(*missing, sep="\n", end="\n" if missing else "")
sys.exit(1 if missing else 0)
