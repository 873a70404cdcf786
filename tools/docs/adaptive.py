#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The page that holds `render --error` against the same samples for all pixels.

usage: adaptive.py PROGRAM   renders five scenes both ways and writes tools/docs/adaptive.md and its
                             chart; takes a quarter of an hour, on a machine with nothing else to do

Errors are from a picture of very many samples, by the channel of a pixel that is furthest off, in
display values. Times are of preparing and rendering, the quickest of three runs.
"""

import json
import math
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tools", "bench"))
from claims import largest, read_pfm  # pylint: disable=wrong-import-position

PAGE = "tools/docs/adaptive.md"
CHART = "tools/docs/charts/adaptive.svg"
SCENES = ["basics/depth_of_field", "basics/motion_blur", "basics/soft_shadows",
          "basics/mirror_glass", "village/night"]
SIZE = "160x120"
TRUTH = 8192
FIXED = [8, 16, 32, 64, 128, 256, 512, 1024]
GOALS = [0.16, 0.08, 0.04, 0.02, 0.01]
MOST = 16384
RUNS = 3
# What is measured of the errors of a picture's pixels.
MEASURES = [("root mean square", lambda e: math.sqrt(sum(x * x for x in e) / len(e))),
            ("of all pixels but one in a thousand", lambda e: sorted(e)[len(e) * 999 // 1000])]


def render(program, scene, folder, *options):
    """The picture's display values, and seconds."""
    picture = os.path.join(folder, "a.pfm")
    stats = os.path.join(folder, "stats.json")
    subprocess.run([program, "render", os.path.join(ROOT, "scenes", scene + ".scene"), "-o",
                    picture, "--stats", stats, "--size", SIZE, "--quiet", *options], check=True)
    with open(stats, encoding="utf-8") as file:
        phases = json.load(file)["phases"]
    seconds = sum(p["seconds"] for p in phases if p["name"] in ("prepare", "render"))
    return [min(max(v, 0.0), 1.0) for v in read_pfm(picture)], seconds


