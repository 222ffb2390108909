# SPDX-License-Identifier: MIT
"""Drawing timed beside Cairo: CPU time of a frame against the error at edges."""
from __future__ import annotations

from pathlib import Path
from typing import Any

from . import charts
from .common import Benchmark, Result, digits, goal_table, median_of, objects, run, table

WORKS = {"full": "full", "together": "together", "apart": "apart", "none": "unchanged", "empty": "empty",
         "floor": "clear+read"}  # kinds of frames, and their columns
GOALS = {"full": "full redraw [ms]", "together": "5 % changed together [ms]", "apart": "5 % changed apart [ms]",
         "none": "unchanged [ms]"}
STROKES = {"full": ("-", "all shapes changed"), "together": ("--", "5 % changed, together"),
           "apart": (":", "5 % changed, apart")}
NOTES = ["Error (RMSE): root mean square of the differences from 16 × 16 samples a pixel, over the red, green and blue of "
         "the pixels", "whose samples are not all alike, in steps of 8 bits."]


def time_of(one: Result, work: str, clock: str = "cpu") -> float | None:
    """Of a kind of frame; who draws all of it whatever has changed has not all kinds."""
    return one["works"].get(work, {}).get(clock)


def over_floor(one: Result) -> float | None:
    """A frame without shapes over clearing and reading."""
    return time_of(one, "empty") / time_of(one, "floor") if "floor" in one["works"] else None


def single(result: Result) -> dict[str, Result]:
    """The methods that ran with one raster thread, by name; ours is the first."""
    return {one["method"]: one for one in result["methods"] if one["threads"] == "0"}


def milliseconds(seconds: float | None) -> str:
    """Of a frame, with four places where it is less than 0.1 ms."""
    return "–" if seconds is None else f"{seconds * 1e3:.4f}" if seconds < 1e-4 else digits(seconds * 1e3)


class Drawing(Benchmark):
    """Pictures of several sizes and numbers of shapes."""
    name, what, program = "render", "time drawing beside Cairo: error at edges against time", "boxreel_render_bench"
    peers = {"boxreel_render_bench_cairo": "libcairo2-dev"}

    def measure(self, build: Path, case: Result, options: Any, work: Path) -> Result:
        """Errors once, times `rounds` times in turn. Ours with one raster thread, and with the user's."""
        ours, *peers = self.programs(build, options)
        entries = [(ours, "0"), *([] if options.against else [(ours, "own")]), *((peer, "0") for peer in peers)]
        errors = [objects(run([path, "error", case["case"]]).output) for path, _ in entries]
        rounds = [[objects(run([path, "time", case["case"], threads]).output) for path, threads in entries]
                  for _ in range(options.rounds)]
        methods = []
        for index, (path, threads) in enumerate(entries):
            for error, *times in zip(errors[index], *(one[index] for one in rounds)):
                wrong = next((time["wrong"] for time in times if time["wrong"]), "")  # frames unlike one from scratch
                methods.append({**error, **median_of(times), "wrong": wrong, "ours": path is ours, "threads": threads})
        return {**case, "methods": methods}

    def judge(self, result: Result) -> None:
        """Goals are for ours with one raster thread."""
        ours = next(one for one in result["methods"] if one["ours"] and one["threads"] == "0")
        result["reached"] = {figure: time_of(ours, work) * 1e3 if not ours["wrong"] else None
                             for work, figure in GOALS.items() if work in ours["works"]}
        result["reached"] |= {"empty over clear and read": over_floor(ours), "RMSE at edges": ours["rms"]}

    def text(self, results: list[Result]) -> str:
        """A row a method: CPU times of frames, and the wall time of a full one."""
        rows = [["case", "method", "threads", *WORKS.values(), "over floor", "wall", "RMSE", "max", ""]]
        for result in results:
            for one in result["methods"]:
                rows.append([
                    result["case"] if one is result["methods"][0] else "", one["method"],
                    "own" if one["threads"] == "own" else "one" if one["ours"] else "",
                    *(milliseconds(time_of(one, work)) for work in WORKS), digits(over_floor(one)),
                    milliseconds(time_of(one, "full", "wall")), digits(one["rms"]), digits(one["most"]),
                    f"wrong: {one['wrong']}" if one["wrong"] else ""])
        return ("CPU time of a frame [ms], wall time of a full one, and the error at edges:\n" + table("<<<>>>>>>>>>><", rows)
                + goal_table("render", results) + "\n" + "\n".join(NOTES) + "\n")

    def drawn(self, results: list[Result]) -> dict[str, charts.Lines]:
        """A chart for each height of the pictures; of methods that draw the same the first."""
        made = {}
        for height in dict.fromkeys(result["height"] for result in results):
            sizes = sorted((result for result in results if result["height"] == height), key=lambda one: one["shapes"])
            kept: dict[tuple, str] = {}
            for name in dict.fromkeys(name for result in sizes for name in single(result)):
                kept.setdefault(tuple(single(result).get(name, {}).get("rms") for result in sizes), name)
            curves = [charts.Curve(name, color, stroke, [
                charts.Point(time_of(single(result)[name], work) * 1e3, single(result)[name]["rms"], f"{result['shapes']:,}",
                             optional=work != "full")
                for result in sizes if name in single(result) and time_of(single(result)[name], work)])
                for color, name in enumerate(kept.values()) for work, (stroke, _) in STROKES.items()]
            made[f"{height}p"] = charts.Lines(
                f"Drawing at {sizes[0]['width']} × {height}", "CPU time of a frame, one raster thread, against the error at "
                "edges; along each curve the number of shapes", [curve for curve in curves if curve.points],
                "CPU time of a frame [ms]", "error at edges [1/255]", NOTES, dict(STROKES.values()))
        return made
