"""What people and files call things never acts: neither in a session nor on a terminal."""
import os
import subprocess
import tempfile
import unittest
import urllib.parse

from real_server import BINARY, FolderTest, ServerTest
import wakesurf

ACTS = "A\u202eB\u2066C\u200bD\ufeffE\U000e0041F\x85G"
SHOWN = "ABCDEFG"
TITLE = "p\x1b]0;owned\x07"

VTI = """<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian"><ImageData WholeExtent="0 2 0 2 0 2" Origin="0 0 0"
Spacing="1 1 1"><Piece Extent="0 2 0 2 0 2"><PointData>
<DataArray type="Float32" Name="U" NumberOfComponents="3" format="ascii">{0}</DataArray>
<DataArray type="Float32" Name="q\u202ep" format="ascii">{1}</DataArray></PointData></Piece></ImageData></VTKFile>
""".format("1 0 0 " * 27, "1 " * 27)


class NamesOfPeople(ServerTest):
    datasets = ("flow:abc",)

    def test_are_cleaned_wherever_they_are_typed(self):
        session = self.client.create_session(ACTS)
        api = session.api
        rake = session.rake(line=[(0, 0, 0), (1, 0, 0)], seeds=4, name=ACTS)
        view = {"position": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0]}
        api.bookmark.set(session=session.id, name=ACTS, view={"camera": view})
        api.annotation.set(session=session.id, text=ACTS + "\nsecond line", position=[0, 0, 0])
        state = session.state()
        self.assertEqual(state["rakes"][0]["name"], SHOWN, rake)
        self.assertEqual(state["bookmarks"][0]["name"], SHOWN)
        self.assertEqual(state["annotations"][0]["text"], SHOWN + "\nsecond line")
        self.assertEqual(state["name"] if "name" in state else SHOWN, SHOWN)

    def test_are_cleaned_where_a_session_comes_from_a_file(self):
        session = self.client.create_session("to be changed")
        session.rake(line=[(0, 0, 0), (1, 0, 0)], seeds=4, name="plain")
        document = session.api.session.export(session=session.id)["file"]
        document["records"]["rakes"][0]["name"] = ACTS
        document["name"] = ACTS
        made = self.client.api.session.import_(file=document)
        self.assertEqual((made["name"], self.client.session(made["session"]).state()["rakes"][0]["name"]), (SHOWN, SHOWN))

    def test_that_hold_nothing_else_are_none(self):
        session = self.client.create_session("empty")
        rake = session.rake(line=[(0, 0, 0), (1, 0, 0)], seeds=4, name="\u200b\u202e")
        self.assertEqual(session.state()["rakes"][0]["name"], rake.id)


class TextOnATerminal(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def run_command(self, *arguments):
        done = subprocess.run([BINARY, *arguments], capture_output=True, timeout=60, check=False)
        said = (done.stdout + done.stderr).decode()
        for sign in ("\x1b", "\x07", "\u202e", "\x9b"):
            self.assertNotIn(sign, said.replace("\r\x1b[K", ""), arguments)
        return said

    def test_names_of_files_and_fields_do_not_act(self):
        path = os.path.join(self.folder, TITLE + ".vti")
        with open(path, "w", encoding="utf-8") as file:
            file.write(VTI)
        self.assertIn("field", self.run_command("info", path))
        self.run_command("info", "--json", path)
        self.run_command("import", path, os.path.join(self.folder, "store"))
        self.assertIn("q\\u202ep", self.run_command("info", os.path.join(self.folder, "store")))
        with open(path, "w", encoding="utf-8") as file:
            file.write(VTI[:300])
        self.run_command("info", path)
        self.run_command("surface", path, "--kind", "stream", "-o", os.path.join(self.folder, "a.ply"))
        self.run_command("info", os.path.join(self.folder, "none" + TITLE))
        self.run_command("info", "flow:" + TITLE)
        self.run_command("info" + TITLE)

    def test_a_foreign_database_does_not_act(self):
        for content in (b"SQLite format 3\0\x1b]0;owned\x07" * 200, b"\x1b]0;owned\x07" * 4000):
            state = tempfile.mkdtemp(dir=self.folder)
            with open(os.path.join(state, "sessions.sqlite"), "wb") as file:
                file.write(content)
            self.run_command("state", "check", state)
            self.run_command("sessions", "list", "--state", state)
            self.run_command("serve", "flow:abc", "--state", state, "--listen", "127.0.0.1:0")

    def test_a_database_with_a_table_that_acts_does_not(self):
        import sqlite3
        state = tempfile.mkdtemp(dir=self.folder)
        subprocess.run([BINARY, "state", "check", state], capture_output=True, check=False)
        with sqlite3.connect(os.path.join(state, "sessions.sqlite")) as database:
            database.execute("CREATE TABLE \"x\x1b]0;owned\x07\" (a CHECK (a > 1))")
            database.execute("PRAGMA writable_schema = ON")
            database.execute("UPDATE sqlite_master SET sql = 'nonsense' WHERE name LIKE 'x%'")
        database.close()
        self.run_command("state", "check", state)
        self.run_command("sessions", "list", "--state", state)


class TextInTheLog(FolderTest):
    def test_of_data_sessions_people_and_requests_does_not_act_and_ends_no_line(self):
        acts = "p\x1b]0;owned\x07\u202e\x9b\nlevel=error event=owned"
        path = os.path.join(self.folder, acts + ".vti")
        with open(path, "w", encoding="utf-8") as file:
            file.write(VTI)
        with open(os.path.join(self.folder, acts + "-cut.vti"), "w", encoding="utf-8") as file:
            file.write(VTI[:300])
        log = os.path.join(self.folder, "log")
        with open(log, "wb") as file:
            server = subprocess.Popen([BINARY, "serve", path, os.path.join(self.folder, acts + "-cut.vti"), "--store", os.path.join(self.folder, "store"),
                                       "--listen", "127.0.0.1:0", "--log-level", "debug"], stdout=subprocess.PIPE, stderr=file, text=True)
        self.addCleanup(server.stdout.close)
        client = wakesurf.Client(server.stdout.readline().split()[1])
        for each in client.call("dataset.list")["datasets"]:
            try:
                client.call("dataset.open", dataset=each["dataset"])
            except wakesurf.WakesurfError as problem:
                self.assertNotIn("\x1b", str(problem))
        session = client.create_session("a\u202eb <b>\"'")
        for method, given in (("no" + acts, {}), ("session.state", {"session": acts}), ("dataset.open", {"dataset": acts}),
                              ("session.rename", {"session": session.id, "name": acts})):
            with self.assertRaises(wakesurf.WakesurfError):
                client.call(method, **given)
        for target in ("/" + acts, "/api/v1/sessions/" + acts + "/surfaces/s1/mesh.vtp"):
            self.assertIn(client._request(urllib.parse.quote(target))[0], (400, 404))
        server.terminate()
        self.assertEqual(server.wait(60), 0)
        with open(log, encoding="utf-8") as file:
            lines = file.read()
        for sign in ("\x1b", "\x07", "\u202e", "\x9b"):
            self.assertNotIn(sign, lines)
        self.assertNotIn("\nlevel=error event=owned", lines)
        self.assertGreater(lines.count("\n"), 3)


if __name__ == "__main__":
    unittest.main()
