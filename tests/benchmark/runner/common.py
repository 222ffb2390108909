# SPDX-License-Identifier: MIT
"""What all benchmarks share: errors, child processes, goals, files, and numbers as text."""
import contextlib
import functools
import json
import math
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from collections import namedtuple
from pathlib import Path
from typing import Any

UNUSABLE, ABSENT, FAILED = 1, 3, 4  # exit codes, the same as the program's
Result = dict[str, Any]  # of a case: its name, what it is, and "methods", ours first
# Bounds of figures by benchmark and case, such as ["<=", 5]; what is written on charts and in tables.
GOALS, TEXTS = (json.loads(Path(__file__).with_name(name).read_text("utf-8")) for name in ("goals.json", "texts.json"))
goal_text = "{0[0]} {0[1]:g}".format  # <= 5
note = functools.partial(print, "bench:", file=sys.stderr, flush=True)  # prints a line about the progress
TEXTS["curve"] = TEXTS["engine"] | TEXTS["curve"]  # the same table
# What a program printed and needed, including the processes that it waited for: times [s], and the max resident
# memory of one process [bytes].
Ended = namedtuple("Ended", "output errors wall cpu memory code")


class Problem(Exception):
    """A sentence for the user, with culprit and remedy, and the exit code that goes with it."""

    def __init__(self, sentence: str, code: int = UNUSABLE) -> None:
        super().__init__(sentence)
        self.code = code


class Benchmark:
    """A kind of measurement. Subclasses have `measure(build, case, options, work)`, which returns a Result;
    `judge(result)`, which adds verdicts (keys of texts.json) and, in `reached`, what goals are for, None where a run is
    broken; and `drawn(results)`, their charts by what is added to the names of their files."""
    name = program = ""
    list_words = ["list"]
    peers: dict[str, str] = {}  # programs, and the packages that they were built with
    parts = [""]  # what `drawn` adds to names, with figures of a case in braces
    key = "methods"  # the member of a Result that has a row for each method

    def cases(self, build: Path) -> list[Result]:
        """All cases; those with `onlyNamed` are run when they are named."""
        return objects(run([program(build, self.program), *self.list_words]).output)

    def programs(self, build: Path, options: Any) -> list[Path]:
        """Our program, and unless we run alone those of the peers that were there at the build."""
        found = [program(build, self.program)]
        for name, package in self.peers.items() if not options.against else []:
            try:
                found.append(program(build, name))
            except Problem:
                note(f"{name} was not built and is not compared; install {package} and build again")
        return found

    def text(self, results: list[Result]) -> str:
        """A row a method, goals, and notes."""
        foot = "".join(f"{line}\n" for line in ["", *TEXTS[self.name].get("foot", [])])
        return columns_table(TEXTS[self.name]["columns"], results, self.key) + goal_table(self.name, results) + foot


def run(words: list, *codes: int) -> Ended:
    """Runs a program to its end. A Problem if it ends with another code than 0 or `codes`."""
    temporary = functools.partial(tempfile.TemporaryFile, "w+", encoding="utf-8", errors="replace")
    with temporary() as output, temporary() as errors:
        start = time.perf_counter()
        try:
            child = subprocess.Popen(list(map(str, words)), stdin=subprocess.DEVNULL, stdout=output, stderr=errors)
        except OSError as error:
            raise Problem(f"cannot run '{words[0]}': {error.strerror}", FAILED) from error
        try:
            _, status, usage = os.wait4(child.pid, 0)
        except BaseException:  # also a signal to stop: no child is left behind
            child.kill()
            child.wait()
            raise
        wall, cpu = time.perf_counter() - start, usage.ru_utime + usage.ru_stime
        code = child.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        errors.seek(0)
        ended = Ended(output.read(), errors.read(), wall, cpu, 1024.0 * usage.ru_maxrss, code)
    if code not in (0, *codes):
        last = (ended.errors.strip() or f"it ended with {code}").splitlines()[-1]
        raise Problem(f"running '{words[0]}' failed: {last}", code if code in (UNUSABLE, ABSENT) else FAILED)
    return ended


def objects(output: str) -> list[Result]:
    """The JSON objects among the lines that a program printed; libraries may print others."""
    with contextlib.suppress(ValueError):
        if found := [json.loads(line) for line in output.splitlines() if line.startswith("{")]:
            return found
    raise Problem(f"a benchmark program printed no figures: '{output.strip()[-200:]}'", FAILED)


def attempt(path: Path, *words: Any) -> Result:
    """The last figures that the program of an engine prints, or `failure`: the others are measured all the same."""
    try:
        return {"program": path.name, "engine": path.name, **objects(run([path, *words]).output)[-1]}
    except Problem as problem:
        note(f"{path.name}: {problem}")
        return {"program": path.name, "engine": path.name, "failure": "failed"}


def version_of(pattern: str, *words: str) -> str | None:
    """The version that a peer prints after the pattern, if it runs."""
    with contextlib.suppress(Problem):
        return re.search(pattern + r" ([^ \n-]+)", run(words).output)[1]


def program(build: Path, name: str) -> Path:
    """A benchmark program of a build folder."""
    path = build / "tests" / "benchmark" / name
    if not os.access(path, os.X_OK):
        raise Problem(f"'{path}' is missing; build the target boxreel_benchmarks", ABSENT)
    return path


def is_number(value: Any) -> bool:
    """True if it is a finite number."""
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def median_of(values: list) -> Any:
    """The median; of objects that of each member, of what is no number the first."""
    if isinstance(values[0], dict):
        return {key: median_of([value[key] for value in values]) for key in values[0]}
    numbers = [value for value in values if is_number(value)]
    return statistics.median(numbers) if numbers else values[0]


