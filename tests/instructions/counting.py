# SPDX-License-Identifier: MIT
"""Runs loop.cpp under callgrind and reads what was counted."""

import collections
import re
import subprocess
import sys
import tempfile

Counted = collections.namedtuple("Counted", "instructions picture")
# Valgrind knows nothing better than AVX2.
WANTED = ("avx2", "sse4")


def count(program, scene, size, samples, instruction_set, effects_off):
    """The instructions of the render loop, and the hash of the picture."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", "--collect-atstart=no",
             "--toggle-collect=cobble_render_loop", f"--callgrind-out-file={folder}/out",
             program, scene, str(size), str(samples), instruction_set, *effects_off],
            capture_output=True, text=True, check=False)
    collected = re.search(r"Collected : ([0-9]+)", run.stderr)
    if run.returncode != 0 or collected is None or int(collected[1]) == 0:
        sys.exit(f"callgrind failed on {program} {scene}:\n{run.stderr[-2000:]}")
    return Counted(int(collected[1]), run.stdout.strip())


def instruction_sets(program, scene):
    """Those wanted that the program has on this machine."""
    def runs(name):
        return subprocess.run([program, scene, "4", "1", name], capture_output=True,
                              check=False).returncode == 0
    return [name for name in WANTED if runs(name)]
