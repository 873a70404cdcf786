#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the cases of tests/cli/cases against the program.

usage: cli_test.py PROGRAM [CASE...]

A case is a folder. Its files are copied to a new folder, where `cmd` is run by /bin/sh with `cobble`
in its PATH; standard output, standard error and exit status must then be those of the files
`stdout`, `stderr` and `exit` (none: empty, empty, 0). Files named `after/X` say what file X must
hold afterwards. COBBLE_UPDATE=1 writes what came out instead.

`cmd` may begin with lines `# needs: WHAT`: a case that needs what this machine lacks is left out,
and the run says so. WHAT is `full-disk` (/dev/full), `mount` (root that may mount a small disk), or
`not-root` (file permissions count: as root, the case is run as nobody).
Times, speeds and temporary paths are replaced by words before comparing: see `normalised`.
"""

import concurrent.futures
import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
CASES = os.path.join(HERE, "cases")
SPECIAL = {"cmd", "stdout", "stderr", "exit", "after"}
TIMEOUT_SECONDS = 120


NOBODY = 65534


def may_mount():
    if os.geteuid() != 0:
        return False
    with tempfile.TemporaryDirectory() as folder:
        mount = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=4k", "tmpfs", folder],
                               capture_output=True, check=False)
        return mount.returncode == 0 and subprocess.run(["umount", folder],
                                                        check=False).returncode == 0


def nobody_may_run(program):
    """Whether every folder on the way to the program may be entered by all."""
    while program != "/":
        if not os.stat(program).st_mode & 0o001:
            return False
        program = os.path.dirname(program)
    return True


def lacks(what, program):
    """Why this machine cannot run a case that needs `what`, or None."""
    if what == "not-root":
        usable = os.geteuid() != 0 or nobody_may_run(program)
        return None if usable else "nobody but root may run the program where it is"
    if what == "mount":
        return None if may_mount() else "mounting a file system is not allowed here"
    if what == "full-disk":
        return None if os.path.exists("/dev/full") else "there is no /dev/full"
    return f"'{what}' is unknown"


def normalised(text, folder):
    text = text.replace(folder, "FOLDER")
    text = re.sub(r"[0-9.]+ ?[kMGT]?rays\b", "N rays", text)
    text = re.sub(r"in [0-9.]+ s \([0-9.]+ ?[kMGT]?rays/s\)", "in T s (N rays/s)", text)
    text = re.sub(r"in [0-9.]+ s \(N rays/s\)", "in T s (N rays/s)", text)
    text = re.sub(r'("seconds": |"peak_bytes": |"rays_per_second": )[0-9.e+-]+', r"\1N", text)
    text = re.sub(r"(expects|expected) ([0-9]+) samples a pixel and [0-9.]+ s",
                  r"\1 \2 samples a pixel and T s", text)
    # How far an interrupted render came depends on the machine.
    text = re.sub(r"interrupted at [0-9]+ %", "interrupted at N %", text)
    return re.sub(r"^rendering: .*\n", "", text, flags=re.MULTILINE)


def read(path, default=""):
    if not os.path.exists(path):
        return default
    with open(path, encoding="utf-8", errors="surrogateescape", newline="") as file:
        return file.read()


def write(path, text, default=""):
    if text == default:
        if os.path.exists(path):
            os.remove(path)
        return
    with open(path, "w", encoding="utf-8", errors="surrogateescape", newline="") as file:
        file.write(text)


def run_case(name, program):
    """A list of what is wrong, or a string: why the case was left out."""
    case = os.path.join(CASES, name)
    command = read(os.path.join(case, "cmd"))
    needs = re.findall(r"^# needs: (.*)$", command, re.MULTILINE)
    for what in needs:
        reason = lacks(what, program)
        if reason:
            return reason
    with tempfile.TemporaryDirectory(prefix="cobble-cli-") as folder:
        for entry in os.listdir(case):
            if entry in SPECIAL:
                continue
            source = os.path.join(case, entry)
            target = os.path.join(folder, entry)
            if os.path.isdir(source):
                shutil.copytree(source, target, symlinks=True)
            else:
                shutil.copy(source, target)
        environment = {k: v for k, v in os.environ.items()
                       if k not in ("NO_COLOR", "COLUMNS", "ASAN_OPTIONS")}
        environment["PATH"] = os.path.dirname(program) + os.pathsep + environment["PATH"]
        environment["TERM"] = "xterm"
        environment["LC_ALL"] = "C.UTF-8"
        as_nobody = {}
        if "not-root" in needs and os.geteuid() == 0:
            as_nobody = {"user": NOBODY, "group": NOBODY, "extra_groups": []}
            for path in [folder] + [os.path.join(folder, entry) for entry in os.listdir(folder)]:
                os.chown(path, NOBODY, NOBODY)
        try:
            result = subprocess.run(["/bin/sh", "-c", command], cwd=folder, env=environment,
                                    **as_nobody,
                                    stdin=subprocess.DEVNULL, capture_output=True,
                                    timeout=TIMEOUT_SECONDS, check=False)
        except subprocess.TimeoutExpired:
            return [f"not done within {TIMEOUT_SECONDS} s"]
        actual = {
            "stdout": normalised(result.stdout.decode(errors="surrogateescape"), folder),
            "stderr": normalised(result.stderr.decode(errors="surrogateescape"), folder),
            "exit": f"{result.returncode}\n",
        }
        after = os.path.join(case, "after")
        for root, _, files in os.walk(after):
            for file in files:
                path = os.path.relpath(os.path.join(root, file), after)
                actual[f"after/{path}"] = read(os.path.join(folder, path), "(no such file)\n")
    problems = []
    for part, text in actual.items():
        path = os.path.join(case, part)
        default = "0\n" if part == "exit" else ""
        expected = read(path, default)
        if text == expected:
            continue
        if os.environ.get("COBBLE_UPDATE"):
            write(path, text, default)
        else:
            problems.append(f"{part} is\n{indented(text)}       and should be\n{indented(expected)}")
    return problems


def indented(text):
    lines = text.encode("utf-8", "backslashreplace").decode().split("\n")
    if lines and not lines[-1]:
        lines.pop()
    return "".join(f"           {line}\n" for line in lines[:80])


def main():
    program = os.path.abspath(sys.argv[1])
    names = sys.argv[2:] or sorted(os.listdir(CASES))
    passed = failed = skipped = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(lambda name: run_case(name, program), names))
    for name, result in zip(names, results):
        if isinstance(result, str):
            skipped += 1
            print(f"left out {name}: {result}")
        elif result:
            failed += 1
            print(f"FAILED   {name}")
            for problem in result:
                print(f"       {problem}")
        else:
            passed += 1
    print(f"test cases: {passed + failed} | {passed} passed | {failed} failed | {skipped} left out")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
