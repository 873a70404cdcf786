#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What `render --error` and `render --budget` claim, held against what they do.

    claims.py coverage PROGRAM [--seeds N] [--size WxH] [--error E] [--truth SAMPLES] [--unbiased]
    claims.py forecast PROGRAM [--size WxH]
    claims.py rare PROGRAM
    claims.py bills PROGRAM [--size WxH]

coverage: over twelve of scenes/ (--scenes), how many pixels of how many seeds are within E of a picture of
very many samples: of all pixels, and of the hard ones, whose error at 64 samples deviates by more
than E/2. Beside it the mean bias, with its 95 % interval over seeds (an equivalence test: the whole
interval must lie within E/4).
forecast: time and error that were expected, over those that came, and the time of the whole program
over the budget. Only of use on a quiet machine.
rare: a speck so small that one sample in 500 sees it: what an interval of 64 samples misses, as
--error does, and what --guarantee does not.
bills: what `cobble cost` says an effect takes, against renders with and without it; and whether the
stages of a render add up to the time of its workers.
"""

import argparse
import json
import math
import os
import re
import struct
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def scenes():
    found = []
    for folder, _, files in os.walk(os.path.join(ROOT, "scenes")):
        found += [os.path.join(folder, name) for name in files if name.endswith(".scene")]
    return sorted(found)


def read_pfm(path):
    """Rows in the file's order, three numbers a pixel."""
    with open(path, "rb") as file:
        assert file.readline().strip() == b"PF"
        width, height = map(int, file.readline().split())
        assert float(file.readline()) < 0, "little-endian"
        count = 3 * width * height
        return struct.unpack(f"<{count}f", file.read(4 * count))


