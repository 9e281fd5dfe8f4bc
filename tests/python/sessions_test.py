"""Sessions by script and by command line: listed, renamed, saved, brought in, deleted, restored; on a server that runs and in
the folder of one that does not."""
import base64
import json
import os
import subprocess
import unittest

from real_server import BINARY, FolderTest, RealServer
import wakesurf

LINE = [(0.2, 0, -1), (1, 0, -1)]
PIXEL = base64.b64decode("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==")


def run(*arguments, **environment):
    """(exit status, standard output, standard error) of `wakesurf sessions ARGUMENTS`."""
    variables = {name: value for name, value in os.environ.items() if name != "WAKESURF_URL"}
    done = subprocess.run([BINARY, "sessions", *arguments], capture_output=True, text=True, timeout=60,
                          env={**variables, **environment})
    return done.returncode, done.stdout, done.stderr


class SessionsTest(FolderTest):
    def setUp(self):
        super().setUp()
        self.state = os.path.join(self.folder, "state")
        self.server = None
        self.start()
        self.addCleanup(self.stop)

    def start(self):
        self.server = RealServer("flow:lamb-oseen", "--state", self.state)
        self.client = wakesurf.Client(self.server.url)

    def stop(self):
        if self.server:
            self.server.stop()
        self.server = None

    def path(self, name):
        return os.path.join(self.folder, name)

    def make(self, name):
        session = self.client.create_session(name)
        rake = session.rake(line=LINE, seeds=9)
        session.surface(rake, "stream", dataset="lamb-oseen", to=2, separation=0.1)
        return session

    @staticmethod
    def document(path):
        """Of a session file, what does not change from one export to the next."""
        with open(path, encoding="utf-8") as file:
            document = json.load(file)
        return {key: value for key, value in document.items() if key not in ("name", "exported")}

    def records(self, session):
        state = session.state()
        return [[{key: value for key, value in each.items() if key not in ("rev", "epoch")} for each in state[group]]
                for group in ("rakes", "surfaces", "bookmarks", "annotations")]

    # By script.

    def test_a_script_lists_renames_deletes_and_restores(self):
        session = self.make("wake")
        listed = {each.id: each.about for each in self.client.sessions()}
        self.assertEqual(listed[session.id]["name"], "wake")
        self.assertEqual((listed[session.id]["rakes"], listed[session.id]["surfaces"]), (1, 1))
        self.assertTrue(listed[session.id]["edited"])
        self.assertFalse(listed["main"]["edited"])
        session.rename("street")
        self.assertEqual(session.state()["name"], "street")
        before = self.records(session)
        session.delete()
        self.assertIn("deletedUntil", session.about)
        with self.assertRaises(wakesurf.NotFound) as raised:
            session.state()
        self.assertIn("`session.api.session.restore()`", raised.exception.hint)
        self.assertEqual([each.id for each in self.client.sessions(trash=True)], [session.id])
        session.restore()
        self.assertEqual(self.records(session), before)
        with self.assertRaises(wakesurf.InvalidParameters):
            self.client.session("main").delete()

    def test_a_script_saves_a_session_and_another_server_takes_it_in(self):
        session = self.make("wake")
        session.call("annotation.set", text="here", position=[0, 0, 0])
        file = session.export(self.path("wake.json"))
        twin = self.client.import_session(file, name="twin")
        self.assertEqual(self.records(twin), self.records(session))
        self.assertEqual(twin.about["notes"], [])
        self.assertEqual(twin.state()["name"], "twin")
        again = twin.export(self.path("again.json"))
        self.assertEqual(self.document(again), self.document(file))
        other = RealServer("flow:abc")
        try:
            stranger = wakesurf.Client(other.url).import_session(file)
            self.assertEqual(len(stranger.about["notes"]), 1, "the dataset is not there")
            self.assertEqual(len(stranger.surfaces()), 1)
        finally:
            other.stop()

    def test_a_file_that_is_longer_than_a_message_comes_in_by_http_only_with_the_servers_token(self):
        session = self.client.create_session("long")
        points = [[0.001 * i, 0.1 + 1 / (i + 3), -1] for i in range(1000)]
        for _ in range(4):
            session.rake(polyline=points, seeds=9)
        file = session.export(self.path("long.json"))
        self.assertGreater(os.path.getsize(file), 128 << 10)
        self.assertEqual(self.records(self.client.import_session(file)), self.records(session))
        address, fragment = session.share("host", 60).split("/#")
        guest = wakesurf.Client(address, token=fragment.split("token=")[1])
        with self.assertRaises(wakesurf.OverLimit):
            guest.import_session(file)
        with open(self.path("short.json"), "w", encoding="utf-8") as short:
            short.write("{}")
        with self.assertRaises(wakesurf.NotPermitted):
            guest.import_session(self.path("short.json"))
        with self.assertRaises(wakesurf.InvalidParameters):
            self.client.import_session(self.path("short.json"))

    def test_a_picture_comes_back_as_it_was_sent(self):
        session = self.client.session("main")
        self.assertIsNone(session.thumbnail())
        session.call("session.thumbnail", image=base64.b64encode(PIXEL).decode())
        self.assertEqual(session.thumbnail(), PIXEL)
        status, headers, _ = self.client._request("/api/v1/sessions/main/thumbnail")
        self.assertEqual((status, headers["Content-Type"]), (200, "image/png"))
        status, _, body = self.client._request("/api/v1/sessions/main/thumbnail",
                                               headers={"If-None-Match": headers["ETag"]})
        self.assertEqual((status, body), (304, b""))

    # By command line.

    def test_the_command_line_does_all_of_it_on_a_server_that_runs(self):
        session = self.make("wake")
        self.everything(session.id, "--url", self.server.url)
        self.assertEqual(run("list", WAKESURF_URL=self.server.url)[0], 0)

    def test_the_command_line_does_all_of_it_in_a_folder_that_no_server_uses(self):
        session = self.make("wake")
        self.stop()
        self.everything(session.id, "--state", self.state)
        self.start()
        names = sorted(each.about["name"] for each in self.client.sessions())
        self.assertEqual(names, ["main", "street", "twin"])
        self.assertEqual(len(self.client.session(session.id).surfaces()), 1)

    def everything(self, session, *where):
        file = self.path("saved.json")
        status, listed, _ = run("list", *where)
        self.assertEqual(status, 0)
        self.assertIn("wake", listed)
        self.assertEqual(run("rename", session, "street", *where)[0], 0)
        self.assertEqual(run("export", session, "-o", file, *where), (0, file + "\n", ""))
        self.assertEqual(run("export", session, "-o", file, *where)[0], 1, "nothing is overwritten unasked")
        status, made, _ = run("import", file, "--name", "twin", *where)
        self.assertEqual(status, 0)
        status, told, _ = run("delete", session, *where)
        self.assertEqual(status, 0)
        self.assertIn("in the trash until 20", told)
        self.assertIn("street", run("list", "--trash", *where)[1])
        self.assertNotIn("street", run("list", *where)[1])
        self.assertEqual(run("restore", session, *where)[0], 0)
        self.assertIn("street", run("list", *where)[1])
        entries = json.loads(run("list", "--json", *where)[1])["sessions"]
        self.assertIn((made.strip(), "twin"), [(each["session"], each["name"]) for each in entries])

    def test_the_command_line_says_in_one_line_what_is_wrong_and_what_to_give(self):
        for arguments, status, words in (
                (["list"], 2, "--url"),
                (["list", "--state", self.state], 1, "--url"),
                (["list", "--state", self.path("none")], 1, "there are no sessions"),
                (["list", "--url", "nonsense"], 2, "http://HOST:PORT"),
                (["list", "--url", "http://127.0.0.1:9/#token=s3cret"], 1, "check that the server is running"),
                (["list", "--url", self.server.url[:-4] + "0000"], 1, "token"),
                (["restore", "session-77", "--url", self.server.url], 1, "in the trash"),
                (["delete", "main", "--url", self.server.url], 1, "cannot be deleted"),
                (["import", self.path("none"), "--url", self.server.url], 1, "cannot read"),
                (["list", "--url", self.server.url, "--state", self.state], 2, "--url"),
                (["nonsense"], 2, "--help")):
            with self.subTest(arguments=arguments):
                got, out, error = run(*arguments)
                self.assertEqual(got, status, error)
                self.assertEqual(error.count("\n"), 1, error)
                self.assertIn(words, error)
                self.assertNotIn("s3cret", error)
                self.assertEqual(out, "")


if __name__ == "__main__":
    unittest.main()
