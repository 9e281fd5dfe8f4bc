"""The engine as an installed package: other programs, those in examples/, find it, compile, link, and compute what is right."""
import os
import re
import shutil
import subprocess
import tempfile
import unittest

from real_server import BINARY, ROOT
from wakesurf import Mesh

PRIVATE = ("columns", "moving", "cells", "api")
CLASH = "#error this is the program's own, and not what wakesurf's headers mean\n"


class PackageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.prefix = os.path.join(cls.folder.name, "prefix")
        tree = os.path.dirname(os.path.dirname(os.path.abspath(BINARY)))
        subprocess.run(["cmake", "--install", tree, "--component", "development", "--prefix", cls.prefix], check=True,
                       stdout=subprocess.DEVNULL)
        cls.examples = os.path.join(cls.folder.name, "examples")
        shutil.copytree(os.path.join(ROOT, "examples"), cls.examples)
        # A program with a core/ of its own, first in its search path.
        cls.own = os.path.join(cls.folder.name, "own")
        for name in cls.headers():
            os.makedirs(os.path.join(cls.own, os.path.dirname(name)), exist_ok=True)
            with open(os.path.join(cls.own, name), "w", encoding="utf-8") as file:
                file.write(CLASH)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def headers(cls):
        include = os.path.join(cls.prefix, "include/wakesurf")
        for folder, _, files in os.walk(include):
            for name in files:
                yield os.path.relpath(os.path.join(folder, name), include)

    def configure(self, source, name, *options):
        build = os.path.join(self.folder.name, "build-" + name)
        return build, subprocess.run(
            ["cmake", "-S", source, "-B", build, "-G", "Ninja", "-DCMAKE_PREFIX_PATH=" + self.prefix, *options],
            capture_output=True, text=True)

    def asks_for(self, words):
        """What CMake says to a project that asks for the package like that."""
        source = os.path.join(self.folder.name, "project")
        os.makedirs(source, exist_ok=True)
        with open(os.path.join(source, "CMakeLists.txt"), "w", encoding="utf-8") as file:
            file.write(f"cmake_minimum_required(VERSION 3.25)\nproject(asks CXX)\nfind_package(wakesurf {words} REQUIRED)\n")
        return self.configure(source, re.sub(r"\W+", "-", words))[1]

    def run_example(self, build, *command):
        ran = subprocess.run([os.path.join(build, command[0]), *command[1:]], capture_output=True, text=True, timeout=120)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        return ran.stdout

    def test_the_examples_compile_and_are_right_by_closed_forms(self):
        # The headers are what is tried here, the libraries have been optimised already.
        build, configured = self.configure(self.examples, "examples", "-DCMAKE_CXX_FLAGS=-O1 -Wall -Wextra -Werror -I" + self.own)
        self.assertEqual(configured.returncode, 0, configured.stderr)
        built = subprocess.run(["cmake", "--build", build, "-j2"], capture_output=True, text=True)
        self.assertEqual(built.returncode, 0, built.stdout)

        with self.subTest("own_velocity"):
            said = self.run_example(build, "own_velocity", self.folder.name)
            found = re.findall(r"(stream|streak): (\d+) cells, off by (\S+)\n", said)
            self.assertEqual([kind for kind, _, _ in found], ["stream", "streak"])
            for kind, cells, off in found:
                self.assertGreater(int(cells), 500)
                self.assertLess(float(off), 1e-4, said)
                with open(os.path.join(self.folder.name, kind + ".vtp"), "rb") as file:
                    mesh = Mesh.from_vtp(file.read())
                self.assertEqual((mesh.about["kind"], len(mesh.offsets) - 1), (kind, int(cells)))

        with self.subTest("own_arrays"):
            cells, off = re.fullmatch(r"streak: (\d+) cells, off by (\S+)\n", self.run_example(build, "own_arrays")).groups()
            self.assertGreater(int(cells), 500)
            self.assertLess(float(off), 1e-3)

        with self.subTest("live_deltas"):
            said = self.run_example(build, "live_deltas")
            moves = re.findall(r"rake at \S+: (\d+) vertices, off by (\S+), a whole one (\d+) bytes, others (\d+)\n", said)
            self.assertEqual(len(moves), 3, said)
            for vertices, off, whole, others in moves:
                self.assertGreater(int(vertices), 200)
                self.assertLess(float(off), 2e-3)  # the lattice's step is 3e-4
                self.assertLess(int(others), int(whole))

        with self.subTest("store_to_file"):
            store, rake = os.path.join(self.folder.name, "store"), "0.4,0.4,0.1 0.6,0.6,0.1"
            subprocess.run([BINARY, "generate", "tornado", store, "--grid", "17,17,17", "--times", "0:4:5"],
                           check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            ours, theirs = (os.path.join(self.folder.name, name) for name in ("ours.vtp", "theirs.vtp"))
            said = self.run_example(build, "store_to_file", store, rake, theirs)
            subprocess.run([BINARY, "surface", store, "--kind", "streak", "--rake", rake, "--from", "0", "--to", "4", "-o", ours],
                           check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            with open(ours, "rb") as one, open(theirs, "rb") as other:
                one, other = Mesh.from_vtp(one.read()), Mesh.from_vtp(other.read())
            self.assertIn(f"{len(other.offsets) - 1} quads, {len(other.points)} vertices", said)
            self.assertGreater(len(other.points), 100)
            self.assertEqual((one.points.tolist(), one.connectivity.tolist()), (other.points.tolist(), other.connectivity.tolist()))

    def test_this_version_is_found_and_others_are_refused(self):
        for words in ("", "0.1", "0.1 COMPONENTS core", "COMPONENTS store protocol"):
            self.assertEqual(self.asks_for(words).returncode, 0, words)
        for words in ("0.2", "1.0"):
            asked = self.asks_for(words)
            self.assertNotEqual(asked.returncode, 0)
            self.assertIn("0.1.0", asked.stderr)
        self.assertIn("wakesurf has no component server here", " ".join(self.asks_for("COMPONENTS server").stderr.split()))

    def test_only_headers_that_programs_include_are_installed(self):
        headers = set(self.headers())
        self.assertLessEqual({"core/surface/builder/surface_builder.hpp", "protocol/files/mesh_file.hpp", "store/open_store.hpp"}, headers)
        self.assertEqual([each for each in headers if set(PRIVATE) & set(each.split("/"))], [])
        # A stored flow can be told which kernel to use.
        self.assertEqual([each for each in headers if "/kernel/" in each], ["core/field/kernel/simd.hpp"])
        self.assertLess(len(headers), 80)

    def test_headers_include_each_other_by_the_name_that_programs_use(self):
        headers = {"wakesurf/" + each for each in self.headers()}
        for each in headers:
            with open(os.path.join(self.prefix, "include", each), encoding="utf-8") as file:
                text = file.read()
            self.assertEqual(re.findall(r'#include "', text), [], each)
            self.assertEqual(set(re.findall(r"#include <(wakesurf/[^>]+)>", text)) - headers, set(), each)
            self.assertNotRegex(text, r"#include <(nlohmann|draco|fmt)/", each)


if __name__ == "__main__":
    unittest.main()
