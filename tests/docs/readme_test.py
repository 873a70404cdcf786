#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Types along the README's tour: its set-up, then each `console` block, and compares what is shown.

usage: readme_test.py ROOT PROGRAM

The set-up is the `sh` block before the first `console` block. It runs as it stands, from a new
folder that holds the repository's folders and the program where `tools/dev demo` builds it, and the
commands run where it leads, with its PATH. A block must show what its commands write, standard
error included; a last line `...` says that more follows. Times, speeds and progress lines are not
compared. COBBLE_UPDATE=1 writes into the README what came out instead.
"""

import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "cli"))
from cli_test import indented, normalised

BLOCK = re.compile(r"^```(sh|console)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
MORE = "...\n"
TIMEOUT_SECONDS = 300


def tour_of(readme):
    """The set-up, and the console blocks as matches; raises ValueError without them."""
    setup = None
    blocks = []
    for match in BLOCK.finditer(readme):
        if match[1] == "console":
            blocks.append(match)
        elif not blocks:
            setup = match[2]
    if setup is None or not blocks:
        raise ValueError("the README has no `sh` block that a `console` block follows")
    return setup, blocks


def steps_of(block):
    """Pairs of a command and what is shown below it."""
    steps = []
    for line in block.splitlines(keepends=True):
        if line.startswith("$ "):
            steps.append((line[2:].rstrip("\n"), ""))
        elif steps:
            steps[-1] = (steps[-1][0], steps[-1][1] + line)
        else:
            raise ValueError(f"a console block begins with {line!r}, not with a command")
    return steps


def make_root(folder, root, program):
    for name in os.listdir(root):
        if name not in ("build", "out", ".git"):
            os.symlink(os.path.join(root, name), os.path.join(folder, name))
    place = os.path.join(folder, "build", "release", "tools", "cobble")
    os.makedirs(place)
    os.symlink(program, os.path.join(place, "cobble"))


def shell(script, folder):
    """What the script writes; raises CalledProcessError if it cannot go on."""
    return subprocess.run(["/bin/sh", "-c", script], cwd=folder, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, check=True,
                          timeout=TIMEOUT_SECONDS).stdout.decode()


def same(shown, written, folder):
    shown, written = normalised(shown, folder), normalised(written, folder)
    if shown.endswith(MORE):
        return written.startswith(shown[:-len(MORE)]) and len(written) > len(shown)
    return shown == written


def main():
    root, program = (os.path.abspath(path) for path in sys.argv[1:3])
    path = os.path.join(root, "README.md")
    with open(path, encoding="utf-8") as file:
        readme = file.read()
    setup, blocks = tour_of(readme)
    passed = failed = 0
    result, end = "", 0
    with tempfile.TemporaryDirectory(prefix="cobble-readme-") as folder:
        make_root(folder, root, program)
        state = shell(f'{setup}\nprintf "%s\\n%s\\n" "$PATH" "$PWD"', folder).splitlines()
        os.environ["PATH"] = state[-2]
        for block in blocks:
            now = ""
            for command, shown in steps_of(block[2]):
                # Commands may find something and say so with their status.
                written = shell(f"({command}) || true", state[-1])
                if same(shown, written, folder):
                    passed += 1
                    now += f"$ {command}\n{shown}"
                    continue
                failed += 1
                now += f"$ {command}\n" + re.sub("^rendering: .*\n", "", written, flags=re.M)
                print(f"FAILED   $ {command}\n       writes\n{indented(written)}"
                      f"       and the README shows\n{indented(shown)}")
            result += readme[end:block.start(2)] + now
            end = block.end(2)
    if failed and os.environ.get("COBBLE_UPDATE"):
        with open(path, "w", encoding="utf-8") as file:
            file.write(result + readme[end:])
    print(f"test cases: {passed + failed} | {passed} passed | {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
