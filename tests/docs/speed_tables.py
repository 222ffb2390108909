#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""speed_tables.py CHECKOUT

The tables and charts of the pages are those of docs/speed/*.json, and a run that ended otherwise than its peers has no
ratio.
"""
import importlib.util
import pathlib
import sys

sys.dont_write_bytecode = True
checkout = pathlib.Path(sys.argv[1])
spec = importlib.util.spec_from_file_location("speed", checkout / "docs/speed/speed.py")
speed = importlib.util.module_from_spec(spec)
spec.loader.exec_module(speed)

drawsTheSame = speed.draws_the_same(checkout)
made = speed.drawn(speed.read(checkout)) if drawsTheSame else {}
found = list(speed.findings(checkout, made))
assert not found, found

# Crosses mark only runs that fell or burst, not those that miss a goal.
figures = speed.read(checkout)
missed = [one for result in figures["accuracy"] for one in result["runs"]
          if one["verdict"] == "missed" and not speed.accuracy.ending(one)]
assert missed, "no run misses a goal, so the next line holds nothing"
for result in figures["accuracy"]:
    if result["case"] in speed.CHARTED:
        ours = speed.accuracy.engines_of(result)[0]
        shown = [point for _, _, point in speed.accuracy.points_of(result, ours, 0.0)]
        ended = [one for one in result["runs"] if one["engine"] == ours and speed.accuracy.ending(one)]
        assert {point.x for point in shown if point.mark == "x"} == {one["cpuOfFrame"] * 1e6 for one in ended}, result["case"]

# A step of the peer takes twice as long, but boxreel's run ended at other heights.
sound = {"threads": 1, "finite": True, "escaped": 0, "awake": 0}
ours = {"method": "boxreel 1.0", "ours": True, "verdict": "other heights", "cpu": 0.001, **sound}
peer = {"method": "Box2D 2.4.1", "ours": False, "verdict": "sound", "cpu": 0.002, "cpuTimes": 2.0, **sound}
scene = {"case": "grid", "what": "a grid", "methods": [ours, peer]}


def cells():
    """Of the scene's row: ours and the peer's."""
    row = next(line for line in speed.engine_table({"engine": [scene]}).splitlines() if "a grid" in line)
    return [cell.strip() for cell in row.split("|")[2:4]]


assert cells()[0].startswith("1.00 ms"), cells()
assert cells()[1].startswith("2.00 ms") and "×" not in cells()[1], cells()
scene["methods"] = [{**ours, "verdict": "sound"}, peer]
assert "2.00×" in cells()[1], cells()
scene["methods"][1] = {"method": "Box2D 2.4.1", "ours": False, "failure": "failed", "verdict": "failed"}
assert cells()[1] == "failed", cells()
scene["methods"][1] = {**peer, "verdict": "escaped", "escaped": 7, "cpuTimes": None}
assert "7 escaped" in cells()[1] and "×" not in cells()[1], cells()

# Films and pictures that are not sound are not compared.
films = [{"role": "boxreel", "method": "boxreel record", "frames": 60, "verdict": "sound", "wall": 1.0},
         {"role": "encodeOnly", "method": "ffmpeg 5, which only encodes", "frames": 60, "verdict": "sound", "wall": 2.0},
         {"role": "immediate", "method": "immediate mode", "frames": 60, "verdict": "unlike", "seen": "7 off", "wall": 3.0}]
cases = [{"case": "pyramid", "methods": films}]
assert [row[3:] for row in speed.recording_rows(cases)] == [("ffmpeg 5, which only encodes", 2.0)]
films[0]["verdict"] = "unlike"
assert not list(speed.recording_rows(cases))
works = {work: {"cpu": 0.01} for work in ("full", "together")}
drawn = [{"method": name, "program": program, "usual": True, "ours": name == "boxreel", "threads": "0", "wrong": "", "works": works}
         for name, program in (("boxreel", "boxreel_render_bench"), ("Cairo 1.16.0", "boxreel_render_bench_cairo"))]
cases = [{"case": "1500-720p", "methods": drawn}]
assert [row[0] for row in speed.drawing_rows(cases)] == ["frame", "frame changed"]
drawn[1]["wrong"] = "empty"
assert not list(speed.drawing_rows(cases))
