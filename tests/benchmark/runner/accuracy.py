# SPDX-License-Identifier: MIT
"""Cases whose truth is known: error against CPU time, for each engine with many settings."""
from __future__ import annotations

import itertools
import math
from pathlib import Path
from typing import Any

from . import charts
from .common import Figures, GOALS, Problem, Result, is_met, is_number, note, objects, program, run, table, time_text, times_text, with_peers
from .engine import PEERS, is_goal_peer

WHAT = "run cases of known truth: error against time"
SETTINGS = ("velocityIterations", "positionIterations", "hz", "subSteps")
EACH = ("velocityIterationsOfASubStep", "positionIterationsOfASubStep")  # what each sub-step gets of a step's
SWEEP = (((4, 2), (8, 3), (20, 10), (50, 20)), (60, 120, 240, 480), (1, 2, 4, 8, 16))
LONG = 0.3  # [s]; what takes longer by itself is timed once, for a sweep takes minutes
FAMILIES = {"subSteps": ("-", "1 to 16 sub-steps", " sub-steps"), "hz": ("--", "60 to 480 Hz", " Hz"),
            "velocityIterations": (":", "4/2 to 50/20 iterations", "")}  # what varies along a curve


def cases(build: Path) -> list[Result]:
    """All cases."""
    return objects(run([program(build, "boxreel_bench"), "accuracy-list"]).output)


def first_run(path: Path, case: str, settings: tuple[int, ...]) -> Result:
    """The figures of one run with everything looked at, or why there are none."""
    try:
        return objects(run([path, "accuracy", case, *settings]).output)[-1]
    except Problem as problem:
        note(f"{path.name}: {problem}")
        return {"engine": path.name, **dict(zip(SETTINGS, settings)), "failure": "failed"}


def measure(build: Path, case: Result, options: Any, work: Path) -> Result:
    """All settings of all engines in turn, `rounds` times, engine by engine within a round.

    The least CPU time counts: what makes a run longer is the machine's, which has slow spells longer than a run.
    """
    sweeps = []
    for path in with_peers(build, "boxreel_bench", PEERS):
        most = objects(run([path, "accuracy-list"]).output)[0]["maxSubSteps"]
        sweeps.append([(path, (*iterations, hz, steps)) for iterations, hz, steps in itertools.product(*SWEEP)
                       if steps <= most])
    turns = [entry for turn in itertools.zip_longest(*sweeps) for entry in turn if entry]
    runs = {entry: first_run(entry[0], case["case"], entry[1]) for entry in turns}
    for (path, settings), one in list(runs.items()) * (options.rounds - 1):
        if "failure" not in one and 0.0 < one["cpu"] * one["steps"] < LONG:
            again = run([path, "accuracy", case["case"], *settings, one["steps"]])
            one["cpu"] = min(one["cpu"], objects(again.output)[-1]["cpu"])
    return {**case, "runs": [runs[entry] for sweep in sweeps for entry in sweep]}


def of_frame(one: Result) -> float:
    """CPU time for 1/60 s, however many steps that takes: what settings are compared by [s]."""
    return one["cpu"] * one["hz"] / 60.0


def ending(one: Result) -> str:
    """How a run ended that has no error to compare, or empty."""
    return one.get("failure") or one["ending"] or ("" if one["held"] and is_number(one["error"]) else "not finite")


def missed(result: Result, one: Result) -> list[str]:
    """The goals that a run misses, such as "error" or "gap_mm"; none are met by a run that ended otherwise."""
    return [figure for figure, goal in GOALS["accuracy"].get(result["case"], {}).items() if ending(one) or not is_met(
        goal, one["error"] if figure == "error" else one["remarks"].get(figure))]


def remarks(result: Result, one: Result) -> str:
    """The further goals that a run misses, as "gap_mm 0.3 (<= 0.1)"."""
    return ", ".join(f"{figure} {one['remarks'].get(figure)} ({GOALS['accuracy'][result['case']][figure]})"
                     for figure in missed(result, one) if figure != "error" and not ending(one))


def usual(result: Result, engine: str, steps: int = 4) -> Result | None:
    """An engine's run with 8/3 iterations at 60 Hz, with so many sub-steps if it has any."""
    own = [one for one in result["runs"] if one["engine"] == engine]
    steps = steps if any(one["subSteps"] > 1 for one in own) else 1
    return next((one for one in own if [one[key] for key in SETTINGS] == [8, 3, 60, steps]), None)


def engines_of(result: Result) -> list[str]:
    """In the order in which they first come; ours is the first."""
    return list(dict.fromkeys(one["engine"] for one in result["runs"]))


def judge(result: Result) -> None:
    """Verdicts are those of single runs."""
    for one in result["runs"]:
        one["verdict"] = ending(one) or remarks(result, one) or ("" if missed(result, one) else "goal met")


