# SPDX-License-Identifier: MIT
"""Films from a cold start to a closed file, beside ffmpeg that only encodes and immediate mode piped to ffmpeg."""
from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Any

from . import charts
from .common import FAILED, Benchmark, Ended, Problem, Result, digits, goal_table, median_of, note, objects, program, run, table

PEERS = ("encodeOnly", "immediate")
ROOM = 500e6  # for films, beside the raw frames [bytes]
FOOT = """
Each film is made by processes of its own, from a cold start to a closed file, then decoded and compared with the raw
frames. CPU time and memory are those of all processes together. libx264, veryfast, crf 20, two threads; PNG level 1.
"""


def make(film: Result, work: Path, *more: str) -> Ended:
    """Makes a film once, in an empty folder."""
    shutil.rmtree(work / film["role"], ignore_errors=True)
    (work / film["role"]).mkdir()
    ended = run([*film["words"], *more])  # of two processes the helper prints the memory
    return ended._replace(memory=1024.0 * objects(ended.output)[-1]["kilobytes"]) if film["role"] == "immediate" else ended


class Recording(Benchmark):
    """Films of a scene by several programs."""
    name, what, program = "record", "make films beside ffmpeg and immediate mode", "boxreel_record_bench"

    def measure(self, build: Path, case: Result, options: Any, work: Path) -> Result:
        """Each film `rounds` times in turn; films and raw frames lie in `work`. Peers may fail, ours may not."""
        helper = program(build, self.program)
        take, *films = objects(run([helper, "films", case["case"], options.frames or 0, *(options.size or (0, 0)),
                                    build / "boxreel", work]).output)
        need, free = 4.0 * take["width"] * take["height"] * take["frames"] + ROOM, shutil.disk_usage(work).free
        if free < need:
            raise Problem(f"the raw frames of '{case['case']}' need {need / 1e9:.1f} GB in {work.parent}, which has "
                          f"{free / 1e9:.1f}; name another folder by TMPDIR", FAILED)
        cached = objects(run([helper, "raw", *take.pop("take"), work / "frames.raw"]).output)[-1]["cached"]
        version = self.encoder() if not options.against else None
        films = films if version else [film for film in films if film["role"] not in PEERS]
        methods = {film["role"]: {**film, "ours": film["role"] not in PEERS} for film in films}
        rounds: dict[str, list[Result]] = {film["role"]: [] for film in films}
        for film in films * options.rounds:
            one, more = methods[film["role"]], [] if film["role"] in PEERS else ["--progress", "none"]
            try:
                ended = make(film, work, *more) if "failure" not in one else None
                rounds[film["role"]] += [{"wall": ended.wall, "cpu": ended.cpu, "memory": ended.memory}] if ended else []
            except Problem as problem:
                if film["role"] == "boxreel":
                    raise
                one["failure"] = str(problem)
                note(str(problem))
        for film, one in zip(films, methods.values()):
            one["method"] = one["method"] if one["ours"] else one["method"].replace("ffmpeg", f"ffmpeg {version}")
            if "failure" not in one:
                size = sum(file.stat().st_size for file in (work / film["role"]).iterdir())
                one |= {**median_of(rounds[film["role"]]), "bytes": size, "seen": objects(run(film["check"]).output)[-1]["verdict"]}
            del one["words"], one["check"]
        clocks = make(films[0], work, "--progress", "json", "--stats")  # in a run of its own: looking at clocks takes time
        stages = next(one for one in objects(clocks.errors) if one.get("event") == "stages")
        return {**case, **take, "resized": bool(options.frames or options.size), "cached": cached,
                "methods": list(methods.values()), "stages": [
                    {"stage": one["stage"], "thread": one["thread"], "cpu": one["cpuSeconds"] / stages["frames"],
                     "wall": one.get("wallSeconds", 0.0) / stages["frames"]} for one in stages["stages"]]}

    @staticmethod
    def encoder() -> str | None:
        """The version of ffmpeg, if it runs."""
        try:
            return re.search(r"version ([^ \n-]+)", run(["ffmpeg", "-version"]).output)[1]
        except Problem:
            note("films are compared with nothing, for ffmpeg does not run; install ffmpeg")
            return None

    def judge(self, result: Result) -> None:
        """Goals are for films of the case's own size, and only sound films are compared."""
        for one in result["methods"]:
            one["verdict"] = one.get("failure") or one["seen"]
        films = {one["role"]: one for one in result["methods"] if "failure" not in one}

        def of(one: str, other: str, figure: str, way: Any) -> float | None:
            found = [films.get(role, {}) for role in (one, other)]
            return way(*(film[figure] for film in found)) if all(film.get("verdict") == "sound" for film in found) else None

        resting, moving = (of(film, start, "wall", lambda a, b, film=film: (a - b) / max(films[film]["frames"] - 1, 1))
                           for film, start in (("boxreel", "start"), ("moving", "movingStart")))
        ours = films["boxreel"]
        reached = {"frames a second": ours["frames"] / ours["wall"] if ours["verdict"] == "sound" else None,
                   "times faster than moving": moving / resting if resting and moving else None,
                   "memory of the longer film, more by [MB]": of("long", "boxreel", "memory", lambda a, b: (a - b) / 1e6)}
        for role, name in zip(PEERS, ("encoding only", "immediate mode")):
            reached |= {f"wall time over {name}": of("boxreel", role, "wall", lambda a, b: a / b)} if role in films else {}
        if "encodeOnly" in films:
            reached["memory over the encoder's [MB]"] = of("boxreel", "encodeOnly", "memory", lambda a, b: (a - b) / 1e6)
        result["reached"] = {} if result["resized"] else reached

    def text(self, results: list[Result]) -> str:
        """A row a film, where the time of a frame goes, and goals."""
        parts = []
        for result in results:
            rows = [["method", "frames", "wall s", "CPU s", "frames/s", "film MB", "memory MB", "wall/ours", "CPU/ours", "film"]]
            ours = result["methods"][0]
            for one in result["methods"]:
                sound = ours["verdict"] == one["verdict"] == "sound" and not one["ours"]
                rows.append([one["method"], str(one["frames"]), *(["failed: " + one["failure"]] if "failure" in one else [
                    *(digits(value) for value in (one["wall"], one["cpu"], one["frames"] / one["wall"], one["bytes"] / 1e6,
                                                  one["memory"] / 1e6)),
                    *(f"{digits(one[clock] / ours[clock])}×" if sound else "" for clock in ("wall", "cpu")), one["verdict"]])])
            stages = [["where a frame's time goes", "thread", "CPU ms", "wall ms"], *(
                [one["stage"], one["thread"], f"{one['cpu'] * 1e3:.3f}", f"{one['wall'] * 1e3:.3f}" if one["wall"] else "–"]
                for one in result["stages"] if max(one["cpu"], one["wall"]) >= 0.5e-6),
                ["all", "", f"{sum(one['cpu'] for one in result['stages']) * 1e3:.3f}"]]
            parts.append(f"{result['case']}: {result['what']}, {result['width']} × {result['height']}, from {result['from']:g} s "
                         f"on; {result['cached'] * 100:.0f} % of the raw frames in the page cache\n"
                         + table("<>>>>>>>><", rows) + table("<<>>", stages))
        return "\n".join(parts) + goal_table("record", results) + FOOT

    def drawn(self, results: list[Result]) -> dict[str, charts.Bars]:
        """The charts of speed and of stages."""
        stages = dict.fromkeys((one["stage"], one["thread"]) for result in results for one in result["stages"]
                               if one["cpu"] >= 20e-6)
        found = [(stage, [next((one["cpu"] * 1e3 for one in result["stages"] if (one["stage"], one["thread"]) == stage), None)
                          for result in results]) for stage in stages]
        return {"speed": charts.ratio_bars(
            results, "wall", "How many times faster is boxreel record?", "wall time of the other over that of boxreel, from a "
            "cold start to a closed film", lambda wall: f"{digits(wall)} s", [
                "The same frames, the same encoder with the same settings. ffmpeg alone reads frames that somebody else has "
                "drawn."]), "stages": charts.Bars(
                "Where each millisecond of a frame goes", "CPU time of boxreel record a frame, by stage and film", [
                    (stage, f"{thread} thread", "", [(time, digits(time)) for time in times]) for (stage, thread), times in found],
                [result["case"] for result in results], "CPU time of a frame [ms]", [
                    "The sum over a film, cold start and end included, divided by its frames."], start=0.0, first_color=0)}
