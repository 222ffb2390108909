# SPDX-License-Identifier: MIT
"""Charts of bars and of lines, in light and dark, as PNG or SVG. Only `draw` loads matplotlib."""
from __future__ import annotations

import importlib.util
import io
import math
from typing import Any, NamedTuple

from .common import ABSENT, Problem, times_text

# Okabe and Ito's colours, which everybody can tell apart; ours first. Of the dark theme those that stand out on dark.
THEMES = {"light": {"ground": "#ffffff", "ink": "#1f2328", "soft": "#59636e", "grid": "#e4e7eb",
                    "series": ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"]},
          "dark": {"ground": "#0d1117", "ink": "#e6edf3", "soft": "#9198a1", "grid": "#2a313c",
                   "series": ["#56B4E9", "#E69F00", "#009E73", "#CC79A7", "#F0E442", "#D55E00"]}}
DPI = 144


class Bars(NamedTuple):
    """A group a case: (name, what, value, [(length or None, label)]), with a bar a series."""
    title: str
    subtitle: str
    groups: list[tuple[str, str, str, list[tuple[float | None, str]]]]
    series: list[str]
    axis: str
    notes: list[str]
    value: str = ""  # heading of the groups' values
    start: float = 1.0  # where bars begin; from 0 the axis is linear, else logarithmic
    first_color: int = 1


class Point(NamedTuple):
    """Of a curve; what has no y failed, and stands at the top."""
    x: float
    y: float | None
    label: str = ""
    mark: str = "."  # one of Lines.marks
    optional: bool = True  # its label is left out where there is no room


class Curve(NamedTuple):
    """Points of one engine; `stroke` is matplotlib's, empty for points that nothing joins."""
    name: str
    color: int
    stroke: str
    points: list[Point]


class Lines(NamedTuple):
    """Curves on two logarithmic axes."""
    title: str
    subtitle: str
    curves: list[Curve]
    x: str
    y: str
    notes: list[str]
    strokes: dict[str, str] = {}  # legend of the strokes
    marks: dict[str, str] = {}  # legend of the marks
    floor: tuple[float, str] | None = None  # a value that stands for all below it, and its name


def ratio_bars(results: list[dict[str, Any]], figure: str, title: str, subtitle: str, value: Any,
               notes: list[str]) -> Bars:
    """How many times more each peer takes than the first method, where both runs are sound."""
    peers = list(dict.fromkeys(one["method"] for result in results for one in result["methods"]
                               if not one["ours"] and "failure" not in one))
    if not peers:
        raise Problem("no peer ran, so there is no ratio to draw; install what was said to be missing and run again", ABSENT)
    groups = []
    for result in results:
        ours, bars = result["methods"][0], []
        for name in peers:
            peer = next((one for one in result["methods"] if one["method"] == name), {"verdict": "not run"})
            wrong = f"boxreel {ours['verdict']}" if ours["verdict"] != "sound" else peer["verdict"]
            ratio = peer[figure] / ours[figure] if wrong == "sound" else None
            bars.append((ratio, times_text(ratio) if ratio else f"not compared: {wrong}"))
        groups.append((result["case"], result["what"], value(ours.get(figure)), bars))
    return Bars(title, subtitle, groups, [f"than {name}" for name in peers], "times faster than the peer", notes, "boxreel")


def check() -> None:
    """Before minutes of work: whether charts can be drawn. Imports nothing, for children count our memory as theirs."""
    if importlib.util.find_spec("matplotlib") is None:
        raise Problem("charts need matplotlib; install python3-matplotlib", ABSENT)


def draw(chart: Bars | Lines, theme: str, kind: str) -> bytes:
    """The bytes of a chart. The same chart gives the same bytes with the same matplotlib."""
    import matplotlib
    from matplotlib.figure import Figure
    look = THEMES[theme]
    settings = {"font.family": "DejaVu Sans", "font.size": 10, "svg.hashsalt": "boxreel", "axes.edgecolor": look["soft"],
                "text.color": look["ink"], "axes.labelcolor": look["ink"], "xtick.color": look["soft"],
                "ytick.color": look["soft"], "axes.axisbelow": True, "legend.frameon": False}
    with matplotlib.rc_context(settings):
        height = 1.9 + 0.46 * len(chart.groups) + 0.19 * sum(
            len(group[3]) - 2 for group in chart.groups) if isinstance(chart, Bars) else 6.8
        figure = Figure(figsize=(10.4, height), dpi=DPI, facecolor=look["ground"])
        axes = figure.add_subplot(facecolor=look["ground"])
        (draw_bars if isinstance(chart, Bars) else draw_lines)(axes, chart, look)
        inch = 1.0 / height
        axes.set_position([0.0, 0.0, 1.0, 1.0])
        left = 0.09 if isinstance(chart, Lines) else 0.40 if chart.value else 0.30
        bottom = (0.72 + 0.2 * len(chart.notes)) * inch
        axes.set_position([left, bottom, 0.97 - left, 1.0 - bottom - 1.2 * inch])
        figure.text(0.02, 1.0 - 0.34 * inch, chart.title, fontsize=15, fontweight="bold")
        figure.text(0.02, 1.0 - 0.60 * inch, chart.subtitle, color=look["soft"])
        for line, words in enumerate(reversed(chart.notes)):
            figure.text(0.02, (0.12 + 0.2 * line) * inch, words, fontsize=8.5, color=look["soft"])
        if isinstance(chart, Lines):
            label_points(axes, chart, look)
        data = io.BytesIO()
        figure.savefig(data, format=kind, facecolor=look["ground"], metadata={"Date": None} if kind == "svg" else {})
    return data.getvalue()


def draw_bars(axes: Any, chart: Bars, look: dict[str, Any]) -> None:
    """Bars from `start` either way, labels beyond their ends, names at the left."""
    lengths = [length for group in chart.groups for length, _ in group[3] if length] or [1.0]
    top = 0.0
    for name, what, value, bars in chart.groups:
        middle = top + 0.5 * (len(bars) - 1)
        for row, (length, words) in enumerate(bars):
            if length is not None:
                axes.barh(top + row, length - chart.start, left=chart.start, height=0.78,
                          color=look["series"][(row + chart.first_color) % 6], zorder=2)
            back = length is not None and length < chart.start
            axes.annotate(words, (chart.start if length is None else length, top + row), (-5 if back else 5, 0),
                          textcoords="offset points", ha="right" if back else "left", va="center",
                          fontsize=8.5, color=look["ink"] if length is not None else look["soft"])
        for x, y, words, style in ((-72 if chart.value else -10, 6, name, {"fontweight": "bold", "fontsize": 9.5}),
                                   (-72 if chart.value else -10, -6, what, {"color": look["soft"], "fontsize": 8}),
                                   (-10, 0, value, {"fontsize": 9})):
            axes.annotate(words, (0.0, middle), (x, y), xycoords=("axes fraction", "data"), textcoords="offset points",
                          ha="right", va="center", **style)
        top += len(bars) + 0.8
    if chart.value:
        axes.annotate(chart.value, (0.0, 1.0), (-10, 6), xycoords="axes fraction", textcoords="offset points", ha="right",
                      fontsize=8, color=look["soft"])
    axes.axvline(chart.start, color=look["ink"], linewidth=1.0, zorder=3)
    axes.set(ylim=(top - 0.9, -0.9), yticks=[], xlabel=chart.axis)
    if chart.start > 0.0:
        low, high = min(lengths + [chart.start]), max(lengths + [chart.start * 10.0])
        axes.set(xscale="log", xlim=(low / (2.2 if low < chart.start else 1.02), high * (high / low) ** 0.16))
        axes.xaxis.set_major_formatter(lambda value, _: f"{value:,.6g}")
    else:
        axes.set_xlim(0.0, 1.12 * max(lengths))
    axes.grid(axis="x", which="major", color=look["grid"], linewidth=0.8)
    axes.spines[["left", "top", "right"]].set_visible(False)
    axes.tick_params(which="both", length=0)
    handles = [axes.barh(0.0, 0.0, color=look["series"][(row + chart.first_color) % 6]) for row in range(len(chart.series))]
    axes.legend(handles, chart.series, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=3, fontsize=9, borderaxespad=0.6,
                handlelength=1.2, columnspacing=1.6)


def draw_lines(axes: Any, chart: Lines, look: dict[str, Any]) -> None:
    """Curves with their marks; a legend of colours, strokes and marks above."""
    marks = {".": ("o", 5.0), "o": ("o", 9.0), "x": ("X", 6.5), "speck": ("o", 3.0)}
    axes.set(xscale="log", yscale="log", xlabel=chart.x, ylabel=chart.y)
    heights = [point.y for curve in chart.curves for point in curve.points if point.y] or [1.0]
    ceiling = max(heights) * 2.0
    handles = {}
    for curve in chart.curves:
        color = look["series"][curve.color % 6]
        heights = [point.y if point.y is not None else ceiling for point in curve.points]
        if curve.stroke:
            axes.plot([point.x for point in curve.points], heights, curve.stroke, color=color, linewidth=1.5, zorder=3)
        for point, y in zip(curve.points, heights):
            mark, size = marks[point.mark if curve.stroke or point.mark != "." else "speck"]
            axes.plot(point.x, y, mark, color=color, markersize=size, zorder=4, alpha=1.0 if curve.stroke else 0.5,
                      markeredgecolor=look["ground" if point.mark == "x" else "ink"] if point.mark in "ox" else color,
                      markeredgewidth=1.4 if point.mark == "o" else 0.6)
        if curve.name not in handles:
            handles[curve.name] = axes.plot([], [], "o", color=color, markersize=6)[0]
    used = {curve.stroke for curve in chart.curves}
    for stroke, words in chart.strokes.items():
        if stroke in used:
            handles[words] = axes.plot([], [], stroke, color=look["soft"], linewidth=1.5)[0]
    for mark, words in chart.marks.items():
        if any(point.mark == mark for curve in chart.curves for point in curve.points):
            shape, size = marks[mark]
            handles[words] = axes.plot([], [], shape, color=look["soft"], markersize=size, linestyle="",
                                       markeredgecolor=look["ink"])[0]
    axes.legend(handles.values(), handles.keys(), loc="lower left", bbox_to_anchor=(-0.01, 1.0), ncol=4, fontsize=8.5,
                borderaxespad=0.4, columnspacing=1.4)
    axes.margins(0.07)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:,.6g}")
    if chart.floor and min(heights) <= chart.floor[0]:
        axes.axhline(chart.floor[0], color=look["soft"], linewidth=0.8, zorder=1)
        axes.annotate(chart.floor[1], (0.0, chart.floor[0]), (-4, 0), xycoords=("axes fraction", "data"),
                      textcoords="offset points", ha="right", va="center", color=look["soft"])
    axes.grid(which="major", color=look["grid"], linewidth=0.8)
    axes.grid(which="minor", color=look["grid"], linewidth=0.4)
    axes.spines[["top", "right"]].set_visible(False)
    axes.tick_params(which="both", length=0)


