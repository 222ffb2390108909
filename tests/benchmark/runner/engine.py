# SPDX-License-Identifier: MIT
"""The engine timed beside its peers: CPU time of a step in scenes that all engines run in turn."""
from pathlib import Path

from . import charts
from .common import GOALS, TEXTS, Benchmark, Result, attempt, median_of, table, times_text

PEERS = {"boxreel_bench_box2d": "libbox2d-dev", "boxreel_bench_chipmunk": "libchipmunk-dev"}
STROKES = {"static": "-", "asleep": "--", "asleep4": ":"}  # of the kinds of curves
GOAL_PEER, GOAL_PROGRAM = "Box2D 2.4", "boxreel_bench_box2d"  # whose times goals are against, in any of its versions


def judge_alone(figures: Result) -> str:
    """The verdict on a run by itself."""
    if "failure" in figures or not figures["finite"]:
        return "failed" if "failure" in figures else "not finite"
    return next((what for what in ("escaped", "awake") if figures[what] > 0), "sound")


def judge_beside(result: Result, ours: Result, peers: list[Result]) -> str:
    """The verdict on our run beside the sound ones of peers; docs/notes/engine-speed.md has reasons."""
    moving = result["comparesSpeeds"]
    for figure, (share, least, wrong) in GOALS["likeness"]["moving" if moving else "resting"].items():
        low, high = (choose(peer[figure] for peer in peers) for choose in (min, max))
        if not low - max(least, share * abs(low)) <= ours[figure] <= high + max(least, share * abs(high)):
            return wrong
    share, least = GOALS["likeness"]["overlap"]
    deepest = min((peer["overlap"] + max(least, share * peer["overlap"])
                   for peer in peers if peer["program"] == GOAL_PROGRAM), default=float("inf"))
    return "sound" if moving or ours["overlap"] <= deepest else "deep overlaps"


class Engine(Benchmark):
    """Scenes by their CPU time."""
    name, program, peers = "engine", "boxreel_bench", PEERS

    def measure(self, build: Path, case: Result, options, work: Path) -> Result:
        """Every engine and thread count `rounds` times in turn; figures are the medians of the rounds."""
        ours, *peers = self.programs(build, options)
        entries = [(ours, threads) for threads in options.threads] + [(peer, 1) for peer in peers]
        sub_steps = [options.sub_steps] if options.sub_steps else []  # engines without any take one step
        rounds = [[attempt(path, "run", case["case"], threads, *sub_steps) for path, threads in entries]
                  for _ in range(options.rounds)]
        methods = []
        for (path, threads), *runs in zip(entries, *rounds):
            one = next((one for one in runs if "failure" in one), None) or median_of(runs) | {
                "finite": all(one["finite"] for one in runs),
                "bits": runs[0]["bits"] if len({one["bits"] for one in runs}) == 1 else "vary"}
            methods.append({"method": one.pop("engine"), "threads": threads, **one, "ours": path is ours})
        return {**case, "subSteps": options.sub_steps, "methods": methods}

    def judge(self, result: Result) -> None:
        """Ours is held against the sound runs of the peers; ratios are of runs that did not burst. Goals are for each
        case's own number of sub-steps."""
        methods, first = result["methods"], result["methods"][0]
        sound = [one for one in methods if judge_alone(one) == "sound"]
        peers = [one for one in sound if not one["ours"]]
        single = next((one for one in sound if one["ours"] and one["threads"] == 1), None)
        for one in methods:
            one["verdict"] = judge_alone(one)
            if "failure" not in one:
                found = f"{one['found']:.0f} {result['found']}, {one['foundSum']:.6g}"
                one |= {"spread": one["p99"] / one["median"], "foundText": found if result["found"] else ""}
        for one in sound:
            if one["ours"]:
                same = one["bits"] == first.get("bits") != "vary"
                one["verdict"] = "other bits" if not same else judge_beside(result, one, peers) if peers else "sound"
            elif first["verdict"] == "sound":
                one |= {"wallTimes": one["mean"] / first["mean"], "cpuTimes": one["cpu"] / first["cpu"]}
            if one["ours"] and one["threads"] > 1 and single:
                one["speedUp"] = single["mean"] / one["mean"]
        reached = {f"speed-up of {one['threads']} threads": one["speedUp"] for one in sound if "speedUp" in one}
        reached |= {f"times faster than {GOAL_PEER}": one.get("cpuTimes")
                    for one in methods if one["program"] == GOAL_PROGRAM}
        if any(one is first for one in sound):
            reached |= {"CPU time [µs]": first["cpu"] * 1e6, "memory [MB]": first["memory"] / 1024.0}
        result["reached"] = {} if result.get("subSteps") else reached

    def drawn(self, results: list[Result]) -> dict:
        return {"": charts.ratio_bars(TEXTS["engine"], results, "cpu")}


class Curve(Engine):
    """Scenes that differ only in the number of bodies that do nothing."""
    name = "curve"

    def cases(self, build: Path) -> list[Result]:
        return [{**one, "onlyNamed": False} for one in super().cases(build) if one["curve"]]

    def text(self, results: list[Result]) -> str:
        """Also what the largest scene of each curve takes over the smallest, for each engine."""
        rows = []
        for kind in dict.fromkeys(result["curve"] for result in results):
            ends = sorted((result for result in results if result["curve"] == kind), key=lambda result: result["count"])
            for small, large in zip(ends[0]["methods"], ends[-1]["methods"]):
                if judge_alone(small) == judge_alone(large) == "sound":
                    growth = times_text(large["cpu"] / small["cpu"])
                    rows.append([ends[-1]["case"], small["method"], f"{growth} the CPU time of {ends[0]['case']}"])
        return super().text(results) + "\n" + table("<<<", rows)

    def drawn(self, results: list[Result]) -> dict:
        """The time of a step over the number of bodies."""
        curves = charts.curves_of(
            (one["method"], STROKES[result["curve"]], charts.Point(result["count"], one["cpu"] * 1e6))
            for result in sorted((result for result in results if result["curve"]), key=lambda one: one["count"])
            for one in result["methods"] if judge_alone(one) == "sound" and one["threads"] == 1)
        for curve in curves:
            first, last = curve.points[0], curve.points[-1]
            curve.points[-1] = last._replace(label=times_text(last.y / first.y), optional=False)
        return {"": charts.Lines(TEXTS["curve"], curves)}
