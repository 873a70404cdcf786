# SPDX-License-Identifier: MIT
import signal, subprocess, sys, time, os
process = subprocess.Popen(["cobble", "render", "good.scene", "--size", "400x300", "--samples", "1000", "-o", "big.pfm"],
                           stderr=subprocess.PIPE)
# The first line comes with the first tenth: what there is then is worth keeping.
process.stderr.readline()
begin = time.monotonic()
process.send_signal(signal.SIGINT)
message = process.stderr.read().decode()
status = process.wait()
seconds = time.monotonic() - begin
print("exit", status, "bytes", os.path.getsize("big.pfm"), sorted(os.listdir(".")))
print("at once" if seconds < 2 else f"after {seconds} s")
sys.stderr.write(message)
