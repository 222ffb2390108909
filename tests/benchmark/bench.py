#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the benchmark programs of a build: prints tables, writes figures as JSON and draws charts.

`./boxreel bench` builds the programs and starts this with the build folder in BOXREEL_BUILD_DIR.
"""
from __future__ import annotations

import argparse
import difflib
import json
import os
import signal
import statistics
import sys
import tempfile
from pathlib import Path
from typing import Any, NoReturn

sys.dont_write_bytecode = True
from runner import accuracy, charts, comparing, drawing, engine, recording  # noqa: E402
from runner.common import (FAILED, Problem, Result, check_outputs, note, read_results, table,  # noqa: E402
                           time_text, times_text, unusable, write_whole)

CHECKOUT = Path(__file__).resolve().parents[2]
# A benchmark is a module: WHAT, cases, measure, judge, text, drawn, rivals.
BENCHMARKS = {"engine": engine, "curve": engine, "accuracy": accuracy, "render": drawing, "record": recording,
              "golden": comparing}


class Parser(argparse.ArgumentParser):
    """Says in one sentence what is wrong, and ends with 1."""

    def error(self, message: str) -> NoReturn:
        raise Problem(f"{message}; `{self.prog} --help` shows what there is")


def count(text: str) -> int:
    """A whole number from 1 on."""
    if not text.isdecimal() or not 1 <= int(text) <= 100_000:
        raise argparse.ArgumentTypeError(f"'{text}' is no whole number from 1 to 100000")
    return int(text)


def counts(text: str) -> list[int]:
    """Thread counts, each once."""
    numbers = [count(word) for word in text.split(",")]
    if len(set(numbers)) < len(numbers) or max(numbers) > 64:
        raise argparse.ArgumentTypeError(f"'{text}' names a count twice, or one above 64")
    return numbers


def even_size(text: str) -> tuple[int, int]:
    """WxH; films are compared in a format whose sides are even."""
    sides = [count(word) for word in text.split("x")]
    if len(sides) != 2 or any(side % 2 for side in sides):
        raise argparse.ArgumentTypeError(f"'{text}' is no size with even sides such as 640x360")
    return sides[0], sides[1]


def parse(words: list[str]) -> argparse.Namespace:
    """The options. What goes with --from is only what shows results."""
    parser = Parser(prog="./boxreel bench", description="Run benchmarks beside peers; `./boxreel bench NAME --help` tells more.")
    commands = parser.add_subparsers(dest="benchmark", metavar="NAME", required=True)
    for name, module in BENCHMARKS.items():
        what = module.WHAT if name != "curve" else "time steps with 200 to 200,000 static or sleeping bodies"
        command = commands.add_parser(name, help=what, description=what[0].upper() + what[1:] + ".", allow_abbrev=False)
        add = command.add_argument
        if name != "curve":
            add("cases", nargs="*", metavar="CASE", help="cases to run, such as those of --list (default: all)")
        add("--list", action="store_true", help="print the cases")
        add("--rounds", type=count, metavar="N", help="times that each method runs, in turn (default: 3)")
        if module is engine:
            add("--threads", type=counts, metavar="N[,N...]", help="thread counts of boxreel (default: 1)")
        if name == "record":
            add("--frames", type=count, metavar="N", help="frames of the films (default: those of the case)")
            add("--size", type=even_size, metavar="WxH", help="size of the films (default: that of the case)")
        if name == "golden":
            add("--peers", metavar="DIR", help="folder where `npm install odiff-bin pixelmatch` was run (BOXREEL_PEERS)")
        source = command.add_mutually_exclusive_group()
        source.add_argument("--from", dest="source", metavar="FILE", help="show what --json wrote; run nothing")
        source.add_argument("--against", type=Path, metavar="BUILD", help="time another build folder's programs alternately")
        add("--json", metavar="FILE", help="write all figures; `-` prints them instead of tables")
        add("--chart", action="append", type=Path, default=[], metavar="FILE", help="draw .png or .svg; repeatable")
        add("--theme", choices=["light", "dark", "both"], default="light", help="of charts; `both` adds -light and -dark to names")
        add("--force", action="store_true", help="overwrite existing files")
    options = parser.parse_args(words)
    given = [name for name in ("rounds", "threads", "frames", "size", "peers") if getattr(options, name, None)]
    if options.source and given:
        raise Problem(f"--from runs nothing; leave --{given[0]} out, or --from")
    if options.against and options.chart:
        raise Problem("--against prints ratios and draws none; leave --chart out, or --against")
    for chart in options.chart:
        if chart.suffix not in (".png", ".svg"):
            raise Problem(f"unsupported extension of '{chart}'; use .png or .svg")
    options.rounds, options.threads = options.rounds or 3, getattr(options, "threads", None) or [1]
    return options


def choose(cases: list[Result], options: argparse.Namespace) -> list[Result]:
    """The cases that were named, else those that are run by default."""
    names, known = getattr(options, "cases", []), {one["case"]: one for one in cases}
    if options.benchmark == "curve":
        return [one for one in cases if one["curve"]]
    for name in names:
        if name not in known and (options.source or options.benchmark != "golden"):  # that takes any scene
            near = "".join(f"; did you mean '{word}'?" for word in difflib.get_close_matches(name, known, 1))
            raise Problem(f"unknown case '{name}'; `./boxreel bench {options.benchmark} --list` shows all{near}")
        if names.count(name) > 1:
            raise Problem(f"'{name}' is named twice; give it once")
    return [known.get(name, {"case": name, "what": "this scene"}) for name in names] or [
        one for one in cases if not one.get("onlyForCurve") and not one.get("onlyNamed")]


def chart_path(path: Path, name: str, theme: str) -> Path:
    """error.svg becomes error-A-projectile-dark.svg."""
    return path.with_name("-".join(word for word in (path.stem, name, theme) if word) + path.suffix)


def themes(options: argparse.Namespace) -> dict[str, str]:
    """What the names of charts have besides, and the theme."""
    return {"light": "light", "dark": "dark"} if options.theme == "both" else {"": options.theme}


def measured(module: Any, build: Path, cases: list[Result], options: argparse.Namespace) -> list[Result]:
    """The results of all cases, or of those before a signal to stop."""
    results: list[Result] = []
    try:
        for case in cases:
            note(f"{case['case']}: {case['what']}")
            with tempfile.TemporaryDirectory(prefix="boxreel-bench-") as work:
                results.append(module.measure(build, case, options, Path(work)))
    except KeyboardInterrupt:
        if not results:
            raise
        note("stopped; the cases before are shown")
    return results


def against(module: Any, build: Path, cases: list[Result], options: argparse.Namespace) -> tuple[str, list[Result]]:
    """Both builds alternately: the median of the rounds' ratios, and their spread."""
    rows = [["case", "", "this build", "other build", "other/this", "spread", "results"]]
    results = []
    for case in cases:
        note(f"{case['case']}: {case['what']}")
        rounds: dict[Path, list[Any]] = {build: [], options.against: []}
        for number in range(options.rounds):
            for folder in sorted(rounds, key=lambda folder: folder == build, reverse=number % 2 == 0):
                with tempfile.TemporaryDirectory(prefix="boxreel-bench-") as work:
                    rounds[folder].append(module.rivals(folder, case, options, Path(work)))
        ours, others = rounds.values()
        same = len({bits for _, bits in [*ours, *others]}) == 1
        for name in ours[0][0].keys() & others[0][0].keys():
            pairs = [(one[name], other[name]) for (one, _), (other, _) in zip(ours, others)]
            ratios = sorted(other / one for one, other in pairs)
            results.append({"case": case["case"], "figure": name, "seconds": pairs, "ratio": statistics.median(ratios),
                            "ratios": ratios, "sameResults": same})
            rows.append([case["case"], name, *(time_text(statistics.median(times)) for times in zip(*pairs)),
                         times_text(statistics.median(ratios)), f"{times_text(ratios[0])} to {times_text(ratios[-1])}",
                         "same" if same else "DIFFERENT"])
    return table("<<>>>><", [rows[0], *sorted(rows[1:])]), results


