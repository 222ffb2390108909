#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""speed_tables.py CHECKOUT

Sees that the tables and charts of the pages say what docs/speed/*.json say, that what is planted there and does not is
found, and that a run which ended otherwise than its peers gets no ratio.
"""
import importlib.util
import pathlib
import re
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True
checkout = pathlib.Path(sys.argv[1])
spec = importlib.util.spec_from_file_location("speed", checkout / "docs/speed/speed.py")
speed = importlib.util.module_from_spec(spec)
spec.loader.exec_module(speed)

drawsTheSame = speed.draws_the_same(checkout)
made = speed.drawn(speed.read(checkout)) if drawsTheSame else {}
found = list(speed.findings(checkout, made))
assert not found, found


def plant(path, old, new):
    """In a copy of the pages and figures: what is found when the first `old` of a file is `new`."""
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder)
        for part in ("docs/speed", "docs/figures"):
            shutil.copytree(checkout / part, copy / part, ignore=shutil.ignore_patterns("src"))
        for page in speed.PAGES:
            shutil.copyfile(checkout / page, copy / page)
        text = (copy / path).read_text(encoding="utf-8")
        changed = re.sub(old, new, text, count=1)
        assert changed != text, (path, old)
        (copy / path).write_text(changed, encoding="utf-8")
        return list(speed.findings(copy, made))


said = "is not what docs/speed/*.json say"
for path, old, new, names in (
        ("README.md", r"(\| \d+)(\.\d+ ms)", r"\g<1>7\2", ["'short'"]),
        ("docs/speed.md", r"(Cairo [\d.]+: )", r"\g<1>9", ["'toolkit'"]),
        ("docs/speed.md", r"\| scene \|[^\n]*\n", "", ["'engine'"]),
        ("docs/speed.md", r"Measured on \d", "Measured on 9", ["'machine'"]),
        ("docs/accuracy.md", r"(H-cradle +)0.1", r"\g<1>0.2", ["'accuracy'"]),
        ("docs/speed/drawing.json", r'("cpu": )', r"\g<1>1", ["'short'", "'toolkit'"])):
    found = plant(path, old, new)
    tables = [line for line in found if said in line and line.startswith("The table")]
    assert len(tables) == len(names) and all(name in line for name, line in zip(names, tables)), (path, old, found)
found = plant("docs/speed.md", "<!-- table: engine -->", "")
assert any("No page has the table 'engine'" in line for line in found), found
found = plant("docs/speed.md", "golden --rounds 3", "golden --rounds 1")
assert len(found) == 1 and "does not show what measures" in found[0], found
if drawsTheSame:
    found = plant("docs/speed/engine-dark.svg", "#e6edf3", "#e6edf4")
    assert len(found) == 1 and "engine-dark.svg" in found[0], found
    found = plant("docs/figures/accuracy-I-pair-light.svg", "#1f2328", "#1f2329")
    assert len(found) == 1 and "accuracy-I-pair-light.svg" in found[0], found
else:
    print("charts are not compared: the matplotlib that drew them is not installed (Debian 12: python3-matplotlib)")

# A step of the peer takes twice as long, but boxreel's run ended at other heights.
sound = {"threads": 1, "finite": True, "escaped": 0, "awake": 0}
ours = {"method": "boxreel 1.0", "ours": True, "verdict": "other heights", "cpu": 0.001, **sound}
peer = {"method": "Box2D 2.4.1", "ours": False, "verdict": "sound", "cpu": 0.002, "cpuTimes": 2.0, **sound}
scene = {"case": "grid", "what": "a grid", "methods": [ours, peer]}
table = speed.engine_table({"engine": [scene]})
assert "| a grid | 1.00 ms | 2.00 ms (not compared) |" in table and "other heights" in table, table
scene["methods"] = [{**ours, "verdict": "sound"}, peer]
assert "| a grid | 1.00 ms | 2.00 ms (2.00×) |" in speed.engine_table({"engine": [scene]})
scene["methods"][1] = {"method": "Box2D 2.4.1", "ours": False, "failure": "it crashed", "verdict": "it crashed"}
assert "| a grid | 1.00 ms | it crashed |" in speed.engine_table({"engine": [scene]})
scene["methods"][1] = {**peer, "verdict": "7 escaped", "escaped": 7, "cpuTimes": None}
assert "| a grid | 1.00 ms | 2.00 ms (7 escaped) |" in speed.engine_table({"engine": [scene]})

# Films and pictures that are not sound are not compared.
films = [{"role": "boxreel", "method": "boxreel record", "frames": 60, "verdict": "sound", "wall": 1.0},
         {"role": "encodeOnly", "method": "ffmpeg 5, which only encodes", "frames": 60, "verdict": "sound", "wall": 2.0},
         {"role": "immediate", "method": "immediate mode", "frames": 60, "verdict": "7 off", "wall": 3.0}]
cases = [{"case": "pyramid", "methods": films}]
assert [row[3:] for row in speed.recording_rows(cases)] == [("ffmpeg 5, which only encodes", 2.0)]
films[0]["verdict"] = "grey"
assert not list(speed.recording_rows(cases))
works = {work: {"cpu": 0.01} for work in ("full", "together")}
drawn = [{"method": name, "ours": name == "boxreel", "threads": "0", "wrong": "", "works": works}
         for name in ("boxreel", "Cairo 1.16.0")]
cases = [{"case": "1500-720p", "methods": drawn}]
assert [row[0] for row in speed.drawing_rows(cases)] == ["frame", "frame changed"]
drawn[1]["wrong"] = "empty"
assert not list(speed.drawing_rows(cases))