def label_points(axes: Any, chart: Lines, look: dict[str, Any]) -> None:
    """Puts each label where it covers no mark, no line and no other label; the optional ones only there."""
    figure = axes.figure
    figure.draw_without_rendering()
    ceiling = max((p.y for c in chart.curves for p in c.points if p.y), default=1.0) * 2.0
    unit = DPI / 72.0  # pixels of a point
    taken = []  # (x, y, half width, half height) in pixels
    spots = []
    for curve in chart.curves:
        places = [axes.transData.transform((p.x, p.y or ceiling)) for p in curve.points]
        taken += [(x, y, 4.5 * unit, 4.5 * unit) for x, y in places]
        for (x, y), (u, v) in zip(places, places[1:] if curve.stroke else []):
            count = max(2, int(math.hypot(u - x, v - y) / (4.0 * unit)))
            taken += [(x + (u - x) * i / count, y + (v - y) * i / count, unit, unit) for i in range(1, count)]
        spots += [(point, place, curve) for point, place in zip(curve.points, places) if point.label]
    box = axes.get_window_extent()
    for point, (x, y), curve in sorted(spots, key=lambda spot: spot[0].optional):
        label = figure.text(0, 0, point.label, fontsize=8, color=look["series"][curve.color % 6], ha="center", va="center",
                            zorder=6)
        size = label.get_window_extent()
        w, h = 0.5 * size.width + unit, 0.5 * size.height + 0.5 * unit

        def covered(u: float, v: float) -> float:
            outside = not (box.x0 < u - w and u + w < box.x1 and box.y0 < v - h and v + h < box.y1)
            return 20.0 * outside + sum(abs(u - a) < w + c and abs(v - b) < h + d for a, b, c, d in taken)

        ways = [(x + (w + gap * unit) * math.cos(turn) * 1.0, y + (h + gap * unit) * math.sin(turn))
                for gap in (5, 9, 14, 20) for turn in (0.0, 0.8, -0.8, 1.57, -1.57, 3.14, 2.35, -2.35)]
        best = min(ways, key=lambda way: covered(*way))
        if covered(*best) and point.optional:
            label.remove()
            continue
        label.set_position(figure.transFigure.inverted().transform(best))
        taken.append((*best, w, h))
