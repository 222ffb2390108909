# SPDX-License-Identifier: MIT
"""Pictures with planted changes, compared by boxreel, odiff, pixelmatch and ImageMagick: what each finds and takes."""
from __future__ import annotations

import json
import os
import re
from pathlib import Path
from typing import Any, NamedTuple

from . import charts
from .common import FAILED, TEXTS, Benchmark, Problem, Result, median_of, objects, program, run, table, time_text

SCENES = ("pyramid", "bridge", "tumbler")  # fills, lines, crowds
# The peers' defaults forgive what a person hardly sees in a photograph; the stricter settings are those that their
# manuals name for exactness and that still let a rounding pass.
STRICT, FUZZ = "0.01", "1%"


class Method(NamedTuple):
    """A program with its words before and after two files; it ends with `code` where they differ."""
    name: str
    before: list[Any]
    after: list[str]
    code: int
    timer: list[Any] = []  # prints the time of each comparison of what was read before


def npm_peers(folder: Path) -> list[Method]:
    """odiff and pixelmatch where npm installed them; the former itself, for its script would start node first."""
    modules = folder / "node_modules"
    version = {name: json.loads((modules / name / "package.json").read_text("utf-8"))["version"]
               for name in ("odiff-bin", "pixelmatch") if (modules / name / "package.json").is_file()}
    if not version:
        raise Problem(f"'{folder}' holds no peers; run `npm install odiff-bin pixelmatch` in it or name another folder")
    odiff = next(modules.glob("@odiff/*/odiff"), "odiff")
    match = ["node", modules / "pixelmatch" / "bin" / "pixelmatch"]
    timer = ["node", Path(__file__).with_name("pixelmatch.mjs"), (modules / "pixelmatch").resolve()]
    found = {"odiff-bin": [("odiff {}", [odiff], [], 22),
                           (f"odiff {{}}, {STRICT}", [odiff], ["--threshold", STRICT], 22)],
             "pixelmatch": [("pixelmatch {}", match, [], 66, [*timer, "{}"]),
                            (f"pixelmatch {{}}, {STRICT}, AA counts", match, ["", STRICT, "true"], 66,
                             [*timer, json.dumps({"threshold": float(STRICT), "includeAA": True})])]}
    return [Method(words[0].format(version[name]), *words[1:]) for name in version for words in found[name]]


def peers_of(folder: str | None) -> tuple[list[Method], list[str]]:
    """The peers that run, and sentences about those that are absent."""
    found, absent = npm_peers(Path(folder).expanduser()) if folder else [], []
    try:
        version = re.search(r"ImageMagick ([^ \n-]+)", run(["compare", "-version"]).output)[1]
        words = ["compare", "-metric", "AE"]
        found += [Method(f"ImageMagick {version}", words, ["null:"], 1),
                  Method(f"ImageMagick {version}, fuzz {FUZZ}", [*words, "-fuzz", FUZZ], ["null:"], 1)]
    except Problem:
        absent.append("ImageMagick is not compared, for its `compare` does not run; install imagemagick")
    return found, absent + [f"{name} is not compared; run `npm install {package}` in a folder and name it by --peers"
                            for name, package in (("odiff", "odiff-bin"), ("pixelmatch", "pixelmatch"))
                            if not any(one.name.startswith(name) for one in found)]


def times(method: Result, clock: str) -> list[float]:
    """Of all pictures that were timed so."""
    return [one[clock] for one in method.get("pictures", []) if clock in one]


def together(results: list[Result]) -> list[Result]:
    """Each method with its pictures of all scenes."""
    found: dict[str, Result] = {}
    for one in (one for result in results for one in result["methods"]):
        method = found.setdefault(one["method"], {**one, "pictures": []})
        method["pictures"] = method["pictures"] + one["pictures"]
    return list(found.values())


