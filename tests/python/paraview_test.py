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
        points = reader.GetDataInformation().GetNumberOfPoints()
        print("found", json.dumps([points, sorted(reader.PointData.keys())]))
""")


@unittest.skipUnless(shutil.which("pvpython"), "ParaView is not installed (Debian: paraview; not beside libvtk9-dev)")
class ParaViewTest(unittest.TestCase):
    def test_opens_what_we_write_with_its_fields(self):
        with tempfile.TemporaryDirectory() as folder:
            files = [os.path.join(folder, "mesh." + extension) for extension in ("vtp", "glb", "ply")]
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
        self.assertEqual(len(found), 3, ran.stderr)
        (vtp, vtp_arrays), (glb, glb_arrays), (ply, ply_arrays) = found
        self.assertGreater(vtp, 100)
        self.assertEqual((glb, ply), (vtp, vtp))
        self.assertLessEqual({"s", "t", "speed", "velocity", "deformation"}, set(vtp_arrays))
        self.assertLessEqual({"_S", "_T", "_SPEED", "_VELOCITY", "_DEFORMATION"}, set(glb_arrays))
        self.assertLessEqual({"RGB", "Normals", "TCoords"}, set(ply_arrays))


if __name__ == "__main__":
    unittest.main()
