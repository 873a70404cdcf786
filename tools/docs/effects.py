#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The page of what effects cost: instructions a pixel with each one off, compiled out, and on.

usage: effects.py BUILD     builds what counts, in the build tree BUILD, and writes
                            tools/docs/effects.md; takes a quarter of an hour and valgrind
       effects.py --check   says which effects the page lacks

A figure is the instructions of the render loop over the pixels of the picture, by callgrind.
"""

import os
import re
import shutil
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tests", "instructions"))
from counting import WANTED, count  # pylint: disable=wrong-import-position

PAGE = "tools/docs/effects.md"
EFFECTS = "ir/scene/effects.hpp"
SET = WANTED[0]
WIDTH, SAMPLES = 128, 4
PIXELS = WIDTH * (WIDTH * 3 // 4)

# A scene that calls for the effect.
SCENES = {
    "depth-of-field": "depth_of_field",
    "motion-blur": "motion_blur",
    "soft-shadows": "soft_shadows",
    "shadows": "phong",
    "reflection": "mirror_glass",
    "refraction": "mirror_glass",
    "highlights": "phong",
    "textures": "textures",
    "normal-maps": "normal_map",
    "noise": "marble",
    "environment": "environment",
}


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def effects():
    """Their names, in the order of ir::Effect."""
    return re.findall(r'^ +COBBLE_EFFECT\(k\w+, "([a-z-]+)"', read(EFFECTS), re.MULTILINE)


def scene_of(effect):
    return f"scenes/basics/{SCENES[effect]}.scene"


def check(names, page):
    for name in names:
        if name not in SCENES:
            yield f"effect {name} has no scene in tools/docs/effects.py"
        elif not os.path.exists(os.path.join(ROOT, scene_of(name))):
            yield f"{scene_of(name)}, for {name}, is not there"
        if f"\n| {name} |" not in page:
            yield f"{PAGE} does not say what {name} costs"
    for name in re.findall(r"^\| ([a-z-]+) \| \[", page, re.MULTILINE):
        if name not in names:
            yield f"{PAGE} knows an effect {name}, which there is not"


def self_test():
    """Each disagreement is found in pages that are wrong on purpose."""
    page = "\n| shadows | [x](y) |\n"
    assert list(check(["shadows"], page)) == []
    for names, text in ((["shadows", "noise"], page), (["glitter"], page), ([], page)):
        if not list(check(names, text)):
            yield f"the check finds nothing wrong with {names}"


def measure(build, effect):
    program = os.path.join(build, "tests", "instructions", "loop_full")
    without = os.path.join(build, "tests", "instructions", f"loop_without_{effect}")
    scene = os.path.join(ROOT, scene_of(effect))
    off = count(program, scene, WIDTH, SAMPLES, SET, [effect])
    out = count(without, scene, WIDTH, SAMPLES, SET, [effect])
    on = count(program, scene, WIDTH, SAMPLES, SET, [])
    if off.picture != out.picture:
        sys.exit(f"{effect}: the pictures with it off and with it compiled out differ")
    if off.picture == on.picture:
        sys.exit(f"{effect}: {scene} does not show it")
    return off.instructions / PIXELS, out.instructions / PIXELS, on.instructions / PIXELS


def row(effect, off, out, on):
    scene = scene_of(effect)
    return (f"| {effect} | [{SCENES[effect]}](../../{scene}) | {out:,.1f} | {off:,.1f} | "
            f"{off / out - 1:+.4%} | {on:,.1f} | {on / off - 1:+.1%} |")


def page(rows):
    return "\n".join([
        "<!-- Written by tools/docs/effects.py; not by hand. -->",
        "",
        "# What effects cost, on and off",
        "",
        "Only what a scene calls for is simulated (`cobble explain SCENE` says what that is, and",
        "`--plan` how). So an effect that is off should cost nothing, as if the program did not",
        "know it. Here is what it does cost: processor instructions of the render loop a pixel, by",
        f"valgrind's callgrind, of the scenes named at {WIDTH}x{WIDTH * 3 // 4}, {SAMPLES} samples "
        "a pixel, in float, on one",
        f"thread with {SET.upper()} kernels. \"Compiled out\" is the same scene with the effect "
        "switched off,",
        "rendered by a program in which the effect is false when it is compiled.",
        "",
        "| effect | scene | compiled out | off | off costs | on | on costs |",
        "|---|---|---:|---:|---:|---:|---:|",
        *rows,
        "",
        "An effect may cost less than what it takes the place of: a surface that shows its",
        "surroundings is not lit.",
        "",
        "`tests/instructions` holds a scene without any effect to this: it takes the same number",
        "of instructions, within a thousandth, in a program without any.",
    ]) + "\n"


def main():
    names = effects()
    if sys.argv[1:] == ["--check"]:
        findings = [*self_test(), *check(names, read(PAGE))]
        for line in findings:
            print(line)
        return 1 if findings else 0
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 2
    if shutil.which("valgrind") is None:
        sys.exit("valgrind is needed")
    build = os.path.abspath(sys.argv[1])
    targets = ["loop_full", *(f"loop_without_{name}" for name in names)]
    subprocess.run(["cmake", "--build", build, "--target", *targets], check=True)
    rows = []
    for name in names:
        rows.append(row(name, *measure(build, name)))
        print(rows[-1], flush=True)
    with open(os.path.join(ROOT, PAGE), "w", encoding="utf-8") as file:
        file.write(page(rows))
    return 0


if __name__ == "__main__":
    sys.exit(main())
