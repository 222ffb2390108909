#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs benchmark programs for `./boxreel bench`: prints tables, writes figures as JSON and draws charts."""
import argparse
import difflib
import functools
import importlib.util
import json
import os
import re
import signal
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
from runner import accuracy, against, charts, engine, toolkit  # noqa: E402
from runner.common import (  # noqa: E402
    ABSENT, FAILED, TEXTS, UNUSABLE, Benchmark, Problem, Result, note, read_results, table, write_whole)

BENCHMARKS: dict[str, Benchmark] = {one.name: one for one in (
    engine.Engine(), engine.Curve(), accuracy.Accuracy(), toolkit.Drawing(), toolkit.Recording(), toolkit.Comparing())}
KINDS = BENCHMARKS | {"against": against.Against()}  # what a file of figures may hold


class Parser(argparse.ArgumentParser):
    """Raises an ArgumentError for what it refuses; its sentence is not shown."""

    def error(self, message: str) -> None:
        raise argparse.ArgumentError(None, message)


def checked(flag: str, how: dict, text: str) -> str | int | list[int]:
    """The value of an option: a word, or whole numbers, which are different ones in a list with commas."""
    found = [int(word) for word in re.findall(r"\d+", text) if how["is"] != "word"]
    repeated = "," in text and len(set(found)) < len(found)
    if repeated or not re.fullmatch(how["pattern"], text) or not all(1 <= number <= how["max"] for number in found):
        raise Problem(f"{flag} cannot be '{text}'; use {how['use']}")
    return text if how["is"] == "word" else found if how["is"] == "list" else found[0]


def parse(words: list[str]) -> argparse.Namespace:
    """The options of texts.json, of which none contradicts another."""
    parser = Parser(prog="./boxreel bench", description="Run benchmarks beside other engines, renderers and encoders.",
                    epilog="\n".join(TEXTS["examples"]), formatter_class=argparse.RawDescriptionHelpFormatter, exit_on_error=False)
    commands, flags = parser.add_subparsers(dest="benchmark", metavar="NAME", required=True), {}
    for name in (*BENCHMARKS, "show"):
        what, own, more = TEXTS[name]["what"], TEXTS[name].get("options", {}), TEXTS["measuring"] if name in BENCHMARKS else {}
        command = commands.add_parser(name, help=what, description=f"{what[0].upper()}{what[1:]}.", allow_abbrev=False,
                                      exit_on_error=False)
        flags[name] = own | TEXTS["options"] | more
        for flag, how in flags[name].items():
            command.add_argument(flag, **how | ({"type": functools.partial(checked, flag, how["type"])} if "type" in how else {}))
    known = flags.get(name := "".join(words[:1]), {})
    remedy = f"; `./boxreel bench {f'{name} ' * bool(known)}--help` shows what there is"
    try:
        options, unknown = parser.parse_known_args(words)
    except argparse.ArgumentError as error:
        takes = "needs a" if "metavar" in known.get(error.argument_name, {}) else "takes no"
        wrong = {None: f"{'FILE' if known else 'NAME'} is missing", "NAME": f"unknown benchmark '{name}'"}
        raise Problem(wrong.get(error.argument_name, f"{error.argument_name} {takes} value") + remedy) from error
    if unknown:
        raise Problem(f"unknown argument '{unknown[0]}'{remedy}")
    return options


def choose(cases: list[Result], options: argparse.Namespace) -> list[Result]:
    """The cases that were named, else those that are run by default; a file may hold several results of a case."""
    shown, known = options.benchmark == "show", [one["case"] for one in cases]
    chosen: list[Result] = []
    for name in options.cases:
        if name not in known and options.benchmark != "golden":  # which takes any scene
            near = "".join(f"; did you mean '{word}'?" for word in difflib.get_close_matches(name, known, 1))
            place = options.source if shown else options.benchmark
            raise Problem(f"unknown case '{name}'; `./boxreel bench {'show ' * shown}{place} --list` shows all{near}")
        if options.cases.count(name) > 1:
            raise Problem(f"'{name}' is named twice; give it once")
        chosen += [one for one in cases if one["case"] == name] or [{"case": name, "what": "this scene"}]
    return chosen or [one for one in cases if shown or not one.get("onlyNamed")]


def measured(benchmark: Benchmark, build: Path, cases: list[Result], options: argparse.Namespace) -> list[Result]:
    """The judged results of all cases, or of those before a signal to stop."""
    def measure(case: Result, folder: Path, rounds: int) -> Result:
        with tempfile.TemporaryDirectory(prefix="boxreel-bench-") as work:
            result = benchmark.measure(folder, case, argparse.Namespace(**{**vars(options), "rounds": rounds}), Path(work))
        benchmark.judge(result)
        return result

    results: list[Result] = []
    try:
        for case in cases:
            note(f"{case['case']}: {case['what']}")
            results += against.compared(benchmark, case, options.rounds, (build, Path(options.against)), measure
                                        ) if options.against else [measure(case, build, options.rounds)]
    except KeyboardInterrupt:
        if not results:
            raise
        note("stopped; the cases before are shown")
    return results


