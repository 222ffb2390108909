# SPDX-License-Identifier: MIT
"""Pictures with planted changes, compared by boxreel, odiff, pixelmatch and ImageMagick: what each finds and takes."""
from __future__ import annotations

import json
import os
import re
from pathlib import Path
from typing import Any, NamedTuple

from . import charts
from .common import Figures, ABSENT, Problem, Result, digits, median_of, note, objects, program, run, table

WHAT = "compare pictures with planted changes beside odiff, pixelmatch and ImageMagick"
SCENES = ("pyramid", "bridge", "tumbler")  # fills, lines, crowds
PRESETS = ("same-machine", "cross-machine")
# The peers' defaults forgive what a person hardly sees in a photograph; the stricter settings are those that their
# manuals name for exactness and that still let a rounding pass.
STRICT, FUZZ = "0.01", "1%"


class Method(NamedTuple):
    """A program with its words before and after two files; it ends with `code` where they differ."""
    name: str
    before: list[str]
    after: list[str]
    code: int
    timed: dict[str, Any] | None = None  # pixelmatch's options, to be timed without a process


def cases(build: Path) -> list[Result]:
    """The scenes that are compared unless others are named."""
    return [{"case": scene, "what": "ten pictures of this scene, with a change each"} for scene in SCENES]


def peers_of(folder: Path | None) -> tuple[list[Method], list[str]]:
    """The peers that run, and sentences about those that are absent. `folder` is where npm installed its own."""
    found, absent, versions = [], [], {}
    modules = folder / "node_modules" if folder else Path("/nowhere")
    for name in ("odiff-bin", "pixelmatch"):
        if (modules / name / "package.json").is_file():
            versions[name] = json.loads((modules / name / "package.json").read_text("utf-8")).get("version")
    if folder and not versions:
        raise Problem(f"'{folder}' holds no peers; run `npm install odiff-bin pixelmatch` in it, or name another folder")
    odiff = next(modules.glob("@odiff/*/odiff"), None) if "odiff-bin" in versions else None
    if odiff:  # the program itself: the package's script would start node first
        name = f"odiff {versions['odiff-bin']}"
        found += [Method(name, [str(odiff)], [], 22), Method(f"{name}, {STRICT}", [str(odiff)], ["--threshold", STRICT], 22)]
    else:
        absent.append("odiff is not compared; run `npm install odiff-bin` in a folder and name it by --peers")
    try:
        if "pixelmatch" not in versions:
            raise Problem("pixelmatch is not compared; run `npm install pixelmatch` in a folder and name it by --peers")
        run(["node", "--version"])
        name, script = f"pixelmatch {versions['pixelmatch']}", ["node", str(modules / "pixelmatch" / "bin" / "pixelmatch")]
        found += [Method(name, script, [], 66, {}), Method(f"{name}, {STRICT}, AA counts", script, ["", STRICT, "true"], 66,
                                                          {"threshold": float(STRICT), "includeAA": True})]
    except Problem as problem:
        absent.append(str(problem) if "npm" in str(problem) else "pixelmatch is not compared, for node does not run; "
                      "install nodejs")
    try:
        version = re.search(r"ImageMagick ([^ \n-]+)", run(["compare", "-version"]).output)
        name = f"ImageMagick {version[1]}"
        found += [Method(name, ["compare", "-metric", "AE"], ["null:"], 1),
                  Method(f"{name}, fuzz {FUZZ}", ["compare", "-metric", "AE", "-fuzz", FUZZ], ["null:"], 1)]
    except Problem:
        absent.append("ImageMagick is not compared, for its `compare` does not run; install imagemagick")
    return found, absent


def ours_of(build: Path) -> list[Method]:
    """`boxreel diff` with the presets for the same and for another machine."""
    return [Method(preset, [str(build / "boxreel"), "diff"], ["--preset", preset], 2) for preset in PRESETS]


def judged(method: Method, pairs: list[Result], rounds: int) -> list[Result]:
    """What a method calls each pair, and what a process takes."""
    runs = [[run([*method.before, pair["expected"], pair["actual"], *method.after], method.code) for _ in range(rounds)]
            for pair in pairs]
    return [{"change": pair["change"], "different": ended[0].code != 0, "process": median_of([one.wall for one in ended])}
            for pair, ended in zip(pairs, runs)]


def planted(build: Path, scene: str, work: Path) -> list[Result]:
    """The pairs of pictures of a scene."""
    for file in work.glob("*.png"):
        file.unlink()
    pairs = objects(run([program(build, "boxreel_golden_bench"), "plant", work, scene]).output)
    return [{"change": one["change"], **{key: str(work / one[key]) for key in ("expected", "actual")}} for one in pairs]