def render(program, scene, folder, *options):
    """The picture's numbers as a display shows them, and what the program said."""
    path = os.path.join(folder, "out.pfm")
    run = subprocess.run([program, "render", scene, "-o", path, *options],
                         capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit(f"{scene}: {run.stderr}")
    return [min(max(v, 0.0), 1.0) for v in read_pfm(path)], run.stderr


def largest(a, b, pixel):
    return max(abs(a[3 * pixel + c] - b[3 * pixel + c]) for c in range(3))


def coverage_of(program, scene, options, folder):
    """Counts of one scene: (pixels within, all), the same of hard ones, bias of each seed."""
    size = ["--size", options.size, "--threads", "2"]
    truth, _ = render(program, scene, folder, *size, "--samples", str(options.truth),
                      "--seed", "1000000")
    pixels = len(truth) // 3
    error = ["--error", str(options.error)] + (["--unbiased"] if options.unbiased else [])
    pictures, squares = [], [[0.0] * 3 for _ in range(pixels)]
    for seed in range(1, options.seeds + 1):
        picture, _ = render(program, scene, folder, *size, *error, "--seed", str(seed))
        pictures.append(picture)
        few, _ = render(program, scene, folder, *size, "--samples", "64", "--scrambles", "8",
                        "--seed", str(seed))
        for p in range(pixels):
            for c in range(3):
                squares[p][c] += (few[3 * p + c] - truth[3 * p + c]) ** 2
    hard = [math.sqrt(max(s) / options.seeds) > options.error / 2 for s in squares]
    within = within_hard = 0
    biases = []
    for picture in pictures:
        biases.append(sum(a - b for a, b in zip(picture, truth)) / len(truth))
        for p in range(pixels):
            good = largest(picture, truth, p) <= options.error
            within += good
            within_hard += good and hard[p]
    return within, pixels * options.seeds, within_hard, sum(hard) * options.seeds, biases


def student(freedom):
    """Student's t of 95 %, by Cornish and Fisher's first terms: 1 % off for 8, less for more."""
    z = 1.959964
    return z + (z ** 3 + z) / (4 * freedom) + (5 * z ** 5 + 16 * z ** 3 + 3 * z) / (96 * freedom ** 2)


def coverage(options):
    if options.seeds < 2:
        sys.exit("--seeds wants 2 or more: biases are compared")
    print(f"error {options.error}, {options.seeds} seeds, {options.size}, truth of "
          f"{options.truth} samples{', unbiased' if options.unbiased else ''}")
    print(f"{'scene':<28}{'all':>10}{'hard':>10}{'hard pixels':>13}{'mean bias':>12}  95 %")
    sums = [0, 0, 0, 0]
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes()[: options.scenes]:
            within, count, within_hard, count_hard, biases = coverage_of(
                options.program, scene, options, folder)
            mean = sum(biases) / len(biases)
            deviation = math.sqrt(sum((b - mean) ** 2 for b in biases) / (len(biases) - 1))
            reach = student(len(biases) - 1) * deviation / math.sqrt(len(biases))
            hard_part = f"{100 * within_hard / count_hard:.2f} %" if count_hard else "-"
            name = os.path.relpath(scene, os.path.join(ROOT, "scenes"))
            print(f"{name:<28}{100 * within / count:>8.2f} %{hard_part:>10}"
                  f"{count_hard // options.seeds:>13}{mean:>12.2e}  +-{reach:.1e}", flush=True)
            for i, part in enumerate((within, count, within_hard, count_hard)):
                sums[i] += part
    hard_part = 100 * sums[2] / sums[3] if sums[3] else float("nan")
    print(f"{'together':<28}{100 * sums[0] / sums[1]:>8.2f} %{hard_part:>8.2f} %")


def forecast(options):
    print(f"{'scene':<28}{'asked':>14}{'expected s':>12}{'took s':>9}{'ratio':>7}"
          f"{'expected error':>16}{'reached':>10}{'ratio':>7}{'of budget':>11}")
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes():
            name = os.path.relpath(scene, os.path.join(ROOT, "scenes"))
            _, said = render(options.program, scene, folder, "--size", options.size,
                             "--error", "0.02", "--max-samples", "4096")
            seconds = float(re.search(r"rays in ([\d.]+) s", said)[1])
            expected = float(re.search(r"\(expected .* and ([\d.]+) s\)", said)[1])
            print(f"{name:<28}{'--error 0.02':>14}{expected:>12.2f}{seconds:>9.2f}"
                  f"{seconds / expected:>7.2f}", flush=True)
            begin = time.monotonic()
            _, said = render(options.program, scene, folder, "--size", options.size,
                             "--budget", "4")
            whole = time.monotonic() - begin
            told = re.search(r"expects ([\d.]+) s and an error of ([\d.e-]+)", said)
            rms = float(re.search(r"error: ([\d.e-]+) \(root", said)[1])
            seconds = float(re.search(r"rays in ([\d.]+) s", said)[1])
            print(f"{'':<28}{'--budget 4':>14}{float(told[1]):>12.2f}{seconds:>9.2f}"
                  f"{seconds / float(told[1]):>7.2f}{float(told[2]):>16.2g}{rms:>10.2g}"
                  f"{rms / float(told[2]):>7.2f}{whole / 4:>11.2f}", flush=True)


RARE = """
PerspectiveCamera {{ center 0 0 5 direction 0 0 -1 up 0 1 0 angle 20 }}
Background {{ color 0.1 0.1 0.1 ambientLight 1 1 1 }}
Materials {{ Material white {{ diffuseColor 1 1 1 }} }}
Group {{
    MaterialIndex white
    Box {{ min {0} {0} 0 max {1} {1} 0.001 }}
}}
"""


def rare(options):
    """One pixel, of which a white speck covers one part in 500."""
    side = 2 * 5 * math.tan(math.radians(10)) / math.sqrt(500)
    truth = 0.1 + 0.9 / 500
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, "rare.scene")
        with open(scene, "w", encoding="utf-8") as file:
            file.write(RARE.format(-0.31, -0.31 + side))
        for method in ([], ["--guarantee"]):
            missed = 0
            for seed in range(options.seeds):
                picture, _ = render(options.program, scene, folder, "--size", "1x1",
                                    "--error", "0.001", "--max-samples", "1048576",
                                    "--seed", str(seed), *method)
                missed += abs(picture[0] - truth) > 0.001
            print(f"one sample in 500 sees it, --error 0.001 {' '.join(method)}: missed in "
                  f"{missed} of {options.seeds} seeds", flush=True)


