"""Means over time: made on the command line and by scripts, coloured and sliced as any field."""
import json
import os
import subprocess
import tempfile
import unittest

import numpy as np

from real_server import BINARY, ROOT, RealServer
import wakesurf

CYLINDER = os.path.join(ROOT, "data/sqcyl/sqcyl.pvd")


class MeansTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        cls.store = os.path.join(cls.folder, "swing")
        cls.said("generate", "flow:double-gyre", cls.store, "--grid", "21,11,5", "--times", "0:10:21")

    @classmethod
    def said(cls, *words, status=0):
        done = subprocess.run([BINARY, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=60, check=False,
                              env={**os.environ, "WAKESURF_STORE": os.path.join(cls.folder, "imported")})
        if done.returncode != status:
            raise AssertionError(f"{words}: {done.returncode}\n{done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    def test_a_script_makes_one_and_has_it_on_a_slice_and_at_points_as_the_time_steps_say(self):
        server = RealServer(self.store)
        self.addCleanup(server.stop)
        client = wakesurf.Client(server.url)
        dataset = client.dataset
        point = (0.5, 0.5, 0.1)
        speeds = np.array([client.probe(dataset, [point], time=time)["velocity"][0] for time in np.linspace(0, 10, 21)])
        weights = np.full(21, 0.5)
        weights[[0, -1]] = 0.25
        mean = weights @ speeds / 10
        rms = np.sqrt(weights @ (speeds - mean) ** 2 / 10)
        made = client.api.mean.make(dataset=dataset, fields=["velocity"])["means"][0]
        self.assertEqual((made["from"], made["to"], made["steps"]), (0, 10, 21))
        for time in (0, 3.3):
            values = client.probe(dataset, [point], time=time, fields=["velocity_mean_y", "velocity_rms_x"])
            # Nodes are averaged and then interpolated, which for the rms is not the same.
            self.assertAlmostEqual(values["velocity_mean_y"][0], mean[1], 5)
            self.assertLess(abs(values["velocity_rms_x"][0] - rms[0]), 0.01 * rms[0] + 1e-6)
        found = client.slice(dataset, point, (0, 0, 1), field="velocity_k", time=5, samples=16)
        self.assertTrue(np.isfinite(found.values).any())
        self.assertLessEqual(np.nanmax(found.values), made["fields"][-1]["range"][1] * (1 + 1e-6))
        self.assertIn("velocity_rms", client.describe(dataset)["surfaceFields"])
        again = client.api.mean.make(dataset=dataset, fields=["velocity"])["means"][0]
        self.assertEqual(again, made)

    def test_the_command_line_makes_lists_and_removes_them(self):
        said = self.said("means", CYLINDER, "--fields", "U,vorticity", "--from", "9")
        self.assertRegex(said, r"U: \d+ time-steps, 9 to 16\n  U_mean ")
        described = json.loads(self.said("info", CYLINDER, "--json"))
        self.assertEqual([each["of"] for each in described["means"]], ["U", "vorticity"])
        self.assertIn("U_k", described["surfaceFields"])
        self.assertRegex(self.said("info", CYLINDER), r"  mean      of U over 15 time-steps, 9 to 16\n            U_mean: \S+ to \S+\n")
        self.assertIn("there is a U_mean already", self.said("means", CYLINDER, "--fields", "U", "--from", "10", status=2))
        self.said("surface", CYLINDER, "--kind", "level", "--field", "U_rms", "--level", "0.2", "--from", "16", "--to", "16",
                  "-o", os.path.join(self.folder, "a.vtp"))
        self.assertIn("U_rms: removed\n", self.said("means", CYLINDER, "--remove", "U_rms"))
        self.assertNotIn("U_k", json.loads(self.said("info", CYLINDER, "--json"))["surfaceFields"])

    def test_what_cannot_be_averaged_is_refused_in_words(self):
        self.assertIn("--fields is needed", self.said("means", self.store, status=2))
        self.assertIn("label` must be letters", self.said("means", self.store, "--fields", "velocity", "--label", "a/b", status=2))
        self.assertIn("a built-in flow has no stored time-steps", self.said("means", "flow:abc", "--fields", "velocity", status=1))


if __name__ == "__main__":
    unittest.main()
