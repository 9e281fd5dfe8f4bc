"""A server ends within five seconds when it is asked to, whatever hangs: what it reads with, and whom it reads from."""
import glob
import http.server
import os
import re
import signal
import subprocess
import threading
import time
import unittest

from importers_end_test import parent_of
from ranks_test import AS_ROOT, BRICKS, MEMORY, START, ranks_of
from real_server import BINARY, FolderTest, RealServer, until

import wakesurf  # real_server says where

LONGEST_STOP = 5  # seconds


def children(process):
    """By whichever thread started them."""
    out = []
    for task in glob.glob(f"/proc/{process}/task/*/children"):
        try:
            with open(task, encoding="ascii") as file:
                out += [int(each) for each in file.read().split()]
        except OSError:
            pass
    return out


def below(process, words=""):
    """Processes below one, the nearest first, with `words` in the command line."""
    out = []
    for each in children(process):
        try:
            with open(f"/proc/{each}/cmdline", "rb") as file:
                line = file.read().decode(errors="replace")
        except OSError:
            continue
        out += ([each] if words in line else []) + below(each, words)
    return out


class Dripping(http.server.ThreadingHTTPServer):
    """Serves a folder; of files of values, from the second request for one on, a byte each tenth of a second."""
    daemon_threads = True

    def __init__(self, folder, dripped):
        self.folder, self.dripped, self.dripping = folder, dripped, threading.Event()
        super().__init__(("127.0.0.1", 0), DrippingAnswer)
        threading.Thread(target=self.serve_forever, daemon=True).start()

    def address(self, name):
        return f"http://127.0.0.1:{self.server_address[1]}/{name}"


class DrippingAnswer(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def do_HEAD(self):
        self.do_GET()

    def do_GET(self):
        path = os.path.join(self.server.folder, self.path.lstrip("/"))
        if not os.path.isfile(path):
            return self.send_error(404)
        with open(path, "rb") as file:
            data = file.read()
        self.send_response(206 if "Range" in self.headers else 200)
        part = data
        if wanted := re.fullmatch(r"bytes=(\d+)-(\d+)", self.headers.get("Range", "")):
            first, last = int(wanted[1]), min(int(wanted[2]), len(data) - 1)
            part = data[first:last + 1]
            self.send_header("Content-Range", f"bytes {first}-{last}/{len(data)}")
        self.send_header("ETag", '"1"')
        self.send_header("Content-Length", str(len(part)))
        self.end_headers()
        if self.command == "HEAD":
            return None
        if not self.path.endswith(self.server.dripped):
            return self.wfile.write(part)
        self.server.dripping.set()
        try:
            for byte in part:
                self.wfile.write(bytes([byte]))
                time.sleep(0.1)
        except OSError:
            pass
        return None

    def log_message(self, *_):
        pass


class Stop(FolderTest):
    def setUp(self):
        super().setUp()
        self.stopped = []
        self.addCleanup(lambda: [self.end(each) for each in self.stopped])

    @staticmethod
    def end(process):
        try:
            os.kill(process, signal.SIGKILL)
        except ProcessLookupError:
            pass

    def halt(self, processes):
        self.assertTrue(processes)
        self.stopped += processes
        for each in processes:
            os.kill(each, signal.SIGSTOP)

    def store(self, *more):
        path = os.path.join(self.folder, "tornado")
        subprocess.run([BINARY, "generate", "tornado", path, "--times", "0:4:5", *more], check=True, capture_output=True)
        return path

    def ends(self, server):
        begun = time.monotonic()
        server.process.terminate()
        try:
            server.process.wait(timeout=15)
        except subprocess.TimeoutExpired:
            server.process.kill()
            server.process.wait()
        server.process.stdout.close()
        self.assertLess(time.monotonic() - begun, LONGEST_STOP)
        until(lambda: not any(parent_of(each) for each in self.stopped))  # none outlives it

    def asked_for(self, server, sessions, **surface):
        """Sessions that wait for a surface each."""
        client = wakesurf.Client(server.url)
        for number in range(sessions):
            session = client.create_session(f"s{number}")
            rake = session.rake(line=[(0.4, 0.5, 0.5), (0.6, 0.5, 0.5)])
            session.api.surface.set(rake=rake.id, dataset="tornado", **surface)

    def test_while_a_web_server_drips_a_dataset_that_is_opened(self):
        self.store("--grid", "33,33,25")
        web = Dripping(self.folder, "store.json")
        self.addCleanup(web.shutdown)
        server = RealServer(web.address("tornado"))
        self.assertTrue(web.dripping.wait(30))
        self.ends(server)

    def test_while_a_web_server_drips_the_time_steps_of_surfaces_that_are_computed(self):
        self.store("--grid", "65,65,49")
        web = Dripping(self.folder, ".f32")
        self.addCleanup(web.shutdown)
        server = RealServer(web.address("tornado"))
        wakesurf.Client(server.url).api.dataset.open(dataset="tornado")
        self.asked_for(server, 8, kind="streak", to=1.5)
        self.assertTrue(web.dripping.wait(30))
        self.ends(server)

    def source(self):
        nodes = 64
        with open(os.path.join(self.folder, "slow_0.vti"), "w", encoding="ascii") as file:
            extent = f"0 {nodes - 1} " * 3
            file.write(f"""<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian"><ImageData WholeExtent="{extent}" Origin="0 0 0"
Spacing="1 1 1"><Piece Extent="{extent}"><PointData><DataArray type="Float32" Name="U" NumberOfComponents="3" format="ascii">
{"0.5 " * (3 * nodes ** 3)}</DataArray></PointData></Piece></ImageData></VTKFile>""")
        for step in range(1, 30):
            os.link(os.path.join(self.folder, "slow_0.vti"), os.path.join(self.folder, f"slow_{step}.vti"))
        return os.path.join(self.folder, "slow_0.vti")

    def test_while_an_importer_is_stopped(self):
        server = RealServer(self.source(), "--store", os.path.join(self.folder, "stores"))
        self.halt(until(lambda: below(server.process.pid, "wakesurf-import")[1:]))
        self.ends(server)

    def test_while_an_importer_is_stopped_with_the_process_that_watches_it(self):
        server = RealServer(self.source(), "--store", os.path.join(self.folder, "stores"))
        until(lambda: len(below(server.process.pid, "wakesurf-import")) > 1)
        self.halt(below(server.process.pid, "wakesurf-import"))
        self.ends(server)

    @unittest.skipUnless(os.path.exists(BRICKS), "wakesurf-bricks is not built: WAKESURF_MPI is off")
    def test_while_ranks_of_two_datasets_hang_and_what_started_them_too(self):
        os.environ.update(AS_ROOT)
        stores = [self.store("--grid", "129,129,97", "--layout", "bricks")]
        stores.append(stores[0] + "2")
        os.rename(stores[0], stores[1])
        self.store("--grid", "129,129,97", "--layout", "bricks")
        server = RealServer(*stores, "--memory", MEMORY, "--bricks", START)
        until(lambda: all(len(ranks_of(each)) == 2 for each in stores))
        self.halt(below(server.process.pid))
        self.ends(server)


if __name__ == "__main__":
    unittest.main()
