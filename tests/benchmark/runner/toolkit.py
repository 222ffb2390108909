# SPDX-License-Identifier: MIT
"""Drawing beside Cairo, films beside ffmpeg and immediate mode, comparing pictures beside what npm and Debian have."""
import itertools
import json
import operator
import os
import shutil
from pathlib import Path

from . import charts
from .common import (FAILED, TEXTS, Benchmark, Ended, Problem, Result, columns_table, digits, median_of, note, objects, program,
                     run, table, value_at, version_of)


class Drawing(Benchmark):
    """Pictures of several sizes and numbers of shapes: CPU time of a frame against the error at edges."""
    name, program, parts = "render", "boxreel_render_bench", ["{height}p"]
    peers = {"boxreel_render_bench_cairo": "libcairo2-dev"}
    works = {"full": ("full redraw [ms]", "-"), "together": ("5 % changed together [ms]", "--"),
             "apart": ("5 % changed apart [ms]", ":"), "none": ("unchanged [ms]", None)}  # goals, and strokes of curves

    def measure(self, build: Path, case: Result, options, work: Path) -> Result:
        """Errors once, times `rounds` times in turn. Ours with one raster thread, and with the user's."""
        ours, *peers = self.programs(build, options)
        entries = [(ours, "0"), *([] if options.against else [(ours, "own")]), *((peer, "0") for peer in peers)]
        errors = [objects(run([path, "error", case["case"]]).output) for path, _ in entries]
        rounds = [[objects(run([path, "time", case["case"], threads]).output) for path, threads in entries]
                  for _ in range(options.rounds)]
        methods = []
        for (path, threads), *said in zip(entries, errors, *rounds):
            for error, *times in zip(*said):
                wrong = next((time["wrong"] for time in times if time["wrong"]), "")  # frames unlike one from scratch
                methods.append({**error, **median_of(times), "wrong": wrong, "ours": path is ours, "threads": threads,
                                "program": path.name})
        return {**case, "methods": methods}

    def judge(self, result: Result) -> None:
        """Goals are for ours with one raster thread."""
        for one in result["methods"]:
            if "floor" in one["works"]:
                one["overFloor"] = value_at(one, "works.empty.cpu") / value_at(one, "works.floor.cpu")
        ours = next(one for one in result["methods"] if one["ours"] and one["threads"] == "0")
        result["reached"] = {figure: ours["works"][work]["cpu"] * 1e3 if not ours["wrong"] else None
                             for work, (figure, _) in self.works.items() if work in ours["works"]}
        result["reached"] |= {"empty over clear and read": ours.get("overFloor"), "RMSE at edges": ours["rms"]}

    def drawn(self, results: list[Result]) -> dict:
        """A chart for each height, of methods with one raster thread, and where these draw the same of the first."""
        made = {}
        for height in dict.fromkeys(result["height"] for result in results):
            sizes = sorted((one for one in results if one["height"] == height), key=lambda one: one["shapes"])
            points = []
            for result in sizes:
                first = {one["rms"]: one for one in reversed(result["methods"]) if one["threads"] == "0"}
                for one, (work, (_, stroke)) in itertools.product(reversed(first.values()), self.works.items()):
                    if stroke and work in one["works"]:
                        label = f"{result['shapes']:,}" if len(sizes) > 1 else work
                        milliseconds = one["works"][work]["cpu"] * 1e3
                        points.append((one["method"], stroke, charts.Point(milliseconds, one["rms"], label, ".", work != "full")))
            title = TEXTS["render"]["title"].format(sizes[0]["width"], height)
            made[f"{height}p"] = charts.Lines({**TEXTS["render"], "title": title}, charts.curves_of(points))
        return made


FILM_PEERS = {"encodeOnly": "encoding only", "immediate": "immediate mode"}  # roles of films that others make
ROOM = 500e6  # for films, beside the raw frames [bytes]


def make(film: Result, work: Path, *more: str) -> Ended:
    """Makes a film once, in an empty folder."""
    shutil.rmtree(work / film["role"], ignore_errors=True)
    (work / film["role"]).mkdir()
    ended = run([*film["words"], *more])
    of_two = film["role"] == "immediate"  # processes
    return ended._replace(memory=1024.0 * objects(ended.output)[-1]["kilobytes"]) if of_two else ended


