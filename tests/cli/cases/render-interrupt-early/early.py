# SPDX-License-Identifier: MIT
import os, signal, subprocess, sys, time
number = getattr(signal, "SIG" + sys.argv[1])
for old in ("old.png", "new.png"):
    if old == "old.png":
        open(old, "w").write("old")
    # So many samples that a hundredth of them takes minutes.
    process = subprocess.Popen(["cobble", "render", "good.scene", "--size", "2000x2000",
                                "--samples", "1000000", "-o", old], stderr=subprocess.PIPE)
    time.sleep(1)
    process.send_signal(number)
    sys.stdout.write(process.stderr.read().decode())
    print("exit", process.wait(), sorted(os.listdir(".")))
print(open("old.png").read())
