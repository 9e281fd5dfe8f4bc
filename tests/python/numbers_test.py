"""Numbers of surfaces, with their errors, and shares of several of them."""
import unittest

import numpy as np

from real_server import ServerTest
import wakesurf
from wakesurf.numbers import Numbers, box, plane, shares

LINE = [(0.4, 0.4, 0.1), (0.6, 0.6, 0.1)]


class NumbersTest(ServerTest):
    def setUp(self):
        self.session = self.client.create_session("measured")

    def surface(self, line=LINE, kind="stream", **more):
        return self.session.surface(self.session.rake(line=line, seeds=12), kind, dataset="tornado", separation=0.05, to=2, **more)

    def test_area_is_that_of_the_mesh_but_for_its_error(self):
        surface = self.surface()
        numbers = surface.numbers(time="end")
        mesh = surface.mesh(time="end", tessellate=4)
        self.assertLess(abs(numbers["area"][0] - mesh.areas(mesh.triangles()).sum()), numbers["area_error"][0])
        self.assertIn("no error between stored times", numbers.notes[0])
        self.assertTrue(np.isnan(numbers["area_interval_error"][0]))

    def test_has_one_row_a_time(self):
        for kind in ("stream", "path", "streak"):
            numbers = self.surface(kind=kind).numbers(times=(0, 2, 0.5), through=plane((0, 0, 0.15), (0, 0, 1)))
            self.assertEqual(len(numbers), 5)
            self.assertTrue((np.diff(numbers["area"]) > 0).all(), kind)

    def test_means_of_fields_are_by_area(self):
        surface = self.surface()
        numbers = surface.numbers(time="end", fields=["velocity", "velocity_x"])
        mesh = surface.mesh(time="end", tessellate=2)
        triangles = mesh.triangles()
        areas = mesh.areas(triangles)
        velocities = mesh["velocity"][triangles].mean(axis=1)
        self.assertAlmostEqual(numbers["mean_velocity_x"][0], np.average(velocities[:, 0], weights=areas), places=3)
        self.assertAlmostEqual(numbers["mean_velocity"][0], np.average(np.linalg.norm(mesh["velocity"][triangles], axis=2).mean(axis=1), weights=areas),
                               places=3)
        with self.assertRaises(wakesurf.WakesurfError) as failed:
            surface.numbers(fields=["velocty"])
        self.assertIn("velocity", str(failed.exception))

    def test_wrong_places_and_times_are_refused_in_words(self):
        for given in ({"through": "ball:0,0,0:1,1,1"}, {"times": "0:3:0.1"}, {"times": (0, 2, 1e-9)}, {"time": "1", "times": (0, 2, 1)}):
            with self.assertRaises(wakesurf.WakesurfError) as failed:
                self.surface().numbers(**given)
            self.assertIn("`time" if "time" in str(given) else "`through`", str(failed.exception))

    def test_shares_of_two_rakes_in_a_box_add_up_to_one(self):
        surfaces = [self.surface(), self.surface([(0.45, 0.4, 0.1), (0.6, 0.55, 0.1)])]
        found = self.session.shares(surfaces, box((0, 0, 0), (1, 1, 1)))
        self.assertEqual(list(found), [each.id for each in surfaces])
        self.assertAlmostEqual(sum(each.value for each in found.values()), 1)
        self.assertTrue(all(each.error > 0 for each in found.values()))
        with self.assertRaises(ValueError) as nothing:
            self.session.shares(surfaces, box((5, 5, 5), (6, 6, 6)))
        self.assertIn("all of them are 0", str(nothing.exception))

    def test_the_error_of_a_share_is_what_the_worst_errors_make_of_it(self):
        def of(value, error):
            return Numbers.from_csv(f"a,a_error,a_interval_error,notes\n{value},{error},,\n")
        found = shares({"x": of(1, 1e-6), "y": of(3, 2e-6)}, "a")
        self.assertAlmostEqual(found["x"].error, (1 + 1e-6) / (1 + 1e-6 + 3 - 2e-6) - 0.25, places=11)
        self.assertTrue(np.isnan(found["x"].interval_error))


if __name__ == "__main__":
    unittest.main()
