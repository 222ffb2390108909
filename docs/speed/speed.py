#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""speed.py measure [NAME ...] | write | check

Keeps the tables and charts of the pages at what docs/speed/*.json say.

  measure  run the benchmarks (all but accuracy, or those named) into docs/speed/*.json, then write; ten minutes on a
           machine that does nothing else, accuracy half an hour
  write    make tables and charts from the JSON
  check    exit code 1, and a sentence for each table and chart that is not what the JSON say

NAME is engine, drawing, recording, comparing or accuracy. BOXREEL_PEERS is the folder with odiff and pixelmatch
(`./boxreel bench golden --help`). Tables stand between the lines `<!-- table: NAME -->` and `<!-- /table -->`.
"""
import importlib.metadata
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import time

CHECKOUT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(CHECKOUT / "tests" / "benchmark"))
from runner import accuracy, charts, engine, toolkit  # noqa: E402
from runner.common import TEXTS, time_text, times_text, verdict_text  # noqa: E402

PAGES = ["README.md", "docs/speed.md", "docs/accuracy.md", "docs/notes/picture-distance.md"]
# What is measured, a file each. Rounds are so few that all but accuracy takes eight to ten minutes on two quiet cores,
# of which one round of the engines is two and a half or more.
BENCHMARKS = {
    "engine": (engine.Engine(), ["--rounds", "2"]),
    "drawing": (toolkit.Drawing(), ["1500-720p"]),
    "recording": (toolkit.Recording(), ["pyramid", "tumbler", "asleep", "pictures", "--rounds", "1"]),  # seconds each
    "comparing": (toolkit.Comparing(), ["--rounds", "3"]),  # medians of thirty pairs
    "accuracy": (accuracy.Accuracy(), []),
}
# Of the chart of sub-steps: cases whose errors are not 0, by names that fit its legend.
SUB_STEPS_CHARTED = {"C-double-pendulum": "two falling rods", "I-pair": "two spinning rods", "J-stack-30": "stack of 30 boxes"}
CHARTED = ["C-double-pendulum", "D-chain-1000", "I-pair", "J-stack-30"]  # of the cases of accuracy
# Of the page: the cases that decide, and those in which a peer is better.
SHORT_ERRORS = ["A-projectile", "C-double-pendulum", "D-chain-1000", "E-heavy-top-1000", "H-cradle", "I-pair", "J-stack-30",
                "J-card-house", "K-far", "X-walls-100"]
# Of the README: scenes, and rows of the toolkit.
SHORT_SCENES = ["large-pyramid", "tumbler", "rain", "ragdolls", "bullets"]
SHORT_TASKS = ["frame", "film", "frames compared"]
TABLE = re.compile(r"(<!-- table: (\S+) -->\n).*?(<!-- /table -->)", re.DOTALL)


def rows_text(heads, rows):
    """A table in Markdown."""
    lines = [heads, ["---"] * len(heads)] + rows
    return "".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |\n" for line in lines)


# ---------------------------------------------------------------------------------------------- the engine


def engine_cell(result, name):
    """What a peer takes, with the ratio where it is compared."""
    peer = next((one for one in result["methods"] if one["method"] == name), None)
    if not peer:
        return "–"
    if peer["verdict"] in ("failed", "not finite"):
        return verdict_text(peer, result)
    ratio, sound = peer.get("cpuTimes"), result["methods"][0]["verdict"] == "sound"
    verdict = verdict_text(peer, result) if peer["verdict"] != "sound" else "not compared"
    return f"{time_text(peer['cpu'])} ({times_text(ratio) if ratio and sound else verdict})"


def methods_of(results):
    """Their names, ours first."""
    return list(dict.fromkeys(one["method"] for result in results for one in result["methods"]))


def engine_table(figures):
    """Every scene, beside the peers."""
    names, rows, notes = methods_of(figures["engine"]), [], []
    for result in figures["engine"]:
        ours = result["methods"][0]
        rows.append([result["what"], time_text(ours["cpu"]) if "cpu" in ours else verdict_text(ours, result),
                     *(engine_cell(result, name) for name in names[1:])])
        if ours["verdict"] != "sound":
            name = result["what"][:1].upper() + result["what"][1:]
            notes.append(f"{name}: {verdict_text(ours, result, as_reason=True)}, so the times are not compared.")
    return rows_text(["scene", *names], rows) + "".join("\n" + note + "\n" for note in notes)


# ---------------------------------------------------------------------------------------------- the toolkit


def case_of(results, name):
    """The result of a case, if there is one."""
    return next((one for one in results if one["case"] == name), {"methods": []})


def drawing_rows(results):
    """Our frames beside Cairo's, which knows nothing of the frame before: it draws all of it."""
    sound = [one for one in case_of(results, "1500-720p")["methods"] if not one["wrong"] and one["threads"] == "0"]
    ours = next((one for one in sound if one["ours"]), None)
    cairo = next((one for one in sound if one["program"] == "boxreel_render_bench_cairo" and one["usual"]), None)
    for key, task, work in (("frame", "a frame of 1500 shapes, 1280 x 720", "full"),
                            ("frame changed", "the same where 5 % of it changes, in one place", "together")):
        if ours and cairo:
            yield key, task, ours["works"][work]["cpu"], cairo["method"], cairo["works"]["full"]["cpu"]


def recording_rows(results):
    """Films that are sound."""
    for case, key, task in (("pyramid", "film", "{} frames of the pyramid to MP4"),
                            ("tumbler", "film of tumbler", "{} frames of the tumbler to MP4"),
                            ("asleep", "film asleep", "{} frames of the pyramid at rest to MP4"),
                            ("pictures", "pictures", "{} frames of the tumbler to PNG files")):
        films = {one["role"]: one for one in case_of(results, case)["methods"] if one["verdict"] == "sound"}
        for role in toolkit.FILM_PEERS:
            if "boxreel" in films and role in films:
                ours, peer = films["boxreel"], films[role]
                yield (key if role == "encodeOnly" else "", task.format(ours["frames"]), ours["wall"], peer["method"],
                       peer["wall"])


def comparing_rows(results):
    """Medians over all pictures, of the peers with their default settings."""
    methods = toolkit.together(results)
    ours = next((one for one in methods if one["ours"]), {})
    for clock, key, task in (("decoded", "frames compared", "two frames of 1280 x 720 compared"),
                             ("process", "files compared", "two PNG files of 1280 x 720 compared, a process each")):
        for one in methods:
            both = [toolkit.times(method, clock) for method in (ours, one)]
            if not one["ours"] and one["usual"] and all(both):
                yield key, task, statistics.median(both[0]), one["method"], statistics.median(both[1])


# Of the changes that are planted, with a name that is as short as a column.
CHANGES = {"body": "body 1 cm", "line": "line missing", "fill": "fill off by 4", "label": "label", "outline": "outline",
           "order": "order", "stray": "one stray pixel", "shift": "edges 0.1 px"}


def finding_text(method, change, truth):
    """How often a change is called different; bold is wrong."""
    calls = [one["different"] for one in method["pictures"] if one["change"] == change]
    different = sum(calls)
    if truth == "equal":
        all_of = "**different**" if different == len(calls) else f"**{different} different**"
        return "equal" if different == 0 else all_of
    return str(different) if different == len(calls) else f"**{different}**"


def comparing_table(figures):
    """What each method finds."""
    results = figures["comparing"]
    truths = {one["change"]: one["truth"] for one in results[0]["changes"]}
    rows = [["is to be called"] + [truths[change] for change in CHANGES]]
    for method in toolkit.together(results):
        found = [finding_text(method, change, truths[change]) for change in CHANGES]
        rows.append([method["method"], *found])
    return rows_text(["", *CHANGES.values()], rows) + "\n" + machine_text(figures, "comparing")


def toolkit_rows(figures):
    """All tasks of the toolkit."""
    return [*drawing_rows(figures["drawing"]), *recording_rows(figures["recording"]),
            *comparing_rows(figures["comparing"])]


def toolkit_table(figures):
    """Pictures, films and comparisons beside their peers."""
    rows = [[task, time_text(ours), f"{peer}: {time_text(theirs)}", times_text(theirs / ours)]
            for _, task, ours, peer, theirs in toolkit_rows(figures)]
    absent = "".join(f"\n{TEXTS['golden']['absent'][name]}.\n" for name in figures["comparing"][0]["absent"])
    return rows_text(["task", methods_of(figures["engine"])[0], "peer", "times faster"], rows) + absent


def short_table(figures):
    """That of the README."""
    rows = []
    for name in SHORT_SCENES:
        result = case_of(figures["engine"], name)
        peer = next((one for one in result["methods"] if one["program"] == engine.GOAL_PROGRAM), {})
        if peer.get("cpuTimes") and result["methods"][0]["verdict"] == "sound":
            rows.append(["a step: " + result["what"], time_text(result["methods"][0]["cpu"]),
                         f"{peer['method']}: {time_text(peer['cpu'])}", times_text(peer["cpuTimes"])])
    seen = set()
    for key, task, ours, peer, theirs in toolkit_rows(figures):
        if key in SHORT_TASKS and key not in seen:
            seen.add(key)
            rows.append([task, time_text(ours), f"{peer}: {time_text(theirs)}", times_text(theirs / ours)])
    return rows_text(["task", "boxreel", "peer", "times faster"], rows) + "\n" + machine_text(figures, "engine")


def error_text(one, result):
    """How far off a run is, or how it ended."""
    unit = result["unit"]
    if accuracy.ending(one):
        return verdict_text(one, result)
    if unit in ("bodies", "pairs", "rods"):
        return f"{one['error']:.0f} {unit}"
    return "0" if one["error"] == 0.0 else f"{float(format(one['error'], '.2g')):g} {unit}"


def accuracy_runs(figures):
    """Of each case its result, and the runs that the tables show: ours with 2 and 4 sub-steps, then the peers'."""
    first, *others = accuracy.engines_of(figures["accuracy"][0])
    names = [f"{first}, 2 sub-steps", "4 sub-steps", *others]
    return names, [(result, [accuracy.usual(result, first, 2), accuracy.usual(result, first, 4),
                             *(accuracy.usual(result, name) for name in others)]) for result in figures["accuracy"]]


def errors_table(figures):
    """The errors of the cases that a reader needs to choose; docs/speed/accuracy.txt has all."""
    names, cases = accuracy_runs(figures)
    rows = [[f"`{result['case']}`", result["what"], *(error_text(one, result) for one in runs)]
            for result, runs in cases if result["case"] in SHORT_ERRORS]
    return rows_text(["case", "error of", *names], rows)


def sub_steps_table(figures):
    """The CPU times of a step in all cases."""
    names, cases = accuracy_runs(figures)
    rows = []
    for result, runs in cases:
        ours = runs[1]["cpu"]
        rows.append([f"`{result['case']}`", *(time_text(one["cpu"]) for one in runs[:2]),
                     *(f"{time_text(one['cpu'])} ({times_text(one['cpu'] / ours)})" for one in runs[2:])])
    return rows_text(["case", *names], rows) + "\n" + machine_text(figures, "accuracy")


def raw_text(figures):
    """docs/speed/accuracy.txt: errors and times beside each other, for a terminal."""
    tables = [accuracy.summary(figures["accuracy"], steps, with_goals=False) for steps in (2, 4)]
    return "\n".join(tables) + "\n" + machine_text(figures, "accuracy").replace("**", "")


def machine_text(figures, name):
    """When and where a benchmark was measured, and whether anything else ran."""
    machine = figures["machine"][name]
    if machine["load"] >= 0.5:
        others = f"**preliminary: other programs ran** (a load of {machine['load']:.1f} before the first benchmark)"
    elif "others" in machine:
        others = f"other programs used {100 * machine['others']:.1f} % of the processors meanwhile"
    else:
        others = f"a load of {machine['load']:.1f} when it began"
    return f"Measured on {machine['date']} on {machine['processor']}, {machine['processors']} processors; {others}.\n"


TABLES = {"comparing": comparing_table, "engine": engine_table, "errors": errors_table, "short": short_table,
          "sub-steps": sub_steps_table, "toolkit": toolkit_table, "machine": lambda figures: machine_text(figures, "engine")}

# ---------------------------------------------------------------------------------------------- what is done


def machine():
    """The machine as it is before a measurement."""
    model = re.search(r"^model name\s*:\s*(.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    return {"date": time.strftime("%Y-%m-%d"), "load": os.getloadavg()[0], "processors": os.cpu_count(),
            "processor": model[1].strip() if model else os.uname().machine}


def busy_seconds():
    """Of all processors, by all programs, since the machine started; the waiting for disks is none."""
    user, nice, system, _, _, irq, softirq = map(int, pathlib.Path("/proc/stat").read_text().split()[1:8])
    return (user + nice + system + irq + softirq) / os.sysconf("SC_CLK_TCK")


def own_seconds():
    """Of processors, by this program and those that it ran."""
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system


def write_json(checkout, name, content):
    """A file of docs/speed."""
    path = checkout / "docs/speed" / (name + ".json")
    path.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def kept(name, data):
    """Of accuracy what tables and charts show: a whole sweep is a megabyte."""
    for result in data["results"] if name == "accuracy" else []:
        if result["case"] not in CHARTED:
            engines = accuracy.engines_of(result)
            shown = [accuracy.usual(result, method, steps) for method in engines for steps in (2, 4)]
            result["runs"] = [one for one in result["runs"] if any(one is other for other in shown)]
    return data


def measure(checkout, names):
    """Runs benchmarks into their files."""
    about = machine()
    begun_all, busy, own = time.monotonic(), busy_seconds(), own_seconds()
    for name in names:
        benchmark, options = BENCHMARKS[name]
        begun = time.monotonic()
        words = [checkout / "boxreel", "bench", benchmark.name, *options, "--json", "-"]
        done = subprocess.run(words, stdout=subprocess.PIPE, check=False)
        if done.returncode != 0:
            sys.exit(f"`{' '.join(map(str, words[1:]))}` ended with {done.returncode}; see above what it lacks.")
        write_json(checkout, name, kept(name, json.loads(done.stdout)))
        print(f"{name}: {time.monotonic() - begun:.0f} s", file=sys.stderr)
    span = (time.monotonic() - begun_all) * about["processors"]
    about["others"] = round(max(0.0, busy_seconds() - busy - (own_seconds() - own)) / span, 4)
    machines = json.loads((checkout / "docs/speed/machine.json").read_text(encoding="utf-8"))
    write_json(checkout, "machine", {**machines, **dict.fromkeys(names, about)})


def read(checkout):
    """All figures, judged again."""
    folder = checkout / "docs/speed"
    files = {name: json.loads((folder / (name + ".json")).read_text(encoding="utf-8"))
             for name in [*BENCHMARKS, "machine"]}
    for name, (benchmark, _) in BENCHMARKS.items():
        files[name] = files[name]["results"]
        for result in files[name]:
            benchmark.judge(result)
    return files


def filled(text, figures):
    """A page with the tables of these figures."""
    return TABLE.sub(lambda found: f"{found[1]}\n{TABLES[found[2]](figures)}\n{found[3]}", text)


def charts_of(figures):
    """The charts of the pages, by the paths of their files without theme and extension."""
    made = {"docs/speed/engine": BENCHMARKS["engine"][0].drawn(figures["engine"])[""]}
    cases = [result for result in figures["accuracy"] if result["case"] in CHARTED]
    made["docs/speed/sub-steps"] = sub_steps_chart(cases)
    made |= {f"docs/figures/accuracy-{name}": chart for name, chart in BENCHMARKS["accuracy"][0].drawn(cases).items()}
    return made


def drawn(figures):
    """The bytes of the charts, by the paths of their files."""
    return {f"{stem}-{theme}.svg": charts.draw(chart, theme, "svg")
            for stem, chart in charts_of(figures).items() for theme in charts.THEMES}


RAW = "docs/speed/accuracy.txt"


def sub_steps_chart(results):
    """Error by number of sub-steps, over that of one step of Box2D 2.4."""
    texts = {"title": "What sub-steps are worth",
             "subtitle": "Error of boxreel over that of Box2D 2.4 with its one step, at 60 Hz with 8/3 iterations",
             "x": "sub-steps", "y": "error over Box2D's", "marks": {"x": "falls"},
             "ticks": [1, 2, 4, 8, 16],
             "notes": ["Cases C-double-pendulum, I-pair and J-stack-30 of the table of errors. Both axes are logarithmic."]}
    points = []
    for name, words in SUB_STEPS_CHARTED.items():
        result = case_of(results, name)
        peer = next(one for one in result["runs"] if one["program"] == engine.GOAL_PROGRAM
                    and [one[key] for key in accuracy.SETTINGS] == [8, 3, 60, 1])
        ours = accuracy.engines_of(result)[0]
        for one in sorted(result["runs"], key=lambda one: one["subSteps"]):
            if one["engine"] == ours and [one[key] for key in accuracy.SETTINGS[:3]] == [8, 3, 60]:
                mark = "x" if accuracy.ending(one) else "."
                points.append((words, "-", charts.Point(one["subSteps"], one["error"] / peer["error"], mark=mark)))
    return charts.Lines(texts, charts.curves_of(points))


def draws_the_same(checkout):
    """Whether the installed matplotlib is the one that drew the stored charts; another one draws other bytes."""
    try:
        version = importlib.metadata.version("matplotlib")
    except importlib.metadata.PackageNotFoundError:
        return False
    return f"Matplotlib v{version}".encode() in (checkout / "docs/speed/engine-dark.svg").read_bytes()


def findings(checkout, made=None):
    """A sentence for each thing that is not what the figures say; charts of another matplotlib are not compared.

    `made` are the charts that they are compared with, if they were drawn before.
    """
    figures = read(checkout)
    remedy = "; run docs/speed/speed.py write."
    named = set()
    for page in PAGES:
        text = (checkout / page).read_text(encoding="utf-8")
        named |= {found[2] for found in TABLE.finditer(text)}
        for found in TABLE.finditer(text):
            if found[2] not in TABLES:
                yield f"There is no table '{found[2]}', which {page} has."
            elif found[0] != filled(found[0], figures):
                yield f"The table '{found[2]}' of {page} is not what docs/speed/*.json say" + remedy
    page = (checkout / "docs/speed.md").read_text(encoding="utf-8")
    for name, (benchmark, options) in BENCHMARKS.items():
        command = f"./boxreel bench {' '.join([benchmark.name, *options])} --json {name}.json"
        if name != "accuracy" and command not in page:
            yield f"docs/speed.md does not show what measures: {command}"
    for stem in charts_of(figures):
        for theme in charts.THEMES:
            name = f"{stem.removeprefix('docs/')}-{theme}.svg"
            if not any(f'"{name}"' in (checkout / page).read_text(encoding="utf-8") for page in PAGES):
                yield f"No page shows docs/{name}; show each chart in light and dark."
    for name in TABLES.keys() - named:
        yield f"No page has the table '{name}'; put its two comments back."
    if (checkout / RAW).read_text(encoding="utf-8") != raw_text(figures):
        yield f"{RAW} is not what docs/speed/*.json say" + remedy
    if not draws_the_same(checkout):
        return
    for path, data in (made or drawn(figures)).items():
        if (checkout / path).read_bytes() != data:
            yield f"{path} is not what docs/speed/*.json say" + remedy


def main():
    """Runs the command; its exit code."""
    action, *names = sys.argv[1:] or [""]
    unknown = set(names) - BENCHMARKS.keys() or (names and action != "measure")
    if action not in ("measure", "write", "check") or unknown:
        sys.exit(__doc__.strip())
    if action == "check":
        found = list(findings(CHECKOUT))
        print("\n".join(found), file=sys.stderr, end="\n" if found else "")
        return 1 if found else 0
    if action == "measure":
        measure(CHECKOUT, names or [name for name in BENCHMARKS if name != "accuracy"])
    figures = read(CHECKOUT)
    for page in PAGES:
        path = CHECKOUT / page
        path.write_text(filled(path.read_text(encoding="utf-8"), figures), encoding="utf-8")
    (CHECKOUT / RAW).write_text(raw_text(figures), encoding="utf-8")
    for path, data in drawn(figures).items():
        (CHECKOUT / path).write_bytes(data)
    return 0


if __name__ == "__main__":
    sys.exit(main())
