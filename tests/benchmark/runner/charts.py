# SPDX-License-Identifier: MIT
"""Charts of bars and of lines, in light and dark, as PNG or SVG. Only `draw` loads matplotlib."""
import functools
import io
import itertools
import math
from collections import namedtuple
from pathlib import Path
from typing import Iterable

from .common import ABSENT, Problem, Result, time_text, times_text, verdict_text

THEMES = ("light", "dark")  # a file of matplotlib's settings each, and chart.mplstyle for both
MARKS = {".": ("o", 5.0), "o": ("o", 9.0), "x": ("X", 6.5), "speck": ("o", 3.0)}  # of points, and their sizes
TURNS = (0.0, 0.8, -0.8, 1.57, -1.57, 3.14, 2.35, -2.35, 1.2, -1.2, 1.95, -1.95)  # to labels from marks, best first [rad]
# Groups are (name, what, value, [(length or None, label)]), with a bar for each series. Bars begin at `start`; from 0
# the axis is linear, else logarithmic.
Bars = namedtuple("Bars", "texts groups series start", defaults=[1.0])
# Curves on two logarithmic axes, the horizontal one with marks at `ticks` of the texts, if there are any; `floor` is a
# value that stands for all below it, and its name.
Lines = namedtuple("Lines", "texts curves floor", defaults=[(0.0, "")])
# Of one engine, with the number of its colour; `stroke` is matplotlib's, empty for points that nothing joins.
Curve = namedtuple("Curve", "name color stroke points")
# What has no y failed, and stands at the top. An optional label is left out where there is no room.
Point = namedtuple("Point", "x y label mark optional", defaults=["", ".", True])


def ratio_bars(texts: dict, results: list[Result], figure: str) -> Bars:
    """How many times more each peer takes than the first method, where both runs are sound."""
    peers = list(dict.fromkeys(one["method"] for result in results for one in result["methods"]
                               if not one["ours"] and "failure" not in one))
    if not peers:
        raise Problem("no peer ran, so there is no ratio to draw; install one and run again", ABSENT)
    groups = []
    for result in results:
        ours, bars = result["methods"][0], []
        for name in peers:
            peer = next((one for one in result["methods"] if one["method"] == name), {"verdict": "not run"})
            wrong = next((one for one in (ours, peer) if one["verdict"] != "sound"), None)
            bars.append((None, f"not compared: {verdict_text(wrong, result, wrong is ours)}") if wrong else
                        (peer[figure] / ours[figure], times_text(peer[figure] / ours[figure])))
        groups.append((result["case"], result["what"], time_text(ours.get(figure)), bars))
    return Bars({"axis": "times faster than the peer", **texts}, groups, [f"than {name}" for name in peers])


def curves_of(points: Iterable[tuple[str, str, Point]]) -> list[Curve]:
    """A curve for each name and stroke, and a colour for each name."""
    lines: dict[tuple[str, str], list[Point]] = {}
    for name, stroke, point in points:
        lines.setdefault((name, stroke), []).append(point)
    names = list(dict.fromkeys(name for name, _ in lines))
    return [Curve(name, names.index(name), stroke, line) for (name, stroke), line in lines.items()]


def draw(chart: Bars | Lines, theme: str, kind: str) -> bytes:
    """The bytes of a chart. The same chart gives the same bytes with the same matplotlib."""
    import matplotlib.style  # only here: children count our memory as theirs
    from matplotlib.figure import Figure
    notes, is_bars, height, left = chart.texts["notes"], isinstance(chart, Bars), 6.8, 0.09  # [inches], share
    if is_bars:
        height = 1.92 + 0.2 * len(notes) + sum(0.18 * len(group[3]) + 0.16 for group in chart.groups)
        left = 0.40 if chart.start else 0.30
    bottom, data = (0.72 + 0.2 * len(notes)) / height, io.BytesIO()
    with matplotlib.style.context([Path(__file__).with_name(f"{name}.mplstyle") for name in ("chart", theme)]):
        soft = matplotlib.rcParams["xtick.color"]
        figure = Figure(figsize=(10.4, height))
        axes = figure.add_axes([left, bottom, 0.97 - left, 1.0 - bottom - 1.2 / height])
        figure.text(0.02, (height - 0.34) / height, chart.texts["title"], fontsize=15, fontweight="bold")
        figure.text(0.02, (height - 0.60) / height, chart.texts["subtitle"], color=soft)
        for line, words in enumerate(reversed(notes)):
            figure.text(0.02, (0.12 + 0.2 * line) / height, words, fontsize=8.5, color=soft)
        (draw_bars if is_bars else draw_lines)(axes, chart, matplotlib.rcParams["text.color"], soft)
        figure.savefig(data, format=kind, metadata={"Date": None} if kind == "svg" else {})
    return data.getvalue()