def summary(results: list[Result]) -> str:
    """A row a case: what every engine reaches with its usual settings, ours with 2 and 4 sub-steps."""
    engines = engines_of(results[0])
    parts = ["At 60 Hz with 8/3 iterations: the error, the CPU time of a step, and how many times that of\n"
             "boxreel it is; slower: than Box2D.\n"]
    for steps in (2, 4):
        rows = [[f"{steps} sub-steps", "goal", "", engines[0], "", *(cell for name in engines[1:] for cell in (name, "", ""))]]
        for result in results:
            ours = usual(result, engines[0], steps)
            cells, slower = [result["case"], GOALS["accuracy"].get(result["case"], {}).get("error", "")[3:], result["unit"]], False
            for engine in engines:
                one = usual(result, engine, steps)
                timed = one and ours and "failure" not in one and "failure" not in ours
                ratio = one["cpu"] / ours["cpu"] if timed else 1.0
                slower = slower or (is_goal_peer(engine) and ratio < 1.0)
                cells += [(ending(one) or f"{one['error']:.3g}") if one else "not run", time_text(one["cpu"]) if timed else "",
                          *([times_text(ratio) if timed else ""] if engine != engines[0] else [])]
            met = ours and not missed(result, ours)
            rows.append([*cells, ("goal met, slower" if slower else "goal met") if met else
                         f"goal not met {remarks(result, ours) if ours else ''}"])
        parts.append(table("<>>>>" + ">>>" * (len(engines) - 1) + "<", rows))
    return "\n".join(parts)


def text(results: list[Result]) -> str:
    """A row a run, and the summary."""
    rows = [["case", "engine", "Hz", "iterations", "sub-steps", "each gets", "error", "", "CPU/step", "per 1/60 s", ""]]
    for result in results:
        for one in result["runs"]:
            each = "/".join(str(one[key]) for key in EACH if one.get(key))
            cells = [result["case"], one["engine"], str(one["hz"]), f"{one[SETTINGS[0]]}/{one[SETTINGS[1]]}",
                     str(one["subSteps"]), each]
            rows.append([*cells, *(["–", "", "", ""] if "failure" in one or not is_number(one["error"]) else [
                f"{one['error']:.4g}", result["unit"], time_text(one["cpu"]), time_text(of_frame(one))]), one["verdict"]])
    return table("<<>>>>><>><", rows) + "\n" + summary(results)


def curves_of(result: Result, engine: str, color: int, floor: float) -> list[charts.Curve]:
    """A curve for each setting that varies, and all others as specks."""
    base, left, curves = usual(result, engine), {}, []

    def point(one: Result, label: str = "", optional: bool = True) -> charts.Point:
        failed = ending(one) or remarks(result, one)
        return charts.Point(of_frame(one) * 1e6, max(one["error"], floor) if is_number(one["error"]) else None, label,
                            "x" if failed else "o" if one is base else ".", optional)

    left = {id(one): one for one in result["runs"] if one["engine"] == engine and "failure" not in one}
    own = list(left.values())
    for key, (stroke, _, unit) in FAMILIES.items():
        line = sorted((one for one in own if base and all(
            one[other] == base[other] for other in FAMILIES if other != key)), key=lambda one: one[key])
        points = []
        for one in line if len(line) > 1 else []:
            words = f"{one[SETTINGS[0]]}/{one[SETTINGS[1]]}" if not unit else str(one[key]) + unit * (one is line[-1])
            named = one is not base or key == "subSteps"
            points.append(point(one, words if named else "", optional=not unit or one is not line[-1]))
            left.pop(id(one), None)
        curves += [charts.Curve(engine, color, stroke, points)] if points else []
    return curves + ([charts.Curve(engine, color, "", [point(one) for one in left.values()])] if left else [])


def drawn(results: list[Result]) -> dict[str, charts.Lines]:
    """A chart for each case that held anywhere."""
    made = {}
    for result in results:
        if all(ending(one) for one in result["runs"]):
            note(f"no run of '{result['case']}' held, so there is nothing to draw")
            continue
        goal = float(GOALS["accuracy"].get(result["case"], {}).get("error", "<= 0")[3:])
        floor = 10.0 ** math.floor(math.log10(goal) - 3.5) if goal > 0.0 else 0.5  # nothing has no logarithm
        made[result["case"]] = charts.Lines(
            result["case"], result["what"], [curve for color, engine in enumerate(engines_of(result))
                                             for curve in curves_of(result, engine, color, floor)],
            "CPU time for 1/60 s [µs]", f"error [{result['unit']}]", [
                "Usual: 8 velocity and 3 position iterations, 60 Hz, and 4 sub-steps where there are any. One setting varies "
                "along a curve. Iterations are those of a step,", "split over its sub-steps, at least one each; Chipmunk has "
                "10 for 8/3. At 480 Hz the time is that of eight steps."],
            {stroke: words for stroke, words, _ in FAMILIES.values()},
            {"o": "usual settings", "speck": "all other settings", "x": "falls, bursts or misses a further goal"},
            (floor, "0" if goal <= 0.0 else f"≤ {floor:g}"))
    if not made:
        raise Problem("no run of these cases held, so there is nothing to draw")
    return made


def rivals(build: Path, case: Result, options: Any, work: Path) -> Figures:
    """For --against: the CPU time of a step with the usual settings, and the errors."""
    runs = [first_run(program(build, "boxreel_bench"), case["case"], (8, 3, 60, steps)) for steps in (1, 2, 4)]
    return ({f"CPU time of a step, {one['subSteps']} sub-steps": one["cpu"] for one in runs if "failure" not in one},
            " ".join(str(one.get("error")) for one in runs))
