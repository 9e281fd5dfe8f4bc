"""Uses a server for hours as people do, and prints its memory over time: PYTHONPATH=tests/python tests/release/soak.py [SECONDS] [WAKESURF]

Each of a few people makes a session, edits rakes and surfaces of all kinds, plays, exports, probes, and deletes it again. From time to
time all pause, for long enough that the server gives back what it has freed. Prints a line of CSV then: seconds, resident MiB
before and after the pause, sessions made, edits, files, refusals. Ends with the growth of both from the second quarter of the sessions
to the last: what a deleted session leaves behind would add up, however fast the machine is. The exit status is 1 where either is more
than 10 %.
"""
import os
import random
import re
import statistics
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "python"))
import wakesurf

PEOPLE, EVERY = 3, 60.0
PAUSE = 8.0  # s, for the allocator to return what was freed


def use(url, stop, going, idle, counts, seed):
    rng = random.Random(seed)
    while not stop.is_set():
        if not going.is_set():
            idle.release()
            going.wait()
            continue
        try:
            with wakesurf.Client(url) as server:
                session = server.create_session("soak")
                counts["sessions"] += 1
                for kind in ("stream", "path", "streak", "time"):
                    y = rng.uniform(-1, 1)
                    rake = session.rake(line=[(-2, y, 0), (-2, y + 1, 1)], seeds=rng.randint(4, 60))
                    sweep = {"sweep": (1, 0, 0)} if kind == "time" else {}
                    surface = session.surface(rake, kind, dataset="abc", to=rng.uniform(0.5, 2),
                                              separation=rng.uniform(0.05, 0.2), fields=["vorticity"], **sweep)
                    for _ in range(5):
                        y = rng.uniform(-1, 1)
                        rake.set(line=[(-2, y, 0), (-2, y + 1, 1)])
                        surface.wait()
                        counts["edits"] += 1
                    surface.download(rng.choice(["ply", "vtp", "glb", "obj"]))
                    counts["files"] += 1
                    server.probe("abc", [(rng.uniform(-1, 1), 0, 0) for _ in range(100)], time=0.0)
                session.play(speed=1.0)
                time.sleep(rng.uniform(0.1, 1.0))
                session.undo()
                session.pause()
                session.delete()
                session.delete(forever=True)
        except wakesurf.WakesurfError as fault:
            counts["refused"] += 1
            print("refused:", fault, file=sys.stderr)
            time.sleep(1.0)


def resident(pid):
    with open(f"/proc/{pid}/status", encoding="ascii") as file:
        return int(re.search(r"VmRSS:\s+(\d+)", file.read()).group(1)) / 1024


def growth(curve, which):
    """From the second quarter of the sessions to the last, of a column of (sessions, busy, rested)."""
    made = curve[-1][0]

    def quarter(nth):
        lines = [line[which] for line in curve if nth * made < 4 * line[0] <= (nth + 1) * made]
        return statistics.median(lines) if lines else sys.exit("there are too few lines to compare: run it for longer")

    return quarter(3) / quarter(1) - 1


def main():
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 3600.0
    program = sys.argv[2] if len(sys.argv) > 2 else os.environ.get("WAKESURF_BINARY", "build/release/bin/wakesurf")
    counts = {"sessions": 0, "edits": 0, "files": 0, "refused": 0}
    with tempfile.TemporaryDirectory() as state:
        server = subprocess.Popen([program, "serve", "flow:abc", "--listen", "127.0.0.1:0", "--memory", "1G", "--state", state],
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        url = next(m.group(0) for m in (re.search(r"http://\S+#token=\S+", line) for line in server.stdout) if m)
        threading.Thread(target=lambda: [None for _ in server.stdout], daemon=True).start()
        stop, going, idle = threading.Event(), threading.Event(), threading.Semaphore(0)
        going.set()
        people = [threading.Thread(target=use, args=(url, stop, going, idle, counts, i)) for i in range(PEOPLE)]
        for each in people:
            each.start()
        start, curve = time.monotonic(), []
        print("seconds,busy_mib,rested_mib,sessions,edits,files,refused", flush=True)
        while time.monotonic() - start < seconds:
            time.sleep(min(EVERY, seconds / 16))
            busy = resident(server.pid)
            going.clear()
            for _ in people:
                idle.acquire()
            time.sleep(PAUSE)
            curve.append((counts["sessions"], busy, resident(server.pid)))
            going.set()
            print(f"{time.monotonic() - start:.0f},{busy:.1f},{curve[-1][2]:.1f}," + ",".join(str(n) for n in counts.values()),
                  flush=True)
        stop.set()
        for each in people:
            each.join()
        server.terminate()
        status = server.wait()
    growths = [growth(curve, which) for which in (1, 2)]
    print(f"growth busy {100 * growths[0]:.1f} %, rested {100 * growths[1]:.1f} %, exit status {status}")
    return 0 if max(growths) < 0.1 and status == 0 and counts["edits"] > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