def draw_bars(axes, chart: Bars, ink: str, soft: str) -> None:
    """Bars from `start` either way, labels at the right of them, names at the left."""
    write = functools.partial(axes.annotate, textcoords="offset points")
    colors = [f"C{(row + (chart.start > 0.0)) % 6}" for row in range(len(chart.series))]  # ours is no ratio
    top, names = 0.0, -72 if chart.start else -10
    for name, what, value, bars in chart.groups:
        for row, (length, words) in enumerate(bars):
            end = chart.start if length is None else length
            axes.barh(top + row, end - chart.start, left=chart.start, height=0.78, color=colors[row], zorder=2)
            write(words, (max(end, chart.start), top + row), (5, 0), va="center", fontsize=8.5, ha="left",
                  color=soft if length is None else ink)
        for x, y, words, style in ((names, 6, name, {"fontweight": "bold", "fontsize": 9.5}),
                                   (names, -6, what, {"color": soft, "fontsize": 8}), (-10, 0, value, {"fontsize": 9})):
            write(words, (0.0, top + 0.5 * (len(bars) - 1)), (x, y), xycoords=("axes fraction", "data"), ha="right",
                  va="center", **style)
        top += len(bars) + 0.8
    axes.axvline(chart.start, color=ink, linewidth=1.0, zorder=3)
    axes.set(ylim=(top - 0.9, -0.9), yticks=[], xlabel=chart.texts["axis"])
    lengths = [chart.start] + [length for group in chart.groups for length, _ in group[3] if length]
    low, high = min(lengths), max(lengths)
    if chart.start:
        write("boxreel", (0.0, 1.0), (-10, 6), xycoords="axes fraction", ha="right", fontsize=8, color=soft)
        high = max(high, 10.0)
        axes.set(xscale="log", xlim=(low / (1.1 if low < chart.start else 1.02), high * (high / low) ** 0.16))
        axes.xaxis.set_major_formatter("{x:,.6g}")
    else:
        axes.set_xlim(0.0, 1.12 * high or 1.0)
    axes.grid(axis="x", which="major")
    axes.spines["left"].set_visible(False)
    axes.legend([axes.barh(0.0, 0.0, color=color) for color in colors], chart.series, ncol=3, fontsize=9,
                bbox_to_anchor=(0.0, 1.0), borderaxespad=0.6, handlelength=1.2, columnspacing=1.6)


