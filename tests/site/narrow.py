#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""narrow.py SITE_FOLDER

Sees that pages of the API reference are not cut on a screen of 500 pixels: each declaration ends within the screen.
Exit code 77: there is no Chromium.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PAGES = ["classb2World.html", "classb2Body.html", "classboxreel_1_1Recording.html"]
SCRIPT = """<script>addEventListener("load", () => setTimeout(() => {
  const cells = [...document.querySelectorAll(".contents td.memItemRight, .contents td.mdescRight, .contents div.memdoc")];
  const ends = cells.map(cell => Math.max(cell.getBoundingClientRect().right, cell.getBoundingClientRect().left + cell.scrollWidth));
  document.body.dataset.cells = cells.length;
  document.body.dataset.end = Math.max(...ends) - document.documentElement.clientWidth;
}, 200));</script>"""

site, chromium = sys.argv[1], shutil.which("chromium")
if chromium is None:
    print("skipped: no Chromium is installed (apt install chromium)")
    sys.exit(77)
problems = []
for name in PAGES:
    page = pathlib.Path(site) / "api" / name
    with tempfile.TemporaryDirectory() as folder, tempfile.NamedTemporaryFile("w", suffix=".html", dir=page.parent) as file:
        file.write(page.read_text(encoding="utf-8").replace("</head>", SCRIPT + "</head>"))
        file.flush()
        made = subprocess.run([chromium, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}", "--window-size=500,1000",
                               "--virtual-time-budget=3000", "--dump-dom", f"file://{file.name}"], capture_output=True, text=True, check=True).stdout
    cells, end = (re.search(f'data-{key}="([-.0-9]+)"', made) for key in ("cells", "end"))
    if cells is None or end is None or int(cells[1]) < 5:
        problems.append(f"{name}: it could not be measured")
    elif float(end[1]) > 0.0:
        problems.append(f"{name}: declarations end {float(end[1]):.0f} pixels beyond the screen")
assert not problems, "\n".join(problems)
