# SPDX-License-Identifier: MIT
"""Drawing timed beside Cairo: CPU time of a frame against the error at edges."""
from __future__ import annotations

from pathlib import Path
from typing import Any

from . import charts
from .common import TEXTS, Benchmark, Result, median_of, objects, run, value_at

GOALS = {"full": "full redraw [ms]", "together": "5 % changed together [ms]", "apart": "5 % changed apart [ms]",
         "none": "unchanged [ms]"}
STROKES = {"full": "-", "together": "--", "apart": ":"}


def single(result: Result) -> dict[str, Result]:
    """The methods that ran with one raster thread, by name; ours is the first."""
    return {one["method"]: one for one in result["methods"] if one["threads"] == "0"}


class Drawing(Benchmark):
    """Pictures of several sizes and numbers of shapes."""
    name, program, peers = "render", "boxreel_render_bench", {"boxreel_render_bench_cairo": "libcairo2-dev"}

    def parts(self, cases: list[Result]) -> list[str]:
        """A chart a height."""
        return list(dict.fromkeys(f"{case['height']}p" for case in cases))

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
        for one in (one for one in result["methods"] if "floor" in one["works"]):
            one["overFloor"] = value_at(one, "works.empty.cpu") / value_at(one, "works.floor.cpu")
        ours = next(one for one in result["methods"] if one["ours"] and one["threads"] == "0")
        result["reached"] = {figure: ours["works"][work]["cpu"] * 1e3 if not ours["wrong"] else None
                             for work, figure in GOALS.items() if work in ours["works"]}
        result["reached"] |= {"empty over clear and read": ours.get("overFloor"), "RMSE at edges": ours["rms"]}

    def drawn(self, results: list[Result]) -> dict[str, Any]:
        """A chart for each height of the pictures; of methods that draw the same the first."""
        made = {}
        for height in dict.fromkeys(result["height"] for result in results):
            sizes = sorted((result for result in results if result["height"] == height), key=lambda one: one["shapes"])
            kept: dict[tuple, str] = {}
            for name in dict.fromkeys(name for result in sizes for name in single(result)):
                kept.setdefault(tuple(single(result).get(name, {}).get("rms") for result in sizes), name)
            curves = []
            for color, (work, stroke), name in ((color, kind, name) for color, name in enumerate(kept.values())
                                                for kind in STROKES.items()):
                found = [(result, single(result)[name]) for result in sizes
                         if work in single(result).get(name, {"works": ()})["works"]]
                curves += [charts.Curve(name, color, stroke, [charts.Point(
                    one["works"][work]["cpu"] * 1e3, one["rms"], f"{result['shapes']:,}" if len(sizes) > 1 else work,
                    optional=work != "full") for result, one in found])] if found else []
            title = TEXTS["render"]["title"].format(sizes[0]["width"], height)
            made[f"{height}p"] = charts.Lines({**TEXTS["render"], "title": title}, curves)
        return made
