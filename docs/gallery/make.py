#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draw the pictures of docs/gallery, those of the README included, and write docs/gallery.md.

make.py PROGRAM            draw all pictures and write the page; needs ffmpeg, which reduces the colours, and Chromium,
                           which opens the report of a golden test
make.py PROGRAM --only N   draw only the scenes whose names contain N, or those of README, and write the page
make.py PROGRAM --check    check the page and the pictures, and draw nothing

PROGRAM is boxreel. The target `gallery` calls the first, a quick test the last. Exit codes: 0, 1 with one line per finding.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
CHECKOUT = FOLDER.parent.parent
PAGE = FOLDER.parent / "gallery.md"
SOURCES = CHECKOUT / "testbed" / "scenes"
MAX_BYTES = 2_000_000
THEMES = {"light": "print", "dark": "dark"}
LOOK = ["--size", "216x120", "--scale", "2"]  # 432x240, with lines that are seen at this size
COLUMNS = 3
COLORS = 48
README_PICTURES = [f"{name}-{page}.{end}" for name, end in (("film", "webp"), ("report", "png"), ("window", "png")) for page in THEMES]
# One moment and its name. The badge says at which depth it differs, which needs the text that is left out.
REPORT_SHOWS = "<style>header, nav, .message, h3, .tabs, .badge { display: none } h2 { margin-bottom: .6rem }</style>"

# Scenes that the site lets one play, as pages of `boxreel record NAME -o NAME.html`.
INTERACTIVE = ["Pyramid", "Dominos", "Theo Jansen's Walker", "Newton's Cradle", "Ragdoll", "Wrecking Ball"]

# The moment of a scene's picture, 2.5s unless named, and the camera, unless it is the scene's own.
MOMENTS = {
    "Pyramid": ("1s", "fit"),
    "Vertical Stack": ("6.2s", None),
    "Bridge": ("1.3s", None),
    "Chain": ("1s", "fit"),
    "Dominos": ("3.2s", None),
    "Tumbler": ("5s", "1,9,19"),
    "Card House": ("0.1s", "fit"),
    "Arch": ("1s", "fit"),
    "Double Domino": ("2.5s", "0,2,13"),
    "Circle Stack": ("1s", "fit"),
    "Rain": ("3s", None),
    "Large Pyramid": ("0.1s", "0,39,26"),
    "Many Pyramids": ("0.1s", None),
    "Far Pyramid": ("7s", None),
    "Smash": ("1s", "5,0,23"),
    "High Mass Ratio 1": ("0.1s", "fit"),
    "High Mass Ratio 2": ("0.1s", "fit"),
    "High Mass Ratio 3": ("0.1s", "fit"),
    "Heavy 1": ("0.3s", "0,2.6,6.2"),
    "Heavy 2": ("1s", "fit"),
    "Overlap Recovery": ("0.1s", "fit"),
    "Chain Slide": ("1s", "-5.5,5,10"),
    "Skinny Box": ("4.7s", "-2,3,7"),
    "Car": ("7s", "follow:chassis:9"),
    "Theo Jansen's Walker": ("2.5s", "0,3.8,12"),
    "Pulleys": ("5.5s", None),
    "Apply Force": ("4s", "0,16,18"),
    "Conveyor Belt": ("7s", None),
    "Sensor Test": ("4s", None),
    "SphereStack": ("1.2s", None),
    "Confined": ("7s", None),
    "Tiles": ("1s", None),
    "Bullet Test": ("4s", None),
    "Continuous Test": ("1.3s", None),
    "Distance Test": ("4s", "0,1,9"),
    "Convex Hull": ("7s", None),
    "Edge Shapes": ("7s", None),
    "Polygon Shapes": ("7s", None),
    "Compound Shapes": ("1s", None),
    "Character Collision": ("1s", None),
    "Collision Filtering": ("1s", None),
    "Collision Processing": ("1s", None),
    "Add Pair Stress Test": ("0.6s", None),
    "Web": ("6.6s", None),
    "Body Types": ("1s", None),
    "Breakable": ("1.6s", "0,4,11"),
    "Ball & Chain": ("1s", None),
    "Wrecking Ball": ("2.3s", None),
    "Scissor Lift": ("4s", None),
    "Ragdoll": ("1.2s", "-5,5.5,10"),
    "Skier": ("2.5s", "follow:ski:8"),
    "Newton's Cradle": ("2.5s", "1,7,18"),
    "Slider Crank": ("2.5s", "0,11,22"),
    "Prismatic": ("2.5s", "0,10,12"),
    "PolyCollision": ("2.5s", "-0.5,0.6,8.5"),
    "Gears": ("2.5s", "-1,13,18"),
    "Time of Impact": ("2.5s", "0,0,13"),
    "MobileBalanced": ("1s", None),
}

