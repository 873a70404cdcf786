# SPDX-License-Identifier: MIT
import signal, subprocess, time, os
process = subprocess.Popen(["cobble", "render", "good.scene", "--size", "400x300", "--samples", "1000000", "-o", "big.pfm"])
time.sleep(1)
begin = time.monotonic()
process.send_signal(signal.SIGINT)
status = process.wait()
seconds = time.monotonic() - begin
print("exit", status, "bytes", os.path.getsize("big.pfm"), sorted(os.listdir(".")))
print("at once" if seconds < 2 else f"after {seconds} s")
