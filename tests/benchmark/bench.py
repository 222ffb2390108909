#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs the benchmark programs of a build: prints tables, writes figures as JSON and draws charts.

`./boxreel bench` builds the programs and starts this with the build folder in BOXREEL_BUILD_DIR.
"""
from __future__ import annotations

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
from typing import Any, Iterable, NoReturn

sys.dont_write_bytecode = True
from runner import accuracy, charts, comparing, drawing, engine, recording  # noqa: E402
from runner.common import (  # noqa: E402
    FAILED, TEXTS, Benchmark, Problem, Result, cell, check_outputs, note, read_results, table, time_text, times_text,
    unusable, value_at, write_whole)

BENCHMARKS: dict[str, Benchmark] = {one.name: one for one in (
    engine.Engine(), engine.Curve(), accuracy.Accuracy(), drawing.Drawing(), recording.Recording(),
    comparing.Comparing())}


class Parser(argparse.ArgumentParser):
    """Says in one sentence what is wrong, and ends with 1."""

    def error(self, message: str) -> NoReturn:
        raise Problem(f"{message}; `{self.prog} --help` shows what there is")


def numbers(pattern: str, example: str, most: int) -> Any:
    """A reader of whole numbers from 1 to `most`, between what else the pattern has."""
    def read(text: str) -> list[int]:
        found = [int(word) for word in re.findall(r"\d+", text)]
        if not re.fullmatch(pattern, text) or not all(1 <= number <= most for number in found) or (
                "," in text and len(set(found)) < len(found)):
            raise argparse.ArgumentTypeError(f"'{text}' is not like {example}, with numbers from 1 to {most}")
        return found
    return read


def parse(words: list[str]) -> argparse.Namespace:
    """The options. What goes with --from is only what shows results."""
    parser = Parser(prog="./boxreel bench", description="Run benchmarks beside peers; `NAME --help` tells more.")
    commands = parser.add_subparsers(dest="benchmark", metavar="NAME", required=True)
    for name in BENCHMARKS:
        what = TEXTS[name]["what"]
        command = commands.add_parser(name, help=what, description=f"{what[0].upper()}{what[1:]}.", allow_abbrev=False)
        command.set_defaults(threads=None, frames=None, size=None, peers=None)
        add = command.add_argument
        add("cases", nargs="*", metavar="CASE", help="cases to run, such as those of --list (all)")
        add("--list", action="store_true", help="print the cases")
        add("--rounds", type=numbers(r"\d{1,4}", "3", 1000), metavar="N", help="runs of each method, in turn (3)")
        if name in ("engine", "curve"):
            add("--threads", type=numbers(r"\d{1,2}(,\d{1,2})*", "1,2", 64), metavar="N[,N...]", help="of boxreel (1)")
        if name == "record":
            add("--frames", type=numbers(r"\d{1,6}", "600", 100_000), metavar="N", help="of films (the case's own)")
            add("--size", type=numbers(r"\d{0,3}[02468]x\d{0,3}[02468]", "640x360, with even sides", 8192),
                metavar="WxH", help="of films (the case's own)")
        if name == "golden":
            add("--peers", metavar="DIR", help="where `npm install odiff-bin pixelmatch` was run (BOXREEL_PEERS)")
        source = command.add_mutually_exclusive_group()
        source.add_argument("--from", dest="source", metavar="FILE", help="show what --json wrote; run nothing")
        source.add_argument("--against", type=Path, metavar="BUILD", help="time another build folder alternately")
        add("--json", metavar="FILE", help="write all figures; `-` prints them instead of tables")
        add("--chart", action="append", type=Path, default=[], metavar="FILE", help="draw .png or .svg; repeatable")
        add("--theme", choices=["light", "dark", "both"], default="light", help="of charts; `both` adds it to names")
        add("--force", action="store_true", help="overwrite existing files")
    options = parser.parse_args(words)
    given = [name for name in ("rounds", "threads", "frames", "size", "peers") if getattr(options, name)]
    if options.source and given:
        raise Problem(f"--from runs nothing; leave --{given[0]} out, or --from")
    if options.against and options.chart:
        raise Problem("--against prints ratios and draws none; leave --chart out, or --against")
    for chart in (chart for chart in options.chart if chart.suffix not in (".png", ".svg")):
        raise Problem(f"unsupported extension of '{chart}'; use .png or .svg")
    options.rounds, options.frames = (options.rounds or [3])[0], (options.frames or [0])[0]
    options.threads = options.threads or [1]
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
    """The figures of a case, with a folder that is removed afterwards."""
    with tempfile.TemporaryDirectory(prefix="boxreel-bench-") as work:
        result = benchmark.measure(build, case, options, Path(work))
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


def against(benchmark: Benchmark, build: Path, cases: list[Result],
            options: argparse.Namespace) -> tuple[str, list[Result]]:
    """Both builds alternately: the median of the rounds' ratios, their spread, and whether both compute the same."""
    rounds, options.rounds = options.rounds, 1
    texts = TEXTS[benchmark.name] if "columns" in TEXTS[benchmark.name] else TEXTS["engine"]
    rows, results = [["case", "", "", "this build", "other build", "other/this", "spread", "results"]], []
    for case in cases:
        note(f"{case['case']}: {case['what']}")
        runs: list[list[list[Result]]] = [[], []]
        for number in range(rounds):
            for which in (0, 1) if number % 2 == 0 else (1, 0):
                result = measured(benchmark, (build, options.against)[which], case, options)
                benchmark.judge(result)
                runs[which].append(result.get("methods") or result["runs"])
        for index, one in enumerate(runs[0][0]):
            name = " ".join(cell(one, path, kind) for _, path, kind in texts["columns"] if kind == "name")
            same = all(value_at(run[index], key) == value_at(one, key)
                       for run in sum(runs, []) for key in texts["same"])
            columns = [(head, path) for head, path, kind in texts["columns"] if kind == "time" and value_at(one, path)]
            for head, path in columns:
                pairs = [(value_at(ours[index], path), value_at(other[index], path)) for ours, other in zip(*runs)]
                ratios = sorted(other / ours for ours, other in pairs)
                ratio = statistics.median(ratios)
                results.append({"case": case["case"], "method": name, "figure": head, "seconds": pairs, "ratio": ratio,
                                "lowest": ratios[0], "highest": ratios[-1], "sameResults": same})
                rows.append([case["case"], name, head, *(time_text(statistics.median(times)) for times in zip(*pairs)),
                             times_text(ratio), f"{times_text(ratios[0])} to {times_text(ratios[-1])}",
                             "same" if same else "DIFFERENT"])
    return table("<<<>>>><", rows), results


