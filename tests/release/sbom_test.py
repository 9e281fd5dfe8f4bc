"""packaging/sbom: what the programs of this build contain and load, compared with what the loader, the lock file and the notices say."""
import json
import os
import re
import subprocess
import sys
import unittest

from real_server import BINARY, ROOT


@unittest.skipUnless(os.path.exists("/var/lib/dpkg/status"), "dpkg knows whose a library is")
class SbomTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tree = os.path.dirname(os.path.dirname(os.path.abspath(BINARY)))
        ran = subprocess.run([sys.executable, os.path.join(ROOT, "packaging/sbom"), cls.tree, "1.2+git3.abc", "0123456789ab", "1000000000"],
                             capture_output=True, text=True)
        if ran.returncode != 0:
            raise AssertionError(ran.stderr)
        cls.text, cls.bill = ran.stdout, json.loads(ran.stdout)
        cls.names = {each["name"] for each in cls.bill["components"]}

    def test_it_says_what_it_is_of(self):
        own = self.bill["metadata"]["component"]
        self.assertEqual((own["name"], own["version"], own["purl"]), ("wakesurf", "1.2+git3.abc", "pkg:generic/wakesurf@1.2%2Bgit3.abc"))
        self.assertEqual(self.bill["metadata"]["timestamp"], "2001-09-09T01:46:40Z")

    def test_the_package_of_every_library_that_the_programs_load_is_in_it(self):
        for program in ("bin/wakesurf", "bin/wakesurf-import"):
            listed = subprocess.run(["ldd", os.path.join(self.tree, program)], capture_output=True, text=True, check=True).stdout
            for name in ("libsqlite3.so", "libtbb.so") if program == "bin/wakesurf" else ("libvtkIOXML", "libudunits2.so"):
                self.assertIn(name, listed)
        for package in ("libsqlite3-0", "libtbb12", "libudunits2-0", "libstdc++6"):
            self.assertIn(package, self.names)
        self.assertTrue(any(re.fullmatch(r"libvtk9\.\d+", name) for name in self.names), self.names)

    def test_every_package_that_the_page_has_a_notice_for_is_in_it(self):
        with open(os.path.join(ROOT, "web-client/package.json"), encoding="utf-8") as file:
            for name, version in json.load(file)["dependencies"].items():
                found = [each for each in self.bill["components"] if each["name"] == name]
                self.assertEqual([each["version"] for each in found], [version], name)
                self.assertRegex(found[0]["hashes"][0]["content"], r"^[0-9a-f]{128}$")
        notices = os.path.join(ROOT, "web-client/dist/third-party-notices.txt")
        if os.path.exists(notices):
            with open(notices, encoding="utf-8") as file:
                noted = set(re.findall(r"^=+\n(\S+) [\d.]+, ", file.read(), re.MULTILINE))
            self.assertGreater(len(noted), 4)
            self.assertEqual(noted - self.names, set())

    def test_what_is_compiled_in_is_in_it_with_its_licence(self):
        boost = next(each for each in self.bill["components"] if each["name"] == "libboost-dev")
        self.assertEqual(boost["licenses"], [{"license": {"name": "BSL-1.0"}}])

    def test_nothing_is_in_it_twice_or_without_version_and_address(self):
        references = [each["bom-ref"] for each in self.bill["components"]]
        self.assertEqual(len(references), len(set(references)))
        self.assertEqual(self.bill["dependencies"][0]["dependsOn"], references)
        for each in self.bill["components"]:
            self.assertTrue(each["version"], each)
            self.assertRegex(each["purl"], r"^pkg:(deb/debian|npm)/[^@ ]+@[^ ?]+")

    def test_the_same_build_has_the_same_bill(self):
        again = subprocess.run([sys.executable, os.path.join(ROOT, "packaging/sbom"), self.tree, "1.2+git3.abc", "0123456789ab",
                                "1000000000"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(again, self.text)


if __name__ == "__main__":
    unittest.main()
