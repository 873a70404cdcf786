#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Disassembles what was built and finds no fused multiply-add in it.

usage: fused_test.py OBJDUMP COMPILER LIBRARY...

A fused multiply-add rounds once where a product and a sum round twice: with one in the code a
picture would depend on the instruction set. The flag -ffp-contract=off keeps compilers from making
them, g++ even of intrinsics; this test sees that it did, in every kernel of every instruction set.
That it can fail is shown first, on code that has them.
"""

import os
import platform
import re
import subprocess
import sys
import tempfile

from report import report

# x86: vfmadd132ss, vfnmsub231pd, vfmaddsub213ps ... AArch64: fmadd, fnmsub, fmla, fmls.
FUSED = re.compile(r"\s(vfn?m(?:add|sub)\w*|fn?m(?:add|sub)|fml[as])\b")
FUNCTION = re.compile(r"^[0-9a-f]+ <(.*)>:$")

PLANTS = {
    "a call of std::fma": ("#include <cmath>\n"
                           "double f(double a, double b, double c) { return std::fma(a, b, c); }\n",
                           "off"),
    "a contracted expression": ("float f(float a, float b, float c) { return a * b + c; }\n",
                                "fast"),
    "a contracted difference": ("float f(float a, float b, float c) { return c - a * b; }\n",
                                "fast"),
}
SOUND = "float f(float a, float b, float c) { return a * b + c; }\n"


def lines_of(objdump, path):
    """The disassembly, line by line: of a library with sanitizers it is large."""
    command = [objdump, "-d", "--no-show-raw-insn", path]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, errors="replace") as run:
        yield from run.stdout
    if run.returncode != 0:
        raise RuntimeError(f"{' '.join(command)} ends with {run.returncode}")


def fused(lines):
    """(function, instruction) of the first one in each function."""
    function = "?"
    found = []
    for line in lines:
        if line[:1].isalnum():
            named = FUNCTION.match(line)
            function = named[1] if named else function
        elif "fm" in line or "vfn" in line:
            match = FUSED.search(line)
            if match and (not found or found[-1][0] != function):
                found.append((function, match[1]))
    return found


def machine_flags():
    return ["-mavx2", "-mfma"] if platform.machine() in ("x86_64", "AMD64") else []


def of_source(objdump, compiler, text, contract):
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, "plant.cpp")
        with open(source, "w", encoding="utf-8") as file:
            file.write(text)
        result = source + ".o"
        subprocess.run([compiler, "-O2", "-std=c++20", f"-ffp-contract={contract}",
                        *machine_flags(), "-c", source, "-o", result], check=True)
        return fused(lines_of(objdump, result))


def check_self(objdump, compiler):
    for name, (text, contract) in PLANTS.items():
        if not of_source(objdump, compiler, text, contract):
            yield f"{name} is not found: this test would see nothing"
    for function, instruction in of_source(objdump, compiler, SOUND, "off"):
        yield f"{instruction} in {function}, which was compiled without contraction"


def check_library(objdump, path):
    # Registers by which an instruction set is known: without them nothing was looked at.
    due = {}
    if "renderer" in os.path.basename(path) and machine_flags():
        due = {"%zmm": "AVX-512", "%ymm": "AVX2", "%xmm": "SSE"}
    seen = set()

    def watched():
        for line in lines_of(objdump, path):
            seen.update(register for register in due.keys() - seen if register in line)
            yield line

    for function, instruction in fused(watched()):
        yield f"{path}: {instruction} in {function}"
    for register in due.keys() - seen:
        yield f"{path} has no kernel for {due[register]}"


def main():
    objdump, compiler, *libraries = sys.argv[1:]
    checks = [("self-test", check_self(objdump, compiler))]
    checks += [(os.path.basename(path), check_library(objdump, path)) for path in libraries]
    return report(checks)


if __name__ == "__main__":
    sys.exit(main())
