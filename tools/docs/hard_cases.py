#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The page of hard cases: each row of tests/hard/README.md with what its tests measured.

usage: hard_cases.py BUILD [AIMED]    runs the tests of BUILD and writes tools/docs/hard-cases.md
       hard_cases.py --check          says what the table, the tests and the page do not agree on

AIMED is what `bench_aimed --json` wrote; without it the page keeps what it says of such a run.
--check compares which rows there are, never figures: those are as old as the page.
"""

import json
import os
import re
import subprocess
import sys
import tempfile
import textwrap
import xml.etree.ElementTree

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TABLE = "tests/hard/README.md"
PAGE = "tools/docs/hard-cases.md"
# Rows that the language gives no meaning to, and the words that would give them one.
NOT_APPLICABLE = {20: ("Cone", "Cylinder")}
TITLE = re.compile(r'TEST_CASE(?:_TEMPLATE)?\(\s*"(rows? [^"]*)')


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def rows_of_title(title):
    """The numbers in "row 4: ...", "rows 4 and 5: ..." and "rows 1 to 41: ..."."""
    match = re.match(r"rows? ([0-9]+(?:(?:, | and | to )[0-9]+)*):", title)
    if not match:
        return set()
    span = re.fullmatch(r"([0-9]+) to ([0-9]+)", match[1])
    if span:
        return set()  # about many rows at once, and the test of none
    return {int(number) for number in re.findall("[0-9]+", match[1])}


def table_rows(text):
    """{row: its other cells} of a page's table whose first cell is a number."""
    rows = {}
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if line.startswith("|") and cells[0].isdigit():
            rows[int(cells[0])] = cells[1:]
    return rows


def files_of(cell):
    """The test files that a row names: `hard/boxes` is tests/hard/boxes_test.cpp."""
    return [f"tests/{name}_test.cpp" for name in re.findall(r"`([a-z_/]+)`", cell)]


def titled_rows(path):
    text = re.sub(r'"\s*\n\s*"', "", read(path))
    return set().union(*(rows_of_title(title) for title in TITLE.findall(text)), set())


def check(table_text, page_text, titles, vocabulary):
    """What does not agree. `titles`: {test file: rows in its titles}, of all test files."""
    rows = table_rows(table_text)
    shown = table_rows(page_text)
    for row, cells in sorted(rows.items()):
        if row in NOT_APPLICABLE:
            for word in NOT_APPLICABLE[row]:
                if re.search(rf"COBBLE_BLOCK\({word}\b", vocabulary):
                    yield f"row {row} is said not to apply, but the language has {word}"
            continue
        files = files_of(cells[-1])
        if not files:
            yield f"row {row} names no test"
        for path in files:
            if path not in titles:
                yield f"row {row} names {path}, which there is not"
            elif row not in titles[path]:
                yield f"row {row}: no test case of {path} is called so"
    for path, numbers in sorted(titles.items()):
        for row in sorted(numbers - rows.keys()):
            yield f"{path} tests row {row}, which the table does not have"
        for row in sorted(numbers & rows.keys()):
            if path not in files_of(rows[row][-1]):
                yield f"{path} tests row {row}, and the table does not say so"
    for row in sorted(set(range(1, 46)) - rows.keys()):
        yield f"{TABLE} has no row {row}"
    for row in sorted(rows.keys() ^ shown.keys()):
        yield f"{PAGE} and {TABLE} do not both have row {row}"
    for row in sorted(rows.keys() & shown.keys()):
        if rows[row][0] != shown[row][0]:
            yield f"row {row} is another case in {PAGE} than in {TABLE}"


def self_test():
    """Each disagreement is found in tables that are wrong on purpose."""
    good = "".join(f"| {i} | case {i} | passes | exact | `hard/a` |\n" for i in range(1, 46))
    titles = {"tests/hard/a_test.cpp": set(range(1, 46)) - {20}}
    assert list(check(good, good, titles, "")) == []
    broken = {
        "a row without a test": (good, good, {"tests/hard/a_test.cpp": {1}}, ""),
        "a row that is missing": (good.replace("| 7 |", "| x |"), good, titles, ""),
        "a page without a row": (good, good.replace("| 7 |", "| x |"), titles, ""),
        "a page with another case": (good, good.replace("case 7", "ease 7"), titles, ""),
        "a test that the table does not know": (good, good, titles | {"tests/b_test.cpp": {3}}, ""),
        "a cone": (good, good, titles, "COBBLE_BLOCK(Cone, kObject)"),
    }
    for name, case in broken.items():
        if not list(check(*case)):
            yield f"the check does not find {name}"
    if rows_of_title("rows 4 and 5: x") != {4, 5} or rows_of_title("row 31: x") != {31}:
        yield "titles are not read"
    both = {"tests/hard/a_test.cpp": {1}, "tests/ir/b_test.cpp": {1}, "tests/hard/c_test.cpp": {2}}
    if programs_of(both) != ["hard", "ir"]:
        yield "a program is left out of the page, or counted twice"