def is_met(goal: list, value: float | None) -> bool:
    """Whether a figure meets a goal such as ["<=", 5]; what is None or not a number meets none."""
    return is_number(value) and (value >= goal[1] if goal[0] == ">=" else value <= goal[1])


def missed_goals(one: Result, result: Result) -> list[tuple[str, float | None, list]]:
    """What a run of accuracy reached where it misses a goal; without a goal every error is small enough."""
    reached = {**one.get("remarks", {}), "error": one.get("error")}
    return [(figure, reached.get(figure), goal) for figure, goal in GOALS["accuracy"].get(result.get("case"), {}).items()
            if not is_met(goal, reached.get(figure))]


def verdict_text(one: Result, result: Result, as_reason: bool = False) -> str:
    """The words for the verdict of a run, or the clause by which it is a reason not to compare ours with the peers."""
    remarks = ", ".join(f"{figure} {value} ({goal_text(goal)})" for figure, value, goal in missed_goals(one, result)
                        if figure != "error")
    words, clause = (*TEXTS["verdicts"][one["verdict"]], "boxreel's run has the verdict '{}'")[:2]
    words = words.format(one=one, result=result, remarks=remarks)
    return clause.format(words) if as_reason else words


def read_results(path: str, kinds: dict[str, Benchmark]) -> tuple[Benchmark, list[Result]]:
    """The kind and the results of a file that --json wrote, judged again. A ValueError or the like for another file."""
    try:
        data = json.loads(Path(path).read_text("utf-8"), parse_constant=int)  # which refuses NaN and Infinity
    except OSError as error:
        raise Problem(f"cannot read '{path}': {error.strerror}; name another file") from error
    kind, results = kinds[data["benchmark"]], data["results"]
    if not results:
        raise ValueError("it holds no results")
    for result in results:
        kind.judge(result)
    return kind, results


def write_whole(path: Path, data: bytes) -> None:
    """Writes a file completely or not at all."""
    part = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        part.write_bytes(data)
        part.replace(path)
    except OSError as error:
        raise Problem(f"cannot write '{path}': {error.strerror}; name another file", FAILED) from error
    finally:
        part.unlink(missing_ok=True)


def digits(value: float | None) -> str:
    """Three significant digits, small ones with fewer: 0.038, 4.88, 31.4, 12,300."""
    if not is_number(value):
        return "–"
    size = abs(value)
    places = 0 if size >= 99.95 else 1 if size >= 9.995 else 2 if size >= 0.0995 else 3
    return f"{value:.{places}f}" if size < 999.5 else f"{float(f'{value:.3g}'):,.0f}"


def time_text(seconds: float | None) -> str:
    """7.26 ms, 350 µs."""
    if not is_number(seconds):
        return "–"
    unit, scale = ("s", 1.0) if seconds >= 0.9995 else ("ms", 1e-3) if seconds >= 0.9995e-3 else ("µs", 1e-6)
    return f"{digits(seconds / scale)} {unit}"


def times_text(ratio: float | None) -> str:
    """4.88×, or nothing."""
    return f"{digits(ratio)}×" if ratio else ""


FORMATS = {"name": str, "text": str, "calls": str, "digits": digits, "time": time_text, "times": times_text,
           "count": "{:.0f}".format, "error": "{:.4g}".format,
           "spread": lambda value: f"{value:.2f}{'!' * (value > 2.0)}", "same": {True: "same", False: "DIFFERENT"}.get,
           "kB": lambda value: f"{value / 1024.0:.1f} MB", "MB": lambda value: digits(value / 1e6)}
TO_THE_LEFT = ("name", "text", "same")


def value_at(one: Result, path: str) -> Any:
    """A member, or with dots a member of members; None if it is absent."""
    key, _, rest = path.partition(".")
    return value_at(one.get(key, {}), rest) if rest else one.get(key)


def cell(one: Result, path: str, kind: str) -> str:
    """The text of a member, or of several between slashes."""
    return "/".join(FORMATS[kind](value) for key in path.split("/") if (value := value_at(one, key)) is not None)


def table(align: str, rows: list[list[str]]) -> str:
    """Columns as wide as their widest cell, `<` or `>` each; a row may end early. Control characters become `?`."""
    cells = [["".join(sign if sign.isprintable() else "?" for sign in cell) for cell in row] for row in rows]
    widths = [max((len(row[i]) for row in cells if i < len(row)), default=0) for i in range(len(align))]
    return "".join("  ".join(f"{cell:{way}{width}}" for cell, way, width in zip(row, align, widths)).rstrip() + "\n"
                   for row in cells)


def columns_table(columns: list[list[str]], results: list[Result], key: str = "methods") -> str:
    """A row for each method of each case, or for each result without any, by columns of (head, path, kind). The name of a
    case stands where it begins; a method that failed has its name and verdict alone."""
    rows = [[head for head, _, _ in columns]]
    for result in results:
        for number, one in enumerate(result.get(key, [result])):
            words = verdict_text(one, result) if "verdict" in one else ""
            one = {**one, "verdict": words, "case": result.get("case") if number == 0 else ""}
            rows.append([cell(one, path, kind) for _, path, kind in columns if "failure" not in one or kind in TO_THE_LEFT])
    return table("".join("<" if kind in TO_THE_LEFT else ">" for _, _, kind in columns), rows)


def goal_table(name: str, results: list[Result]) -> str:
    """A line for each goal whose figure is in the `reached` of its case."""
    rows = [[result["case"], figure, digits(result["reached"][figure]), goal_text(goal),
             "met" if is_met(goal, result["reached"][figure]) else "MISSED"]
            for result in results for figure, goal in GOALS.get(name, {}).get(result["case"], {}).items()
            if figure in result.get("reached", {})]
    return "\n" + table("<<><<", [["goals", "", "reached", "goal", ""], *rows]) if rows else ""
