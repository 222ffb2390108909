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
from runner import accuracy, charts, engine, toolkit  # noqa: E402
from runner.common import (  # noqa: E402
    ABSENT, FAILED, TEXTS, UNUSABLE, Benchmark, Problem, Result, cell, check_outputs, columns_table, median_of,
    note, read_results, table, value_at, write_whole)

BENCHMARKS: dict[str, Benchmark] = {one.name: one for one in (
    engine.Engine(), engine.Curve(), accuracy.Accuracy(), toolkit.Drawing(), toolkit.Recording(), toolkit.Comparing())}
MEASURING = ("--rounds", "--threads", "--frames", "--size", "--peers", "--against")  # these do not go with --from


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
    parser = Parser(prog="./boxreel bench", description="Run benchmarks beside peers; `NAME --help` tells more.")
    commands = parser.add_subparsers(dest="benchmark", metavar="NAME", required=True)
    for name in BENCHMARKS:
        what = TEXTS[name]["what"]
        command = commands.add_parser(name, help=what, description=f"{what[0].upper()}{what[1:]}.", allow_abbrev=False)
        for flag, how in (TEXTS["options"] | TEXTS[name].get("options", {})).items():
            command.add_argument(flag, **how | ({"type": numbers(*how["type"])} if "type" in how else {}))
    options = parser.parse_args(words)
    for word in words if options.source else []:
        if word.startswith(MEASURING):
            raise Problem(f"--from runs nothing; leave {word} out, or --from")
    if options.against and options.chart:
        raise Problem("--against prints ratios and draws none; leave --chart out, or --against")
    for chart in options.chart:
        if Path(chart).suffix not in (".png", ".svg"):
            raise Problem(f"unsupported extension of '{chart}'; use .png or .svg")
    return options


def choose(cases: list[Result], options: argparse.Namespace) -> list[Result]:
    """The cases that were named, else those that are run by default."""
    known = {one["case"]: one for one in cases}
    for name in options.cases:
        if name not in known and (options.source or options.benchmark != "golden"):  # which takes any scene
            near = "".join(f"; did you mean '{word}'?" for word in difflib.get_close_matches(name, known, 1))
            raise Problem(f"unknown case '{name}'; `./boxreel bench {options.benchmark} --list` shows all{near}")
        if options.cases.count(name) > 1:
            raise Problem(f"'{name}' is named twice; give it once")
    return [known.get(name, {"case": name, "what": "this scene"}) for name in options.cases] or [
        one for one in cases if options.source or not one.get("onlyNamed")]


def measured(benchmark: Benchmark, build: Path, case: Result, options: argparse.Namespace) -> Result:
    """The judged figures of a case, made with a folder that is removed afterwards."""
    with tempfile.TemporaryDirectory(prefix="boxreel-bench-") as work:
        result = benchmark.measure(build, case, options, Path(work))
    benchmark.judge(result)
    return result


def compared(benchmark: Benchmark, build: Path, case: Result, options: argparse.Namespace) -> list[Result]:
    """Both builds alternately: the median of the rounds' ratios, their spread, and whether both compute the same."""
    builds, results = (build, Path(options.against)), []
    runs: tuple[list, list] = ([], [])  # of both builds: the methods of each round
    once = argparse.Namespace(**{**vars(options), "rounds": 1})
    for number in range(options.rounds):
        for which in (0, 1) if number % 2 == 0 else (1, 0):
            runs[which].append(measured(benchmark, builds[which], case, once)[benchmark.key])
    texts = TEXTS[benchmark.name]
    for index, one in enumerate(runs[0][0]):
        name = " ".join(cell(one, path, kind) for _, path, kind in texts["columns"] if kind == "name").strip()
        same = all(value_at(run[index], key) == value_at(one, key) for run in sum(runs, []) for key in texts["same"])
        for head, path, kind in texts["columns"]:
            if kind == "time" and value_at(one, path):
                pairs = [(value_at(ours[index], path), value_at(other[index], path)) for ours, other in zip(*runs)]
                ratios = [other / ours for ours, other in pairs]
                results.append({"case": case["case"], "method": name, "figure": head, "seconds": pairs,
                                "this": median_of([ours for ours, _ in pairs]),
                                "other": median_of([other for _, other in pairs]), "ratio": median_of(ratios),
                                "lowest": min(ratios), "highest": max(ratios), "sameResults": same})
    return results


def measure_all(benchmark: Benchmark, build: Path, cases: list[Result], options: argparse.Namespace) -> list[Result]:
    """The results of all cases, or of those before a signal to stop."""
    results: list[Result] = []
    try:
        for case in cases:
            note(f"{case['case']}: {case['what']}")
            results += compared(benchmark, build, case, options) if options.against else [
                measured(benchmark, build, case, options)]
    except KeyboardInterrupt:
        if not results:
            raise
        note("stopped; the cases before are shown")
    return results


def perform(benchmark: Benchmark, options: argparse.Namespace) -> None:
    """Lists or measures cases, or reads their results; prints, writes and draws them."""
    build = Path(os.environ.get("BOXREEL_BUILD_DIR") or Path(__file__).resolve().parents[2] / "build" / "release")
    known = read_results(options.source, benchmark) if options.source else benchmark.cases(build)
    cases = choose(known, options)
    # The part and theme of each chart by its file: error.svg becomes error-A-projectile-dark.svg.
    parts = dict.fromkeys(part.format(**case) for case in cases for part in benchmark.parts)
    suffixes = {f"-{theme}": theme for theme in charts.THEMES} if options.theme == "both" else {"": options.theme}
    pictures = {path.with_name(f"{path.stem}{'-' * bool(part)}{part}{suffix}{path.suffix}"): (part, theme)
                for path in map(Path, options.chart) for part in parts for suffix, theme in suffixes.items()}
    check_outputs([*pictures, *([] if options.json in (None, "-") else [Path(options.json)])], options.force)
    if options.chart and importlib.util.find_spec("matplotlib") is None:
        raise Problem("charts need matplotlib; install python3-matplotlib", ABSENT)
    if options.list:
        print(table("<<", [[one["case"], one["what"]] for one in known]), end="")
        return
    results = cases if options.source else measure_all(benchmark, build, cases, options)
    shown = columns_table(TEXTS["against"]["columns"], results) if options.against else benchmark.text(results)
    drawn = benchmark.drawn(results) if options.chart else {}
    # Times are in seconds, memory of the engine is in kB, that of films in bytes.
    data = {"benchmark": "against" if options.against else benchmark.name, "results": results}
    data = json.dumps(data, indent=1, ensure_ascii=False) + "\n"
    print(data if options.json == "-" else shown, end="")
    if options.json not in (None, "-"):
        write_whole(Path(options.json), data.encode())
    for path, (part, theme) in pictures.items():
        if part in drawn:
            write_whole(path, charts.draw(drawn[part], theme, path.suffix[1:]))


def main(words: list[str]) -> int:
    """Runs the command; its exit code."""
    options = argparse.Namespace(source=None)
    try:
        options = parse(words)
        perform(BENCHMARKS[options.benchmark], options)
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
        if not options.source:
            raise
        note(f"'{options.source}' is not what `./boxreel bench {options.benchmark} --json FILE` writes ({error}); "
             "make it again.")
        return UNUSABLE


if __name__ == "__main__":
    for stopping in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(stopping, signal.default_int_handler)  # ends in order: no frames and films are left behind
    sys.exit(main(sys.argv[1:]))