# What else is drawn, where bodies and joints say too little or too much.
MARKS = {
    "Heavy 1": ["--draw", "shapes,joints,impulses"],
    "Skinny Box": ["--onion", "14:2steps"],
    "Continuous Test": ["--strobe", "3steps"],
    "Car": ["--draw", "shapes"],  # lines of joints would start at the origin of the ground, far from their wheels
}


def scenes_of(program):
    """Category, name and description of each scene, in the order of `boxreel list`."""
    lines = subprocess.run([program, "list"], check=True, text=True, stdout=subprocess.PIPE).stdout.splitlines()
    starts = [lines[0].index(title) for title in ("CATEGORY", "NAME", "SHOWS")]
    return [tuple(line[a:b].strip() for a, b in zip(starts, starts[1:] + [None])) for line in lines[1:]]


def file_name(scene):
    return re.sub(r"-+", "-", re.sub(r"[^a-z0-9]+", "-", scene.lower().replace("'", ""))).strip("-")


def source_of(scene):
    """The file that defines the function in the scene's line of SceneTable.cpp."""
    entry = re.search(rf'\{{"{re.escape(scene)}".*?\b(Make\w+)\}}', (SOURCES / "SceneTable.cpp").read_text(), re.DOTALL)
    for source in sorted(SOURCES.glob("*.cpp")):
        if source.name != "SceneTable.cpp" and entry and re.search(rf"\b{entry[1]}\(", source.read_text()):
            return source.relative_to(CHECKOUT)
    raise SystemExit(f"{scene}: no source in testbed/scenes")


def options_of(scene):
    moment, camera = MOMENTS.get(scene, ("2.5s", None))
    return ["--at", moment] + (["--camera", camera] if camera else []) + MARKS.get(scene, [])


def pictures_of(scene):
    return [FOLDER / f"{file_name(scene)}-{page}.png" for page in THEMES]


def run(*command, folder=None, codes=(0,)):
    done = subprocess.run(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode not in codes:
        raise SystemExit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stderr}")


def reduce(full, target, colors=COLORS, cut=""):
    """Writes a PNG with a palette, a fourth of the size."""
    palette = f"{cut}split[a][b];[a]palettegen=max_colors={colors}:reserve_transparent=0[p];[b][p]paletteuse=dither=none"
    run("ffmpeg", "-y", "-loglevel", "error", "-i", full, "-vf", palette, "-pred", "none", "-compression_level", "100", target)


def draw(program, scene):
    for target, theme in zip(pictures_of(scene), THEMES.values()):
        with tempfile.TemporaryDirectory() as folder:
            full = pathlib.Path(folder) / "full.png"
            run(program, "shot", scene, "-o", full, "--theme", theme, *LOOK, *options_of(scene))
            reduce(full, target)


def draw_readme(program):
    """A film, the report of a golden test that fails, and the window."""
    for page, theme in THEMES.items():
        run(program, "record", "theo-jansens-walker", "-o", FOLDER / f"film-{page}.webp", "--force", "--theme", theme, "--size", "400x225",
            "--fps", "10", "--seconds", "2.4", "--camera", "path:0s=-8,3.8,11;2.4s=-1.5,3.8,11")
        draw_report(program, page, theme)
        with tempfile.TemporaryDirectory() as name:
            full = pathlib.Path(name) / "window.png"
            run(program, "shot", "wrecking-ball", "-o", full, "--at", "2.15s", "--ui", "--theme", theme, "--size", "800x556",
                "--camera", "5,6,13")
            reduce(full, FOLDER / f"window-{page}.png", 128)


