#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs the benchmark programs of a build: prints tables, writes figures as JSON and draws charts.

`./boxreel bench` builds the programs and starts this with the build folder in BOXREEL_BUILD_DIR.
"""
import argparse
import difflib
import json
import os
import re
import signal
import statistics
import sys
import tempfile
from pathlib import Path
from typing import Any, NoReturn

sys.dont_write_bytecode = True
from runner import accuracy, charts, engine, toolkit  # noqa: E402
from runner.common import (  # noqa: E402
    FAILED, TEXTS, Benchmark, Problem, Result, cell, check_outputs, columns_table, note, read_results, table, value_at,
    write_whole)

BENCHMARKS: dict[str, Benchmark] = {one.name: one for one in (
    engine.Engine(), engine.Curve(), accuracy.Accuracy(), toolkit.Drawing(), toolkit.Recording(),
    toolkit.Comparing())}
MEASURING = ("--rounds", "--threads", "--frames", "--size", "--peers")  # these options do not go with --from


class Parser(argparse.ArgumentParser):
    """Reports a wrong command line in one sentence, with exit code 1."""

    def error(self, message: str) -> NoReturn:
        raise Problem(f"{message}; `{self.prog} --help` shows what there is")


def numbers(text: str, pattern: str, example: str, most: int) -> list[int]:
    """The whole numbers in an argument, which are different ones in a list with commas."""
    found = [int(word) for word in re.findall(r"\d+", text)]
    if not re.fullmatch(pattern, text) or not all(1 <= number <= most for number in found) or (
            "," in text and len(set(found)) < len(found)):
        raise argparse.ArgumentTypeError(f"'{text}' is not like {example}, with numbers from 1 to {most}")
    return found


def parse(words: list[str]) -> argparse.Namespace:
    """The options, of which none contradicts another."""
    shared = argparse.ArgumentParser(add_help=False)
    add = shared.add_argument
    add("cases", nargs="*", metavar="CASE", help="cases to run, such as those of --list (all)")
    add("--list", action="store_true", help="print the cases")
    add("--rounds", type=lambda text: numbers(text, r"\d{1,4}", "3", 1000)[0], default=3, metavar="N",
        help="runs of each method, in turn (3)")
    source = shared.add_mutually_exclusive_group()
    source.add_argument("--from", dest="source", metavar="FILE", help="show what --json wrote; run nothing")
    source.add_argument("--against", type=Path, metavar="BUILD", help="time another build folder alternately")
    add("--json", metavar="FILE", help="write all figures; `-` prints them instead of tables")
    add("--chart", action="append", type=Path, default=[], metavar="FILE", help="draw .png or .svg; repeatable")
    add("--theme", choices=["light", "dark", "both"], default="light", help="of charts; `both` adds it to names")
    add("--force", action="store_true", help="overwrite existing files")
    parser = Parser(prog="./boxreel bench", description="Run benchmarks beside peers; `NAME --help` tells more.")
    commands = parser.add_subparsers(dest="benchmark", metavar="NAME", required=True)
    for name in BENCHMARKS:
        what = TEXTS[name]["what"]
        add = commands.add_parser(name, parents=[shared], help=what, description=f"{what[0].upper()}{what[1:]}.",
                                  allow_abbrev=False).add_argument
        if name in ("engine", "curve"):
            add("--threads", type=lambda text: numbers(text, r"\d{1,2}(,\d{1,2})*", "1,2", 64), default=[1],
                metavar="N[,N...]", help="of boxreel (1)")
        if name == "record":
            add("--frames", type=lambda text: numbers(text, r"\d{1,6}", "600", 100_000)[0], default=0, metavar="N",
                help="of films (the case's own)")
            add("--size", type=lambda text: numbers(text, r"\d{0,3}[02468]x\d{0,3}[02468]",
                                                    "640x360, with even sides", 8192),
                default=[0, 0], metavar="WxH", help="of films (the case's own)")
        if name == "golden":
            add("--peers", metavar="DIR", help="where `npm install odiff-bin pixelmatch` was run (BOXREEL_PEERS)")
    options = parser.parse_args(words)
    for word in words if options.source else []:
        if word.startswith(MEASURING):
            raise Problem(f"--from runs nothing; leave {word} out, or --from")
    if options.against and options.chart:
        raise Problem("--against prints ratios and draws none; leave --chart out, or --against")
    for chart in options.chart:
        if chart.suffix not in (".png", ".svg"):
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


def measure_all(benchmark: Benchmark, build: Path, cases: list[Result], options: argparse.Namespace) -> list[Result]:
    """The results of all cases, or of those before a signal to stop."""
    results: list[Result] = []
    try:
        for case in cases:
            note(f"{case['case']}: {case['what']}")
            results.append(measured(benchmark, build, case, options))
    except KeyboardInterrupt:
        if not results:
            raise
        note("stopped; the cases before are shown")
    return results


def against(benchmark: Benchmark, build: Path, cases: list[Result], options: argparse.Namespace) -> list[Result]:
    """Both builds alternately: the median of the rounds' ratios, their spread, and whether both compute the same."""
    rounds, options.rounds = options.rounds, 1
    texts, results = TEXTS[benchmark.name], []
    for case in cases:
        note(f"{case['case']}: {case['what']}")
        runs: tuple[list, list] = ([], [])  # of this build and of the other: the methods of each round
        for number in range(rounds):
            for which in (0, 1) if number % 2 == 0 else (1, 0):
                folder = (build, options.against)[which]
                runs[which].append(measured(benchmark, folder, case, options)[benchmark.key])
        for index, one in enumerate(runs[0][0]):
            name = " ".join(cell(one, path, kind) for _, path, kind in texts["columns"] if kind == "name").strip()
            same = all(value_at(run[index], key) == value_at(one, key)
                       for run in runs[0] + runs[1] for key in texts["same"])
            for head, path, kind in texts["columns"]:
                if kind == "time" and value_at(one, path):
                    pairs = [(value_at(ours[index], path), value_at(other[index], path)) for ours, other in zip(*runs)]
                    ratios = [other / ours for ours, other in pairs]
                    results.append({"case": case["case"], "method": name, "figure": head, "seconds": pairs,
                                    "ratio": statistics.median(ratios), "lowest": min(ratios), "highest": max(ratios),
                                    "sameResults": same})
    return results


