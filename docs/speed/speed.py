#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""speed.py measure|write|check [PROGRAM]

Keeps the tables of README.md, docs/speed.md and docs/golden.md and the chart at what docs/speed/*.json say. PROGRAM is the boxreel
of the checkout unless it is named.

  measure  run the benchmarks into docs/speed/*.json, then write; minutes, on a machine that does nothing else
  write    make tables and chart from the JSON
  check    exit code 1, and a sentence for each table, or with PROGRAM the chart, that is not what the JSON say

Peers are those that the benchmarks find; BOXREEL_PEERS is the folder with odiff and pixelmatch (`boxreel bench
--help`). Tables stand between the lines `<!-- table: NAME -->` and `<!-- /table -->`.
"""
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

CHECKOUT = pathlib.Path(__file__).resolve().parent.parent.parent
PAGES = ["README.md", "docs/speed.md", "docs/golden.md"]
# What is measured, a file each; in several rounds everybody comes in turn. Rounds are so few that all of it takes
# eight to ten minutes on two quiet cores, of which one round of the engines is two and a half or more.
BENCHMARKS = {
    "engine": ["--rounds", "2"],
    "drawing": ["--render", "1500-720p"],
    "recording": ["--record", "pyramid", "tumbler", "asleep", "pictures", "--rounds", "1"],  # seconds each
    "comparing": ["--golden", "--rounds", "3"],  # medians of thirty pairs
}
# Of the README: scenes, and rows of the toolkit.
SHORT_SCENES = ["large-pyramid", "tumbler", "rain", "ragdolls", "bullets"]
SHORT_TASKS = ["frame", "film", "frames compared"]
TABLE = re.compile(r"(<!-- table: (\S+) -->\n).*?(<!-- /table -->)", re.DOTALL)


def time_text(seconds):
    """7.26 ms, 350 µs: three digits, as the chart writes them."""
    for unit, scale in (("s", 1.0), ("ms", 1e-3)):
        if seconds >= 0.9995 * scale:
            return digits(seconds / scale) + " " + unit
    return digits(seconds / 1e-6) + " µs"


def digits(value):
    if value >= 999.5:
        return f"{float(f'{value:.3g}'):,.0f}"
    return f"{value:.{0 if value >= 99.95 else 1 if value >= 9.995 else 2 if value >= 0.0995 else 3}f}"


def times_text(ratio):
    return digits(ratio) + "×"


def rows_text(heads, rows):
    lines = [heads, ["---"] * len(heads)] + rows
    return "".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |\n" for line in lines)


# ---------------------------------------------------------------------------------------------- the engine


def peer_of(scene, name):
    return next((engine for engine in scene["engines"] if engine["engine"] == name), {})


def is_sound(engine):
    return "failure" not in engine and "cpuSeconds" in engine and engine["finite"]


def engine_cell(peer):
    if not is_sound(peer):
        return peer.get("verdict") or "–"
    if peer.get("cpuRatio", 0.0) > 0.0:
        return f"{time_text(peer['cpuSeconds'])} ({times_text(peer['cpuRatio'])})"
    verdict = peer["verdict"]
    return f"{time_text(peer['cpuSeconds'])} ({'not compared' if verdict == 'sound' else verdict})"


def engine_names(scenes):
    """Ours first."""
    return list(dict.fromkeys(engine["engine"] for scene in scenes for engine in scene["engines"]))


def engine_table(figures):
    scenes = figures["engine"]["scenes"]
    names = engine_names(scenes)
    rows, notes = [], []
    for scene in scenes:
        ours = scene["engines"][0]
        rows.append([scene["what"], time_text(ours["cpuSeconds"]) if is_sound(ours) else ours["verdict"]]
                    + [engine_cell(peer_of(scene, name)) for name in names[1:]])
        if ours["verdict"] != "sound":
            notes.append(f"Not compared: {scene['what']}; of boxreel's run: {ours['verdict']}.")
    return rows_text(["scene"] + names, rows) + "".join("\n" + note + "\n" for note in notes)


# ---------------------------------------------------------------------------------------------- the toolkit


def case_of(figures, name):
    return next((case for case in figures["cases"] if case["case"] == name), {"methods": []})


def drawing_rows(figures):
    methods = [m for m in case_of(figures, "1500-720p")["methods"]
               if "failure" not in m and not m["wrong"] and m["rasterThreads"] == "0"]
    ours = next((m for m in methods if m["ours"]), None)
    cairo = next((m for m in methods if re.fullmatch(r"Cairo [\d.]+", m["method"])), None)
    if ours and cairo:
        # Cairo knows nothing of the frame before: it draws all of it.
        whole = cairo["frames"]["full"]["cpuSeconds"]
        for key, task, work in (("frame", "a frame of 1500 shapes, 1280 x 720", "full"),
                                ("frame changed", "the same where 5 % of it changes, in one place", "together")):
            yield key, task, ours["frames"][work]["cpuSeconds"], cairo["method"], whole


def recording_rows(figures):
    for case, key, task in (("pyramid", "film", "{} frames of the pyramid to MP4"),
                            ("tumbler", "film of tumbler", "{} frames of the tumbler to MP4"),
                            ("asleep", "film asleep", "{} frames of the pyramid at rest to MP4"),
                            ("pictures", "pictures", "{} frames of the tumbler to PNG files")):
        methods = {m["role"]: m for m in case_of(figures, case)["methods"] if m.get("verdict") == "sound"}
        for role, words in (("encodeOnly", "{}, which only encodes"), ("immediate", "{}")):
            if "boxreel" in methods and role in methods:
                peer = methods[role]
                yield (key if role == "encodeOnly" else "", task.format(methods["boxreel"]["frames"]),
                       methods["boxreel"]["wallSeconds"], words.format(peer["method"].replace(", raw file", "")), peer["wallSeconds"])


def comparing_rows(figures):
    def median(method, clock):
        times = [p[clock] for p in method.get("pictures", []) if p[clock] is not None]
        return statistics.median(times) if times else None

    ours = next((m for m in figures["methods"] if m["ours"]), {})
    for clock, key, task in (("decodedSeconds", "frames compared", "two frames of 1280 x 720 compared"),
                             ("processSeconds", "files compared", "two PNG files of 1280 x 720 compared, a process each")):
        for method in figures["methods"]:
            if not method["ours"] and "," not in method["method"] and median(method, clock) and median(ours, clock):
                yield key, task, median(ours, clock), method["method"], median(method, clock)


# Of the changes that are planted, with a name that is as short as a column.
CHANGES = {"body": "body 1 cm", "line": "line missing", "fill": "fill off by 4", "label": "label", "outline": "outline",
           "order": "order", "stray": "one stray pixel", "shift": "edges 0.1 px"}


def finding_text(method, change, truth):
    calls = [p["different"] for p in method["pictures"] if p["change"] == change]
    different = sum(calls)
    if truth == "equal":
        return "equal" if different == 0 else "**different**" if different == len(calls) else f"**{different} different**"
    return str(different) if different == len(calls) else f"**{different}**"


def comparing_table(figures):
    comparing = figures["comparing"]
    truths = {c["change"]: c["truth"] for c in comparing["changes"]}
    rows = [["is to be called"] + [truths[change] for change in CHANGES] + [""]]
    for method in comparing["methods"]:
        found = [finding_text(method, change, truths[change]) for change in CHANGES]
        process = statistics.median(p["processSeconds"] for p in method["pictures"])
        rows.append([method["method"], *found, time_text(process)])
    return rows_text(["", *CHANGES.values(), "a process"], rows) + "\n" + machine_text(figures)


def toolkit_rows(figures):
    return [*drawing_rows(figures["drawing"]), *recording_rows(figures["recording"]),
            *comparing_rows(figures["comparing"])]


def toolkit_table(figures):
    rows = [[task, time_text(ours), f"{peer}: {time_text(theirs)}", times_text(theirs / ours)]
            for _, task, ours, peer, theirs in toolkit_rows(figures)]
    version = engine_names(figures["engine"]["scenes"])[0]
    absent = "".join(f"\n{sentence}\n" for sentence in figures["comparing"]["absent"])
    return rows_text(["task", version, "peer", "times faster"], rows) + absent


def short_table(figures):
    rows = []
    for name in SHORT_SCENES:
        scene = next((s for s in figures["engine"]["scenes"] if s["scene"] == name), None)
        peers = [e for e in scene["engines"] if e["engine"].startswith("Box2D") and is_sound(e)] if scene else []
        if peers and peers[0].get("cpuRatio", 0.0) > 0.0:
            rows.append(["a step: " + scene["what"], time_text(scene["engines"][0]["cpuSeconds"]),
                         f"{peers[0]['engine']}: {time_text(peers[0]['cpuSeconds'])}", times_text(peers[0]["cpuRatio"])])
    seen = set()
    for key, task, ours, peer, theirs in toolkit_rows(figures):
        if key in SHORT_TASKS and key not in seen:
            seen.add(key)
            rows.append([task, time_text(ours), f"{peer}: {time_text(theirs)}", times_text(theirs / ours)])
    return rows_text(["task", "boxreel", "peer", "times faster"], rows) + "\n" + machine_text(figures)


def machine_text(figures):
    machine = figures["machine"]
    if machine["load"] >= 0.5:
        others = f"**preliminary: other programs ran** (a load of {machine['load']:.1f} before the first benchmark)"
    elif "others" in machine:
        others = f"other programs took {100 * machine['others']:.1f} % of their time meanwhile"
    else:
        others = f"a load of {machine['load']:.1f} when it began"
    return f"Measured on {machine['date']} on {machine['processor']}, {machine['processors']} processors; {others}.\n"


TABLES = {"comparing": comparing_table, "engine": engine_table, "toolkit": toolkit_table, "short": short_table, "machine": machine_text}

# ---------------------------------------------------------------------------------------------- what is done


def machine():
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
    path = checkout / "docs/speed" / (name + ".json")
    path.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def measure(checkout, program):
    about = machine()
    begun_all, busy, own = time.monotonic(), busy_seconds(), own_seconds()
    for name, options in BENCHMARKS.items():
        begun = time.monotonic()
        done = subprocess.run([program, "bench", *options, "--json"], stdout=subprocess.PIPE, check=False)
        if done.returncode != 0:
            sys.exit(f"`boxreel bench {' '.join(options)}` ended with {done.returncode}; see above what it lacks.")
        write_json(checkout, name, json.loads(done.stdout))
        print(f"{name}: {time.monotonic() - begun:.0f} s", file=sys.stderr)
    span = (time.monotonic() - begun_all) * about["processors"]
    about["others"] = round(max(0.0, busy_seconds() - busy - (own_seconds() - own)) / span, 4)
    write_json(checkout, "machine", about)


def read(checkout):
    folder = checkout / "docs/speed"
    return {name: json.loads((folder / (name + ".json")).read_text(encoding="utf-8")) for name in [*BENCHMARKS, "machine"]}


def filled(text, figures):
    return TABLE.sub(lambda found: f"{found[1]}\n{TABLES[found[2]](figures)}\n{found[3]}", text)


def draw(checkout, program, chart):
    subprocess.run([program, "bench", "--from", checkout / "docs/speed/engine.json", "--chart", chart, "--force"],
                   check=True, stdout=subprocess.DEVNULL)


def shows_the_same(program, one, other):
    """Whether two SVGs show the same. Versions of Cairo write the same picture in different elements and units."""
    if one.read_bytes() == other.read_bytes():
        return True
    with tempfile.TemporaryDirectory() as folder:
        pictures = [pathlib.Path(folder) / "one.png", pathlib.Path(folder) / "other.png"]
        for drawing, picture in zip((one, other), pictures):
            box = re.search(r'viewBox="0 0 (\d+) (\d+)"', drawing.read_text(encoding="utf-8"))
            subprocess.run(["rsvg-convert", "-w", box[1], "-h", box[2], "-o", picture, drawing], check=True)
        run = subprocess.run([program, "diff", *pictures, "--preset", "exact"], stdout=subprocess.DEVNULL)
    return run.returncode == 0


def findings(checkout, program=None):
    figures = read(checkout)
    remedy = "; run docs/speed/speed.py write."
    named = set()
    for page in PAGES:
        text = (checkout / page).read_text(encoding="utf-8")
        named |= {found[2] for found in TABLE.finditer(text)}
        for found in TABLE.finditer(text):
            if found[0] != filled(found[0], figures):
                yield f"The table '{found[2]}' of {page} is not what docs/speed/*.json say" + remedy
    page = (checkout / "docs/speed.md").read_text(encoding="utf-8")
    for name, options in BENCHMARKS.items():
        command = f"./boxreel bench {' '.join(options)} --json > {name}.json"
        if command not in page:
            yield f"docs/speed.md does not show what measures: {command}"
    for name in TABLES.keys() - named:
        yield f"No page has the table '{name}'; put its two comments back."
    if program:
        with tempfile.TemporaryDirectory() as folder:
            chart = pathlib.Path(folder) / "engine.svg"
            draw(checkout, program, chart)
            if not shows_the_same(program, checkout / "docs/speed/engine.svg", chart):
                yield "docs/speed/engine.svg is not what docs/speed/engine.json says" + remedy


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[1] not in ("measure", "write", "check"):
        sys.exit(__doc__.strip())
    program = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) == 3 else None
    if sys.argv[1] == "check":
        found = list(findings(CHECKOUT, program))
        print("\n".join(found), file=sys.stderr, end="\n" if found else "")
        return 1 if found else 0
    program = program or CHECKOUT / "boxreel"
    if sys.argv[1] == "measure":
        measure(CHECKOUT, program)
    figures = read(CHECKOUT)
    for page in PAGES:
        path = CHECKOUT / page
        path.write_text(filled(path.read_text(encoding="utf-8"), figures), encoding="utf-8")
    draw(CHECKOUT, program, CHECKOUT / "docs/speed/engine.svg")
    return 0


if __name__ == "__main__":
    sys.exit(main())
