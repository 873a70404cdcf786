# SPDX-License-Identifier: MIT
"""What the tests of this folder print, in the form that tools/dev counts."""


def report(checks):
    """`checks`: pairs of a name and its findings, an iterable of lines. Gives the exit status."""
    failed = 0
    for name, findings in checks:
        findings = list(findings)
        failed += bool(findings)
        print(f"{'FAILED' if findings else 'ok':6} {name}")
        for line in findings:
            print(f"       {line}")
    print(f"test cases: {len(checks)} | {len(checks) - failed} passed | {failed} failed")
    return 1 if failed else 0