def chart_paths(parts: Iterable[str], options: argparse.Namespace) -> dict[Path, tuple[str, str]]:
    """The charts' parts and themes by their files: error.svg becomes error-A-projectile-dark.svg."""
    suffixes = {"-light": "light", "-dark": "dark"} if options.theme == "both" else {"": options.theme}
    return {path.with_name(f"{path.stem}{'-' * bool(part)}{part}{suffix}{path.suffix}"): (part, theme)
            for path in dict.fromkeys(options.chart) for part in parts for suffix, theme in suffixes.items()}


def show(benchmark: Benchmark, results: list[Result], options: argparse.Namespace) -> None:
    """Judges results, prints, writes and draws them."""
    try:
        for result in results:
            benchmark.judge(result)
        shown, drawn = benchmark.text(results), benchmark.drawn(results) if options.chart else {}
    except (KeyError, TypeError, ValueError, IndexError, AttributeError, ArithmeticError, StopIteration) as error:
        if not options.source:
            raise
        raise unusable(options.source, benchmark.name, error) from error
    output(benchmark.name, results, shown, options)
    for path, (part, theme) in chart_paths(drawn, options).items():
        write_whole(path, charts.draw(drawn[part], theme, path.suffix[1:]))


def output(name: str, results: list[Result], shown: str, options: argparse.Namespace) -> None:
    """Prints the tables, or writes all figures: times in seconds, memory of the engine in kB, of films in bytes."""
    data = json.dumps({"benchmark": name, "results": results}, indent=1, ensure_ascii=False) + "\n"
    print(data if options.json == "-" else shown, end="")
    if options.json not in (None, "-"):
        write_whole(Path(options.json), data.encode())


def main(words: list[str]) -> int:
    """Runs the command; its exit code."""
    options = parse(words)
    benchmark = BENCHMARKS[options.benchmark]
    build = Path(os.environ.get("BOXREEL_BUILD_DIR") or Path(__file__).resolve().parents[2] / "build" / "release")
    results = read_results(options.source, benchmark.name) if options.source else []
    known = results or benchmark.cases(build)
    cases = choose(known, options)
    outputs = [] if options.json in (None, "-") else [Path(options.json)]
    check_outputs(outputs + list(chart_paths(benchmark.parts(cases), options)), options.force)
    if options.chart:
        charts.check()
    if options.list:
        print(table("<<", [[one["case"], one["what"]] for one in known]), end="")
    elif options.against:
        shown, ratios = against(benchmark, build, cases, options)
        output("against", ratios, shown, options)
    else:
        show(benchmark, cases if results else measure_all(benchmark, build, cases, options), options)
    return 0


def stop(number: int, frame: Any) -> NoReturn:
    """Ends in order, so that no frames and films are left behind."""
    raise KeyboardInterrupt


if __name__ == "__main__":
    for stopping in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(stopping, stop)
    try:
        sys.exit(main(sys.argv[1:]))
    except Problem as problem:
        print(f"bench: {problem}.".replace("?.", "?"), file=sys.stderr)
        sys.exit(problem.code)
    except KeyboardInterrupt:
        print("bench: stopped before the first case was done.", file=sys.stderr)
        sys.exit(FAILED)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
