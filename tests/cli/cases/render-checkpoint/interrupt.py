# SPDX-License-Identifier: MIT
# Interrupts a render once it has something to keep, and what goes on from there too.
import os, re, signal, subprocess


def interrupted(*more):
    process = subprocess.Popen(["cobble", "render", "good.scene", "--size", "400x300", "--samples",
                                "1000", "-o", "a.pfm", "--checkpoint", "a.state", *more],
                               stderr=subprocess.PIPE)
    # The first line comes with the first tenth, or with the next.
    process.stderr.readline()
    process.send_signal(signal.SIGINT)
    message = process.stderr.read().decode()
    print("exit", process.wait(), sorted(os.listdir(".")), message, end="")
    return int(re.search("interrupted at ([0-9]+) %", message)[1])


first = interrupted()
second = interrupted("--resume")
print("nothing was lost" if second >= first else f"{first} %, then {second} %")
