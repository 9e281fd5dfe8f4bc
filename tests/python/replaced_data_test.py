"""Data that change under the server: never the old values under the new name."""
import base64
import os
import shutil
import struct
import subprocess
import tempfile
import time
import unittest
import urllib.request
import zlib

import numpy as np

from real_server import BINARY, RealServer
import wakesurf
from wakesurf import notifications


def write_step(path, speed, nodes=12, length=1.1):
    """A .vti with the velocity (speed, 0, 0) everywhere, in place."""
    spacing = length / (nodes - 1)
    values = np.zeros((nodes ** 3, 3), np.float32)
    values[:, 0] = speed
    extent = f"0 {nodes - 1} " * 3
    with open(path, "wb") as file:
        file.write(f"""<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian"><ImageData WholeExtent="{extent}"
Origin="0 0 0" Spacing="{spacing} {spacing} {spacing}"><Piece Extent="{extent}"><PointData><DataArray type="Float32" Name="U"
NumberOfComponents="3" format="appended" offset="0"/></PointData></Piece></ImageData><AppendedData encoding="raw">_""".encode())
        file.write(struct.pack("<I", values.nbytes) + values.tobytes() + b"</AppendedData></VTKFile>")


def write_series(folder, speed, steps=4, **grid):
    for step in range(steps):
        write_step(os.path.join(folder, f"f_{step}.vti"), speed, **grid)
    return os.path.join(folder, "f_0.vti")


