"""The tour of docs/how-to/curl.md: its blocks run as one script against the real server, and print what they say."""
import os
import re
import subprocess
import tempfile
import unittest

from real_server import ROOT, RealServer


def tour():
    with open(os.path.join(ROOT, "docs/how-to/curl.md"), encoding="utf-8") as file:
        text = file.read()
    return "\n".join(re.findall(r"^```bash tour\n(.*?)^```", text, re.S | re.M))


class CurlTourTest(unittest.TestCase):
    def test_every_line_prints_what_it_says(self):
        script = tour()
        expected = [line.strip() for line in re.findall(r"# -> (.*)$", script, re.M)]
        self.assertGreater(len(expected), 10)
        with tempfile.TemporaryDirectory() as folder:
            token = os.path.join(folder, "token")
            server = RealServer("flow:tornado", "--token-file", token)
            try:
                address = server.url.split("/#")[0]
                ran = subprocess.run(["bash", "-euo", "pipefail", "-c", script], cwd=folder, text=True, timeout=120,
                                     env={**os.environ, "server": address, "token_file": token},
                                     stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            finally:
                server.stop()
            self.assertEqual(ran.stdout.split("\n")[:-1] or ran.stdout, expected, ran.stderr)
            self.assertEqual((ran.returncode, ran.stderr), (0, ""))
            sizes = {name: os.path.getsize(os.path.join(folder, name)) for name in os.listdir(folder)}
            for extension in ("vtp", "glb", "ply", "obj", "drc"):
                self.assertGreater(sizes["stream." + extension], 1000)
            self.assertGreater(sizes["hint.txt"], 10)


if __name__ == "__main__":
    unittest.main()
