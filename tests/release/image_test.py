"""What the image adds to the programs: its entry point, its health check, the notices. docker/verify tries the image itself."""
import http.server
import os
import shutil
import subprocess
import tempfile
import threading
import unittest

from real_server import ROOT


def text_of(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


class EntryPointTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.data = os.path.join(self.folder.name, "data")
        os.mkdir(self.data)
        os.chmod(self.folder.name, 0o755)
        shutil.copy(os.path.join(ROOT, "docker/entrypoint"), self.folder.name)
        program = os.path.join(self.folder.name, "wakesurf")
        with open(program, "w", encoding="utf-8") as file:
            file.write('#!/bin/sh\necho "$*; ${WAKESURF_DATASET:-none}"\n')
        os.chmod(program, 0o755)

    def said(self, *arguments, **environment):
        user = {"user": 65534} if os.geteuid() == 0 else {}  # root reads everything
        ran = subprocess.run([os.path.join(self.folder.name, "entrypoint"), *arguments], text=True, timeout=30, **user,
                             env={"PATH": self.folder.name + os.pathsep + os.environ["PATH"],
                                  "WAKESURF_DATA_FOLDER": self.data, **environment},
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return ran.stdout.strip()

    def test_without_a_command_it_serves(self):
        self.assertEqual(self.said(), "serve; none")
        self.assertEqual(self.said("/data/case.pvd", "--threads", "2"), "serve /data/case.pvd --threads 2; none")
        self.assertEqual(self.said("flow:abc"), "serve flow:abc; none")
        self.assertEqual(self.said("--listen", "0.0.0.0:9000"), "serve --listen 0.0.0.0:9000; none")

    def test_a_command_of_wakesurf_is_that_command(self):
        self.assertEqual(self.said("info", "/data/case.pvd"), "info /data/case.pvd; none")
        self.assertEqual(self.said("serve", "--help"), "serve --help; none")
        self.assertEqual(self.said("--version"), "--version; none")

    def test_what_is_mounted_is_served_unless_something_else_is_named(self):
        with open(os.path.join(self.data, "case.pvd"), "w", encoding="utf-8"):
            pass
        self.assertEqual(self.said("--threads", "2"), f"serve --threads 2; {self.data}")
        self.assertEqual(self.said(WAKESURF_DATASET="flow:abc"), "serve; flow:abc")

    def test_what_is_mounted_and_cannot_be_read_is_not_passed_over(self):
        os.chmod(self.data, 0)
        self.assertIn("chmod -R o+rX", self.said())


class HealthCheckTest(unittest.TestCase):
    def setUp(self):
        test = self
        self.status = 200

        class Handler(http.server.BaseHTTPRequestHandler):
            def do_GET(self):
                self.send_response(test.status if self.path == "/healthz" else 404)
                self.end_headers()

            def log_message(self, *_):
                pass

        self.server = http.server.HTTPServer(("127.0.0.1", 0), Handler)
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.addCleanup(self.server.server_close)
        self.addCleanup(self.server.shutdown)
        self.address = f"0.0.0.0:{self.server.server_port}"

    def healthy(self, *command, listen="127.0.0.1:1"):
        with tempfile.NamedTemporaryFile() as words:
            words.write(b"".join(word.encode() + b"\0" for word in ("wakesurf", "serve", *command)))
            words.flush()
            return subprocess.run([os.path.join(ROOT, "docker/healthcheck"), words.name], timeout=30,
                                  env={**os.environ, "WAKESURF_LISTEN": listen},
                                  stderr=subprocess.DEVNULL).returncode == 0

    def test_it_asks_where_the_server_was_told_to_listen(self):
        self.assertTrue(self.healthy(listen=self.address))
        self.assertTrue(self.healthy("--listen", self.address))
        self.assertTrue(self.healthy("--listen=" + self.address))
        self.assertFalse(self.healthy("--listen", "127.0.0.1:1", listen=self.address))

    def test_only_a_good_answer_is_one(self):
        self.status = 503
        self.assertFalse(self.healthy(listen=self.address))

    def test_a_port_that_speaks_tls_answers_plain_http_with_400(self):
        self.status = 400
        self.assertTrue(self.healthy("--tls-cert", "c", "--tls-key", "k", listen=self.address))
        self.assertFalse(self.healthy(listen=self.address))


class NoticesTest(unittest.TestCase):
    def test_every_library_that_is_built_with_has_its_notice(self):
        rows = [line.split() for line in text_of("packaging/packages.txt").splitlines() if line and line[0] != "#"]
        tools = {"g++", "python3", "cmake", "ninja-build", "ccache", "mold"}
        libraries = [row[0] for row in rows if row[1] == "build" and row[0] not in tools] + ["libvtk9-dev"]
        noticed = {line.split()[1] for line in text_of("THIRD_PARTY.txt").splitlines()
                   if line.startswith("    package ")}
        self.assertEqual(set(libraries) - noticed, set())

    def test_every_licence_named_has_its_text(self):
        notices = text_of("THIRD_PARTY.txt")
        named = {name for line in notices.splitlines() if line.startswith("    licence ") and "public domain" not in line
                 for name in line.replace(" and ", " ").split()[1:]}
        texts = {line.split()[1] for line in notices.splitlines() if line.startswith("Licence ")}
        self.assertEqual(named, texts)


if __name__ == "__main__":
    unittest.main()
