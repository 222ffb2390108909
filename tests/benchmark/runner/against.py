# SPDX-License-Identifier: MIT
"""Another build timed alternately with this one: ratios of each time of each method, and their spread."""
from pathlib import Path
from typing import Callable

from . import charts
from .common import TEXTS, Benchmark, Result, cell, median_of, time_text, times_text, value_at


def compared(benchmark: Benchmark, case: Result, rounds: int, builds: tuple[Path, Path],
             measure: Callable[[Result, Path, int], Result]) -> list[Result]:
    """A result for each time of each method; this build is the first of both."""
    runs: tuple[list, list] = ([], [])  # of both builds: the methods of each round
    for number in range(rounds):
        for which in (0, 1) if number % 2 == 0 else (1, 0):
            runs[which].append(measure(case, builds[which], 1)[benchmark.key])
    results, texts = [], TEXTS[benchmark.name]
    for index, one in enumerate(runs[0][0]):
        name = " ".join(cell(one, path, kind) for _, path, kind in texts["columns"] if kind == "name").strip()
        same = all(value_at(run[index], key) == value_at(one, key) for run in sum(runs, []) for key in texts["same"])
        for head, path, kind in texts["columns"]:
            if kind == "time" and value_at(one, path):
                pairs = [(value_at(ours[index], path), value_at(other[index], path)) for ours, other in zip(*runs)]
                ratios = [other / ours for ours, other in pairs]
                results.append({"case": case["case"], "what": case["what"], "method": name, "figure": head,
                                "seconds": pairs, "this": median_of([ours for ours, _ in pairs]),
                                "other": median_of([other for _, other in pairs]), "ratio": median_of(ratios),
                                "lowest": min(ratios), "highest": max(ratios), "sameResults": same})
    return results


class Against(Benchmark):
    """The results of `compared`, of any benchmark."""
    name = "against"

    def judge(self, result: Result) -> None:
        """Whether all numbers are there; there are no goals."""
        for figure in ("this", "other", "ratio", "lowest", "highest"):
            result[figure] = float(result[figure])

    def drawn(self, results: list[Result]) -> dict:
        """A bar for each time."""
        groups = [(one["case"], f"{one['method']}: {one['figure']}", time_text(one["this"]),
                   [(one["ratio"], f"{times_text(one['ratio'])} ({one['lowest']:.2f} to {one['highest']:.2f})"
                     + ", other results" * (not one["sameResults"]))]) for one in results]
        return {"": charts.Bars(TEXTS["against"], groups, ["than the other build"])}
