#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""An effect that is off costs no instruction: counts them in the render loop.

usage: instructions_test.py FULL WITHOUT SCENE

FULL and WITHOUT are the program loop.cpp, the second one built with every effect compiled out. A
scene that calls for none takes the same number of instructions in both, within a thousandth, at
each instruction set, for the same picture. So that this is known to be able to fail, the first
program is also run with an effect on.
"""

import shutil
import sys

from counting import count, instruction_sets

TOLERANCE = 0.001
SIZE, SAMPLES = 64, 4


def main():
    full, without, scene = sys.argv[1:4]
    if shutil.which("valgrind") is None:
        print("skipped: there is no valgrind")
        return 0
    failures = 0
    for name in instruction_sets(full, scene):
        off = count(full, scene, SIZE, SAMPLES, name, ["none"])
        out = count(without, scene, SIZE, SAMPLES, name, ["none"])
        shadows = count(full, scene, SIZE, SAMPLES, name, [])
        ratio = off.instructions / out.instructions
        print(f"{name}: {off.instructions} instructions with all effects off, "
              f"{out.instructions} with all compiled out: {ratio - 1:+.5%}; "
              f"{shadows.instructions} with shadows")
        if abs(ratio - 1) > TOLERANCE:
            failures += 1
            print("FAILED: an effect that is off costs something")
        if off.picture != out.picture:
            failures += 1
            print("FAILED: the pictures differ")
        if shadows.instructions < (1 + 10 * TOLERANCE) * off.instructions:
            failures += 1
            print("FAILED: an effect that is on is not seen")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
