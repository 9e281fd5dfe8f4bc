#!/usr/bin/env python3
"""The server with an MPI job that holds bricks: a rank that is killed ends no session, and no surface is another."""
import os
import re
import signal
import subprocess
import tempfile
import unittest
import urllib.parse
import urllib.request

from real_server import BINARY, RealServer, until

import wakesurf  # real_server says where

BRICKS = os.path.join(os.path.dirname(BINARY), "wakesurf-bricks")
START = "mpirun -n 2 --oversubscribe --mca mpi_yield_when_idle 1"
AS_ROOT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
MEMORY = "112MiB"  # four time-steps of 19 MB do not fit in half of it


def ranks_of(store):
    """Processes of wakesurf-bricks that hold it."""
    out = []
    for each in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{each}/cmdline", "rb") as file:
                words = file.read().decode(errors="replace").split("\0")
        except OSError:
            continue
        if words[0] == BRICKS and store in words:
            out.append(int(each))
    return out


def metrics(server):
    """How many ranks there are (`job`), and bricks that came from `ranks` and from `files`."""
    address = urllib.parse.urlsplit(server.url)
    asked = urllib.request.Request(f"http://{address.netloc}/metrics",
                                   headers={"Authorization": "Bearer " + address.fragment.removeprefix("token=")})
    with urllib.request.urlopen(asked) as answer:
        text = answer.read().decode()
    found = re.findall(r'^wakesurf_brick(?:s_total\{.*from="(\w+)"|_(ranks)\{).* (\d+)$', text, re.MULTILINE)
    return {("job" if ranks else where): int(number) for where, ranks, number in found}


def streak(session, height):
    session.client.api.dataset.open(dataset="tornado")  # the server answers before its data are open
    rake = session.rake(line=[(0.4, 0.5, 0.1), (0.6, 0.5, height)], seeds=16)
    surface = session.surface(rake, "streak", dataset="tornado", to=3.5, separation=0.02)
    surface.wait()
    return surface.download("ply")


@unittest.skipUnless(os.path.exists(BRICKS), "wakesurf-bricks is not built: WAKESURF_MPI is off")
class Ranks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        os.environ.update(AS_ROOT)
        cls.folder = tempfile.TemporaryDirectory()
        cls.store = os.path.join(cls.folder.name, "tornado")
        subprocess.run([BINARY, "generate", "tornado", cls.store, "--grid", "129,129,97", "--times", "0:4:5", "--layout", "bricks"],
                       check=True, capture_output=True)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def start(self, *more):
        server = RealServer(self.store, "--memory", MEMORY, *more)
        self.addCleanup(server.stop)
        client = wakesurf.Client(server.url)
        return server, client.create_session("ranks")

    def test_surfaces_are_the_same_while_ranks_are_killed(self):
        _, alone = self.start()
        heights = (0.5, 0.6, 0.7)
        wanted = [streak(alone, each) for each in heights]
        server, session = self.start("--bricks", START)
        for height, mesh in zip(heights, wanted):
            until(lambda: metrics(server).get("job") == 2)  # none before the data are open
            ranks = until(lambda: ranks_of(self.store))
            os.kill(ranks[-1], signal.SIGKILL)
            self.assertEqual(streak(session, height), mesh)
        self.assertGreater(metrics(server)["files"], 0)
        self.assertIsNone(server.process.poll())

    def test_ranks_end_with_a_server_that_is_killed(self):
        server, _ = self.start("--bricks", START)
        until(lambda: metrics(server).get("job") == 2)  # none before the data are open
        self.assertEqual(len(ranks_of(self.store)), 2)
        server.process.kill()
        until(lambda: not ranks_of(self.store))

    def test_words_that_start_nothing_leave_files(self):
        server, session = self.start("--bricks", "/no/such/program")
        streak(session, 0.5)
        self.assertEqual(metrics(server)["ranks"], 0)
        self.assertGreater(metrics(server)["files"], 0)

    def test_what_cannot_be_is_wrong_usage(self):
        done = subprocess.run([BINARY, "serve", self.store, "--bricks", " "], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("mpirun -n 4", done.stderr)


if __name__ == "__main__":
    unittest.main()
