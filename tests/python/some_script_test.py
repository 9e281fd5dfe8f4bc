"""tests/some in a clone where nothing is prepared: it does so by itself, once. The set-up, ninja and the tests are of paper."""
import os
import shutil
import subprocess
import tempfile
import unittest

from real_server import ROOT, write_program

NINJA = '''#!/bin/sh
echo "ninja $3" >>"$(dirname "$0")/../ran.txt"
[ -e "$2/CMakeCache.txt" ] || exit 1
echo "[1/$STEPS] Building a file"
[ -z "$BROKEN" ] || { echo "error: no such type"; exit 1; }
'''
SET_UP = '''#!/bin/sh
cd "$(dirname "$0")/.."
echo "set up" >>ran.txt
mkdir -p build/release
printf '\\nWAKESURF_TESTS:BOOL=ON\\n' >build/release/CMakeCache.txt
'''


class SomeScriptTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.clone = self.folder.name
        write_program(self.clone, "bin/ninja", NINJA)
        write_program(self.clone, "docker/set_up_tests", SET_UP)
        write_program(self.clone, "tests/python/paper_test.py", "")
        shutil.copy(os.path.join(ROOT, "tests/some"), os.path.join(self.clone, "tests/some"))

    def some(self, **environment):
        """Its status, and what it said."""
        ran = subprocess.run([os.path.join(self.clone, "tests/some"), "python/paper_test"], text=True, timeout=60, check=False, capture_output=True,
                             env={"PATH": os.path.join(self.clone, "bin") + ":" + os.environ["PATH"], "STEPS": "2", **environment})
        return ran.returncode, ran.stderr

    def ran(self):
        with open(os.path.join(self.clone, "ran.txt"), encoding="utf-8") as file:
            return file.read().splitlines()

    def test_prepares_a_new_clone_before_it_builds_and_does_so_once(self):
        self.assertEqual(self.some()[0], 0)
        self.assertEqual(self.some()[0], 0)
        self.assertEqual(self.ran(), ["set up", "ninja wakesurf", "ninja wakesurf"])

    def test_prepares_a_clone_that_run_has_built_without_tests(self):
        write_program(self.clone, "build/release/CMakeCache.txt", "\nWAKESURF_TESTS:BOOL=OFF\n")
        self.some()
        self.assertEqual(self.ran(), ["set up", "ninja wakesurf"])

    def test_ends_where_that_fails(self):
        write_program(self.clone, "docker/set_up_tests", "#!/bin/sh\necho no packages >&2\nexit 3\n")
        self.assertEqual(self.some(), (1, "no packages\n"))

    def test_says_how_much_there_is_to_compile_where_one_would_wonder(self):
        self.assertIn("57 steps of building ...\n", self.some(STEPS="57")[1])
        self.assertNotIn("steps", self.some(STEPS="2")[1])

    def test_shows_what_the_compiler_said_when_it_failed(self):
        status, said = self.some(BROKEN="yes")
        self.assertEqual(status, 1)
        self.assertIn("error: no such type", said)


if __name__ == "__main__":
    unittest.main()
