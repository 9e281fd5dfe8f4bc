#!/usr/bin/env python3
"""The server and its ranks as a job of Slurm's, by examples/bricks.sbatch, on two nodes that are this machine.

    tests/some release/slurm_ranks

Not part of ./check, for it wants Debian's slurm-wlm and munge. It prints what it measured."""
import os
import signal
import time
import types
import unittest

import ranks_test
from real_server import BINARY, ROOT, until
from slurm_cluster import Cluster, installed

import wakesurf  # real_server says where

HEIGHTS = (0.5, 0.6, 0.7, 0.55, 0.65)


@unittest.skipUnless(installed() and os.path.exists(ranks_test.BRICKS), "wants slurm-wlm, munge and a build with WAKESURF_MPI")
class SlurmRanks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.cluster = Cluster()
        cls.addClassCleanup(cls.cluster.stop)
        cls.cluster.start()
        cls.store = cls.cluster.path("tornado")
        cls.cluster.output(BINARY, "generate", "tornado", cls.store, "--grid", "129,129,97", "--times", "0:4:5", "--layout", "bricks")
        cls.wanted = cls.surfaces_without_ranks()

    @classmethod
    def surfaces_without_ranks(cls):
        server = ranks_test.RealServer(cls.store, "--memory", ranks_test.MEMORY)
        try:
            session = wakesurf.Client(server.url).create_session("alone")
            return {height: ranks_test.streak(session, height) for height in HEIGHTS}
        finally:
            server.stop()

    def begin(self):
        """The job's number, and its server."""
        link = self.cluster.path("url")
        if os.path.exists(link):
            os.remove(link)
        job = self.cluster.output(
            "sbatch", "--parsable", "--nodes=2", "--cpus-per-task=1", "--mem=500M", "--time=30", "--output", self.cluster.path("job.out"),
            os.path.join(ROOT, "examples/bricks.sbatch"), self.store, PATH=os.path.dirname(BINARY) + ":" + self.cluster.environment["PATH"],
            URL_FILE=link, MEMORY=ranks_test.MEMORY, BRICKS_MEMORY="200MiB").strip()
        self.addCleanup(self.end, job)
        until(lambda: os.path.exists(link) and os.path.getsize(link) > 0)
        with open(link, encoding="utf-8") as file:
            return job, types.SimpleNamespace(url=file.read().strip())

    def end(self, job):
        self.cluster.output("scancel", job)
        until(lambda: not self.cluster.output("squeue", "-h").strip())

    def ranks(self, server, before=()):
        """Both, by their numbers, when they are others than before."""
        ranks = []

        def come():
            ranks[:] = ranks_test.ranks_of(self.store)
            return len(ranks) == 2 and not set(ranks) & set(before) and ranks_test.metrics(server).get("job") == 2
        until(come)
        return sorted(ranks, key=self.number)

    @staticmethod
    def number(process):
        with open(f"/proc/{process}/environ", "rb") as file:
            return next(int(each[10:]) for each in file.read().split(b"\0") if each.startswith(b"PMIX_RANK="))

    def steps(self):
        """Those of the ranks: the server is the batch script itself."""
        return [each for each in self.cluster.output("squeue", "-h", "-s", "-o", "%i").split() if not each.endswith("batch")]

    def test_surfaces_are_the_same_while_ranks_are_killed(self):
        _, server = self.begin()
        session = wakesurf.Client(server.url).create_session("ranks")
        ranks = self.ranks(server)
        start = time.monotonic()
        self.assertEqual(ranks_test.streak(session, HEIGHTS[-1]), self.wanted[HEIGHTS[-1]])
        print(f"a surface with two ranks: {time.monotonic() - start:.2f} s", flush=True)
        for i, height in enumerate(HEIGHTS):
            start = time.monotonic()
            os.kill(ranks[i % 2], signal.SIGKILL)
            self.assertEqual(ranks_test.streak(session, height), self.wanted[height])
            print(f"rank {i % 2} killed: the next surface after {time.monotonic() - start:.2f} s", flush=True)
            ranks = self.ranks(server, ranks)
            print(f"  two ranks again after {time.monotonic() - start:.2f} s", flush=True)
        self.assertGreater(ranks_test.metrics(server)["files"], 0)

    def test_bricks_come_from_ranks_on_both_nodes(self):
        _, server = self.begin()
        session = wakesurf.Client(server.url).create_session("ranks")
        self.ranks(server)
        for height in HEIGHTS:
            self.assertEqual(ranks_test.streak(session, height), self.wanted[height])
        self.assertGreater(ranks_test.metrics(server)["ranks"], 0)

    def test_a_rank_that_hangs_is_ended_with_its_step_which_is_started_again(self):
        _, server = self.begin()
        session = wakesurf.Client(server.url).create_session("ranks")
        before = self.steps()
        ranks = self.ranks(server)
        hangs = ranks[1]
        os.kill(hangs, signal.SIGSTOP)
        for height in HEIGHTS:
            start = time.monotonic()
            self.assertEqual(ranks_test.streak(session, height), self.wanted[height])
            print(f"a rank hangs: a surface after {time.monotonic() - start:.2f} s", flush=True)
        until(lambda: hangs not in ranks_test.ranks_of(self.store))
        self.ranks(server, ranks)
        until(lambda: len(self.steps()) == 1)
        self.assertNotEqual(self.steps(), before)

    def test_a_job_that_is_cancelled_leaves_nothing(self):
        job, server = self.begin()
        self.ranks(server)
        start = time.monotonic()
        self.end(job)
        print(f"cancelled: all is gone after {time.monotonic() - start:.2f} s", flush=True)
        self.assertEqual(ranks_test.ranks_of(self.store), [])


if __name__ == "__main__":
    unittest.main()
