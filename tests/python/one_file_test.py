"""The client as the one file that the server gives away: nothing else of it is to be found, and everything works."""
import json
import os
import subprocess
import sys
import tempfile
import unittest

from real_server import ROOT, RealServer

PYTHON = os.path.join(ROOT, "python")
SCRIPT = """
import os, sys, wakesurf, wakesurf.frames
assert os.path.dirname(wakesurf.__file__) == os.getcwd(), wakesurf.__file__
session = wakesurf.Client(sys.argv[1]).session()
print(session.suggested("stream").wait()["complete"], wakesurf.__version__, wakesurf.records.Dataset.__name__)
print("class FrameError" in wakesurf.frames.__loader__.get_source("wakesurf.frames"))
"""


def one_file():
    """As web-client/vite.config.ts makes it."""
    sources = {}
    for at, _, names in os.walk(os.path.join(PYTHON, "wakesurf")):
        for name in names:
            if name.endswith(".py"):
                path = os.path.join(at, name)
                with open(path, encoding="utf-8") as file:
                    sources[os.path.relpath(path, os.path.join(PYTHON, "wakesurf"))[:-3]] = file.read()
    with open(os.path.join(PYTHON, "one_file.py"), encoding="utf-8") as file:
        return file.read().replace("_SOURCES = {}", "_SOURCES = " + json.dumps(sources, indent=1))


class OneFileTest(unittest.TestCase):
    def test_it_is_all_that_a_script_needs_beside_numpy(self):
        server = RealServer("flow:tornado")
        try:
            with tempfile.TemporaryDirectory() as folder:
                with open(os.path.join(folder, "wakesurf.py"), "w", encoding="utf-8") as file:
                    file.write(one_file())
                environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
                ran = subprocess.run([sys.executable, "-W", "error", "-c", SCRIPT, server.url], cwd=folder, env=environment,
                                     stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=60)
        finally:
            server.stop()
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertRegex(ran.stdout, r"^True \d+\.\d+\.\d+ Dataset\nTrue\n$")


if __name__ == "__main__":
    unittest.main()
