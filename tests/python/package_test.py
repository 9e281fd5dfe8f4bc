"""The engine as an installed package: another program finds it, compiles, links and computes a surface."""
import os
import re
import shutil
import subprocess
import tempfile
import unittest

from real_server import BINARY, ROOT

PRIVATE = ("columns", "moving", "cells")


class PackageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.prefix = os.path.join(cls.folder.name, "prefix")
        tree = os.path.dirname(os.path.dirname(os.path.abspath(BINARY)))
        subprocess.run(["cmake", "--install", tree, "--component", "development", "--prefix", cls.prefix], check=True,
                       stdout=subprocess.DEVNULL)
        cls.program = os.path.join(cls.folder.name, "program")
        shutil.copytree(os.path.join(ROOT, "tests/install"), cls.program)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def configure(self, version):
        build = os.path.join(self.folder.name, "build-" + version)
        return build, subprocess.run(
            ["cmake", "-S", self.program, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
             "-DCMAKE_PREFIX_PATH=" + self.prefix, "-DWAKESURF_WANTED=" + version], capture_output=True, text=True)

    def headers(self):
        include = os.path.join(self.prefix, "include/wakesurf")
        for folder, _, files in os.walk(include):
            for name in files:
                yield os.path.relpath(os.path.join(folder, name), include)

    def test_a_program_of_forty_lines_computes_a_surface_with_it(self):
        with open(os.path.join(self.program, "program.cpp"), encoding="utf-8") as file:
            self.assertLessEqual(len(file.readlines()), 40)
        build, configured = self.configure("0.1")
        self.assertEqual(configured.returncode, 0, configured.stderr)
        built = subprocess.run(["cmake", "--build", build], capture_output=True, text=True)
        self.assertEqual(built.returncode, 0, built.stdout)
        ran = subprocess.run([os.path.join(build, "user_of_wakesurf")], capture_output=True, text=True, timeout=60)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        cells, timelines, off = re.fullmatch(r"(\d+) cells, (\d+) timelines, off by (\S+)\n", ran.stdout).groups()
        self.assertGreater(int(cells), 1000)
        self.assertEqual(int(timelines), 4)
        self.assertLess(float(off), 1e-3)

    def test_another_version_is_refused(self):
        for version in ("0.2", "1.0"):
            _, configured = self.configure(version)
            self.assertNotEqual(configured.returncode, 0)
            self.assertIn("0.1.0", configured.stderr)

    def test_only_headers_that_programs_include_are_installed(self):
        headers = set(self.headers())
        self.assertIn("core/surface/surface_builder.hpp", headers)
        self.assertEqual([each for each in headers if set(PRIVATE) & set(each.split("/"))], [])
        # A stored flow can be told which kernel to use.
        self.assertEqual([each for each in headers if "/kernel/" in each], ["core/field/kernel/rk4_batch.hpp"])
        self.assertLess(len(headers), 60)

    def test_every_header_that_one_includes_is_installed(self):
        headers = set(self.headers())
        for each in headers:
            with open(os.path.join(self.prefix, "include/wakesurf", each), encoding="utf-8") as file:
                self.assertEqual(set(re.findall(r'#include "([^"]+)"', file.read())) - headers, set(), each)


if __name__ == "__main__":
    unittest.main()