def measure(build: Path, case: Result, options: Any, work: Path) -> Result:
    """Every method on every pair of a scene; times are medians."""
    helper, pairs = program(build, "boxreel_golden_bench"), planted(build, case["case"], work)
    folder = options.peers or os.environ.get("BOXREEL_PEERS")
    peers, absent = peers_of(Path(folder).expanduser() if folder else None)
    files, methods = [pair[key] for pair in pairs for key in ("expected", "actual")], []
    for method in [*ours_of(build), *peers]:
        one = {"method": method.name, "ours": method not in peers}
        try:
            one["pictures"] = judged(method, pairs, options.rounds)
            if one["ours"]:
                decoded = objects(run([helper, "time", method.name, options.rounds, *files]).output)
                one["method"] = decoded[0]["method"]
            elif method.timed is not None:
                timer = Path(__file__).with_name("pixelmatch.mjs")
                package = Path(method.before[1]).resolve().parents[1]
                decoded = objects(run(["node", timer, package, options.rounds, json.dumps(method.timed), *files]).output)
            for picture, time in zip(one["pictures"], decoded if one["ours"] or method.timed is not None else []):
                if time.get("different", picture["different"]) != picture["different"]:
                    raise Problem(f"`boxreel diff` judges '{picture['change']}' otherwise than the library; report this", 4)
                picture["decoded"] = time["decodedSeconds"]
        except Problem as problem:
            if one["ours"]:
                raise
            one["failure"] = str(problem)
        methods.append(one)
    return {**case, "changes": objects(run([helper, "list"]).output), "absent": absent, "methods": methods}


def times(method: Result, clock: str) -> list[float]:
    """Of all pictures."""
    return [one[clock] for one in method.get("pictures", []) if clock in one]


def judge(result: Result) -> None:
    """Adds what a process takes on average; a method that failed is not sound."""
    for one in result["methods"]:
        one["verdict"] = "failed" if "failure" in one else "sound"
        one |= {clock: median_of(times(one, clock)) for clock in ("process", "decoded") if times(one, clock)}


def together(results: list[Result]) -> list[Result]:
    """Each method with its pictures of all scenes."""
    names = dict.fromkeys(one["method"] for result in results for one in result["methods"])
    own = {name: [one for result in results for one in result["methods"] if one["method"] == name] for name in names}
    return [{**found[0], "pictures": [picture for one in found for picture in one.get("pictures", [])]} for found in own.values()]


def text(results: list[Result]) -> str:
    """A row a method: what it calls different of each change, and its times."""
    changes = [one for one in results[0]["changes"] if one["truth"] != "either"]
    rows = [["called different, of as many", *(one["change"] for one in changes), "ms", "max ms", "process ms"]]
    for method in together(results):
        cells = []
        for change in changes if "failure" not in method else []:
            calls = [one["different"] for one in method["pictures"] if one["change"] == change["change"]]
            wrong = not all(calls) if change["truth"] == "different" else any(calls)
            cells.append(f"{sum(calls)}/{len(calls)}{'!' if wrong else ' '}")
        decoded, process = times(method, "decoded"), times(method, "process")
        rows.append([method["method"], *(cells or [f"failed: {method.get('failure')}"]), *(
            digits(value * 1e3) if value else "–" for value in (
                median_of(decoded) if decoded else None, max(decoded, default=None), median_of(process) if process else None))])
    legend = table("<<<", [[one["change"], one["what"], "is to pass" if one["truth"] == "equal" else ""]
                           for one in results[0]["changes"]])
    absent = "".join(f"\n{sentence}" for sentence in results[0]["absent"])
    return (table("<" + ">" * (len(changes) + 3), rows) + "! marks a change that was missed, or a false alarm. Scenes: "
            + ", ".join(result["case"] for result in results) + ".\n\n" + legend + absent + ("\n" if absent else ""))


def drawn(results: list[Result]) -> dict[str, charts.Bars]:
    """The chart of the time of a process."""
    return {"": charts.ratio_bars(
        results, "process", "How many times faster is boxreel diff?", "wall time of a process that compares two PNG files of "
        "1280 × 720, over that of boxreel", lambda time: f"{digits(time * 1e3)} ms", [
            "Medians of ten pairs of pictures a scene. What the peers miss and call different is in the table."])}


def rivals(build: Path, case: Result, options: Any, work: Path) -> Figures:
    """For --against: the time of a process and of a comparison with each preset, and the verdicts."""
    pairs, figures, said = planted(build, case["case"], work), {}, ""
    for method in ours_of(build):
        pictures = judged(method, pairs, 1)
        figures[f"a process, {method.name}"] = median_of(times({"pictures": pictures}, "process"))
        said += "".join("01"[one["different"]] for one in pictures)
    return figures, said
