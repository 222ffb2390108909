# SPDX-License-Identifier: MIT
"""Cases whose truth is known: error against CPU time, for each engine with many settings."""
import itertools
import math
from pathlib import Path
from typing import Iterator

from . import charts
from .common import (GOALS, TEXTS, Benchmark, Result, attempt, is_number, missed_goals, note, objects, run, table, time_text,
                     times_text, verdict_text)
from .engine import GOAL_PROGRAM, PEERS

SETTINGS = ("velocityIterations", "positionIterations", "hz", "subSteps")
SWEEP = (((4, 2), (8, 3), (20, 10), (50, 20)), (60, 120, 240, 480), (1, 2, 4, 8, 16))
LONG = 0.3  # [s]; what takes longer by itself is timed once, for a sweep takes minutes
VARIED = {"subSteps": ("-", " sub-steps"), "hz": ("--", " Hz"), "velocityIterations": (":", "")}  # strokes, and units


def ending(one: Result) -> str:
    """The verdict on a run that has no error to compare, or empty."""
    finite = "failure" in one or one["held"] and (one["ending"] or is_number(one["error"]))
    return one.get("failure", one.get("ending")) if finite else "not finite"


def engines_of(result: Result) -> list[str]:
    """In the order in which they first come; ours is the first."""
    return list(dict.fromkeys(one["engine"] for one in result["runs"]))


def usual(result: Result, engine: str, steps: int = 4) -> Result:
    """An engine's run with 8/3 iterations at 60 Hz, with so many sub-steps if it has any."""
    own = [one for one in result["runs"] if one["engine"] == engine]
    wanted = [8, 3, 60, steps if any(one["subSteps"] > 1 for one in own) else 1]
    return next((one for one in own if [one[key] for key in SETTINGS] == wanted), {"failure": "not run", "verdict": "not run"})


def summary(results: list[Result], steps: int, with_goals: bool = True) -> str:
    """A row a case: what every engine reaches with its usual settings, ours with so many sub-steps."""
    first, *others = engines_of(results[0])
    rows = [[f"{steps} sub-steps", "goal", "", first, "", *(cell for name in others for cell in (name, "", "")), ""]]
    for result in results:
        ours, *peers = [usual(result, engine, steps) for engine in (first, *others)]
        goal = GOALS["accuracy"].get(result["case"], {}).get("error")
        row = [result["case"], f"{goal[1]:g}" if goal else "", result["unit"]]
        for one in (ours, *peers):
            timed = "failure" not in one and "failure" not in ours
            times = [time_text(one["cpu"]), times_text(one["cpu"] / ours["cpu"])] if timed else ["", ""]
            row += [verdict_text(one, result) if ending(one) else f"{one['error']:.3g}", *times[:1 if one is ours else 2]]
        slower = any(one.get("program") == GOAL_PROGRAM and one.get("cpu", math.inf) < ours.get("cpu", 0.0) for one in peers)
        words = verdict_text(ours, result)
        rows.append([*row, words + ", slower" * slower if ours["verdict"] == "met" else f"goal not met {words}"])
    ways = "<>>>>" + ">>>" * len(others)
    return table(ways + "<", rows) if with_goals else table(ways[:-1], [[row[0], *row[2:-1]] for row in rows])


def points_of(result: Result, engine: str, floor: float) -> Iterator[tuple[str, str, charts.Point]]:
    """Curves of the settings that vary, one of them along each, and all other settings as specks."""
    base = usual(result, engine)
    own = rest = [one for one in result["runs"] if one["engine"] == engine and "failure" not in one]

    def point(one: Result, label: str = "", optional: bool = True) -> charts.Point:
        mark = "x" if ending(one) else "o" if one is base else "." if label else "speck"
        error = max(one["error"], floor) if is_number(one["error"]) else None
        return charts.Point(one["cpuOfFrame"] * 1e6, error, label, mark, optional)

    for key, (stroke, unit) in VARIED.items():
        line = sorted((one for one in own if all(one[other] == base.get(other) for other in VARIED if other != key)),
                      key=lambda one: one[key])
        for one in line if len(line) > 1 else []:
            is_last = unit and one is line[-1]
            words = f"{one[key]}{unit * is_last}" if unit else f"{one[SETTINGS[0]]}/{one[SETTINGS[1]]}"
            is_shown = key == "subSteps" or one is not base  # the usual settings are on every curve
            yield engine, stroke, point(one, words if is_shown else "", not is_last and one is not base)
            rest = [other for other in rest if other is not one]
    yield from ((engine, "", point(one)) for one in rest)


class Accuracy(Benchmark):
    """Cases with a sweep of settings each."""
    name, program, peers, list_words = "accuracy", "boxreel_bench", PEERS, ["accuracy-list"]
    parts, key = ["{case}"], "runs"

    def measure(self, build: Path, case: Result, options, work: Path) -> Result:
        """All settings of all engines in turn, `rounds` times; the least CPU time counts."""
        # What makes a run longer is the machine's, which has slow spells that are longer than a run.
        sweeps = []
        for path in self.programs(build, options):
            most = 4 if options.against else objects(run([path, *self.list_words]).output)[0]["maxSubSteps"]
            sweeps.append([(path, (*iterations, hz, steps)) for iterations, hz, steps in itertools.product(*SWEEP)
                           if steps <= most])
        turns = [entry for turn in itertools.zip_longest(*sweeps) for entry in turn if entry]
        runs = {(path, settings): dict(zip(SETTINGS, settings)) | attempt(path, "accuracy", case["case"], *settings)
                for path, settings in turns}
        for (path, settings), one in list(runs.items()) * (options.rounds - 1):
            if "failure" not in one and 0.0 < one["cpu"] * one["steps"] < LONG:
                again = run([path, "accuracy", case["case"], *settings, one["steps"]])
                one["cpu"] = min(one["cpu"], objects(again.output)[-1]["cpu"])
        return {**case, "runs": [runs[entry] for sweep in sweeps for entry in sweep]}

    def judge(self, result: Result) -> None:
        """Goals are for the error and for remarks. Settings are compared by the CPU time for 1/60 s, in any number of steps."""
        for one in result["runs"]:
            one["verdict"] = ending(one) or ("missed" if missed_goals(one, result) else "met")
            if "failure" not in one:
                one["cpuOfFrame"] = one["cpu"] * one["hz"] / 60.0

    def text(self, results: list[Result]) -> str:
        return "\n".join([super().text(results), summary(results, 2), summary(results, 4)])

    def drawn(self, results: list[Result]) -> dict:
        made = {}
        for result in results:
            if all(ending(one) for one in result["runs"]):
                note(f"no run of '{result['case']}' held, so there is nothing to draw")
                continue
            _, goal = GOALS["accuracy"].get(result["case"], {}).get("error", ["<=", 0.0])
            floor = 10.0 ** math.floor(math.log10(goal) - 3.5) if goal > 0.0 else 0.5  # nothing has no logarithm
            texts = TEXTS["accuracy"] | {"title": result["case"], "subtitle": result["what"]}
            texts["y"] = texts["y"].format(result["unit"])
            curves = charts.curves_of(one for engine in engines_of(result) for one in points_of(result, engine, floor))
            made[result["case"]] = charts.Lines(texts, curves, (floor, f"≤ {floor:g}" if goal > 0.0 else "0"))
        return made