def stats_of(program, scene, folder, *options):
    path = os.path.join(folder, "stats.json")
    render(program, scene, folder, "--stats", path, *options)
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def seconds_of(stats, *phases):
    return sum(p["seconds"] for p in stats["phases"] if p["name"] in phases)


def saving(program, scene, folder, effect, options, rounds=7):
    """Rays, seconds and their 95 % reach, by renders side by side."""
    differences = []
    for _ in range(rounds):
        both = [stats_of(program, scene, folder, *options, *more)
                for more in ([], [f"--no-{effect}"])]
        with_it, without = (seconds_of(s, "prepare", "render") for s in both)
        differences.append(with_it - without)
    rays = both[0]["rays"]["total"] - both[1]["rays"]["total"]
    mean = sum(differences) / rounds
    deviation = math.sqrt(sum((d - mean) ** 2 for d in differences) / (rounds - 1))
    return rays, mean, 2.447 * deviation / math.sqrt(rounds)


def bills(options):
    print(f"{'scene':<28}{'effect':<16}{'bill s':>10}{'+-':>9}{'render s':>10}{'+-':>9}  agree"
          f"{'rays':>12}{'same':>6}")
    agreed = count = 0
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes():
            name = os.path.relpath(scene, os.path.join(ROOT, "scenes"))
            study = json.loads(subprocess.run(
                [options.program, "cost", scene, "--json", "--quiet", "--size", options.size,
                 "--budget", "20"], capture_output=True, text=True, check=True).stdout)
            size = ["--size", options.size, "--samples", str(study["effect_samples"])]
            for bill in study["effects"]:
                low, high = bill["seconds_band"]
                rays, seconds, reach = saving(options.program, scene, folder, bill["effect"], size)
                # Both are uncertain: their difference by the root of the sum of squares.
                off = math.hypot((high - low) / 2, reach)
                agrees = abs(seconds - bill["seconds"]) <= off
                agreed += agrees
                count += 1
                print(f"{name:<28}{bill['effect']:<16}{bill['seconds']:>10.4f}"
                      f"{(high - low) / 2:>9.4f}{seconds:>10.4f}{reach:>9.4f}"
                      f"{'yes' if agrees else 'NO':>7}{rays:>12}"
                      f"{'yes' if rays == bill['rays'] else 'NO':>6}", flush=True)
                name = ""
            stats = stats_of(options.program, scene, folder, "--size", options.size,
                             "--samples", "64")
            stages = sum(s["seconds"] for s in stats["stages"])
            whole = stats["workers"] * seconds_of(stats, "render")
            print(f"{'':<28}stages are {100 * stages / whole:.2f} % of the workers' time", flush=True)
    print(f"{agreed} of {count} bills agree")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["coverage", "forecast", "rare", "bills"])
    parser.add_argument("program")
    parser.add_argument("--seeds", type=int, default=100)
    parser.add_argument("--scenes", type=int, default=12)
    parser.add_argument("--size", default=None)
    parser.add_argument("--error", type=float, default=0.02)
    parser.add_argument("--truth", type=int, default=65536)
    parser.add_argument("--unbiased", action="store_true")
    options = parser.parse_args()
    options.size = options.size or ("16x12" if options.what == "coverage" else "320x240")
    {"coverage": coverage, "forecast": forecast, "rare": rare, "bills": bills}[options.what](
        options)


if __name__ == "__main__":
    main()