def all_titles():
    titles = {}
    for program in sorted(os.listdir(os.path.join(ROOT, "tests"))):
        folder = os.path.join(ROOT, "tests", program)
        for name in sorted(os.listdir(folder)) if os.path.isdir(folder) else ():
            if name.endswith("_test.cpp"):
                path = f"tests/{program}/{name}"
                rows = titled_rows(path)
                if rows:
                    titles[path] = rows
    return titles


def programs_of(titles):
    """The test programs that any row is tested by: tests/NAME/x_test.cpp is part of test_NAME."""
    return sorted({path.split("/")[1] for path in titles})


def run_tests(build):
    """({row: checks}, {row: [what was measured]})."""
    checks = {}
    measured = {}
    with tempfile.TemporaryDirectory() as folder:
        results = os.path.join(folder, "results")
        environment = dict(os.environ, COBBLE_HARD_RESULTS=results)
        for program in programs_of(all_titles()):
            run = subprocess.run(
                [os.path.join(build, "tests", f"test_{program}"), "-tc=row*", "-r=xml"], cwd=ROOT,
                env=environment, capture_output=True, text=True, check=False)
            if run.returncode != 0:
                sys.exit(f"test_{program} fails: mend that first")
            for case in xml.etree.ElementTree.fromstring(run.stdout).iter("TestCase"):
                asserts = case.find("OverallResultsAsserts")
                count = int(asserts.get("successes")) if asserts is not None else 0
                for row in rows_of_title(case.get("name")):
                    checks[row] = checks.get(row, 0) + count
        with open(results, encoding="utf-8") as file:
            for line in file:
                row, text = line.rstrip("\n").split("\t")
                if text not in measured.setdefault(int(row), []):
                    measured[int(row)].append(text)
    return checks, measured


def of_aimed_rays(path):
    """What is said of a run of bench_aimed; without one what the page says now."""
    if path is None:
        kept = re.search(r"\nOf [0-9,]+ different rays.*?\n\n", read(PAGE), re.DOTALL)
        return kept[0].strip() if kept else ""
    with open(path, encoding="utf-8") as file:
        report = json.load(file)
    total = report["total"]
    sets = report["instruction_sets"]
    text = (f"Of {total['rays']:,} different rays at edges, vertices and outlines of "
            f"{len(report['scenes'])} scenes (`bench_aimed`), each asked of the fast core by "
            f"{', '.join(sets)}, ray by ray, in batches, and in packets where rays go alike, "
            f"{total['answers']:,} answers in all, {total['in_packets']:,} of them in packets, "
            f"{total['leaks']:,} slipped through a closed thing and {total['differ']:,} "
            f"differed; {total['wrong']:,} of {total['checked']:,} that brute force was asked about "
            f"were unlike its answer.")
    return textwrap.fill(text, 100)


def page(checks, measured, aimed):
    lines = [
        "<!-- Written by tools/docs/hard_cases.py from tests/hard/README.md; not by hand. -->",
        "",
        "# Hard cases, measured",
        "",
        "Where ray tracers have been seen to go wrong, what must hold here, and what was measured.",
        "The table of [tests/hard](../../tests/hard/README.md) says what the words mean; `u` is",
        "half of the spacing of floats at 1. Figures that are fractions of a bound are the worst",
        "error over what the bound allows there: 1 is just allowed.",
        "",
        *([aimed, ""] if aimed else []),
        "| row | case | our result | error bound, or what passes | reference |",
        "|---|---|---|---|---|",
    ]
    for row, cells in sorted(table_rows(read(TABLE)).items()):
        case, bound, reference = cells[:3]
        if row in NOT_APPLICABLE:
            result = "does not apply"
        else:
            parts = measured.get(row, []) + [f"{checks.get(row, 0):,} checks passed"]
            result = "; ".join(parts)
        lines.append(f"| {row} | {case} | {result} | {bound} | {reference} |")
    return "\n".join(lines) + "\n"


def main():
    if sys.argv[1:] == ["--check"]:
        findings = list(self_test())
        findings += check(read(TABLE), read(PAGE), all_titles(), read("grammar/vocabulary.def"))
        for line in findings:
            print(line)
        if findings:
            print(f"write the page anew: {sys.argv[0]} BUILD")
        return 1 if findings else 0
    if len(sys.argv) not in (2, 3) or sys.argv[1].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 2
    aimed = of_aimed_rays(sys.argv[2] if len(sys.argv) == 3 else None)
    text = page(*run_tests(os.path.abspath(sys.argv[1])), aimed)
    with open(os.path.join(ROOT, PAGE), "w", encoding="utf-8") as file:
        file.write(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
