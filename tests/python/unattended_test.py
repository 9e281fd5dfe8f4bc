"""A server that nobody watches: as the unit of systemd runs it, which may write to three folders and nowhere else, as a user of its own without rights.
What systemd does is done here by namespaces and setpriv, as root; calls of the system and memory are not limited."""
import os
import re
import shlex
import shutil
import stat
import subprocess
import unittest

from real_server import BINARY, LONGEST, ROOT, FolderTest, until
import wakesurf

UNIT = os.path.join(ROOT, "packaging/wakesurf.service.in")
NOBODY = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", "--bounding-set=-all", "--inh-caps=-all", "--no-new-privs"]
VTI = """<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian"><ImageData WholeExtent="0 4 0 4 0 4" Origin="0 0 0" Spacing="1 1 1">
<Piece Extent="0 4 0 4 0 4"><PointData><DataArray type="Float32" Name="U" NumberOfComponents="3" format="ascii">{}</DataArray></PointData></Piece>
</ImageData></VTKFile>""".format("1 0 0 " * 125)


def unit():
    with open(UNIT, encoding="utf-8") as file:
        return file.read().replace("@CMAKE_INSTALL_PREFIX@", os.path.dirname(os.path.dirname(BINARY)))


def stopped(server):
    server.terminate()
    return server.wait(LONGEST)


def allowed():
    """Whether this machine lets a test make namespaces, and whether that user can reach the program."""
    return shutil.which("setpriv") and subprocess.run(
        ["unshare", "-m", "sh", "-c", "mount --make-rprivate / && exec \"$@\"", "sh", *NOBODY, BINARY, "--version"],
        capture_output=True, check=False).returncode == 0


class Unit(FolderTest):
    @unittest.skipUnless(shutil.which("systemd-analyze"), "systemd-analyze is not installed (Debian: systemd)")
    def test_is_one_that_systemd_takes_without_a_word(self):
        path = os.path.join(self.folder, "wakesurf.service")
        with open(path, "w", encoding="utf-8") as file:
            file.write(unit())
        told = subprocess.run(["systemd-analyze", "verify", "--man=no", path], capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual((told.returncode, told.stdout + told.stderr), (0, ""))


@unittest.skipUnless(allowed(), "this test makes namespaces, as root, for a user who can reach the program")
class Unattended(FolderTest):
    def setUp(self):
        super().setUp()
        os.chmod(self.folder, 0o755)
        self.places = {name: os.path.join(self.folder, name) for name in ("STATE_DIRECTORY", "CACHE_DIRECTORY", "RUNTIME_DIRECTORY")}
        for name, place in self.places.items():
            os.mkdir(place, int(re.search(rf"^{name.title().replace('_', '')}Mode=(\d+)$", unit(), re.M)[1], 8))
            os.chown(place, 65534, 65534)
        self.data = os.path.join(self.folder, "box.vti")
        with open(self.data, "w", encoding="utf-8") as file:
            file.write(VTI)
        self.log = os.path.join(self.folder, "log")

    def start(self, read_only=()):
        command = shlex.split(re.search(r"^ExecStart=((?:.*\\\n)*.*)$", unit(), re.M)[1].replace("\\\n", " "))
        command = [re.sub(r"\$\{(\w+)\}", lambda name: self.places[name[1]], word) for word in command]
        script = "umask 0077; mount --make-rprivate /\n"
        for place in self.places.values():
            script += f"mount --bind {place} {place}\n" + (f"mount -o remount,bind,ro {place}\n" if place in read_only else "")
        script += 'mount -o remount,bind,ro /; if mountpoint -q /tmp; then mount -o remount,bind,ro /tmp; fi; exec "$@"'
        environment = {"PATH": os.environ["PATH"], "WAKESURF_DATASET": self.data, "WAKESURF_LISTEN": "127.0.0.1:0", **self.places}
        with open(self.log, "wb") as log:
            server = subprocess.Popen(["unshare", "-m", "sh", "-e", "-c", script, "sh", *NOBODY, *command], stdout=subprocess.PIPE, stderr=log,
                                      text=True, env=environment, cwd="/")
        self.addCleanup(server.stdout.close)
        self.addCleanup(server.wait, LONGEST)
        self.addCleanup(server.kill)
        return server

    def logged(self):
        with open(self.log, encoding="utf-8") as file:
            return file.read()

    def client_of(self, server):
        said = server.stdout.readline()
        self.assertTrue(said, self.logged())
        self.assertNotIn("token=", said)
        with open(os.path.join(self.places["RUNTIME_DIRECTORY"], "url"), encoding="utf-8") as file:
            return wakesurf.Client(file.read().strip())

    def test_imports_computes_and_keeps_with_nothing_to_write_to_but_its_folders(self):
        server = self.start()
        client = self.client_of(server)
        client.call("dataset.open", dataset="box")
        session = client.session()
        rake = session.rake(line=[(0.5, 1, 2), (0.5, 3, 2)], seeds=4)
        self.assertTrue(session.surface(rake, "stream", dataset="box", to=2, separation=0.5).wait(LONGEST)["complete"])
        for name, kept in (("STATE_DIRECTORY", "token"), ("RUNTIME_DIRECTORY", "url"), ("STATE_DIRECTORY", "sessions.sqlite")):
            there = os.stat(os.path.join(self.places[name], kept))
            self.assertEqual((stat.S_IMODE(there.st_mode), there.st_uid), (0o600, 65534), kept)
        self.assertEqual(stopped(server), 0, self.logged())
        self.assertNotIn("level=error", self.logged())
        again = self.client_of(self.start()).session()
        self.assertEqual([each["rake"] for each in again.state()["rakes"]], [rake.id])

    def test_goes_on_where_its_state_can_only_be_read_from_now_on_and_says_that_edits_are_not_durable(self):
        server = self.start()
        client = self.client_of(server)
        session = client.session()

        def edit():
            return session.api.rake.set(session=session.id, kind="line", points=[(0.5, 1, 2), (0.5, 3, 2)], seeds=4)

        def within(*command):
            subprocess.run(["nsenter", "-t", str(server.pid), "-m", *command, self.places["STATE_DIRECTORY"]], check=True)

        self.assertTrue(edit()["durable"])
        within("mount", "-t", "tmpfs", "-o", "ro", "none")  # one that is open for writing cannot be made read-only
        for _ in range(3):
            answer = edit()
            self.assertFalse(answer["durable"])
            self.assertTrue(answer["hint"])
            self.assertNotIn(self.folder, answer["hint"])
        self.assertEqual(client._request("/healthz")[0], 200)
        within("umount")
        until(lambda: edit()["durable"])
        self.assertEqual(stopped(server), 0)

    def test_does_not_start_where_its_state_can_only_be_read_and_says_why_in_a_line(self):
        server = self.start(read_only=(self.places["STATE_DIRECTORY"],))
        self.assertEqual(server.wait(LONGEST), 1)
        self.assertRegex(self.logged(), r"^wakesurf: [^\n]*cannot be written: Read-only file system[^\n]*\n$")


if __name__ == "__main__":
    unittest.main()
