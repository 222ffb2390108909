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


def placed(curves, floor=(0.0, "")):
    """Of the labels of a chart their boxes, and of a point (x, y) its place, both in pixels."""
    from matplotlib.figure import Figure
    figure = Figure(figsize=(10.4, 6.8))
    axes = figure.add_axes([0.09, 0.15, 0.88, 0.65])
    speed.charts.draw_lines(axes, speed.charts.Lines({"x": "x", "y": "y"}, curves, floor), "black", "grey")
    return {text.get_text(): text.get_window_extent() for text in figure.texts}, axes.transData.transform


# No other curve is between a label and its mark, and no label is on the line of the floor. An optional one that is as near
# to another mark is left out.
if drawsTheSame:
    Curve, Point = speed.charts.Curve, speed.charts.Point
    ends = Curve("ends", 1, "", [Point(1.0, 0.01), Point(10.0, 100.0)])
    line = Curve("line", 0, "-", [Point(1.0, 1.45), Point(10.0, 1.45)])
    slope = Curve("slope", 2, "-", [Point(2.8, 0.4), Point(3.0, 1.0, "spot"), Point(3.2, 0.4)])
    beside = Curve("beside", 1, "", [Point(x, y) for x in (2.5, 2.65, 2.8, 3.21, 3.4, 3.6) for y in (0.7, 1.0)])
    labels, place = placed([ends, line, slope, beside])
    assert "spot" not in labels or labels["spot"].y1 < place((3.0, 1.45))[1], labels
    near = [Curve("near", 1, "", [Point(x, y) for x, y in ((2.75, 1.5), (3.27, 1.5), (3.0, 2.7), (3.0, 0.83))])]
    labels, place = placed([ends, *near, Curve("crowd", 2, "", [Point(3.0, 1.5, "crowded")])])
    assert "crowded" not in labels, labels
    labels, place = placed([ends, Curve("low", 2, "", [Point(3.0, 0.01, "480 Hz", optional=False)])], (0.01, "floor"))
    assert not labels["480 Hz"].y0 <= place((3.0, 0.01))[1] <= labels["480 Hz"].y1, labels
