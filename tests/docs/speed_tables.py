#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""speed_tables.py CHECKOUT [PROGRAM]

Sees that the tables and the chart of README.md and docs/speed.md say what docs/speed/*.json say, that what is planted
there and does not is found, and that a run which ended otherwise than its peers gets no ratio.
"""
import importlib.util
import json
import pathlib
import re
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True
checkout = pathlib.Path(sys.argv[1])
program = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
spec = importlib.util.spec_from_file_location("speed", checkout / "docs/speed/speed.py")
speed = importlib.util.module_from_spec(spec)
spec.loader.exec_module(speed)

found = list(speed.findings(checkout, program))
assert not found, found


def plant(path, old, new):
    """In a copy of the pages and figures: what is found when the first `old` of a file is `new`."""
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder)
        shutil.copytree(checkout / "docs/speed", copy / "docs/speed")
        for page in speed.PAGES:
            shutil.copyfile(checkout / page, copy / page)
        text = (copy / path).read_text(encoding="utf-8")
        changed = re.sub(old, new, text, count=1)
        assert changed != text, (path, old)
        (copy / path).write_text(changed, encoding="utf-8")
        return list(speed.findings(copy, program))


said = "is not what docs/speed/*.json say"
for path, old, new, names in (
        ("README.md", r"(\| \d+)(\.\d+ ms)", r"\g<1>7\2", ["'short'"]),
        ("docs/speed.md", r"(Cairo [\d.]+: )", r"\g<1>9", ["'toolkit'"]),
        ("docs/speed.md", r"\| scene \|[^\n]*\n", "", ["'engine'"]),
        ("docs/speed.md", r"Measured on \d", "Measured on 9", ["'machine'"]),
        ("docs/speed/drawing.json", r'("cpuSeconds": )', r"\g<1>1", ["'short'", "'toolkit'"])):
    found = plant(path, old, new)
    tables = [line for line in found if said in line and line.startswith("The table")]
    assert len(tables) == len(names) and all(name in line for name, line in zip(names, tables)), (path, old, found)
found = plant("docs/speed.md", "<!-- table: engine -->", "")
assert any("No page has the table 'engine'" in line for line in found), found
found = plant("docs/speed.md", "--golden --rounds 3", "--golden --rounds 1")
assert len(found) == 1 and "does not show what measures" in found[0], found
if program:
    found = plant("docs/speed/engine.svg", r"rgb\(0%,55%,42%\)", "rgb(84%,37%,0%)")  # a bar of the other engine's colour
    assert len(found) == 1 and "engine.svg" in found[0], found

# A step of the peer takes twice as long, but boxreel's run ended at other heights.
peer = {"engine": "Box2D 2.4.1", "verdict": "sound", "finite": True, "cpuSeconds": 0.002}
ours = {"engine": "boxreel 1.0", "verdict": "heights 9 (8)", "finite": True, "cpuSeconds": 0.001}
scene = {"scene": "grid", "what": "a grid", "engines": [ours, {**peer, "cpuRatioNotComparable": 2.0}]}
table = speed.engine_table({"engine": {"scenes": [scene]}})
assert "| a grid | 1.00 ms | 2.00 ms (not compared) |" in table and "heights 9 (8)" in table, table
scene["engines"] = [{**ours, "verdict": "sound"}, {**peer, "cpuRatio": 2.0}]
assert "| a grid | 1.00 ms | 2.00 ms (2.00×) |" in speed.engine_table({"engine": {"scenes": [scene]}})
scene["engines"][1] = {"engine": "Box2D 2.4.1", "failure": "it crashed", "verdict": "it crashed"}
assert "| a grid | 1.00 ms | it crashed |" in speed.engine_table({"engine": {"scenes": [scene]}})

# Films and pictures that are not sound are not compared.
films = [{"role": "boxreel", "method": "boxreel record", "frames": 60, "verdict": "sound", "wallSeconds": 1.0},
         {"role": "encodeOnly", "method": "ffmpeg 5", "frames": 60, "verdict": "sound", "wallSeconds": 2.0},
         {"role": "immediate", "method": "immediate mode", "frames": 60, "verdict": "7 off", "wallSeconds": 3.0}]
cases = {"cases": [{"case": "pyramid", "methods": films}]}
assert [row[3:] for row in speed.recording_rows(cases)] == [("ffmpeg 5, which only encodes", 2.0)]
films[0]["verdict"] = "grey"
assert not list(speed.recording_rows(cases))
frames = {work: {"cpuSeconds": 0.01} for work in ("full", "together")}
drawn = [{"method": name, "ours": name == "boxreel", "rasterThreads": "0", "wrong": "", "frames": frames}
         for name in ("boxreel", "Cairo 1.16.0")]
cases = {"cases": [{"case": "1500-720p", "methods": drawn}]}
assert [row[0] for row in speed.drawing_rows(cases)] == ["frame", "frame changed"]
drawn[1]["wrong"] = "empty"
assert not list(speed.drawing_rows(cases))

assert [speed.time_text(t) for t in (2.5e-8, 3.5e-4, 0.00726, 3.22)] == ["0.025 µs", "350 µs", "7.26 ms", "3.22 s"]
assert [speed.times_text(t) for t in (0.284, 6.95, 31.42, 12345.0)] == ["0.28×", "6.95×", "31.4×", "12,300×"]
