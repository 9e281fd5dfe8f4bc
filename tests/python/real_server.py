"""The real program for tests in Python: started on a free port, stopped at the end; and what many of them begin with."""
import os
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BINARY = os.environ.get("WAKESURF_BINARY", os.path.join(ROOT, "build/release/bin/wakesurf"))
sys.path.insert(0, os.path.join(ROOT, "python"))
import wakesurf  # noqa: E402

LONGEST = 300  # seconds, longer than any machine takes


def until(what):
    """Waits for what comes in its own time."""
    end = time.monotonic() + LONGEST
    while not (found := what()):
        if time.monotonic() > end:
            raise TimeoutError
        time.sleep(0.05)
    return found


class RealServer:
    """`wakesurf serve ARGUMENTS`; `url` is the line it prints, with the token."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen([BINARY, "serve", *arguments, "--listen", "127.0.0.1:0"],
                                        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        line = self.process.stdout.readline().split()
        if not line:
            raise RuntimeError(f"{BINARY} did not start")
        self.url = line[1]

    def stop(self):
        self.process.terminate()
        self.process.wait(timeout=20)
        self.process.stdout.close()


class ServerTest(unittest.TestCase):
    """Tests that share a server, which serves `datasets`, and a client of it."""
    datasets = ("flow:tornado",)

    @classmethod
    def setUpClass(cls):
        cls.server = RealServer(*cls.datasets)
        cls.addClassCleanup(cls.server.stop)
        cls.client = wakesurf.Client(cls.server.url)


class FolderTest(unittest.TestCase):
    """Tests that have a folder each, which goes when they end."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name


def write_program(folder, name, text):
    """Writes an executable file below a folder."""
    path = os.path.join(folder, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    os.chmod(path, 0o755)
    return path