def against_text(results: list[Result]) -> str:
    """A row a figure."""
    return columns_table(TEXTS["against"]["columns"], [
        {**one, **{which: statistics.median(times) for which, times in zip(("this", "other"), zip(*one["seconds"]))},
         "spread": (one["lowest"], one["highest"]), "same": "same" if one["sameResults"] else "DIFFERENT"}
        for one in results])


def chart_paths(benchmark: Benchmark, cases: list[Result], options: argparse.Namespace) -> dict[Path, tuple[str, str]]:
    """The charts' parts and themes by their files: error.svg becomes error-A-projectile-dark.svg."""
    parts = dict.fromkeys(part.format(**case) for case in cases for part in benchmark.parts)
    suffixes = {"-light": "light", "-dark": "dark"} if options.theme == "both" else {"": options.theme}
    return {path.with_name(f"{path.stem}{'-' * bool(part)}{part}{suffix}{path.suffix}"): (part, theme)
            for path in dict.fromkeys(options.chart) for part in parts for suffix, theme in suffixes.items()}


def perform(benchmark: Benchmark, options: argparse.Namespace) -> None:
    """Lists or measures cases, or reads their results; prints, writes and draws them."""
    build = Path(os.environ.get("BOXREEL_BUILD_DIR") or Path(__file__).resolve().parents[2] / "build" / "release")
    known = read_results(options.source, benchmark) if options.source else benchmark.cases(build)
    cases = choose(known, options)
    files, pictures = [Path(options.json or "-")], chart_paths(benchmark, cases, options)
    check_outputs([path for path in (*files, *pictures) if str(path) != "-"], options.force)
    if options.chart:
        charts.check()
    if options.list:
        print(table("<<", [[one["case"], one["what"]] for one in known]), end="")
        return
    if options.against:
        name, results = "against", against(benchmark, build, cases, options)
    else:
        name, results = benchmark.name, cases if options.source else measure_all(benchmark, build, cases, options)
    shown = against_text(results) if options.against else benchmark.text(results)
    drawn = benchmark.drawn(results) if options.chart else {}
    # Times are in seconds, memory of the engine is in kB, that of films in bytes.
    data = json.dumps({"benchmark": name, "results": results}, indent=1, ensure_ascii=False) + "\n"
    print(data if options.json == "-" else shown, end="")
    if options.json not in (None, "-"):
        write_whole(Path(options.json), data.encode())
    for path, (part, theme) in pictures.items():
        if part in drawn:
            write_whole(path, charts.draw(drawn[part], theme, path.suffix[1:]))


def main(words: list[str]) -> None:
    """Runs the command."""
    options = parse(words)
    try:
        perform(BENCHMARKS[options.benchmark], options)
    except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError, StopIteration, RecursionError) as error:
        if not options.source:
            raise
        raise Problem(f"'{options.source}' is not what `./boxreel bench {options.benchmark} --json FILE` writes "
                      f"({error}); make it again") from error


if __name__ == "__main__":
    for stopping in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(stopping, signal.default_int_handler)  # ends in order: no frames and films are left behind
    try:
        main(sys.argv[1:])
    except Problem as problem:
        print(f"bench: {problem}.".replace("?.", "?"), file=sys.stderr)
        sys.exit(problem.code)
    except KeyboardInterrupt:
        print("bench: stopped before the first case was done.", file=sys.stderr)
        sys.exit(FAILED)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