class Comparing(Benchmark):
    """Scenes, each drawn and drawn with a change, once for each kind of change."""
    name, program = "golden", "boxreel_golden_bench"

    def cases(self, build: Path) -> list[Result]:
        """The scenes that are compared unless others are named."""
        return [{"case": scene, "what": "ten pairs of pictures of this scene"} for scene in SCENES]

    def measure(self, build: Path, case: Result, options: Any, work: Path) -> Result:
        """Every method on every pair of a scene; times are medians. Peers may fail, ours may not."""
        helper = program(build, self.program)
        peers, absent = peers_of(options.peers or os.environ.get("BOXREEL_PEERS")) if not options.against else ([], [])
        pairs = objects(run([helper, "plant", work, case["case"]]).output)
        files, methods = [work / pair[key] for pair in pairs for key in ("expected", "actual")], []
        ours = [Method(preset, [build / "boxreel", "diff"], ["--preset", preset], 2, [helper, "time", preset])
                for preset in ("same-machine", "cross-machine")]
        for method in ours + peers:
            one: Result = {"method": method.name, "ours": method in ours, "pictures": []}
            methods.append(one)
            try:
                for pair, expected, actual in zip(pairs, files[::2], files[1::2]):
                    words = [*method.before, expected, actual, *method.after]
                    runs = [run(words, method.code) for _ in range(options.rounds)]
                    one["pictures"].append({"change": pair["change"], "different": runs[0].code != 0,
                                            "process": median_of([ended.wall for ended in runs])})
                timer = [*method.timer[:3], options.rounds, *method.timer[3:], *files]
                for picture, said in zip(one["pictures"], objects(run(timer).output) if method.timer else []):
                    if said.get("different", picture["different"]) != picture["different"]:
                        raise Problem(f"`boxreel diff` and library differ about '{picture['change']}'; report it",
                                      FAILED)
                    picture["decoded"], one["method"] = said["decodedSeconds"], said.get("method", one["method"])
            except Problem as problem:
                if one["ours"]:
                    raise
                one["failure"] = str(problem)
        return {**case, "changes": objects(run([helper, "list"]).output), "absent": absent, "methods": methods}

    def judge(self, result: Result) -> None:
        """Adds the medians of the times."""
        for one in result["methods"]:
            one["verdict"] = "failed" if "failure" in one else "sound"
            one |= {clock: median_of(times(one, clock)) for clock in ("process", "decoded") if times(one, clock)}

    def text(self, results: list[Result]) -> str:
        """A row a method: what it calls different of each change, and its times."""
        changes = [one for one in results[0]["changes"] if one["truth"] != "either"]
        heads = ["decoded", "max", "process"]
        rows = [["called different, of as many", *(one["change"] for one in changes), *heads]]
        for method in together(results):
            cells = []
            for change in changes:
                calls = [one["different"] for one in method["pictures"] if one["change"] == change["change"]]
                wrong = not all(calls) if change["truth"] == "different" else any(calls)
                cells.append(f"{sum(calls)}/{len(calls)}{'!' if wrong else ' '}")
            decoded, process = times(method, "decoded") or [None], times(method, "process") or [None]
            rows.append([method["method"], *([f"failed: {method['failure']}"] if "failure" in method else [*cells, *map(
                time_text, (median_of(decoded), max(decoded) if decoded[0] else None, median_of(process)))])])
        legend = [[one["change"], one["what"], "is to pass" if one["truth"] == "equal" else ""]
                  for one in results[0]["changes"]]
        return (table("<" + ">" * (len(changes) + len(heads)), rows) + TEXTS["golden"]["legend"]
                + ", ".join(result["case"] for result in results) + ".\n\n" + table("<<<", legend)
                + "".join(f"\n{sentence}" for sentence in (*results[0]["absent"], "")))

    def drawn(self, results: list[Result]) -> dict[str, Any]:
        """The chart of the time of a process."""
        return {"": charts.ratio_bars(TEXTS["golden"], results, "process", time_text)}
