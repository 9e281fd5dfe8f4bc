"""A server of one's own, from a script: it starts, answers, stops, and says what is wrong."""
import os
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy as np

from real_server import BINARY, ROOT
import wakesurf
from wakesurf import frame_origin


class ServeTest(unittest.TestCase):
    def setUp(self):
        os.environ["WAKESURF"] = BINARY

    def tearDown(self):
        os.environ.pop("WAKESURF", None)

    def test_runs_for_as_long_as_the_block_and_imports_what_it_was_given(self):
        reported = []
        with tempfile.TemporaryDirectory() as folder:
            with wakesurf.serve(os.path.join(ROOT, "data/sqcyl/sqcyl.pvd"), store=folder, progress=reported.append) as session:
                server = session.client.server
                self.assertEqual(session.dataset, "sqcyl")
                self.assertEqual(session.client.datasets()[0]["state"], "ready")
                self.assertEqual(len(session.client.describe("sqcyl")["times"]), 16)
            self.assertFalse(server.running)
            self.assertEqual(server.process.returncode, 0)
        self.assertEqual(reported[-1].share, 1.0)
        with self.assertRaises(wakesurf.Unreachable):
            session.state()

    def test_has_in_its_log_why_data_cannot_be_read(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "none.vtk")
            with open(path, "w", encoding="utf-8") as file:
                file.write("nothing of a format")
            os.utime(path, (1e9, 1e9))  # no one is writing it
            server = subprocess.Popen([BINARY, "serve", path, "--listen", "127.0.0.1:0", "--store", os.path.join(folder, "store")],
                                      stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            late = threading.Timer(60, server.kill)
            late.start()
            try:
                line = next((line for line in server.stderr if "event=dataset_failed" in line), "")
            finally:
                late.cancel()
                server.terminate()
                server.communicate()
        self.assertRegex(line, r"level=error event=dataset_failed dataset=none message=\S")

    def test_stops_where_the_block_fails_and_when_it_is_told_to_twice(self):
        with self.assertRaises(ZeroDivisionError):
            with wakesurf.serve("flow:abc", binary=BINARY) as session:
                server = session.client.server
                1 / 0
        self.assertFalse(server.running)
        server.stop()

    def test_ends_with_the_script_that_forgot_it(self):
        script = "import wakesurf\nserver = wakesurf.serve('flow:abc')\nprint(server.process.pid)"
        path = os.path.join(ROOT, "python")
        ran = subprocess.run([sys.executable, "-c", script], env={**os.environ, "PYTHONPATH": path}, stdout=subprocess.PIPE, text=True,
                             timeout=60, check=True)
        with self.assertRaises(ProcessLookupError):
            os.kill(int(ran.stdout), 0)

    def test_says_how_to_get_a_server_where_there_is_none(self):
        for set_it, words in ((lambda: os.environ.update(WAKESURF="/nowhere/wakesurf"), "'/nowhere/wakesurf' is not a program"),
                              (lambda: os.environ.pop("WAKESURF"), "there is no program `wakesurf`")):
            set_it()
            before, os.environ["PATH"] = os.environ["PATH"], "/nowhere"
            try:
                with self.assertRaises(wakesurf.ServerMissing) as raised:
                    wakesurf.serve("flow:abc")
            finally:
                os.environ["PATH"] = before
            self.assertIsInstance(raised.exception, FileNotFoundError)
            self.assertIn(words, str(raised.exception))
            for way in ("Debian package", "PATH", "$WAKESURF", "binary=", "container"):
                self.assertIn(way, raised.exception.hint)

    def test_takes_the_program_that_is_in_path(self):
        del os.environ["WAKESURF"]
        before, os.environ["PATH"] = os.environ["PATH"], os.path.dirname(BINARY)
        try:
            with wakesurf.serve("flow:abc") as session:
                self.assertEqual(session.dataset, "abc")
        finally:
            os.environ["PATH"] = before

    def test_says_what_the_server_said_where_it_does_not_start(self):
        with self.assertRaisesRegex(wakesurf.ServerFailed, "status 2.*nonsense"):
            wakesurf.serve("flow:abc", options=["--nonsense"])
        with self.assertRaises(wakesurf.WakesurfError) as raised:
            wakesurf.serve("/nowhere/case.foam")
        self.assertIn("case.foam", str(raised.exception))


class FrameOriginTest(unittest.TestCase):
    def test_is_that_of_the_notebook_that_started_this_kernel(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, pid, url in (("nbserver-1.json", 1, "http://localhost:1111/"), ("jpserver-22.json", 22, "http://localhost:8888/lab/"),
                                   ("jpserver-3.json", 3, "https://host.example:9/")):
                with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                    file.write(f'{{"pid": {pid}, "url": "{url}"}}')
            kept = {name: os.environ.get(name) for name in ("JUPYTER_RUNTIME_DIR", "JPY_PARENT_PID", "WAKESURF_FRAME_ORIGIN")}
            try:
                os.environ["JUPYTER_RUNTIME_DIR"] = folder
                for pid, origins in (("22", ["http://localhost:8888", "http://127.0.0.1:8888"]), ("3", ["https://host.example:9"]),
                                     ("4", [])):
                    os.environ["JPY_PARENT_PID"] = pid
                    self.assertEqual(frame_origin.notebook_origins(), origins)
                os.environ["WAKESURF_FRAME_ORIGIN"] = "https://a.example https://b.example"
                self.assertEqual(frame_origin.notebook_origins(), ["https://a.example", "https://b.example"])
            finally:
                for name, value in kept.items():
                    os.environ.pop(name, None)
                    if value is not None:
                        os.environ[name] = value


class ArraysTest(unittest.TestCase):
    """A flow of numpy arrays, served: what comes back is what was written."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = os.path.join(self.folder.name, "mine.pvd")

    def test_is_read_with_its_values_its_times_and_its_place(self):
        axes = [np.linspace(-1, 1, 9), np.linspace(0, 1, 7), np.linspace(2, 3, 5)]
        x, y, z = np.meshgrid(*axes, indexing="ij")
        at = [np.stack([-y + t, x, 0.1 * z], axis=-1).astype(np.float32) for t in (0.5, 1.5, 3)]
        files = wakesurf.write_series(self.path, [0.5, 1.5, 3], lambda i: at[i], origin=(-1, 0, 2), spacing=[a[1] - a[0] for a in axes],
                                      fields={"pressure": [x * y] * 3})
        self.assertEqual(len(files), 4)
        with wakesurf.serve(self.path, binary=BINARY, store=os.path.join(self.folder.name, "store")) as session:
            client, dataset = session.client, session.dataset
            about = client.describe(dataset)
            self.assertEqual(about["times"], [0.5, 1.5, 3])
            self.assertEqual(about["dimensions"], [9, 7, 5])
            np.testing.assert_allclose(about["bounds"], [-1, 1, 0, 1, 2, 3])
            points = np.array([(0.3, 0.4, 2.5), (-0.9, 0.1, 2.9)])
            found = client.probe(dataset, points, time=1.5, fields=[about["velocity"], "pressure"])
            expected = np.stack([1.5 - points[:, 1], points[:, 0], 0.1 * points[:, 2]], axis=1)
            np.testing.assert_allclose(found[about["velocity"]], expected, atol=1e-6)
            self.assertLess(np.abs(found["pressure"] - points[:, 0] * points[:, 1]).max(), 1e-6)
            self.assertTrue(session.suggested("path").wait()["complete"])

    def test_refuses_what_does_not_fit_together(self):
        field = np.zeros((4, 4, 4, 3))
        for bad, words in ((dict(times=[0, 0], velocity=[field] * 2), "rise"), (dict(times=[0], velocity=[field[..., :2]]), "shape"),
                           (dict(times=[0, 1], velocity=[field, field[:3]]), "time 1"),
                           (dict(times=[0], velocity=[field], fields={"p": [np.zeros(3)]}), "`p`"),
                           (dict(times=[0], velocity=[field], spacing=(0, 1, 1)), "spacings are greater than 0"),
                           (dict(times=[0], velocity=[field], spacing=0.1), "three numbers"), (dict(times=[0, 1], velocity=[field]), "1 arrays for 2 times")):
            with self.assertRaisesRegex(ValueError, words):
                wakesurf.write_series(self.path, **bad)
        with self.assertRaisesRegex(ValueError, "pvd"):
            wakesurf.write_series("mine.vti", [0], [field])


if __name__ == "__main__":
    unittest.main()