def outputs(benchmark: Benchmark, cases: list[Result], options: argparse.Namespace) -> dict[Path, tuple[str, str]]:
    """The part and theme of each chart by its file: error.svg becomes error-A-projectile-dark.svg."""
    parts = dict.fromkeys(part.format(**case) for case in cases for part in benchmark.parts)
    suffixes = {f"-{theme}": theme for theme in charts.THEMES} if options.theme == "both" else {"": options.theme}
    pictures = {path.with_name(f"{path.stem}{'-' * bool(part)}{part}{suffix}{path.suffix}"): (part, theme)
                for path in map(Path, options.chart) for part in parts for suffix, theme in suffixes.items()}
    files = [*pictures, *([] if options.json in (None, "-") else [Path(options.json)])]
    for path in files:  # checked before minutes of work
        if files.count(path) > 1:
            raise Problem(f"'{path}' would be written twice; give each file once")
        if not path.parent.is_dir() or not os.access(path.parent, os.W_OK):
            raise Problem(f"'{path.parent}' is no folder that can be written; create it first")
        if path.is_dir() or (path.exists() and not options.force):
            raise Problem(f"'{path}' exists; --force overwrites files")
    if options.chart and importlib.util.find_spec("matplotlib") is None:
        raise Problem("charts need matplotlib; install python3-matplotlib", ABSENT)
    return pictures


def show_pictures(options: argparse.Namespace, build: Path) -> None:
    """Measures the default cases of drawing and of comparing pictures, and prints their tables."""
    for benchmark in map(BENCHMARKS.get, TEXTS["record"]["pictures"]):
        cases = [one for one in benchmark.cases(build) if not one.get("onlyNamed")]
        results = measured(benchmark, build, cases, argparse.Namespace(**{**vars(options), "peers": None}))
        print(f"\n{(against.Against() if options.against else benchmark).text(results)}", end="")


def perform(options: argparse.Namespace) -> None:
    """Lists or measures cases, or reads their results; prints, writes and draws them."""
    build = Path(os.environ.get("BOXREEL_BUILD_DIR") or Path(__file__).resolve().parents[2] / "build" / "release")
    if options.benchmark == "show":
        kind, known = read_results(options.source, KINDS)
    else:
        benchmark = BENCHMARKS[options.benchmark]
        kind, known = KINDS["against"] if options.against else benchmark, benchmark.cases(build)
    if getattr(options, "pictures", False) and options.json is not None:
        raise Problem("--json holds one benchmark; leave out --pictures, or measure `render` and `golden` on their own")
    cases = choose(known, options)
    pictures = outputs(kind, cases, options)
    if options.list:
        print(table("<<", list(dict.fromkeys((one["case"], one["what"]) for one in known))), end="")
        return
    results = cases if options.benchmark == "show" else measured(benchmark, build, cases, options)
    shown, drawn = kind.text(results), kind.drawn(results) if options.chart else {}
    # Times are in seconds, memory of the engine is in kB, that of films in bytes.
    data = json.dumps({"benchmark": kind.name, "results": results}, indent=1, ensure_ascii=False) + "\n"
    print(data if options.json == "-" else shown, end="")
    if options.json not in (None, "-"):
        write_whole(Path(options.json), data.encode())
    if getattr(options, "pictures", False):
        show_pictures(options, build)
    for path, (part, theme) in pictures.items():
        if part in drawn:
            write_whole(path, charts.draw(drawn[part], theme, path.suffix[1:]))


def main(words: list[str]) -> int:
    """Runs the command; its exit code."""
    options = argparse.Namespace(benchmark="")
    try:
        options = parse(words)
        perform(options)
        return 0
    except Problem as problem:
        note(f"{problem}.".replace("?.", "?"))
        return problem.code
    except KeyboardInterrupt:
        note("stopped before the first case was done.")
        return FAILED
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except Exception as error:  # any, for a file that another program wrote
        if options.benchmark != "show":
            raise
        note(f"'{options.source}' is not what `./boxreel bench NAME --json FILE` writes ({error}); make it again.")
        return UNUSABLE


if __name__ == "__main__":
    for stopping in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(stopping, signal.default_int_handler)  # ends in order: no frames and films are left behind
    sys.exit(main(sys.argv[1:]))
