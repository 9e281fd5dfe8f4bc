"""What is shown of the bundled simulation where no one has said what to show: by the command line and by a script, the same."""
import os
import re
import subprocess
import tempfile
import unittest

import numpy as np

from real_server import BINARY, RealServer
import wakesurf

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DATA = os.path.join(ROOT, "data/sqcyl/sqcyl.pvd")
FRONT = -0.5  # of the square cylinder, along x
KINDS = ("stream", "path", "streak", "time")


def share_behind(triangles, front):
    """The part of the area whose triangles lie downstream of the front."""
    a, b, c = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    areas = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return areas[triangles.mean(axis=1)[:, 0] > front].sum() / areas.sum()


class FirstPictureTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.store = os.path.join(cls.folder.name, "store")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_half_of_each_surface_lies_downstream_of_the_front_of_the_body(self):
        for kind in KINDS:
            out = os.path.join(self.folder.name, f"{kind}.vtp")
            made = subprocess.run([BINARY, "surface", DATA, "--kind", kind, "--store", self.store, "-o", out],
                                  capture_output=True, text=True, check=True)
            self.assertIn("without --rake: The rake is ahead of a body", made.stderr)
            self.assertNotIn("coarsened", made.stderr)
            with open(out, "rb") as file:
                mesh = wakesurf.Mesh.from_vtp(file.read())
            self.assertIn(f": {len(mesh.polygons)} quads, ", made.stdout)
            self.assertGreaterEqual(share_behind(mesh.points[mesh.triangles()], FRONT), 0.5, kind)

    def test_a_script_is_suggested_what_the_command_line_takes(self):
        server = RealServer(DATA, "--store", self.store)
        try:
            client = wakesurf.Client(server.url)
            client.call("dataset.open", dataset="sqcyl")
            scene = client.suggest("sqcyl")
        finally:
            server.stop()
        self.assertEqual([each["kind"] for each in scene["surfaces"]], ["streak", "stream", "path", "time"])
        self.assertEqual({each["from" if each["kind"] == "stream" else "to"] for each in scene["surfaces"]}, {16})
        out = os.path.join(self.folder.name, "same.obj")
        made = subprocess.run([BINARY, "surface", DATA, "--kind", "stream", "--store", self.store, "-o", out],
                              capture_output=True, text=True, check=True)
        rake = re.search(r'--rake "([^"]*)"', made.stderr).group(1)
        self.assertEqual([[float(each) for each in point.split(",")] for point in rake.split()], scene["rake"]["points"])


if __name__ == "__main__":
    unittest.main()