class Recording(Benchmark):
    """Films of a scene by several programs, from a cold start to a closed file."""
    name, program, parts = "record", "boxreel_record_bench", ["speed", "stages"]

    def measure(self, build: Path, case: Result, options, work: Path) -> Result:
        """Each film `rounds` times in turn; films and raw frames lie in `work`. Peers may fail, ours may not."""
        helper = program(build, self.program)
        take, *films = objects(run([helper, "films", case["case"], options.frames, *options.size, build / "boxreel",
                                    work]).output)
        need, free = 4.0 * take["width"] * take["height"] * take["frames"] + ROOM, shutil.disk_usage(work).free
        if free < need:
            raise Problem(f"the raw frames of '{case['case']}' need {need / 1e9:.1f} GB in {work.parent}, which has "
                          f"{free / 1e9:.1f}; name another folder by TMPDIR", FAILED)
        cached = objects(run([helper, "raw", *take.pop("take"), work / "frames.raw"]).output)[-1]["cached"]
        version = None if options.against else version_of("version", "ffmpeg", "-version")
        if not version and not options.against:
            note("films are compared with nothing, for ffmpeg does not run; install ffmpeg")
        films = [{**film, "ours": film["role"] not in FILM_PEERS, "made": [],
                  "method": film["method"].format(version=version)}
                 for film in films if version or film["role"] not in FILM_PEERS]
        for film in films * options.rounds:
            try:
                if "failure" not in film:
                    film["made"].append(make(film, work, *(["--progress", "none"] if film["ours"] else [])))
            except Problem as problem:
                if film["role"] == "boxreel":
                    raise
                film["failure"] = str(problem)
                note(film["failure"])
        for film in films:
            if "failure" not in film:
                film |= {figure: median_of([getattr(ended, figure) for ended in film["made"]])
                         for figure in ("wall", "cpu", "memory")}
                film |= {"seen": objects(run(film["check"]).output)[-1]["verdict"],
                         "bytes": sum(file.stat().st_size for file in (work / film["role"]).iterdir())}
        # In a run of its own: looking at clocks takes time.
        clocks = make(films[0], work, "--progress", "json", "--stats")
        stages = next(one for one in objects(clocks.errors) if one.get("event") == "stages")
        methods = [{key: film[key] for key in film if key not in ("words", "check", "made")} for film in films]
        return {**case, **take, "resized": bool(options.frames or any(options.size)), "cached": cached,
                "methods": methods, "stages": [
                    {"stage": one["stage"], "thread": one["thread"], "cpu": one["cpuSeconds"] / stages["frames"],
                     "wall": one.get("wallSeconds", 0.0) / stages["frames"]} for one in stages["stages"]]}

    def judge(self, result: Result) -> None:
        """Goals are for films of the case's own size, and only sound films are compared."""
        films = {one["role"]: one for one in result["methods"] if "failure" not in one}
        for one in result["methods"]:
            one["verdict"] = "not made" if "failure" in one else "sound" if one["seen"] == "sound" else "unlike"
            if "failure" not in one:
                one |= {"rate": one["frames"] / one["wall"], "megabytes": one["memory"] / 1e6}

        def of(role: str, other: str, figure: str, compare=operator.truediv) -> float | None:
            both = [films.get(name, {}) for name in (role, other)]
            sound = all(film.get("verdict") == "sound" for film in both)
            return compare(*(film[figure] for film in both)) if sound else None

        moving, resting = (of(film, start, "wall", lambda a, b, film=film: (a - b) / max(films[film]["frames"] - 1, 1))
                           for film, start in (("moving", "movingStart"), ("boxreel", "start")))
        reached = {"frames a second": of("boxreel", "boxreel", "rate", min),
                   "times faster than moving": moving / resting if moving and resting else None,
                   "memory of the longer film, more by [MB]": of("long", "boxreel", "megabytes", operator.sub)}
        for role, name in FILM_PEERS.items():
            if role in films:
                reached[f"wall time over {name}"] = of("boxreel", role, "wall")
                reached[f"bytes over {name}"] = of("boxreel", role, "bytes")
                films[role] |= {"wallTimes": of(role, "boxreel", "wall"), "cpuTimes": of(role, "boxreel", "cpu")}
        if "encodeOnly" in films:
            reached["memory over the encoder's [MB]"] = of("boxreel", "encodeOnly", "megabytes", operator.sub)
        result["reached"] = {} if result["resized"] else reached

    def text(self, results: list[Result]) -> str:
        """Also where the time of a frame goes."""
        cached = min(result["cached"] for result in results)
        return (columns_table(TEXTS["stages"]["columns"], results, "stages") + "\n" + super().text(results)
                + f"At least {cached * 100:.0f} % of the raw frames were in the page cache.\n")

    def drawn(self, results: list[Result]) -> dict:
        times = [{(one["stage"], one["thread"]): one["cpu"] * 1e3 for one in result["stages"]} for result in results]
        stages = dict.fromkeys(key for one in times for key, time in one.items() if time >= 0.02)
        groups = [(key[0], f"{key[1]} thread", "", [(one.get(key), digits(one.get(key))) for one in times])
                  for key in stages]
        return {"speed": charts.ratio_bars(TEXTS["record"], results, "wall"),
                "stages": charts.Bars(TEXTS["stages"], groups, [result["case"] for result in results], start=0.0)}


# The peers' defaults forgive what a person hardly sees in a photograph; the stricter settings in texts.json are those
# that their manuals name for exactness and that still let a rounding pass.
SCENES = ("pyramid", "bridge", "tumbler")  # fills, lines, crowds


