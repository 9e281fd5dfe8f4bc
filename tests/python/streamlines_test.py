"""Streamlines as arrays."""
import os
import tempfile
import unittest

import numpy as np

from real_server import ServerTest
import wakesurf
from wakesurf.streamlines import Streamlines


class StreamlinesTest(ServerTest):
    def test_follow_the_flow_that_a_probe_finds_and_have_its_values(self):
        lines = self.client.streamlines("tornado", line=((0.3, 0.5, 0.3), (0.7, 0.5, 0.3)), seeds=5, time=1)
        self.assertEqual(len(lines), 5)
        points, values = next(iter(lines))
        velocity = self.client.probe("tornado", points[1:-1], time=1)["velocity"]
        np.testing.assert_allclose(values[1:-1], np.linalg.norm(velocity, axis=1), rtol=1e-3)
        ways = np.diff(points, axis=0)[1:]
        along = (ways * velocity).sum(axis=1) / (np.linalg.norm(ways, axis=1) * np.linalg.norm(velocity, axis=1))
        self.assertGreater(along.min(), 0.99)

    def test_of_each_kind_of_seeds_begin_there(self):
        centre = np.array((0.5, 0.5, 0.5))
        lines = self.client.streamlines("tornado", sphere=(centre, 0.2), seeds=20, direction="forward", time=0)
        first = np.array([points[0] for points, _ in lines])
        np.testing.assert_allclose(np.linalg.norm(first - centre, axis=1), 0.2, atol=1e-6)
        flat = self.client.streamlines("tornado", plane=((0.2, 0.2, 0.5), (0.8, 0.2, 0.5), (0.2, 0.8, 0.5)), seeds=16, direction="forward",
                                       duration=1e-3, time=0)
        self.assertEqual(len(flat), 16)

    def test_are_written_as_a_row_a_point(self):
        lines = self.client.streamlines("tornado", line=((0.3, 0.5, 0.3), (0.7, 0.5, 0.3)), seeds=2, time=0)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "lines.csv")
            lines.to_csv(path)
            with open(path, encoding="utf-8") as file:
                head, *rows = file.read().splitlines()
        self.assertEqual(head, 'line,x,y,z,"velocity"')
        self.assertEqual(len(rows), len(lines.points))

    def test_that_cannot_be_are_refused_in_words(self):
        for words, given in (("one of `line`", {}), ("no radius", {"sphere": ((0.5, 0.5, 0.5), 1e30)}), ("nothing", {"field": "nothing", "walls": 0.1}),
                             ("`seeds`", {"walls": 0.1, "seeds": 0})):
            with self.assertRaises(wakesurf.WakesurfError) as failed:
                self.client.streamlines("tornado", time=0, **given)
            self.assertIn(words, str(failed.exception))

    def test_bytes_of_something_else_are_refused(self):
        for body in (b"", b"WST\x01", b"WST\x02" + 120 * b"\0", b"WST\x01" + 84 * b"\0"):
            with self.assertRaises(wakesurf.ServerFault):
                Streamlines.from_bytes(body, "p")


if __name__ == "__main__":
    unittest.main()