def draw_report(program, page, theme):
    """One moment, at twice the size: the text is read where the README shows it 400 pixels wide."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        record = [program, "record", "newtons-cradle", "--quality", "lossless", "--from", "7s", "--frames", "1", "--size", "480x130",
                  "--camera", "0.5,7.4,9.4", "--theme", theme]
        run(*record, "-o", "approved.mkv", folder=folder)
        run(program, "golden", "accept", "newtons-cradle", "--film", "approved.mkv", "--references", "references", folder=folder)
        run(*record, "-o", "today.mkv", "--hz", "120", folder=folder)
        run(program, "golden", "verify", "newtons-cradle", "--film", "today.mkv", "--references", "references", "--output", "failures",
            "--report", "report.html", folder=folder, codes=(2,))
        with open(folder / "report.html", "a", encoding="utf-8") as report:
            report.write(REPORT_SHOWS)
        run("chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--window-size=400,432",
            "--force-device-scale-factor=2", *(["--blink-settings=preferredColorScheme=0"] if page == "dark" else []),
            f"--user-data-dir={folder / 'profile'}", f"--screenshot={folder / 'report.png'}", f"file://{folder}/report.html",
            folder=folder)
        reduce(folder / "report.png", FOLDER / f"report-{page}.png", 128)


def cell(category, scene, shows):
    light, dark = (picture.relative_to(PAGE.parent).as_posix() for picture in pictures_of(scene))
    return (f'<picture><source media="(prefers-color-scheme: dark)" srcset="{dark}"><img src="{light}" '
            f'alt="{scene}" width="270"></picture><br>**[{scene}](../{source_of(scene).as_posix()})**: {shows}<br>'
            f'`boxreel record {file_name(scene)} -o {file_name(scene)}.mp4`')


def page_of(scenes):
    lines = [
        "# Gallery",
        "",
        f"All {len(scenes)} scenes of `boxreel list`. The name leads to the source. The command makes the film; `boxreel ui NAME`",
        "opens the scene in [the window](window.md). With a name that ends in `.html`, the command makes a page in which one can",
        f"stop, zoom and point at bodies ([recording.md](recording.md#a-page-to-play)). On the site, {len(INTERACTIVE)} scenes",
        f"can be played in the browser, by \"play it\" beside their names: {', '.join(INTERACTIVE)}.",
        "",
    ]
    categories = list(dict.fromkeys(category for category, _, _ in scenes))
    lines += [", ".join(f"[{category}](#{category.lower()})" for category in categories), ""]
    for category in categories:
        cells = [cell(*scene) for scene in scenes if scene[0] == category]
        cells += [""] * (-len(cells) % COLUMNS)
        lines += [f"## {category}", "", "| " + " | ".join([" "] * COLUMNS) + " |", "|" + " --- |" * COLUMNS]
        lines += ["| " + " | ".join(cells[i:i + COLUMNS]) + " |" for i in range(0, len(cells), COLUMNS)]
        lines.append("")
    lines += [
        "`docs/gallery/make.py` draws the pictures and writes this page: `cmake --build build/release --target gallery`.",
    ]
    return "\n".join(lines) + "\n"


def findings(scenes):
    text = PAGE.read_text() if PAGE.exists() else ""
    if text != page_of(scenes):
        yield "docs/gallery.md is not what docs/gallery/make.py writes; build the target `gallery`"
    wanted = {picture for _, scene, _ in scenes for picture in pictures_of(scene)}
    wanted |= {FOLDER / name for name in README_PICTURES}
    found = {path for path in FOLDER.iterdir() if path.suffix in (".png", ".webp")}
    for _, scene, _ in scenes:
        if f"[{scene}](" not in text:
            yield f"docs/gallery.md has no scene {scene}"
    for picture in sorted(wanted - found):
        yield f"docs/gallery/{picture.name} is missing; build the target `gallery`"
    for picture in sorted(found - wanted):
        yield f"docs/gallery/{picture.name} is no picture of a scene or of the README; remove it"
    for name in sorted((MOMENTS.keys() | MARKS.keys()) - {scene for _, scene, _ in scenes}):
        yield f"docs/gallery/make.py has a moment for {name}, which is no scene"
    size = sum(picture.stat().st_size for picture in found)
    if size > MAX_BYTES:
        yield f"the pictures of docs/gallery have {size} bytes, more than {MAX_BYTES}"


def main():
    parser = argparse.ArgumentParser(description="Draw the pictures of docs/gallery and write docs/gallery.md.")
    parser.add_argument("program", help="boxreel")
    parser.add_argument("--only", metavar="NAME", help="draw only the scenes whose names contain this, or README")
    parser.add_argument("--check", action="store_true", help="check the page and the pictures, and draw nothing")
    options = parser.parse_args()
    scenes = scenes_of(options.program)
    if not options.check:
        for _, scene, _ in scenes:
            if (options.only or "").lower() in scene.lower():
                draw(options.program, scene)
        if (options.only or "README") == "README":
            draw_readme(options.program)
        PAGE.write_text(page_of(scenes))
    problems = list(findings(scenes))
    print("\n".join(problems), file=sys.stderr, end="\n" if problems else "")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
