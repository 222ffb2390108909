# SPDX-License-Identifier: MIT
"""Charts of bars and of lines, in light and dark, as PNG or SVG. Only `draw` loads matplotlib."""
from __future__ import annotations

import importlib.util
import io
import math
from typing import Any, NamedTuple

from .common import ABSENT, Problem, Result, times_text

# Okabe and Ito's colours, which everybody can tell apart; ours first. Of the dark theme those that stand out on dark.
THEMES = {"light": {"ground": "#ffffff", "ink": "#1f2328", "soft": "#59636e", "grid": "#e4e7eb",
                    "series": ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"]},
          "dark": {"ground": "#0d1117", "ink": "#e6edf3", "soft": "#9198a1", "grid": "#2a313c",
                   "series": ["#56B4E9", "#E69F00", "#009E73", "#CC79A7", "#F0E442", "#D55E00"]}}
MARKS = {".": ("o", 5.0), "o": ("o", 9.0), "x": ("X", 6.5), "speck": ("o", 3.0)}  # of points, and their sizes
DPI = 144


class Bars(NamedTuple):
    """A group a case: (name, what, value, [(length or None, label)]), with a bar a series."""
    texts: dict[str, Any]
    groups: list[tuple[str, str, str, list[tuple[float | None, str]]]]
    series: list[str]
    start: float = 1.0  # where bars begin; from 0 the axis is linear, else logarithmic


class Point(NamedTuple):
    """Of a curve; what has no y failed, and stands at the top."""
    x: float
    y: float | None
    label: str = ""
    mark: str = "."
    optional: bool = True  # its label is left out where there is no room


class Curve(NamedTuple):
    """Points of one engine; `stroke` is matplotlib's, empty for points that nothing joins."""
    name: str
    color: int
    stroke: str
    points: list[Point]


class Lines(NamedTuple):
    """Curves on two logarithmic axes."""
    texts: dict[str, Any]
    curves: list[Curve]
    floor: tuple[float, str] = (0.0, "")  # a value that stands for all below it, and its name


def ratio_bars(texts: dict[str, Any], results: list[Result], figure: str, value: Any) -> Bars:
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
            wrong = f"boxreel {ours['verdict']}" if ours["verdict"] != "sound" else peer["verdict"]
            ratio = peer[figure] / ours[figure] if wrong == "sound" else None
            bars.append((ratio, times_text(ratio) if ratio else f"not compared: {wrong}"))
        groups.append((result["case"], result["what"], value(ours.get(figure)), bars))
    return Bars({"axis": "times faster than the peer", **texts}, groups, [f"than {name}" for name in peers])


def check() -> None:
    """Before minutes of work: whether charts can be drawn. Imports nothing, for children count our memory as theirs."""
    if importlib.util.find_spec("matplotlib") is None:
        raise Problem("charts need matplotlib; install python3-matplotlib", ABSENT)


def draw(chart: Bars | Lines, theme: str, kind: str) -> bytes:
    """The bytes of a chart. The same chart gives the same bytes with the same matplotlib."""
    import matplotlib
    from matplotlib.figure import Figure
    look, notes, isBars = THEMES[theme], chart.texts["notes"], isinstance(chart, Bars)
    settings = {"font.family": "DejaVu Sans", "font.size": 10, "svg.hashsalt": "boxreel", "axes.axisbelow": True,
                "text.color": look["ink"], "axes.labelcolor": look["ink"], "xtick.color": look["soft"],
                "ytick.color": look["soft"], "axes.edgecolor": look["soft"], "legend.frameon": False}
    height = 6.8 if not isBars else 1.92 + 0.2 * len(notes) + sum(0.18 * len(group[3]) + 0.16 for group in chart.groups)
    left, bottom = 0.09 if not isBars else 0.40 if chart.start else 0.30, (0.72 + 0.2 * len(notes)) / height
    with matplotlib.rc_context(settings):
        figure = Figure(figsize=(10.4, height), dpi=DPI, facecolor=look["ground"])
        axes = figure.add_axes([left, bottom, 0.97 - left, 1.0 - bottom - 1.2 / height], facecolor=look["ground"])
        for place, words, style in ((height - 0.34, chart.texts["title"], {"fontsize": 15, "fontweight": "bold"}),
                                    (height - 0.60, chart.texts["subtitle"], {"color": look["soft"]}),
                                    *((0.12 + 0.2 * line, words, {"fontsize": 8.5, "color": look["soft"]})
                                      for line, words in enumerate(reversed(notes)))):
            figure.text(0.02, place / height, words, **style)
        (draw_bars if isBars else draw_lines)(axes, chart, look)
        axes.spines[["top", "right"]].set_visible(False)
        axes.tick_params(which="both", length=0)
        data = io.BytesIO()
        figure.savefig(data, format=kind, facecolor=look["ground"], metadata={"Date": None} if kind == "svg" else {})
    return data.getvalue()


def draw_bars(axes: Any, chart: Bars, look: dict[str, Any]) -> None:
    """Bars from `start` either way, labels beyond their ends, names at the left."""
    colors = [look["series"][(row + (chart.start > 0.0)) % 6] for row in range(len(chart.series))]  # ours is no ratio
    top, names = 0.0, -72 if chart.start else -10
    for name, what, value, bars in chart.groups:
        for row, (length, words) in enumerate(bars):
            end = chart.start if length is None else length
            axes.barh(top + row, end - chart.start, left=chart.start, height=0.78, color=colors[row], zorder=2)
            axes.annotate(words, (end, top + row), (-5 if end < chart.start else 5, 0), textcoords="offset points",
                          ha="right" if end < chart.start else "left", va="center", fontsize=8.5,
                          color=look["soft" if length is None else "ink"])
        for x, y, words, style in ((names, 6, name, {"fontweight": "bold", "fontsize": 9.5}),
                                   (names, -6, what, {"color": look["soft"], "fontsize": 8}),
                                   (-10, 0, value, {"fontsize": 9})):
            axes.annotate(words, (0.0, top + 0.5 * (len(bars) - 1)), (x, y), xycoords=("axes fraction", "data"),
                          textcoords="offset points", ha="right", va="center", **style)
        top += len(bars) + 0.8
    axes.axvline(chart.start, color=look["ink"], linewidth=1.0, zorder=3)
    axes.set(ylim=(top - 0.9, -0.9), yticks=[], xlabel=chart.texts["axis"])
    lengths = [chart.start] + [length for group in chart.groups for length, _ in group[3] if length]
    low, high = min(lengths), max(lengths)
    if chart.start:
        axes.annotate("boxreel", (0.0, 1.0), (-10, 6), xycoords="axes fraction", textcoords="offset points", ha="right",
                      fontsize=8, color=look["soft"])
        high = max(high, 10.0)
        axes.set(xscale="log", xlim=(low / (2.2 if low < chart.start else 1.02), high * (high / low) ** 0.16))
        axes.xaxis.set_major_formatter(lambda value, _: f"{value:,.6g}")
    else:
        axes.set_xlim(0.0, 1.12 * high or 1.0)
    axes.grid(axis="x", which="major", color=look["grid"], linewidth=0.8)
    axes.spines["left"].set_visible(False)
    axes.legend([axes.barh(0.0, 0.0, color=color) for color in colors], chart.series, loc="lower left", ncol=3,
                fontsize=9, bbox_to_anchor=(0.0, 1.0), borderaxespad=0.6, handlelength=1.2, columnspacing=1.6)


def draw_lines(axes: Any, chart: Lines, look: dict[str, Any]) -> None:
    """Curves with their marks and labels; a legend of colours, strokes and marks above."""
    axes.set(xscale="log", yscale="log", xlabel=chart.texts["x"], ylabel=chart.texts["y"])
    heights = [point.y for curve in chart.curves for point in curve.points if point.y is not None]
    top = 2.0 * max(heights, default=0.5)
    curves = [curve._replace(points=[point._replace(y=top if point.y is None else point.y) for point in curve.points])
              for curve in chart.curves]
    legend: dict[str, Any] = {}
    for curve in curves:
        color = look["series"][curve.color % 6]
        if curve.stroke:
            axes.plot(*zip(*(point[:2] for point in curve.points)), curve.stroke, color=color, linewidth=1.5, zorder=3)
        for point in curve.points:
            rim = {"o": (look["ink"], 1.4), "x": (look["ground"], 0.6)}.get(point.mark, (color, 0.6))
            axes.plot(point.x, point.y, MARKS[point.mark][0], color=color, markersize=MARKS[point.mark][1], zorder=4,
                      alpha=1.0 if curve.stroke else 0.5, markeredgecolor=rim[0], markeredgewidth=rim[1])
        legend.setdefault(curve.name, axes.plot([], [], "o", color=color, markersize=6)[0])
    for stroke, words in chart.texts.get("strokes", {}).items():
        if any(curve.stroke == stroke for curve in curves):
            legend[words] = axes.plot([], [], stroke, color=look["soft"], linewidth=1.5)[0]
    for mark, words in chart.texts.get("marks", {}).items():
        if any(point.mark == mark for curve in curves for point in curve.points):
            legend[words] = axes.plot([], [], MARKS[mark][0], color=look["soft"], markersize=MARKS[mark][1],
                                      markeredgecolor=look["ink" if mark == "o" else "soft"])[0]
    axes.legend(legend.values(), legend.keys(), loc="lower left", bbox_to_anchor=(-0.01, 1.0), ncol=5, fontsize=8.5,
                borderaxespad=0.4, columnspacing=1.4)
    axes.margins(0.07)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:,.6g}")
    floor, name = chart.floor
    if any(point.y <= floor for curve in curves for point in curve.points):
        axes.axhline(floor, color=look["soft"], linewidth=0.8, zorder=1)
        axes.annotate(name, (0.0, floor), (6, 3), xycoords=("axes fraction", "data"), textcoords="offset points",
                      color=look["soft"], fontsize=8)
    for which, width in (("major", 0.8), ("minor", 0.4)):
        axes.grid(which=which, color=look["grid"], linewidth=width)
    label_points(axes, curves, look)


