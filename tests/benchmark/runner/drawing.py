# SPDX-License-Identifier: MIT
"""Drawing timed beside Cairo: CPU time of a frame against the error at edges."""
from __future__ import annotations

from pathlib import Path
from typing import Any

from . import charts
from .common import Figures, Result, digits, goal_table, median_of, objects, program, run, table, with_peers

WHAT = "time drawing beside Cairo: error at edges against time"
WORKS = {"full": "full", "together": "together", "apart": "apart", "none": "unchanged", "empty": "empty",
         "floor": "clear+read"}  # kinds of frames, and their columns
FAMILIES = {"full": ("-", "all shapes changed"), "together": ("--", "5 % changed, together"),
            "apart": (":", "5 % changed, apart")}
ERROR = ("Error: root mean square of the differences from 16 × 16 samples a pixel, over the red, green and blue of the "
         "pixels", "whose samples are not all alike, in steps of 8 bits.")


def cases(build: Path) -> list[Result]:
    """All pictures."""
    return objects(run([program(build, "boxreel_render_bench"), "list"]).output)


def measure(build: Path, case: Result, options: Any, work: Path) -> Result:
    """Errors once, times `rounds` times in turn. Ours with one raster thread, and with the user's."""
    ours, *peers = with_peers(build, "boxreel_render_bench", {"boxreel_render_bench_cairo": "libcairo2-dev"})
    entries = [(ours, "0"), (ours, "own"), *((peer, "0") for peer in peers)]
    errors = [objects(run([path, "error", case["case"]]).output) for path, _ in entries]
    rounds = [[objects(run([path, "time", case["case"], threads]).output) for path, threads in entries]
              for _ in range(options.rounds)]
    methods = []
    for index, (path, threads) in enumerate(entries):
        for error, *times in zip(errors[index], *(one[index] for one in rounds)):
            wrong = next((time["wrong"] for time in times if time["wrong"]), "")  # frames unlike one from scratch
            methods.append({**error, **median_of(times), "wrong": wrong, "ours": path is ours, "threads": threads})
    return {**case, "methods": methods}


def cpu(one: Result, work: str) -> float | None:
    """CPU time of a kind of frame; who draws all of it whatever has changed has not all kinds."""
    return one["works"].get(work, {}).get("cpu")


def over_floor(one: Result, clock: str = "cpu") -> float | None:
    """A frame without shapes over clearing and reading."""
    works = one["works"]
    return works["empty"][clock] / works["floor"][clock] if "floor" in works else None


def single(result: Result) -> dict[str, Result]:
    """The methods that ran with one raster thread, by name; ours is the first."""
    return {one["method"]: one for one in result["methods"] if one["threads"] == "0"}


def judge(result: Result) -> None:
    """Adds what goals are for: ours with one raster thread."""
    ours = next(one for one in result["methods"] if one["ours"] and one["threads"] == "0")
    times = {name: cpu(ours, work) for work, name in (
        ("full", "full redraw [ms]"), ("together", "5 % changed together [ms]"), ("apart", "5 % changed apart [ms]"),
        ("none", "unchanged [ms]"))}
    result["reached"] = {**{name: None if time is None or ours["wrong"] else time * 1e3 for name, time in times.items()},
                         "empty over clear and read": over_floor(ours), "RMSE at edges": ours["rms"]}


def milliseconds(seconds: float | None) -> str:
    """Of a frame, with four places where it is less than 0.1 ms."""
    return "–" if seconds is None else f"{seconds * 1e3:.4f}" if seconds < 1e-4 else digits(seconds * 1e3)


def summary(results: list[Result]) -> str:
    """A row a case: CPU times with one raster thread, and errors."""
    names = list(dict.fromkeys(name for result in results for name in single(result)))
    rows = [["", "", "", "", "", names[0], "", *(cell for name in names[1:] for cell in (name, ""))],
            ["case", "full", "together", "apart", "unchanged", "over floor", "RMSE", *["full", "RMSE"] * (len(names) - 1)]]
    for result in results:
        cells = [result["case"]]
        for name in names:
            one = single(result).get(name, {"works": {}, "rms": None})
            isFirst = name == names[0]
            cells += [milliseconds(cpu(one, work)) for work in (list(WORKS)[:4] if isFirst else ["full"])]
            cells += [*([digits(over_floor(one))] if isFirst else []), digits(one["rms"])]
        rows.append(cells)
    return ("CPU time of a frame with one raster thread [ms], and the error at edges:\n"
            + table("<" + ">" * (len(rows[1]) - 1), rows))


def text(results: list[Result]) -> str:
    """A row a method and clock, goals, and the summary."""
    parts = []
    for result in results:
        rows = [["method", "threads", "ms", *WORKS.values(), "over floor", "RMSE", "max", ""]]
        for one in result["methods"]:
            threads = "own" if one["threads"] == "own" else "one" if one["ours"] else ""
            for cells, clock, rest in (([one["method"], threads, "CPU"], "cpu", [digits(one["rms"]), digits(one["most"]),
                                       f"wrong: {one['wrong']}" if one["wrong"] else ""]), (["", "", "wall"], "wall", [])):
                rows.append([*cells, *(milliseconds(one["works"].get(work, {}).get(clock)) for work in WORKS),
                             digits(over_floor(one, clock)), *rest])
        parts.append(f"{result['case']}: {result['what']}, {result['methods'][0]['edgePixels']:.0f} pixels at edges\n"
                     + table("<<<>>>>>>>>><", rows))
    return "\n".join([*parts, summary(results)]) + goal_table("render", results) + "\n" + "\n".join(ERROR) + "\n"


def drawn(results: list[Result]) -> dict[str, charts.Lines]:
    """A chart for each height of the pictures; of methods that draw the same the first."""
    made = {}
    for height in dict.fromkeys(result["height"] for result in results):
        sizes = sorted((result for result in results if result["height"] == height), key=lambda one: one["shapes"])
        kept: dict[tuple, str] = {}
        for name in dict.fromkeys(name for result in sizes for name in single(result)):
            kept.setdefault(tuple(single(result).get(name, {}).get("rms") for result in sizes), name)
        curves = [charts.Curve(name, color, stroke, [
            charts.Point(cpu(single(result)[name], work) * 1e3, single(result)[name]["rms"], f"{result['shapes']:,}",
                         optional=work != "full")
            for result in sizes if name in single(result) and cpu(single(result)[name], work)])
            for color, name in enumerate(kept.values()) for work, (stroke, _) in FAMILIES.items()]
        made[f"{height}p"] = charts.Lines(
            f"Drawing at {sizes[0]['width']} × {height}", "CPU time of a frame, one raster thread, against the error at edges; "
            "along each curve the number of shapes", [curve for curve in curves if curve.points],
            "CPU time of a frame [ms]", "error at edges [1/255]", [*ERROR], dict(FAMILIES.values()))
    return made


def rivals(build: Path, case: Result, options: Any, work: Path) -> Figures:
    """For --against: the CPU time of each kind of frame with one raster thread, and the error."""
    path = program(build, "boxreel_render_bench")
    works = objects(run([path, "time", case["case"], "0"]).output)[0]["works"]
    error = objects(run([path, "error", case["case"]]).output)[0]["rms"]
    return {f"CPU time, {WORKS[name]}": times["cpu"] for name, times in works.items()}, str(error)