def measured(program, scene, folder, truth, *options):
    """(seconds, errors by measure)"""
    runs = [render(program, scene, folder, *options) for _ in range(RUNS)]
    picture = runs[0][0]
    errors = [largest(picture, truth, p) for p in range(len(truth) // 3)]
    return min(r[1] for r in runs), [measure(errors) for _, measure in MEASURES]


def study(program, scene, folder):
    """The two curves: points (seconds, errors), of the same samples for all and of goals."""
    truth, _ = render(program, scene, folder, "--samples", str(TRUTH), "--seed", "1000000")
    fixed = [measured(program, scene, folder, truth, "--samples", str(n)) for n in FIXED]
    goals = [measured(program, scene, folder, truth, "--error", str(goal), "--max-samples",
                      str(MOST)) for goal in GOALS]
    return fixed, goals


def at(curve, x):
    """A curve of (x, y), rising in x, at x: straight between logarithms; None outside."""
    for (x0, y0), (x1, y1) in zip(curve, curve[1:]):
        if x0 <= x <= x1:
            t = math.log(x / x0) / math.log(x1 / x0)
            return math.exp((1 - t) * math.log(y0) + t * math.log(y1))
    return None


def ratio(value):
    return "-" if value is None else f"{value:.2f}"


def table(results):
    lines = ["| scene | goal | s | RMS error | same time: RMS | rare errors | same RMS: time |"
             " rare errors: time |",
             "|---|---|---|---|---|---|---|---|"]
    for scene, (fixed, goals) in results.items():
        for goal, (seconds, errors) in zip(GOALS, goals):
            cells = [scene.split("/")[1], f"{goal:g}", f"{seconds:.2f}", f"{errors[0]:.4f}"]
            in_time, in_error = [], []
            for k, error in enumerate(errors):
                same_time = at([(s, e[k]) for s, e in fixed], seconds)
                same_error = at(sorted((e[k], s) for s, e in fixed), error)
                in_time.append(same_time and same_time / error)
                in_error.append(same_error and same_error / seconds)
            cells += [ratio(v) for v in in_time + in_error]
            lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


# The chart: a row of panels for each measure.
WIDTH, HEIGHT, LEFT, TOP = 212, 170, 58, 64
BLUE, ORANGE = "#1f6fb2", "#c8531c"


def decades(low, high):
    values = []
    for power in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1):
        values += [m * 10.0 ** power for m in (1, 2, 5)]
    return [v for v in values if low <= v <= high]


def panel(x, y, curves, title, y_title):
    points = [p for curve, _, _ in curves for p in curve]
    x0, x1 = min(p[0] for p in points) / 1.3, max(p[0] for p in points) * 1.3
    y0, y1 = min(p[1] for p in points) / 1.4, max(p[1] for p in points) * 1.4
    w, h = WIDTH - 56, HEIGHT - 44

    def px(v):
        return x + w * math.log(v / x0) / math.log(x1 / x0)

    def py(v):
        return y + h - h * math.log(v / y0) / math.log(y1 / y0)

    out = [f'<rect x="{x}" y="{y}" width="{w}" height="{h}" fill="none" stroke="#888"/>']
    if title:
        out.append(f'<text x="{x + w / 2}" y="{y - 8}" text-anchor="middle" font-weight="bold">'
                   f'{title}</text>')
    for value in decades(x0, x1):
        out.append(f'<line x1="{px(value):.1f}" y1="{y}" x2="{px(value):.1f}" y2="{y + h}" '
                   'stroke="#ddd"/>')
        if not str(f"{value:e}").startswith("5"):
            out.append(f'<text x="{px(value):.1f}" y="{y + h + 13}" text-anchor="middle">'
                       f'{value:g}</text>')
    for value in decades(y0, y1):
        out.append(f'<line x1="{x}" y1="{py(value):.1f}" x2="{x + w}" y2="{py(value):.1f}" '
                   'stroke="#ddd"/>')
        if not str(f"{value:e}").startswith("5"):
            out.append(f'<text x="{x - 4}" y="{py(value) + 4:.1f}" text-anchor="end">'
                       f'{value:g}</text>')
    for curve, color, mark in curves:
        path = " ".join(f"{px(a):.1f},{py(b):.1f}" for a, b in curve)
        out.append(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="1.8"/>')
        for a, b in curve:
            if mark == "circle":
                out.append(f'<circle cx="{px(a):.1f}" cy="{py(b):.1f}" r="2.8" fill="{color}"/>')
            else:
                out.append(f'<rect x="{px(a) - 2.6:.1f}" y="{py(b) - 2.6:.1f}" width="5.2" '
                           f'height="5.2" fill="{color}"/>')
    out.append(f'<text x="{x + w / 2}" y="{y + h + 27}" text-anchor="middle">seconds</text>')
    if y_title:
        out.append(f'<text transform="translate({x - 42},{y + h / 2}) rotate(-90)" '
                   f'text-anchor="middle">{y_title}</text>')
    return "\n".join(out)


def chart(results):
    width = LEFT + WIDTH * len(results)
    height = TOP + (HEIGHT + 24) * len(MEASURES) + 6
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
           f'viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="10.5">',
           '<title>Error over time: the same samples for all pixels, and an error to reach'
           '</title>', f'<rect width="{width}" height="{height}" fill="white"/>',
           f'<circle cx="{LEFT + 6}" cy="20" r="3.5" fill="{BLUE}"/>',
           f'<text x="{LEFT + 16}" y="24" font-size="12">the same samples for all pixels '
           '(--samples)</text>',
           f'<rect x="{LEFT + 304}" y="17" width="7" height="7" fill="{ORANGE}"/>',
           f'<text x="{LEFT + 318}" y="24" font-size="12">an error to reach (--error)</text>']
    for row, (name, _) in enumerate(MEASURES):
        for column, (scene, (fixed, goals)) in enumerate(results.items()):
            curves = [([(s, e[row]) for s, e in fixed], BLUE, "circle"),
                      ([(s, e[row]) for s, e in goals], ORANGE, "square")]
            title = scene.split("/")[1].replace("_", " ") if row == 0 else ""
            y_title = "error: " + ("root mean square" if row == 0 else "1 pixel in 1000")
            out.append(panel(LEFT + WIDTH * column, TOP + (HEIGHT + 24) * row, curves, title,
                             y_title if column == 0 else ""))
    return "\n".join(out) + "\n</svg>\n"


PAGE_TEXT = """# An error to reach, and what it costs

`cobble render --error E` takes samples of each pixel until its interval is narrow enough;
`--samples N` takes as many of all. Which is the better way to spend time? This page is made by
`tools/docs/adaptive.py`: five scenes, {size}, both ways, each picture held against one of {truth}
samples a pixel.

![Errors over time of five scenes, by both ways](charts/adaptive.svg)

The error of a pixel is that of its channel that is furthest off, 1 being from black to white.
Above, the root of the mean square over the picture; below, the *rare errors*: what all pixels but
one in a thousand are within, which is what an error to reach is about. A goal of 0.01 gives few
pixels more samples than the picture has that it is held against.

In the table a goal's picture is compared with the samples for all that would take as long ("same
time": how many times larger its error is), and with those that would come as near ("time": how many
times longer they take). Above 1 the goal is the better way. A line: no such picture was rendered.

What follows: a goal is a promise about each pixel, not a way to save time in general. It pays where
most of a picture is easy and the rest hard, and the goal is strict (soft shadows, glass): there the
rare errors take up to 2.6 times less time. Where the hard pixels are a large part of the picture, as
in depth of field and motion blur, the samples for all are quicker: a goal shares its samples out
among eight independent sets, to know its error, and each of them is less even than one set of all
would be. Goals that 64 samples meet everywhere cost those 64.

{table}
"""


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    results = {}
    with tempfile.TemporaryDirectory() as folder:
        for scene in SCENES:
            results[scene] = study(sys.argv[1], scene, folder)
            print(f"{scene}: done", flush=True)
    os.makedirs(os.path.dirname(os.path.join(ROOT, CHART)), exist_ok=True)
    with open(os.path.join(ROOT, CHART), "w", encoding="utf-8") as file:
        file.write(chart(results))
    with open(os.path.join(ROOT, PAGE), "w", encoding="utf-8") as file:
        file.write(PAGE_TEXT.format(size=SIZE, truth=TRUTH, table=table(results)))


if __name__ == "__main__":
    main()
