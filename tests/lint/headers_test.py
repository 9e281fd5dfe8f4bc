#!/usr/bin/env python3
"""Every public name of the installed headers has words, by doxygen, where that is installed.

Run it alone with: python3 tests/lint/headers_test.py
"""
import os
import shutil
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def faults(include, folder):
    """What doxygen says of the headers below `include`."""
    with open(os.path.join(ROOT, "docs/site/Doxyfile"), encoding="utf-8") as file:
        settings = file.read().replace("build/doxygen/include", include).replace("build/doxygen", folder)
    done = subprocess.run(["doxygen", "-"], input=settings + "\nGENERATE_HTML = NO\nGENERATE_XML = YES\n", capture_output=True, text=True,
                          check=False, cwd=ROOT)
    return [line for line in done.stderr.split("\n") if "warning" in line or "error" in line]


@unittest.skipUnless(shutil.which("doxygen") and shutil.which("cmake"), "doxygen is not installed")
class HeadersTest(unittest.TestCase):
    maxDiff = None

    def test_every_public_name_of_the_installed_headers_has_words(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(["cmake", "-DSOURCES=" + ROOT, "-DMADE=" + os.path.join(folder, "made"), "-DCMAKE_INSTALL_PREFIX=" + folder,
                            "-P", os.path.join(ROOT, "packaging/install_headers.cmake")], check=True, stdout=subprocess.DEVNULL)
            self.assertEqual(faults(os.path.join(folder, "include"), folder), [])

    def test_finds_a_name_without_words(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "a.hpp"), "w", encoding="utf-8") as file:
                file.write("namespace w {\n/// Words.\nstruct A {\n    int bare;\n    int told; ///< words\n};\n}\n")
            (found,) = [line for line in faults(folder, folder) if "not documented" in line]
            self.assertIn("bare", found)


if __name__ == "__main__":
    unittest.main()
