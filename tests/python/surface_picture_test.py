"""`wakesurf surface DATA -o a.png`: the page's picture of what the options ask for, and nothing left behind."""
import os
import signal
import struct
import subprocess
import time
import unittest

from real_server import BINARY, FolderTest

SURFACE = ("surface", "flow:tornado", "--kind", "path", "--rake", "0.4,0.4,0.1 0.6,0.6,0.1", "--to", "1", "--separation", "0.1")


class SurfacePictureTest(FolderTest):
    def setUp(self):
        super().setUp()
        self.path = os.path.join(self.folder, "a.png")

    def environment(self, **more):
        return {**os.environ, "WAKESURF_STORE": os.path.join(self.folder, "store"), **more}

    def run_it(self, *words, **environment):
        return subprocess.run([BINARY, *words], capture_output=True, text=True, timeout=300, cwd=self.folder,
                              env=self.environment(**environment), check=False)

    def test_is_as_large_as_asked_for_says_what_it_shows_and_verifies(self):
        ran = self.run_it(*SURFACE, "-o", self.path, "--size", "400x300", "--seeds", "12")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertRegex(ran.stdout, r"a\.png: 400 x 300 pixels of \d+ quads, separation 0\.1\n$")
        with open(self.path, "rb") as file:
            head = file.read(24)
        self.assertEqual((head[:4], struct.unpack(">II", head[16:24])), (b"\x89PNG", (400, 300)))
        verified = self.run_it("verify", self.path)
        self.assertEqual((verified.returncode, verified.stdout.splitlines()[-1].split(";")[0]), (0, "verified: the surfaces that are shown"), verified)
        mesh = self.run_it(*SURFACE, "-o", os.path.join(self.folder, "a.vtp"), "--seeds", "12")
        self.assertEqual(ran.stdout.split()[6], mesh.stdout.split()[1], "as many quads as the mesh has")

    def test_shows_points_where_asked_for(self):
        sizes = []
        for words in ((), ("--lines", "points")):
            ran = self.run_it(*SURFACE, "-o", self.path, "--size", "400x300", "--seeds", "12", *words)
            self.assertEqual(ran.returncode, 0, ran.stderr)
            with open(self.path, "rb") as file:
                sizes.append(file.read())
        self.assertNotEqual(*sizes)

    def test_goes_to_a_file_whose_name_is_no_text_as_meshes_do(self):
        name = b"wake-\xff.png"
        ran = subprocess.run([BINARY, *SURFACE, "-o", name, "--size", "200x200"], capture_output=True, timeout=300, cwd=self.folder,
                             env=self.environment(), check=False)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertTrue(ran.stdout.startswith(name + b": 200 x 200 pixels"), ran.stdout)
        self.assertEqual(os.listdir(os.fsencode(self.folder)).count(name), 1)

    def test_begins_as_the_data_suggest_where_nothing_is_said(self):
        ran = self.run_it("surface", "flow:sphere", "--kind", "stream", "-o", "a.png", "--size", "200x200", "--separation", "0.5")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertIn("without --rake:", ran.stderr)
        self.assertTrue(os.path.exists(self.path))

    def test_says_what_is_wrong_before_or_after_the_data_are_open(self):
        for words, status, told in ((("--tessellate", "2"), 2, "--tessellate is for meshes"), (("--lines", "timelines:4"), 2, "--lines is for meshes"),
                                    (("--stats", "a.json"), 2, "--stats is for meshes"), (("--size", "400"), 2, "WIDTHxHEIGHT"),
                                    (("--size", "1x1"), 2, "64 to 8192"), (("--angle", "900"), 2, "--angle"),
                                    (("--fields", "nothing"), 1, "--fields names a field"), (("--interpolation", "smooth"), 1, "smooth")):
            with self.subTest(words):
                ran = self.run_it(*SURFACE, "-o", "a.png", *words)
                self.assertEqual((ran.returncode, told in ran.stderr, ran.stderr.count("\n")), (status, True, 1), ran.stderr)
        self.assertFalse(os.path.exists(self.path))
        self.assertIn("no folder", self.run_it(*SURFACE, "-o", "nowhere/a.png").stderr)
        self.assertIn("case.foam", self.run_it("surface", "/nowhere/case.foam", "--kind", "path", "-o", "a.png").stderr)

    def test_says_what_to_install(self):
        ran = self.run_it(*SURFACE, "-o", "a.png", WAKESURF_CHROMIUM="/nowhere/chromium")
        self.assertEqual((ran.returncode, "Debian: chromium" in ran.stderr), (1, True), ran.stderr)
        ran = self.run_it(*SURFACE, "-o", "a.png", WAKESURF_PYTHON="/nowhere/python")
        self.assertEqual((ran.returncode, "python3-numpy" in ran.stderr), (1, True), ran.stderr)

    def test_leaves_no_server_behind_where_it_is_stopped(self):
        process = subprocess.Popen([BINARY, "surface", "flow:tornado", "--kind", "streak", "--to", "12", "--separation", "0.004", "-o", "a.png"],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, cwd=self.folder, env=self.environment())
        self.addCleanup(process.stderr.close)
        children = f"/proc/{process.pid}/task/{process.pid}/children"
        end, server = time.monotonic() + 60, ""
        while not server and time.monotonic() < end:
            with open(children, encoding="utf-8") as file:
                server = file.read().strip()
        process.stderr.readline()  # it has a rake: the server answers
        process.send_signal(signal.SIGTERM)
        self.assertEqual((process.wait(timeout=60), process.stderr.read()), (1, "wakesurf: stopped, nothing was written\n"))
        self.assertFalse(os.path.exists(f"/proc/{server}"))
        self.assertFalse(os.path.exists(self.path))


if __name__ == "__main__":
    unittest.main()
