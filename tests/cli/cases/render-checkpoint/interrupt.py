# SPDX-License-Identifier: MIT
# Interrupts a render once it has something to keep, and what goes on from there too.
import os, re, signal, subprocess


def interrupted(*more):
    process = subprocess.Popen(["cobble", "render", "good.scene", "--size", "400x300", "--samples",
                                "1000", "-o", "a.pfm", "--checkpoint", "a.state", *more],
                               stderr=subprocess.PIPE)
    # Progress is told with the first tenth, or with the next.
    lines = [process.stderr.readline().decode()]
    while not lines[-1].startswith("rendering"):
        lines.append(process.stderr.readline().decode())
    goes_on = any(re.fullmatch("going on from a.state at [0-9]+ %\n", line) for line in lines)
    assert goes_on == ("--resume" in more), lines
    process.send_signal(signal.SIGINT)
    message = process.stderr.read().decode()
    print("exit", process.wait(), sorted(os.listdir(".")), message, end="")
    return int(re.search("interrupted at ([0-9]+) %", message)[1])


first = interrupted()
second = interrupted("--resume")
print("nothing was lost" if second >= first else f"{first} %, then {second} %")
