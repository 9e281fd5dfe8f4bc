"""Values along lines and over time."""
import os
import tempfile
import unittest

import numpy as np

from real_server import ServerTest
from wakesurf.series import Series, points_along


class SeriesTest(ServerTest):
    def test_along_a_line_has_what_a_probe_has_there_and_nothing_outside(self):
        along = self.client.profile("tornado", [(0.5, 0.5, 0.5), (0.9, 0.5, 0.5), (1.5, 0.5, 0.5)], ["speed", "velocity_x"], time=1, samples=11)
        np.testing.assert_allclose(along["distance"], np.linspace(0, 1, 11))
        inside = along["x"] <= 1
        self.assertTrue(inside.any() and not inside.all())
        probed = self.client.probe("tornado", np.column_stack([along["x"], along["y"], along["z"]])[inside], time=1)["velocity"]
        np.testing.assert_array_equal(along["speed"][inside], np.linalg.norm(probed, axis=1))
        np.testing.assert_array_equal(along["velocity_x"][inside], probed[:, 0])
        self.assertTrue(np.isnan(along["speed"][~inside]).all())

    def test_over_time_has_a_row_for_each_time_and_the_velocity_becomes_its_components(self):
        history = self.client.history("tornado", (0.5, 0.6, 0.5), ["velocity"], times=[0, 0.5, 2])
        self.assertEqual(list(history.columns), ["time", "x", "y", "z", "velocity_x", "velocity_y", "velocity_z"])
        for i, time in enumerate(history["time"]):
            probed = self.client.probe("tornado", [(0.5, 0.6, 0.5)], time=time)["velocity"][0]
            np.testing.assert_array_equal([history[f"velocity_{axis}"][i] for axis in "xyz"], probed)

    def test_has_what_the_server_makes_of_the_velocity(self):
        parts = [f"vorticity_{axis}" for axis in "xyz"]
        along = self.client.profile("tornado", [(0.3, 0.5, 0.5), (0.7, 0.6, 0.5)], ["vorticity", *parts], time=1, samples=5)
        self.assertGreater(along["vorticity"].min(), 0)
        np.testing.assert_allclose(along["vorticity"], np.linalg.norm([along[part] for part in parts], axis=0), rtol=1e-5)

    def test_is_saved_as_the_page_saves_it(self):
        found = Series({"distance": np.array([0.0, 1.0]), "p, static": np.array([np.nan, 1e21]), "q": np.array([1e-7, 0.25])},
                       {"distance": "m", "p, static": "Pa"})
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "line.csv")
            found.save(path)
            with open(path, encoding="utf-8", newline="") as file:
                self.assertEqual(file.read(), 'distance [m],"p, static [Pa]",q\n0,,1e-7\n1,1e+21,0.25\n')

    def test_lines_without_length_are_refused_in_words(self):
        for line in ([], [(0, 0, 0)], [(1, 2, 3), (1, 2, 3)], [(0, 0), (1, 1)]):
            with self.assertRaisesRegex(ValueError, "line"):
                points_along(line, 5)


if __name__ == "__main__":
    unittest.main()
