# SPDX-License-Identifier: MIT
import signal, subprocess, time
# Reading a pipe that gives nothing: the first interrupt ends it.
for command in ["fmt", "-"], ["fmt", "--check", "-"], ["lint", "--fix", "-"], ["lint", "-"]:
    process = subprocess.Popen(["cobble", *command], stdin=subprocess.PIPE)
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    try:
        print(*command, "exit", process.wait(10))
    except subprocess.TimeoutExpired:
        process.kill()
        print(*command, "goes on")
