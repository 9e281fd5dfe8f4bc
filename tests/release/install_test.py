"""`cmake --install`: a prefix from which the program serves, without the sources it was built from."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import urllib.request

from real_server import BINARY, ROOT

sys.path.insert(0, os.path.join(ROOT, "python"))
from wakesurf import Client  # noqa: E402


class InstallTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        # Three folders below one that looks like the sources: an installed program must not look there.
        cls.prefix = os.path.join(cls.folder.name, "usr/local")
        for decoy in ("data/sqcyl/sqcyl.pvd", "web-client/dist/index.html"):
            os.makedirs(os.path.join(cls.folder.name, os.path.dirname(decoy)))
            with open(os.path.join(cls.folder.name, decoy), "w", encoding="utf-8") as file:
                file.write("not ours")
        tree = os.path.dirname(os.path.dirname(os.path.abspath(BINARY)))
        subprocess.run(["cmake", "--install", tree, "--component", "program", "--prefix", cls.prefix], check=True,
                       stdout=subprocess.DEVNULL)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_it_has_the_licences(self):
        for name in ("LICENSE", "THIRD_PARTY.txt", "CHANGELOG.md"):
            with open(os.path.join(ROOT, name), encoding="utf-8") as file:
                expected = file.read()
            with open(os.path.join(self.prefix, "share/doc/wakesurf", name), encoding="utf-8") as file:
                self.assertEqual(file.read(), expected)

    def test_it_has_nothing_of_the_engine_for_other_programs(self):
        self.assertEqual(sorted(os.listdir(self.prefix)), ["bin", "lib", "share"])
        self.assertEqual(sorted(os.listdir(os.path.join(self.prefix, "bin"))), ["wakesurf", "wakesurf-import"])
        libraries = [name for _, _, names in os.walk(os.path.join(self.prefix, "lib")) for name in names]
        self.assertEqual(sorted(libraries), ["libwakesurf_frames.so",  # what the Python client decodes live frames with
                                             "wakesurf.service"])

    @unittest.skipUnless(os.path.exists(os.path.join(os.path.dirname(BINARY), "wakesurf-bricks")), "WAKESURF_MPI is off")
    def test_the_ranks_of_an_mpi_job_are_a_component_of_their_own_with_their_manual_page(self):
        with tempfile.TemporaryDirectory() as prefix:
            tree = os.path.dirname(os.path.dirname(os.path.abspath(BINARY)))
            subprocess.run(["cmake", "--install", tree, "--component", "bricks", "--prefix", prefix], check=True, stdout=subprocess.DEVNULL)
            files = [os.path.relpath(os.path.join(folder, name), prefix) for folder, _, names in os.walk(prefix) for name in names]
            self.assertEqual(sorted(files), ["bin/wakesurf-bricks", "share/man/man1/wakesurf-bricks.1"])
            with open(os.path.join(prefix, "share/man/man1/wakesurf-bricks.1"), encoding="utf-8") as page:
                self.assertTrue(page.read().startswith(".TH WAKESURF\\-BRICKS"))

    def text_of(self, path):
        with open(os.path.join(self.prefix, path), encoding="utf-8") as file:
            return file.read()

    def test_it_has_manual_pages_completion_and_a_unit_that_names_where_it_is(self):
        for page in ("wakesurf", "wakesurf-import"):
            self.assertTrue(self.text_of(f"share/man/man1/{page}.1").startswith(".TH WAKESURF"), page)
        self.assertIn("complete -o default -F _wakesurf wakesurf", self.text_of("share/bash-completion/completions/wakesurf"))
        self.assertIn(f"\nExecStart={self.prefix}/bin/wakesurf serve ", self.text_of("lib/systemd/system/wakesurf.service"))

    def test_it_has_the_plugin_for_paraview_and_the_client_that_it_finds(self):
        plugin = self.text_of("share/wakesurf/paraview/wakesurf_source.py")
        self.assertIn('os.path.join(_above, "python")', plugin)
        self.assertTrue(os.path.exists(os.path.join(self.prefix, "share/wakesurf/python/wakesurf/link.py")))

    def test_without_arguments_it_serves_the_bundled_simulation_and_its_page(self):
        page = os.path.join(self.prefix, "share/wakesurf/web")
        if not os.path.exists(os.path.join(page, "index.html")):  # the web client was not built yet
            shutil.rmtree(page, ignore_errors=True)
            os.makedirs(page)
            with open(os.path.join(page, "index.html"), "w", encoding="utf-8") as file:
                file.write("<title>wakesurf</title>")
        environment = {name: value for name, value in os.environ.items() if not name.startswith("WAKESURF_")}
        server = subprocess.Popen(
            [os.path.join(self.prefix, "bin/wakesurf"), "serve", "--listen", "127.0.0.1:0",
             "--store", os.path.join(self.folder.name, "store")],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment)
        try:
            address = server.stdout.readline().split()[1]
            with urllib.request.urlopen(address.split("#")[0], timeout=20) as response:
                self.assertIn("<title>", response.read().decode())
            names = [each["name"] for each in Client(address).call("dataset.list")["datasets"]]
            self.assertEqual(names, ["sqcyl"])
        finally:
            server.terminate()
            _, log = server.communicate(timeout=20)
        self.assertIn("event=bundled_simulation", log)
        self.assertNotIn("level=warn", log)


if __name__ == "__main__":
    unittest.main()
