# SPDX-License-Identifier: MIT
# Kills renders at random moments, and goes on with each until it is done: the picture is then that
# of a render that nobody killed. COBBLE_KILLS says how many kills there are, COBBLE_KILL_OPTIONS what
# samples the render takes.
import hashlib, os, random, subprocess, sys, time

VIEW = ["good.scene", "--size", "96x72", "--quiet",
        *os.environ.get("COBBLE_KILL_OPTIONS", "--samples 300").split()]
EXTRA = ["--depth", "depth.pfm", "--normals", "normals.pfm"]
PICTURES = ["color.pfm", "depth.pfm", "normals.pfm"]
kills = int(os.environ.get("COBBLE_KILLS", "12"))
random.seed(int(os.environ.get("COBBLE_KILLS_SEED", "1")))


def command(*more):
    return ["cobble", "render", *VIEW, "-o", "color.pfm", *EXTRA, *more]


def hashes():
    return [hashlib.sha256(open(path, "rb").read()).hexdigest() for path in PICTURES]


begin = time.monotonic()
subprocess.run(command(), check=True)
whole_seconds = time.monotonic() - begin
expected = hashes()

killed = ended = different = 0
while killed < kills:
    for path in PICTURES:
        os.remove(path)
    while True:
        resume = ["--checkpoint", "render.state", "--checkpoint-interval", "0.02", "--resume"]
        ways = ["--threads", str(random.randint(1, 3))] + random.choice([[], [], ["--reference"]])
        process = subprocess.Popen(command(*resume, *ways))
        if killed < kills:
            time.sleep(random.uniform(0, 0.7) * whole_seconds)
            process.kill()
        if process.wait() == 0:
            break
        killed += process.returncode == -9
        if process.returncode != -9:
            sys.exit(f"exit status {process.returncode}")
    ended += 1
    different += hashes() != expected
    if os.path.exists("render.state"):
        sys.exit("the checkpoint of a render that ended is still there")
print("killed", killed, "times:", different, "pictures are other than without a kill")
print("renders that ended: some" if ended else "renders that ended: none")
