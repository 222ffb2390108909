# SPDX-License-Identifier: MIT
"""Films from a cold start to a closed file, beside ffmpeg that only encodes and immediate mode piped to ffmpeg."""
from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Any

from . import charts
from .common import (FAILED, TEXTS, Benchmark, Ended, Problem, Result, columns_table, digits, median_of, note, objects,
                     program, run, time_text)

PEERS = {"encodeOnly": "encoding only", "immediate": "immediate mode"}
ROOM = 500e6  # for films, beside the raw frames [bytes]


def make(film: Result, work: Path, *more: str) -> Ended:
    """Makes a film once, in an empty folder."""
    shutil.rmtree(work / film["role"], ignore_errors=True)
    (work / film["role"]).mkdir()
    ended = run([*film["words"], *more])
    if film["role"] != "immediate":
        return ended
    return ended._replace(memory=1024.0 * objects(ended.output)[-1]["kilobytes"])  # of two processes


class Recording(Benchmark):
    """Films of a scene by several programs."""
    name, program = "record", "boxreel_record_bench"

    def parts(self, cases: list[Result]) -> list[str]:
        """Two charts of all cases."""
        return ["speed", "stages"]

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
        films = [film for film in films if version or film["role"] not in PEERS]
        methods = [{**{key: film[key] for key in ("role", "method", "frames")}, "ours": film["role"] not in PEERS}
                   for film in films]
        rounds: dict[str, list[Result]] = {film["role"]: [] for film in films}
        for film, one in list(zip(films, methods)) * options.rounds:
            try:
                if "failure" not in one:
                    ended = make(film, work, *(["--progress", "none"] if one["ours"] else []))
                    rounds[film["role"]].append({"wall": ended.wall, "cpu": ended.cpu, "memory": ended.memory})
            except Problem as problem:
                if film["role"] == "boxreel":
                    raise
                one["failure"] = str(problem)
                note(str(problem))
        for film, one in zip(films, methods):
            one["method"] = one["method"] if one["ours"] else one["method"].replace("ffmpeg", f"ffmpeg {version}")
            if "failure" not in one:
                one |= {**median_of(rounds[film["role"]]), "seen": objects(run(film["check"]).output)[-1]["verdict"],
                        "bytes": sum(file.stat().st_size for file in (work / film["role"]).iterdir())}
        # In a run of its own: looking at clocks takes time.
        clocks = make(films[0], work, "--progress", "json", "--stats")
        stages = next(one for one in objects(clocks.errors) if one.get("event") == "stages")
        return {**case, **take, "resized": bool(options.frames or options.size), "cached": cached, "methods": methods,
                "stages": [{"stage": one["stage"], "thread": one["thread"], "cpu": one["cpuSeconds"] / stages["frames"],
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
        films = {one["role"]: one for one in result["methods"] if "failure" not in one}
        for one in result["methods"]:
            one["verdict"] = one.get("failure") or one["seen"]
            one |= {"rate": one["frames"] / one["wall"]} if "failure" not in one else {}

        def of(one: str, other: str, figure: str, way: Any = lambda a, b: (a - b) / 1e6) -> float | None:
            found = [films.get(role, {}) for role in (one, other)]
            sound = all(film.get("verdict") == "sound" for film in found)
            return way(*(film[figure] for film in found)) if sound else None

        resting, moving = (of(film, start, "wall", lambda a, b, film=film: (a - b) / max(films[film]["frames"] - 1, 1))
                           for film, start in (("boxreel", "start"), ("moving", "movingStart")))
        reached = {"frames a second": of("boxreel", "boxreel", "rate", min),
                   "times faster than moving": moving / resting if resting and moving else None,
                   "memory of the longer film, more by [MB]": of("long", "boxreel", "memory")}
        for role in (role for role in PEERS if role in films):
            reached[f"wall time over {PEERS[role]}"] = of("boxreel", role, "wall", lambda a, b: a / b)
            films[role] |= {f"{clock}Times": of(role, "boxreel", clock, lambda a, b: a / b)
                            for clock in ("wall", "cpu")}
        if "encodeOnly" in films:
            reached["memory over the encoder's [MB]"] = of("boxreel", "encodeOnly", "memory")
        result["reached"] = {} if result["resized"] else reached

    def text(self, results: list[Result]) -> str:
        """Where the time of a frame goes, then a row a film, goals, and notes."""
        cached = min(result["cached"] for result in results)
        return (columns_table(TEXTS["stages"]["columns"], results, "stages") + "\n" + super().text(results)
                + f"At least {cached * 100:.0f} % of the raw frames were in the page cache.\n")

    def drawn(self, results: list[Result]) -> dict[str, Any]:
        """The charts of speed and of stages."""
        times = [{(one["stage"], one["thread"]): one["cpu"] * 1e3 for one in result["stages"]} for result in results]
        stages = dict.fromkeys(key for one in times for key, time in one.items() if time >= 0.02)
        groups = [(key[0], f"{key[1]} thread", "", [(one.get(key), digits(one.get(key))) for one in times])
                  for key in stages]
        return {"speed": charts.ratio_bars(TEXTS["record"], results, "wall", time_text),
                "stages": charts.Bars(TEXTS["stages"], groups, [result["case"] for result in results], start=0.0)}
