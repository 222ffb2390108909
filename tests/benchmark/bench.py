#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs benchmark programs for `./boxreel bench`: prints tables, writes figures as JSON and draws charts."""
import argparse
import difflib
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
    ABSENT, FAILED, TEXTS, UNUSABLE, Benchmark, Problem, Result, check_outputs,
    note, read_results, table, write_whole)

BENCHMARKS: dict[str, Benchmark] = {one.name: one for one in (
    engine.Engine(), engine.Curve(), accuracy.Accuracy(), toolkit.Drawing(), toolkit.Recording(), toolkit.Comparing())}
KINDS = BENCHMARKS | {"against": against.Against()}  # what a file of figures may hold

EXAMPLES = """Examples:
  ./boxreel bench engine --list
  ./boxreel bench engine large-pyramid rain --threads 1,2
  ./boxreel bench accuracy --json accuracy.json
  ./boxreel bench show accuracy.json J-stack-30 --chart stack.svg
  ./boxreel bench engine --against ../before/build/release

`./boxreel bench NAME --help` shows the options of a benchmark."""


class Parser(argparse.ArgumentParser):
    """Reports a wrong command line in one sentence, with exit code 1."""

    def error(self, message: str) -> None:
        raise Problem(f"{message}; `{self.prog} --help` shows what there is")


def numbers(pattern: str, example: str, most: int):
    """A reader of whole numbers, which are different ones in a list with commas."""
    def read(text: str) -> int | list[int]:
        found = [int(word) for word in re.findall(r"\d+", text)]
        repeated = "," in text and len(set(found)) < len(found)
        if repeated or not re.fullmatch(pattern, text) or not all(1 <= number <= most for number in found):
            raise argparse.ArgumentTypeError(f"'{text}' is not like {example}, with numbers from 1 to {most}")
        return found if re.search("[,x]", example) else found[0]
    return read


def parse(words: list[str]) -> argparse.Namespace:
    """The options of texts.json, of which none contradicts another."""
    parser = Parser(prog="./boxreel bench", description="Run benchmarks beside other engines, renderers and encoders.",
                    epilog=EXAMPLES, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="benchmark", metavar="NAME", required=True)
    for name in (*BENCHMARKS, "show"):
        what = TEXTS[name]["what"]
        command = commands.add_parser(name, help=what, description=f"{what[0].upper()}{what[1:]}.", allow_abbrev=False)
        own = TEXTS[name].get("options", {})
        for flag, how in (own | TEXTS["options"] | (TEXTS["measuring"] if name in BENCHMARKS else {})).items():
            command.add_argument(flag, **how | ({"type": numbers(*how["type"])} if "type" in how else {}))
    options = parser.parse_args(words)
    for chart in options.chart:
        if Path(chart).suffix not in (".png", ".svg"):
            raise Problem(f"unsupported extension of '{chart}'; use .png or .svg")
    return options


def choose(cases: list[Result], options: argparse.Namespace) -> list[Result]:
    """The cases that were named, else those that are run by default; a file may hold several results of a case."""
    shown, known = options.benchmark == "show", [one["case"] for one in cases]
    for name in options.cases:
        if name not in known and options.benchmark != "golden":  # which takes any scene
            near = "".join(f"; did you mean '{word}'?" for word in difflib.get_close_matches(name, known, 1))
            place = options.source if shown else options.benchmark
            raise Problem(f"unknown case '{name}'; `./boxreel bench {'show ' * shown}{place} --list` shows all{near}")
        if options.cases.count(name) > 1:
            raise Problem(f"'{name}' is named twice; give it once")
    return [one for name in options.cases for one in ([one for one in cases if one["case"] == name] or
                                                      [{"case": name, "what": "this scene"}])] or [
        one for one in cases if shown or not one.get("onlyNamed")]


def measured(benchmark: Benchmark, build: Path, case: Result, options: argparse.Namespace) -> Result:
    """The judged figures of a case, made with a folder that is removed afterwards."""
    with tempfile.TemporaryDirectory(prefix="boxreel-bench-") as work:
        result = benchmark.measure(build, case, options, Path(work))
    benchmark.judge(result)
    return result


def measure_all(benchmark: Benchmark, build: Path, cases: list[Result], options: argparse.Namespace) -> list[Result]:
    """The results of all cases, or of those before a signal to stop."""
    results: list[Result] = []
    once = argparse.Namespace(**{**vars(options), "rounds": 1})
    try:
        for case in cases:
            note(f"{case['case']}: {case['what']}")
            results += against.compared(
                benchmark, case, options.rounds, (build, Path(options.against)),
                lambda which, case=case: measured(benchmark, which, case, once)
            ) if options.against else [measured(benchmark, build, case, options)]
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
    check_outputs([*pictures, *([] if options.json in (None, "-") else [Path(options.json)])], options.force)
    if options.chart and importlib.util.find_spec("matplotlib") is None:
        raise Problem("charts need matplotlib; install python3-matplotlib", ABSENT)
    return pictures


def present(kind: Benchmark, results: list[Result], options: argparse.Namespace, pictures: dict) -> None:
    """Prints, writes and draws results. Times are in seconds, memory of the engine is in kB, that of films in bytes."""
    shown, drawn = kind.text(results), kind.drawn(results) if options.chart else {}
    data = json.dumps({"benchmark": kind.name, "results": results}, indent=1, ensure_ascii=False) + "\n"
    print(data if options.json == "-" else shown, end="")
    if options.json not in (None, "-"):
        write_whole(Path(options.json), data.encode())
    for path, (part, theme) in pictures.items():
        if part in drawn:
            write_whole(path, charts.draw(drawn[part], theme, path.suffix[1:]))


def perform(options: argparse.Namespace) -> None:
    """Lists or measures cases, or reads their results, and presents them."""
    build = Path(os.environ.get("BOXREEL_BUILD_DIR") or Path(__file__).resolve().parents[2] / "build" / "release")
    if options.benchmark == "show":
        kind, known = read_results(options.source, KINDS)
    else:
        benchmark = BENCHMARKS[options.benchmark]
        kind, known = KINDS["against"] if options.against else benchmark, benchmark.cases(build)
    cases = choose(known, options)
    pictures = outputs(kind, cases, options)
    if options.list:
        print(table("<<", list(dict.fromkeys((one["case"], one["what"]) for one in known))), end="")
        return
    present(kind, cases if options.benchmark == "show" else measure_all(benchmark, build, cases, options), options,
            pictures)


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
    except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError, StopIteration,
            RecursionError) as error:
        if options.benchmark != "show":
            raise
        note(f"'{options.source}' is not what `./boxreel bench NAME --json FILE` writes ({error}); make it again.")
        return UNUSABLE


if __name__ == "__main__":
    for stopping in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(stopping, signal.default_int_handler)  # ends in order: no frames and films are left behind
    sys.exit(main(sys.argv[1:]))
