# SPDX-License-Identifier: MIT
"""The engine timed beside its peers: CPU time of a step in scenes that all engines run in turn."""
from pathlib import Path

from . import charts
from .common import TEXTS, Benchmark, Result, attempt, median_of, table, time_text, times_text

PEERS = {"boxreel_bench_box2d": "libbox2d-dev", "boxreel_bench_chipmunk": "libchipmunk-dev"}
# How far our figures may lie outside those of the peers, as a share and at least: scenes are chaotic, and engines keep
# different gaps. Over runs whose bodies begin up to 1 mm elsewhere the standard deviation of the mean height during
# the second half is 1 to 1.4 % in the tumbler, 0.7 to 1 % with the ragdolls, 0.2 % in the rain, for Box2D 2.4 as for
# ours. What calls find depends on rounding only: a ray may just miss a corner.
LIKENESS = {"bodies": (0.0, 0.0), "found": (1e-4, 0.0), "foundSum": (1e-4, 0.0), "contacts": (0.15, 0.0),
            "meanHeight": (0.03, 0.005), "meanSpeed": (0.05, 0.1)}  # [m], [m/s]
CONTACTS_IN_FLIGHT = 10.0  # few of what flies about touch at a time
# How much deeper our bodies may overlap than those of Box2D 2.4, which keeps the same skins and slop. The most that a
# sound run of ours has more is 22 %, in the pyramid of base 100, which drifts sideways by 0.4 m in Box2D.
DEEPER, DEEPER_LEAST = 0.25, 0.001  # share, [m]


def is_goal_peer(engine: str) -> bool:
    """True if goals are against this engine."""
    return engine.startswith("Box2D 2.4")


def judge_alone(figures: Result) -> str:
    """What is wrong with a run by itself, or "sound"."""
    if "failure" in figures or not figures["finite"]:
        return figures.get("failure", "not finite")
    return next((f"{figures[what]:.0f} {what}" for what in ("escaped", "awake") if figures[what] > 0), "sound")


def judge_beside(result: Result, ours: Result, peers: list[Result]) -> str:
    """What is wrong with our run beside the sound ones of the peers, or "sound"."""
    speeds = result["comparesSpeeds"]

    def is_like(figure: str) -> bool:
        share, least = LIKENESS[figure]
        least = CONTACTS_IN_FLIGHT if figure == "contacts" and speeds else least
        low, high = (choose(peer[figure] for peer in peers) for choose in (min, max))
        return low - max(least, share * abs(low)) <= ours[figure] <= high + max(least, share * abs(high))

    deepest = min((peer["overlap"] + max(DEEPER_LEAST, DEEPER * peer["overlap"])
                   for peer in peers if is_goal_peer(peer["method"])), default=float("inf"))
    checks = {"other bodies": is_like("bodies"), f"other {result['found']}": is_like("found") and is_like("foundSum"),
              "other contacts": is_like("contacts"), "deep overlaps": speeds or ours["overlap"] <= deepest,
              "other speeds": not speeds or is_like("meanSpeed"), "other heights": speeds or is_like("meanHeight")}
    return next((wrong for wrong, holds in checks.items() if not holds), "sound")


class Engine(Benchmark):
    """Scenes by their CPU time."""
    name, program, peers = "engine", "boxreel_bench", PEERS

    def measure(self, build: Path, case: Result, options, work: Path) -> Result:
        """Every engine and thread count `rounds` times in turn; figures are the medians of the rounds."""
        ours, *peers = self.programs(build, options)
        entries = [(ours, threads) for threads in options.threads] + [(peer, 1) for peer in peers]
        rounds = [[attempt(path, "run", case["case"], threads) for path, threads in entries]
                  for _ in range(options.rounds)]
        methods = []
        for (path, threads), *runs in zip(entries, *rounds):
            one = next((one for one in runs if "failure" in one), None) or median_of(runs) | {
                "finite": all(one["finite"] for one in runs),
                "bits": runs[0]["bits"] if len({one["bits"] for one in runs}) == 1 else "vary"}
            methods.append({"method": one.pop("engine"), "threads": threads, **one, "ours": path is ours})
        return {**case, "methods": methods}

    def judge(self, result: Result) -> None:
        """Ours is held against the sound runs of the peers; ratios are of runs that did not burst."""
        methods, first = result["methods"], result["methods"][0]
        sound = [one for one in methods if judge_alone(one) == "sound"]
        peers = [one for one in sound if not one["ours"]]
        single = next((one for one in sound if one["ours"] and one["threads"] == 1), None)
        reached = result["reached"] = {}
        for one in methods:
            one["verdict"] = judge_alone(one)
            if "failure" not in one:
                found = f"{one['found']:.0f} {result['found']}, {one['foundSum']:.6g}"
                one |= {"spread": one["p99"] / one["median"], "foundText": found if result["found"] else ""}
        for one in sound:
            if one["ours"]:
                same = one["bits"] == first.get("bits") != "vary"
                one["verdict"] = "other bits" if not same else judge_beside(result, one, peers) if peers else "sound"
                if one["threads"] > 1 and single:
                    one["speedUp"] = single["mean"] / one["mean"]
                if one["threads"] == 2 and single:
                    reached["speed-up of 2 threads"] = one["speedUp"]
            elif first["verdict"] == "sound":
                one |= {"wallTimes": one["mean"] / first["mean"], "cpuTimes": one["cpu"] / first["cpu"]}
        for one in methods:
            if is_goal_peer(one["method"]):
                reached["times faster than Box2D 2.4"] = one.get("cpuTimes")
        if any(one is first for one in sound):
            reached |= {"CPU time [µs]": first["cpu"] * 1e6, "memory [MB]": first["memory"] / 1024.0}

    def drawn(self, results: list[Result]) -> dict:
        return {"": charts.ratio_bars(TEXTS["engine"], results, "cpu", time_text)}


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
        lines = {}
        for result in sorted((result for result in results if result["curve"]), key=lambda one: one["count"]):
            for one in result["methods"]:
                if judge_alone(one) == "sound" and one["threads"] == 1:
                    point = charts.Point(result["count"], one["cpu"] * 1e6)
                    lines.setdefault((one["method"], result["curve"]), []).append(point)
        engines = list(dict.fromkeys(engine for engine, _ in lines))
        for line in lines.values():
            line[-1] = line[-1]._replace(label=times_text(line[-1].y / line[0].y), optional=False)
        strokes = {"static": "-", "asleep": "--", "asleep4": ":"}
        return {"": charts.Lines(TEXTS["curve"], [charts.Curve(engine, engines.index(engine), strokes[kind], line)
                                                  for (engine, kind), line in lines.items()])}
