"""Fields on planes through the data."""
import os
import tempfile
import unittest

import numpy as np

from real_server import ServerTest
import wakesurf
from wakesurf.slice import Slice


class SliceTest(ServerTest):
    def test_has_the_values_that_a_probe_has_at_its_points(self):
        found = self.client.slice("tornado", (0.5, 0.5, 0.3), (0.2, 0.1, 1), field="velocity_x", time=1, samples=40)
        known = np.isfinite(found.values)
        self.assertGreater(known.sum(), 800)
        self.assertLess(np.abs((found.points - (0.5, 0.5, 0.3)) @ (0.2, 0.1, 1)).max(), 1e-12)
        probed = self.client.probe("tornado", found.points[known], time=1)["velocity"][:, 0]
        span = probed.max() - probed.min()
        self.assertLess(np.abs(probed - found.values[known]).max(), 1e-4 * span)

    def test_minus_another_time_is_the_difference_of_both(self):
        early, late, difference = (
            self.client.slice("tornado", (0.5, 0.5, 0.3), (0, 0, 1), field="velocity_x", samples=16, **times)
            for times in ({"time": 1}, {"time": 4}, {"time": 4, "minus_time": 1}))
        self.assertLess(np.nanmax(np.abs(difference.values - (late.values - early.values))), 1e-4 * np.nanmax(np.abs(late.values)))
        none = self.client.slice("tornado", (0.5, 0.5, 0.3), (0, 0, 1), time=1, samples=16, minus="tornado")
        self.assertEqual(np.nanmax(np.abs(none.values)), 0)

    def test_has_an_area_and_a_mean_over_what_has_values(self):
        found = self.client.slice("tornado", (0.5, 0.5, 0.5), (0, 0, 1), field="velocity_z", time=0, samples=64)
        self.assertAlmostEqual(found.area, 1.0, places=9)  # of the unit cube
        half = Slice(np.where(np.arange(4) < 2, [1.0, 2.0, 3.0, 4.0], np.nan)[None, :], np.zeros(3), np.array([8.0, 0, 0]),
                     np.array([0, 0, 3.0]), "p", 0.0)
        self.assertEqual((half.area, half.mean), (12.0, 1.5))

    def test_is_written_as_a_row_a_sample(self):
        found = self.client.slice("tornado", (0.5, 0.5, 0.3), (0, 0, 1), time=0, samples=8)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "slice.csv")
            found.to_csv(path)
            with open(path, encoding="utf-8") as file:
                head, *rows = file.read().splitlines()
        self.assertEqual(head, 'x,y,z,"velocity"')
        np.testing.assert_array_equal([float(row.split(",")[3]) for row in rows], found.values.ravel())

    def test_planes_beside_the_data_and_unknown_fields_are_refused_in_words(self):
        for kind, given in ((wakesurf.WakesurfError, {"point": (9, 9, 9)}), (wakesurf.WakesurfError, {"field": "nothing"})):
            with self.assertRaises(kind) as failed:
                self.client.slice("tornado", given.get("point", (0.5, 0.5, 0.5)), (0, 0, 1), field=given.get("field"), time=0)
            self.assertRegex(str(failed.exception), "misses the domain|nothing")

    def test_bytes_of_something_else_are_refused(self):
        for body in (b"", b"WSL\x01", b"WSL\x01" + 108 * b"\0", b"WSL\x02" + 120 * b"\0"):
            with self.assertRaises(wakesurf.ServerFault):
                Slice.from_bytes(body, "p")


if __name__ == "__main__":
    unittest.main()
