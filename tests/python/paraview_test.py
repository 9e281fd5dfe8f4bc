"""What we write opens in ParaView itself, where that is installed: Debian's reads no appended data, no Draco, and of a .ply only
colours, normals and texture coordinates."""
import json
import os
import shutil
import subprocess
import tempfile
import textwrap
import unittest

from real_server import BINARY

SCRIPT = textwrap.dedent("""
    import json, sys
    from paraview.simple import OpenDataFile
    for path in sys.argv[1:]:
        reader = OpenDataFile(path)
        reader.UpdatePipeline()
        data = reader.GetDataInformation()
        arrays = {name: reader.PointData[name].GetRange(0) for name in reader.PointData.keys()}
        print("found", json.dumps([data.GetNumberOfPoints(), data.GetNumberOfCells(), data.GetBounds(), arrays]))
""")


@unittest.skipUnless(shutil.which("pvpython"), "ParaView is not installed (Debian: paraview; not beside libvtk9-dev)")
class ParaViewTest(unittest.TestCase):
    def test_opens_what_we_write_with_its_fields(self):
        extensions = ("vtp", "glb", "ply", "obj")
        with tempfile.TemporaryDirectory() as folder:
            files = [os.path.join(folder, "mesh." + extension) for extension in extensions]
            for file in files:
                subprocess.run([BINARY, "surface", "flow:abc", "--kind", "stream", "--rake", "0.5,0,0 2.5,0.3,1", "--to", "4",
                                "--separation", "0.2", "--no-draco", "-o", file], check=True, timeout=60,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            script = os.path.join(folder, "open.py")
            with open(script, "w", encoding="utf-8") as file:
                file.write(SCRIPT)
            ran = subprocess.run(["pvpython", script, *files], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                 timeout=240)
        found = [json.loads(line[6:]) for line in ran.stdout.split("\n") if line.startswith("found ")]
        self.assertEqual(len(found), len(extensions), ran.stderr)
        (points, cells, bounds, vtp), (_, _, _, glb), (_, _, _, ply), (_, _, _, obj) = found
        self.assertGreater(points, 100)
        for extension, (its_points, its_cells, its_bounds, _) in zip(extensions, found):
            with self.subTest(extension):
                self.assertEqual(its_points, points)
                self.assertGreaterEqual(its_cells, cells)  # those without polygons of five sides and more have several for one
                for its_bound, bound in zip(its_bounds, bounds):
                    self.assertAlmostEqual(its_bound, bound, places=5)
        self.assertLessEqual({"s", "t", "speed", "velocity", "deformation"}, set(vtp))
        for name in ("s", "t", "speed", "velocity", "deformation"):
            self.assertEqual(glb["_" + name.upper()], vtp[name])
        self.assertEqual((vtp["s"], vtp["t"]), ([0, 1], [0, 4]))
        self.assertLess(vtp["speed"][0], vtp["speed"][1])
        self.assertLessEqual({"RGB", "Normals", "TCoords"}, set(ply))
        self.assertIn("TCoords", obj)


if __name__ == "__main__":
    unittest.main()