def show(module: Any, results: list[Result], options: argparse.Namespace) -> None:
    """Prints, writes and draws results."""
    name = options.benchmark if options.benchmark != "curve" else "engine"
    try:
        for result in results:
            module.judge(result)
        shown = module.text(results)
        drawn = (engine.drawn_curve if options.benchmark == "curve" else module.drawn)(results) if options.chart else {}
        pictures = {chart_path(path, part, suffix): charts.draw(chart, theme, path.suffix[1:]) for path in options.chart
                    for part, chart in drawn.items() for suffix, theme in themes(options).items()}
    except (KeyError, TypeError, ValueError, IndexError, AttributeError, ArithmeticError, StopIteration) as error:
        if not options.source:
            raise
        raise unusable(options.source, name, error) from error
    write_json(name, results, options)
    print(shown if options.json != "-" else "", end="")
    check_outputs(list(pictures), options.force)
    for path, data in pictures.items():
        write_whole(path, data)


def write_json(name: str, results: list[Result], options: argparse.Namespace) -> None:
    """All figures, times in seconds."""
    data = json.dumps({"benchmark": name, "results": results}, indent=1, ensure_ascii=False) + "\n"
    if options.json == "-":
        print(data, end="")
    elif options.json:
        write_whole(Path(options.json), data.encode())


def main(words: list[str]) -> int:
    """Runs the command; its exit code."""
    options = parse(words)
    module, build = BENCHMARKS[options.benchmark], Path(os.environ.get("BOXREEL_BUILD_DIR") or CHECKOUT / "build/release")
    outputs = [Path(options.json)] if options.json not in (None, "-") else []
    check_outputs(outputs + [chart_path(path, "", suffix) for path in options.chart for suffix in themes(options)], options.force)
    if options.chart:
        charts.check()
    results = read_results(options.source, "engine" if options.benchmark == "curve" else options.benchmark) if options.source else []
    cases = choose(results or module.cases(build), options)
    if options.list:
        print(table("<<", [[one["case"], one["what"]] for one in results or module.cases(build)]), end="")
    elif options.against:
        shown, ratios = against(module, build, cases, options)
        write_json("against", ratios, options)
        print(shown if options.json != "-" else "", end="")
    else:
        show(module, cases if results else measured(module, build, cases, options), options)
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
        print(f"bench: {problem}.", file=sys.stderr)
        sys.exit(problem.code)
    except KeyboardInterrupt:
        print("bench: stopped before the first case was done.", file=sys.stderr)
        sys.exit(FAILED)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