def label_points(axes: Any, curves: list[Curve], look: dict[str, Any]) -> None:
    """Puts each label where it covers no mark, no line and no other label; the optional ones only there."""
    axes.figure.draw_without_rendering()
    unit = DPI / 72.0  # pixels of a point
    taken, spots = [], []  # what is covered, as (x, y, half width, half height) in pixels; where labels belong
    for curve in curves:
        places = [axes.transData.transform(point[:2]) for point in curve.points]
        taken += [(x, y, 4.5 * unit, 4.5 * unit) for x, y in places]
        for (x, y), (u, v) in zip(places, places[1:] if curve.stroke else []):
            count = max(2, int(math.hypot(u - x, v - y) / (4.0 * unit)))
            taken += [(x + (u - x) * i / count, y + (v - y) * i / count, unit, unit) for i in range(1, count)]
        color = look["series"][curve.color % 6]
        spots += [(point, place, color) for point, place in zip(curve.points, places) if point.label]
    box = axes.get_window_extent()
    for point, (x, y), color in sorted(spots, key=lambda spot: spot[0].optional):
        label = axes.figure.text(0, 0, point.label, fontsize=8, color=color, ha="center", va="center", zorder=6)
        size = label.get_window_extent()
        w, h = 0.5 * size.width + unit, 0.5 * size.height + 0.5 * unit

        def covered(place: tuple[float, float]) -> float:
            u, v = place
            outside = not (box.x0 < u - w and u + w < box.x1 and box.y0 < v - h and v + h < box.y1)
            return 20.0 * outside + sum(abs(u - a) < w + c and abs(v - b) < h + d for a, b, c, d in taken)

        turns = (0.0, 0.8, -0.8, 1.57, -1.57, 3.14, 2.35, -2.35)
        best = min(((x + (w + gap * unit) * math.cos(turn), y + (h + gap * unit) * math.sin(turn))
                    for gap in (5, 9, 14, 20) for turn in turns), key=covered)
        if covered(best) and point.optional:
            label.remove()
            continue
        label.set_position(axes.figure.transFigure.inverted().transform(best))
        taken.append((*best, w, h))