def draw_lines(axes, chart: Lines, ink: str, soft: str) -> None:
    """Curves with their marks and labels; a legend of colours, strokes and marks above."""
    axes.set(xscale="log", yscale="log", xlabel=chart.texts["x"], ylabel=chart.texts["y"])
    heights = [point.y for curve in chart.curves for point in curve.points if point.y is not None]
    top, legend = 2.0 * max(heights, default=0.5), {}
    curves = [curve._replace(points=[point._replace(y=top if point.y is None else point.y) for point in curve.points])
              for curve in chart.curves]
    points = [point for curve in curves for point in curve.points]
    rims = {"o": (ink, 1.4), "x": (axes.get_facecolor(), 0.6)}
    for curve in curves:
        color = f"C{curve.color % 6}"
        if curve.stroke:
            axes.plot(*zip(*(point[:2] for point in curve.points)), curve.stroke, color=color, linewidth=1.5, zorder=3)
        for point in curve.points:
            (mark, size), (rim, width) = MARKS[point.mark], rims.get(point.mark, (color, 0.6))
            axes.plot(point.x, point.y, mark, color=color, markersize=size, zorder=4, markeredgecolor=rim,
                      markeredgewidth=width, alpha=1.0 if curve.stroke else 0.5)
        legend.setdefault(curve.name, axes.plot([], [], "o", color=color, markersize=6)[0])
    for stroke, words in chart.texts.get("strokes", {}).items():
        if any(curve.stroke == stroke for curve in curves):
            legend[words] = axes.plot([], [], stroke, color=soft, linewidth=1.5)[0]
    for mark, words in chart.texts.get("marks", {}).items():
        if any(point.mark == mark for point in points):
            legend[words] = axes.plot([], [], MARKS[mark][0], color=soft, markersize=MARKS[mark][1],
                                      markeredgecolor=ink if mark == "o" else soft)[0]
    axes.legend(legend.values(), legend.keys(), bbox_to_anchor=(-0.01, 1.0), ncol=5, fontsize=8.5, borderaxespad=0.4,
                columnspacing=1.4)
    axes.margins(0.07)
    if ticks := chart.texts.get("ticks"):
        axes.set_xticks(ticks)
        axes.set_xticks([], minor=True)
    axes.xaxis.set_major_formatter("{x:,.6g}")
    floor, name = chart.floor
    is_floored = any(point.y <= floor for point in points)
    if is_floored:
        axes.axhline(floor, color=soft, linewidth=0.8, zorder=1)
        axes.annotate(name, (0.0, floor), (6, 3), xycoords=("axes fraction", "data"), textcoords="offset points",
                      color=soft, fontsize=8)
    axes.grid(which="major")
    axes.grid(which="minor", linewidth=0.4)
    label_points(axes, curves, floor if is_floored else 0.0)


def label_points(axes, curves: list[Curve], floor: float) -> None:
    """Puts each label where it covers no mark, no line and no other label, where no other mark is as near, and where no
    other curve is between; the optional ones only there."""
    from matplotlib import path, patheffects, transforms
    axes.figure.draw_without_rendering()
    view, unit = axes.get_window_extent(), axes.figure.dpi / 72.0  # pixels of a point
    places = [axes.transData.transform([point[:2] for point in curve.points]) for curve in curves]
    lines = [path.Path(ends) for curve, ends in zip(curves, places) if curve.stroke]
    if floor > 0.0:
        bottom = axes.transData.transform((1.0, floor))[1]
        lines.append(path.Path([(view.x0, bottom), (view.x1, bottom)]))
    spots = [(point, place, curve.color) for curve, ends in zip(curves, places) for point, place in zip(curve.points, ends)]
    marks = list({tuple(place) for point, place, _ in spots if point.mark != "speck"})
    taken = [transforms.Bbox([place, place]).padded((0.5 * MARKS[point.mark][1] + 1.0) * unit) for point, place, _ in spots]

    def mistakable(box: transforms.Bbox, place) -> float:
        """How much speaks against a label there; 0 where nothing does."""
        center, distance = 0.5 * (box.min + box.max), max(*(box.min - place), *(place - box.max))
        between = path.Path([place + 0.2 * (center - place), center])
        crossed = sum(line.intersects_bbox(box, filled=False) + line.intersects_path(between, filled=False) for line in lines)
        nearer = box.padded(distance + 1.5 * unit).count_contains(marks) - 1  # one is its own
        outside = not (view.contains(*box.min) and view.contains(*box.max))
        return 20.0 * outside + 3.0 * nearer + crossed + box.count_overlaps(taken)

    for point, place, color in sorted((spot for spot in spots if spot[0].label), key=lambda spot: spot[0].optional):
        label = axes.figure.text(0.0, 0.0, point.label, fontsize=8, color=f"C{color % 6}", ha="center", va="center", zorder=6)
        label.set_path_effects([patheffects.withStroke(linewidth=2.5, foreground=axes.get_facecolor())])  # over lines
        half, boxes = 0.5 * label.get_window_extent().padded(0.5 * unit).size, []
        for gap, turn in itertools.product((5, 7, 9, 12, 15), TURNS):
            center = place + (half + gap * unit) * (math.cos(turn), math.sin(turn))
            boxes.append(transforms.Bbox([center - half, center + half]))
        best = min(boxes, key=lambda box: mistakable(box, place))
        if point.optional and mistakable(best, place) > 0.0:
            label.remove()
        else:
            label.set_position(axes.figure.transFigure.inverted().transform(0.5 * (best.min + best.max)))
            taken.append(best)
