"""What we write opens in ParaView itself, where that is installed, and the plugin shows a session there. Debian's reads no appended data, no
Draco, and of a .ply only colours, normals and texture coordinates."""
import json
import os
import shutil
import subprocess
import tempfile
import textwrap
import unittest

from real_server import BINARY, ROOT, RealServer
import wakesurf

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


# In its own process: what the test does to the session meanwhile comes by standard input, a time a line.
LIVE = textwrap.dedent("""
    import inspect, json, os, sys
    if not hasattr(inspect, "getargspec"):
        inspect.getargspec = inspect.getfullargspec
    from paraview import servermanager
    from paraview.simple import *
    plugin, address, session = sys.argv[1:]
    LoadPlugin(plugin, remote=False, ns=globals())
    source = WakesurfSurface(Address=address, Session=session, Kind="Path", FromTo=[0, 2], Separation=0.1, Fields="vorticity",
                             RakePoint1=[0.4, 0.4, 0.1], RakePoint2=[0.6, 0.6, 0.1])
    for line in iter(os.fdopen(0).readline, ""):  # ParaView replaces sys.stdin
        changed = bool(source.GetClientSideObject().GetNeedsUpdate())
        source.UpdatePipelineInformation()
        source.UpdatePipeline(float(line))
        data = servermanager.Fetch(source)
        points = [list(data.GetPoint(i)) for i in range(data.GetNumberOfPoints())]
        found = [changed, list(source.TimestepValues), list(source.PointData.keys()), points]
        os.write(1, ("found " + json.dumps(found) + "\\n").encode())
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

    def test_the_plugin_shows_a_surface_of_a_session_and_follows_it(self):
        server = RealServer("flow:tornado")
        self.addCleanup(server.stop)
        session = wakesurf.Client(server.url).create_session("from ParaView")
        with tempfile.TemporaryDirectory() as folder:
            script = os.path.join(folder, "live.py")
            with open(script, "w", encoding="utf-8") as file:
                file.write(LIVE)
            plugin = os.path.join(ROOT, "python/paraview/wakesurf_source.py")
            paraview = subprocess.Popen(["pvpython", script, plugin, server.url, session.id], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

            def shown_at(time):
                paraview.stdin.write(f"{time}\n")
                paraview.stdin.flush()
                said = []
                for line in paraview.stdout:
                    if line.startswith("found "):
                        return json.loads(line[6:])
                    said.append(line)
                self.fail("".join(said))

            try:
                changed, times, arrays, points = shown_at(1.0)
                (surface,), (rake,) = session.surfaces(), session.rakes()
                self.assertFalse(changed)
                self.assertEqual(times, [0.0, 0.5, 1.0, 1.5, 2.0])
                self.assertLessEqual({"s", "t", "speed", "velocity", "vorticity"}, set(arrays))
                self.assertEqual(rake.points.tolist(), [[0.4, 0.4, 0.1], [0.6, 0.6, 0.1]])
                self.assertEqual(points, surface.mesh(time=1.0).points.tolist())

                rake.set(line=[(0.3, 0.5, 0.2), (0.7, 0.5, 0.2)])  # somebody drags it on the page
                changed, _, _, moved = shown_at(2.0)
                self.assertTrue(changed)
                self.assertEqual(moved, surface.mesh(time=2.0).points.tolist())
                self.assertNotEqual(moved, points)
                self.assertFalse(shown_at(2.0)[0])
            finally:
                paraview.stdin.close()
                paraview.wait(timeout=60)
                paraview.stdout.close()


if __name__ == "__main__":
    unittest.main()