def comparing_methods(folder: str | None, alone: bool) -> list[Result]:
    """The programs of texts.json that are there, with the words in braces that are known of them."""
    modules, versions = Path(folder or "").expanduser() / "node_modules", {"boxreel": ""}
    for package in () if alone or not folder else modules.glob("*/package.json"):
        if package.parent.name in ("odiff-bin", "pixelmatch"):
            versions[package.parent.name] = json.loads(package.read_text("utf-8"))["version"]
    if folder and not alone and len(versions) == 1:
        raise Problem(f"'{folder}' holds no peers; run `npm install odiff-bin pixelmatch` in it or name another folder")
    if not alone and (version := version_of("ImageMagick", "compare", "-version")):
        versions["imagemagick"] = version
    places = {"{odiff}": next(modules.glob("@odiff/*/odiff"), "odiff"),  # itself: its script would start node first
              "{pixelmatch}": (modules / "pixelmatch").resolve(),
              "{pixelmatch program}": modules / "pixelmatch" / "bin" / "pixelmatch",
              "{pixelmatch timer}": Path(__file__).with_name("pixelmatch.mjs")}
    return [{**one, "name": one["name"].replace("{version}", versions[one["of"]]), "places": places}
            for one in TEXTS["golden"]["methods"] if one["of"] in versions]


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
        return [{"case": scene, "what": "ten pairs of pictures of this scene"} for scene in SCENES]

    def measure(self, build: Path, case: Result, options, work: Path) -> Result:
        """Every method on every pair of a scene; times are medians. Peers may fail, ours may not."""
        helper, folder = program(build, self.program), options.peers or os.environ.get("BOXREEL_PEERS")
        pairs, methods = objects(run([helper, "plant", work, case["case"]]).output), []
        files = [work / pair[which] for pair in pairs for which in ("expected", "actual")]
        programs = comparing_methods(folder, bool(options.against))
        for method in programs:
            one = {"method": method["name"], "ours": method["of"] == "boxreel", "usual": method["usual"], "pictures": []}
            places = method["places"] | {"{boxreel}": build / "boxreel", "{helper}": helper, "{rounds}": options.rounds}
            methods.append(one)
            try:
                for pair, expected, actual in zip(pairs, files[::2], files[1::2]):
                    places |= {"{expected}": expected, "{actual}": actual}
                    runs = [run([places.get(word, word) for word in method["words"]], method["differ"])
                            for _ in range(options.rounds)]
                    one["pictures"].append({"change": pair["change"], "different": runs[0].code != 0,
                                            "process": median_of([ended.wall for ended in runs])})
                timer = [places.get(word, word) for word in method.get("timer", [])]
                for picture, said in zip(one["pictures"], objects(run([*timer, *files]).output) if timer else []):
                    if said.get("different", picture["different"]) != picture["different"]:
                        raise Problem(f"`boxreel diff` and library differ about '{picture['change']}'; report it",
                                      FAILED)
                    picture["decoded"], one["method"] = said["decodedSeconds"], said.get("method", one["method"])
            except Problem as problem:
                if one["ours"]:
                    raise
                one["failure"] = str(problem)
        found = [method["of"] for method in programs]
        absent = [name for name in TEXTS["golden"]["absent"] if name not in found and not options.against]
        return {**case, "changes": objects(run([helper, "list"]).output), "absent": absent, "methods": methods}

    def judge(self, result: Result) -> None:
        for one in result["methods"]:
            one["verdict"] = "failed" if "failure" in one else "sound"
            one |= {clock: median_of(times(one, clock)) for clock in ("process", "decoded") if times(one, clock)}

    def text(self, results: list[Result]) -> str:
        """A row a method: what it calls different of each change, and its times."""
        changes, rows = [one for one in results[0]["changes"] if one["truth"] != "either"], together(results)
        for one in rows:
            for change in changes:
                calls = [picture["different"] for picture in one["pictures"] if picture["change"] == change["change"]]
                wrong = not all(calls) if change["truth"] == "different" else any(calls)
                one[change["change"]] = f"{sum(calls)}/{len(calls)}{'!' if wrong else ' '}"
            one |= {clock: median_of(times(one, clock) or [None]) for clock in ("decoded", "process")}
            one["max"] = max(times(one, "decoded"), default=None)
        (name, *clocks), said = TEXTS["golden"]["columns"], ["", "failure", "text"]
        legend = [[one["change"], one["what"], "is to pass" if one["truth"] == "equal" else ""]
                  for one in results[0]["changes"]]
        return (columns_table([name, *([one["change"]] * 2 + ["calls"] for one in changes), *clocks, said], rows)
                + TEXTS["golden"]["legend"] + ", ".join(result["case"] for result in results) + ".\n\n"
                + table("<<<", legend) + "".join(f"\n{TEXTS['golden']['absent'][name]}" for name in results[0]["absent"]) + "\n")

    def drawn(self, results: list[Result]) -> dict:
        return {"": charts.ratio_bars(TEXTS["golden"], results, "process")}
