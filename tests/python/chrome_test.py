"""The browser that draws pictures leaves nothing behind: neither what its other processes write late, nor where Python is killed."""
import os
import signal
import subprocess
import sys
import tempfile
import textwrap
import unittest
from unittest import mock

from real_server import ROOT
from wakesurf.chrome import Chrome

# It answers every command. A second process of it goes on writing into the profile when it has ended, as Chromium's network service does.
BROWSER = """\
    #!{python}
    import json, os, sys
    profile = next(each.split("=", 1)[1] for each in sys.argv if each.startswith("--user-data-dir="))
    if os.fork() == 0:
        while True:
            os.makedirs(profile + "/Default/Cache", exist_ok=True)
            with open(profile + "/Default/Cache/index", "w") as file:
                file.write(str(os.getpid()))
    text = b""
    while True:
        some = os.read(3, 4096)
        if not some:
            break
        text += some
        while b"\\0" in text:
            message, text = text.split(b"\\0", 1)
            os.write(4, json.dumps({{"id": json.loads(message)["id"], "result": {{"targetId": "t", "sessionId": "s"}}}}).encode() + b"\\0")
"""


class ChromeTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.profiles = os.path.join(folder.name, "tmp")
        os.mkdir(self.profiles)
        browser = os.path.join(folder.name, "browser")
        with open(browser, "w", encoding="utf-8") as file:
            file.write(textwrap.dedent(BROWSER).format(python=sys.executable))
        os.chmod(browser, 0o755)
        for change in (mock.patch.dict(os.environ, {"WAKESURF_CHROMIUM": browser, "TMPDIR": self.profiles}),
                       mock.patch.object(tempfile, "tempdir", self.profiles)):
            change.start()
            self.addCleanup(change.stop)

    def test_leaves_no_profile_though_a_process_of_it_writes_longer_than_it_lives(self):
        for _ in range(5):
            chrome = Chrome("http://127.0.0.1:9/", (320, 200))
            self.assertEqual(len(os.listdir(self.profiles)), 1)
            chrome.close()
            chrome.close()
            self.assertEqual(os.listdir(self.profiles), [])

    def killed(self):
        """A Python with a browser that was killed. Its browser ends with the pipe, and then so does what writes."""
        code = "import time, wakesurf.chrome as chrome; kept = chrome.Chrome('http://127.0.0.1:9/', (320, 200)); print(kept._process.pid, flush=True);" \
               "time.sleep(600)"
        python = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True,
                                  env={**os.environ, "PYTHONPATH": os.path.join(ROOT, "python")})
        browser = int(python.stdout.readline())
        python.kill()
        python.wait()
        python.stdout.close()
        os.killpg(browser, signal.SIGKILL)

    def test_removes_what_a_python_left_that_was_killed_and_nothing_that_is_used(self):
        self.killed()
        self.assertEqual(len(os.listdir(self.profiles)), 1)
        (left,) = os.listdir(self.profiles)
        first = Chrome("http://127.0.0.1:9/", (320, 200))
        self.addCleanup(first.close)
        (used,) = os.listdir(self.profiles)
        self.assertNotEqual(used, left)
        second = Chrome("http://127.0.0.1:9/", (320, 200))
        self.addCleanup(second.close)
        self.assertEqual(len(os.listdir(self.profiles)), 2)
        self.assertIn(used, os.listdir(self.profiles))

    def test_ends_with_a_python_that_does_not_close_it(self):
        code = "import wakesurf.chrome as chrome; kept = chrome.Chrome('http://127.0.0.1:9/', (320, 200))"
        subprocess.run([sys.executable, "-c", code], check=True, env={**os.environ, "PYTHONPATH": os.path.join(ROOT, "python")})
        self.assertEqual(os.listdir(self.profiles), [])


if __name__ == "__main__":
    unittest.main()