def png():
    """A picture of one pixel."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return base64.b64encode(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 0, 0, 0, 0))
                            + chunk(b"IDAT", zlib.compress(b"\0\0")) + chunk(b"IEND", b"")).decode()


class ReplacedDataTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.data = os.path.join(self.folder, "data")
        os.mkdir(self.data)

    def serve(self, source, *options):
        server = RealServer(source, "--store", os.path.join(self.folder, "stores"), *options)
        self.addCleanup(server.stop)
        self.client = wakesurf.Client(server.url, timeout=20)
        entry = self.client.datasets()[0]["dataset"]
        self.client.api.dataset.open(dataset=entry)
        self.dataset = entry
        return server

    def speed(self, at=0.0, point=(0.5, 0.5, 0.5)):
        return float(self.client.probe(self.dataset, [point], time=at)["U"][0][0])

    def surface_speeds(self, surface):
        surface.wait(timeout=60)
        return np.unique(np.round(surface.mesh()["speed"], 3)).tolist()

    def until_notice(self, listening):
        begun = time.monotonic()
        for each in listening:
            if isinstance(each, notifications.ServerNotice) and each.kind == "dataReplaced":
                return each.text
            if time.monotonic() - begun > 20:
                break
        return "nothing"

    def session(self):
        session = self.client.create_session("looked at")
        rake = session.rake(line=[(0.2, 0.3, 0.5), (0.2, 0.7, 0.5)], seeds=5)
        surfaces = {kind: session.surface(rake, kind, dataset=self.dataset, to=2, separation=0.1)
                    for kind in ("stream", "path", "streak")}
        return session, surfaces

    def check_replaced(self, change, after=2.0, at=0.0, old=1.0, **serving):
        session, surfaces = self.session()
        for kind, surface in surfaces.items():
            self.assertEqual(self.surface_speeds(surface), [old], kind)
        before = surfaces["stream"].download("ply")
        session.api.session.thumbnail(image=png(), session=session.id)
        values = self.client.datasets()[0].get("values")
        listening = session.watch("listener", timeout=20)
        begun = time.monotonic()
        change()
        self.assertIn("have been replaced", self.until_notice(listening))
        self.assertLess(time.monotonic() - begun, 60)
        self.client.api.dataset.open(dataset=self.dataset)
        self.assertNotEqual(self.client.datasets()[0].get("values"), values)
        self.assertEqual(self.speed(at), after)
        return session, surfaces, before

    def test_computed_again_into_the_same_files_everything_is_of_the_new_data(self):
        self.serve(write_series(self.data, 1.0))
        session, surfaces, before = self.check_replaced(lambda: write_series(self.data, 2.0))
        for kind, surface in surfaces.items():
            self.assertEqual(self.surface_speeds(surface), [2.0], kind)
        self.assertNotEqual(surfaces["stream"].download("ply"), before)
        again = session.surface(session.rakes()[0], "stream", dataset=self.dataset, to=2, separation=0.1)
        self.assertEqual(self.surface_speeds(again), [2.0])
        self.assertFalse(session.api.session.list()["sessions"][-1]["thumbnail"])

    def test_one_time_step_that_was_written_again_is_noticed(self):
        self.serve(write_series(self.data, 1.0))
        _, surfaces, _ = self.check_replaced(lambda: write_step(os.path.join(self.data, "f_1.vti"), 3.0), after=3.0, at=1.0)
        self.assertEqual(self.speed(2.0), 1.0)
        self.assertGreater(max(self.surface_speeds(surfaces["path"])), 2.0)

    def test_another_grid_with_the_same_times_takes_its_place(self):
        self.serve(write_series(self.data, 1.0))
        self.check_replaced(lambda: write_series(self.data, 2.0, nodes=20, length=1.9))
        self.assertEqual(self.speed(point=(1.6, 0.5, 0.5)), 2.0)
        self.assertEqual(self.client.describe(self.dataset)["bounds"][1], 1.9)

    def test_a_store_that_was_replaced_is_opened_again(self):
        stores = [os.path.join(self.folder, name) for name in ("served", "other")]
        for store, speed in zip(stores, (1.0, 2.0)):
            source = os.path.join(self.folder, f"source{speed}")
            os.mkdir(source)
            subprocess.run([BINARY, "import", write_series(source, speed), store], check=True, capture_output=True)

        def swap():
            shutil.rmtree(stores[0])
            os.rename(stores[1], stores[0])

        self.serve(stores[0])
        _, surfaces, _ = self.check_replaced(swap)
        for kind, surface in surfaces.items():
            self.assertEqual(self.surface_speeds(surface), [2.0], kind)

    def test_data_replaced_while_no_server_ran_are_told_of_and_the_picture_goes(self):
        state = ("--state", os.path.join(self.folder, "state"))
        source = write_series(self.data, 1.0)
        server = self.serve(source, *state)
        session, surfaces = self.session()
        self.assertEqual(self.surface_speeds(surfaces["path"]), [1.0])
        session.api.session.thumbnail(image=png(), session=session.id)
        server.stop()
        write_series(self.data, 2.0)
        self.serve(source, *state)
        session = self.client.session(session.id)
        self.assertIn("since this session was last used", self.until_notice(session.watch("listener", timeout=30)))
        listed = {each["session"]: each for each in self.client.api.session.list()["sessions"]}
        self.assertFalse(listed[session.id]["thumbnail"])
        for surface in session.surfaces():
            self.assertEqual(self.surface_speeds(surface), [2.0], surface.id)

    def test_of_a_series_larger_than_memory_nothing_is_of_the_old_data(self):
        steps, large = 60, {"nodes": 64, "length": 200}
        self.serve(write_series(self.data, 1.0, steps=steps, **large), "--memory", "160MiB")
        budget = self.client.api.cache.status(dataset=self.dataset)["budget"]
        self.assertGreater(steps * large["nodes"] ** 3 * 12, budget)
        session = self.client.create_session("larger than memory")
        rake = session.rake(line=[(20, 60, 100), (20, 140, 100)], seeds=5)
        path = session.surface(rake, "path", dataset=self.dataset, to=steps - 1, separation=20)
        self.assertEqual(self.surface_speeds(path), [1.0])
        for time_step in range(steps):
            self.assertAlmostEqual(self.speed(time_step), 1.0)
        listening = session.watch("listener", timeout=20)
        write_series(self.data, 2.0, steps=steps, **large)
        self.assertIn("have been replaced", self.until_notice(listening))
        self.client.api.dataset.open(dataset=self.dataset)
        for time_step in (*range(steps), 0):
            self.assertAlmostEqual(self.speed(time_step), 2.0, msg=time_step)
        again = session.surface(rake, "path", dataset=self.dataset, to=steps - 1, separation=20)
        for surface in (path, again):
            self.assertEqual(self.surface_speeds(surface), [2.0])

    def test_a_download_that_is_under_way_ends_as_it_began_and_the_next_is_of_the_new_data(self):
        self.serve(write_series(self.data, 1.0))
        session = self.client.create_session("downloads")
        rake = session.rake(line=[(0.1, 0.1, 0.5), (0.1, 1.0, 0.5)], seeds=5)
        surface = session.surface(rake, "stream", dataset=self.dataset, to=2, separation=0.003)
        surface.wait(timeout=60)
        old = surface.download("ply")
        self.assertGreater(len(old), 4_000_000, "more than sockets hold")
        request = urllib.request.Request(
            f"{self.client.url}/api/v1/sessions/{session.id}/surfaces/{surface.id}/mesh.ply",
            headers={"Authorization": f"Bearer {self.client._token}"})
        with urllib.request.urlopen(request, timeout=60) as reply:
            begun = reply.read(1000)
            listening = session.watch("listener", timeout=20)
            write_series(self.data, 2.0)
            self.assertIn("have been replaced", self.until_notice(listening))
            self.assertEqual(begun + reply.read(), old)
        surface.wait(timeout=60)
        new = surface.download("ply")
        self.assertNotEqual(new, old)
        self.assertEqual(self.surface_speeds(surface), [2.0])

    def test_the_same_values_written_again_are_no_news(self):
        self.serve(write_series(self.data, 1.0))
        session, _ = self.session()
        values = self.client.datasets()[0].get("values")
        listening = session.watch("listener", timeout=20)
        write_series(self.data, 1.0)
        arrived = []
        for each in listening:
            arrived.append(each)
            if isinstance(each, notifications.DatasetPatched) and each.state == "ready":
                break
        self.assertEqual(arrived[-1].values, values)
        self.assertFalse([each for each in arrived if isinstance(each, notifications.ServerNotice)])
        self.assertEqual(self.client.datasets()[0].get("values"), values)

    def test_a_surface_that_was_being_computed_of_both_starts_again(self):
        self.serve(write_series(self.data, 1.0, steps=3, nodes=64))
        session = self.client.create_session("long")
        rake = session.rake(line=[(0.01, 0.01, 0.5), (0.011, 1.09, 0.5)], seeds=256)
        surface = session.surface(rake, "stream", dataset=self.dataset, to=1, separation=0.0006, max_quads=4_000_000)
        listening = session.watch("listener", timeout=20)
        write_series(self.data, 0.5, steps=3, nodes=64)
        self.until_notice(listening)
        surface.wait(timeout=120)
        self.assertEqual(np.unique(np.round(surface.mesh()["speed"], 3)).tolist(), [0.5])


if __name__ == "__main__":
    unittest.main()
