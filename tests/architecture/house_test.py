#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds the house to its plan: which room may include which, and what every file owes.

usage: house_test.py ROOT BUILD

ROOT is the repository, BUILD a configured build tree with compile_commands.json. Each check is
written so that it can be pointed at a broken house too: `self_test` does so first, because a rule
that cannot fail protects nothing.
"""

import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

from report import report

# A header that stands for each library, and the libraries that each one may see.
PROBES = {
    "source": "frontend/source/span.hpp",
    "math": "ir/math/vec.hpp",
    "image": "ir/image/decoder.hpp",
    "grammar": "grammar/vocabulary.hpp",
    "frontend": "frontend/ast/ast.hpp",
    "ir_scene": "ir/scene/scene.hpp",
    "ir": "ir/lower.hpp",
    "renderer": "renderer/settings.hpp",
    "driver": "tools/driver/disk_file_source.hpp",
}
MAY_SEE = {
    "source": {"source"},
    "math": {"math"},
    "image": {"math", "image"},
    "grammar": {"grammar"},
    "frontend": {"source", "grammar", "frontend"},
    "ir_scene": {"source", "math", "ir_scene"},
    "ir": {"source", "math", "image", "grammar", "frontend", "ir_scene", "ir"},
    "renderer": {"source", "math", "image", "ir_scene", "renderer"},
    "driver": set(PROBES),
}

ROOMS = ("grammar", "frontend", "ir", "renderer", "tools", "tests", "scenes", "cmake", ".ci")
# Headers that a room must do without, and the folder in it that is excused.
BANNED_HEADERS = {
    "grammar": (r"thread|mutex|condition_variable|future|fstream|filesystem|iostream|cstdio", None),
    "frontend": (r"thread|mutex|condition_variable|future|fstream|filesystem|iostream|cstdio", None),
    "ir": (r"thread|mutex|condition_variable|future|fstream|filesystem|iostream|cstdio", None),
    "renderer": (r"thread|mutex|condition_variable|future", "renderer/job"),
}
# The C library's own functions differ between machines in the last bit; ir/math has ours.
LIBM = re.compile(
    r"\bstd::(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|expm1|log|log2|log10|log1p"
    r"|pow|cbrt|hypot|erf|tgamma|lgamma)\s*\(")
MAX_LINES = 500


def sources(root, extensions):
    for room in ROOMS:
        # Test cases are data, whatever their files are called.
        for folder, folders, files in os.walk(os.path.join(root, room)):
            folders[:] = sorted(f for f in folders if f not in ("build", "cases", "__pycache__"))
            for name in sorted(files):
                path = os.path.join(folder, name)
                if not os.path.islink(path) and name.endswith(extensions):
                    yield os.path.relpath(path, root)


def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()


def includes(text):
    return re.findall(r'^\s*#\s*include\s+(["<])([^">]+)[">]', text, re.MULTILINE)


def check_includes_go_down(root):
    """No "../", and no folder that reaches itself through the folders that it includes."""
    graph = {}
    for path in sources(root, (".cpp", ".hpp", ".def")):
        folder = os.path.dirname(path)
        for kind, target in includes(read(root, path)):
            if ".." in target.split("/"):
                yield f"{path}: includes {target}: write the path from the root"
            if kind == '"' and os.path.dirname(target) != folder:
                graph.setdefault(folder, {}).setdefault(os.path.dirname(target), path)
    done = set()
    for start in sorted(graph):
        stack = [(start, iter(sorted(graph[start])))]
        on_path = [start]
        while stack:
            folder, rest = stack[-1]
            child = next(rest, None)
            if child is None:
                stack.pop()
                on_path.pop()
                done.add(folder)
            elif child in on_path:
                cycle = on_path[on_path.index(child):] + [child]
                where = ", ".join(graph[a][b] for a, b in zip(cycle, cycle[1:]))
                yield f"folders include each other: {' -> '.join(cycle)} (by {where})"
            elif child not in done and child in graph:
                stack.append((child, iter(sorted(graph[child]))))
                on_path.append(child)


def check_banned(root):
    for path in sources(root, (".cpp", ".hpp")):
        text = read(root, path)
        room = path.split("/")[0]
        banned, excused = BANNED_HEADERS.get(room, ("(?!)", None))
        for _, target in includes(text):
            if re.fullmatch(banned, target) and not (excused and path.startswith(excused + "/")):
                yield f"{path}: includes <{target}>, which {room}/ does without"
            if target in ("format", "stop_token"):
                yield f"{path}: includes <{target}>, which libc++ 19 or libstdc++ 12 lacks"
        if room in ("ir", "renderer"):
            for match in LIBM.finditer(text):
                yield f"{path}: calls std::{match[1]}: use ir/math/elementary.hpp"


def check_licence_lines(root):
    endings = (".cpp", ".hpp", ".def", ".py", ".sh", "CMakeLists.txt", ".cmake", ".cmake.in")
    everything = list(sources(root, endings)) + ["CMakeLists.txt", "tools/dev", ".ci/run"]
    for path in everything:
        if path == "CMakeLists.txt" and not os.path.exists(os.path.join(root, path)):
            continue
        if not os.path.exists(os.path.join(root, path)):
            continue
        if "SPDX-License-Identifier: MIT" not in "\n".join(read(root, path).split("\n")[:2]):
            yield f"{path}: the first line is not the licence's SPDX line"


def check_length(root):
    for path in sources(root, (".cpp", ".hpp", ".py")):
        text = read(root, path)
        count = text.count("\n")
        generated = re.search(r"\bgenerated\b", "\n".join(text.split("\n")[:5]), re.IGNORECASE)
        if count > MAX_LINES and not generated:
            yield f"{path}: {count} lines; past {MAX_LINES} a file is two"


STATIC_CHECKS = (check_includes_go_down, check_banned, check_licence_lines, check_length)


def compile_commands(root, build):
    """For each library with a source file: the command that preprocesses one of its files."""
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        entries = json.load(file)
    commands = {}
    for entry in entries:
        arguments = shlex.split(entry["command"])
        output = arguments[arguments.index("-o") + 1]
        match = re.search(r"cobble_(\w+)\.dir/", output)
        if match and match[1] in MAY_SEE and match[1] not in commands:
            at = arguments.index("-o")
            arguments = arguments[:at] + arguments[at + 2:]
            arguments = [a for a in arguments if a not in ("-c", entry["file"])]
            if os.path.basename(arguments[0]) == "ccache":
                arguments = arguments[1:]
            commands[match[1]] = (arguments, entry["directory"])
    return commands


def check_walls(root, build):
    commands = compile_commands(root, build)
    for needed, room in (("grammar", "grammar"), ("frontend", "frontend"), ("ir", "ir"),
                         ("renderer", "renderer"), ("driver", "tools/driver")):
        has_sources = any(path.startswith(room + "/") for path in sources(root, (".cpp",)))
        if has_sources and needed not in commands:
            yield f"no compile command of cobble_{needed} was found: nothing was tried"

    def compiles(library, header):
        arguments, folder = commands[library]
        with tempfile.NamedTemporaryFile("w", suffix=".cpp") as file:
            file.write(f'#include "{header}"\n')
            file.flush()
            run = subprocess.run(arguments + ["-E", "-o", os.devnull, file.name], cwd=folder,
                                 capture_output=True, text=True, check=False)
        return run.returncode == 0, run.stderr

    tries = [(library, other) for library in commands for other in PROBES]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        results = pool.map(lambda pair: compiles(pair[0], PROBES[pair[1]]), tries)
    for (library, other), (worked, errors) in zip(tries, results):
        allowed = other in MAY_SEE[library]
        if worked and not allowed:
            yield f"a file of cobble_{library} that includes {PROBES[other]} compiles"
        if allowed and not worked:
            yield f"a file of cobble_{library} cannot include {PROBES[other]}: {errors.strip()}"


def self_test():
    """Each static check finds what is wrong in a house made wrong on purpose."""
    spdx = "// SPDX-License-Identifier: MIT\n"
    broken = {
        "ir/up.cpp": spdx + '#include "../grammar/vocabulary.hpp"\n',
        "frontend/a/x.hpp": spdx + '#include "frontend/b/y.hpp"\n',
        "frontend/b/y.hpp": spdx + '#include "frontend/a/x.hpp"\n',
        "renderer/shade/t.cpp": spdx + "#include <thread>\n",
        "renderer/job/t.cpp": spdx + "#include <thread>\n",
        "renderer/shade/m.cpp": spdx + "double f(double x) { return std::sin(x); }\n",
        "ir/f.cpp": spdx + "#include <format>\n",
        "grammar/bare.cpp": "int x;\n",
        "tools/long.cpp": spdx + "\n" * MAX_LINES,
        "tools/long_generated.cpp": spdx + "// Generated.\n" + "\n" * MAX_LINES,
    }
    expected = {"ir/up.cpp", "folders", "renderer/shade/t.cpp", "renderer/shade/m.cpp", "ir/f.cpp",
                "grammar/bare.cpp", "tools/long.cpp"}
    with tempfile.TemporaryDirectory() as root:
        for path, text in broken.items():
            os.makedirs(os.path.join(root, os.path.dirname(path)), exist_ok=True)
            with open(os.path.join(root, path), "w", encoding="utf-8") as file:
                file.write(text)
        found = [line for check in STATIC_CHECKS for line in check(root)]
    starts = {re.split(r"[: ]", line)[0] for line in found}
    if starts != expected:
        yield f"the checks of this test find {sorted(starts)}, not {sorted(expected)}"


def main():
    root, build = sys.argv[1:3]
    checks = [("self-test", self_test())]
    checks += [(check.__name__, check(root)) for check in STATIC_CHECKS]
    checks.append(("check_walls", check_walls(root, build)))
    return report(checks)


if __name__ == "__main__":
    sys.exit(main())
