"""What the server tells of a session, in a loop and with asyncio."""
import asyncio
import threading
import unittest

from real_server import RealServer, ServerTest
import wakesurf
from wakesurf import notifications

LINE = [(0.4, 0.4, 0.1), (0.6, 0.6, 0.1)]


class WatchTest(ServerTest):
    def setUp(self):
        self.session = self.client.create_session("watched")

    def test_gives_records_and_people_as_objects_from_the_moment_it_is_called(self):
        received = self.session.watch("listener", timeout=20)
        rake = self.session.rake(line=LINE, seeds=8)
        first = next(each for each in received if isinstance(each, notifications.SessionPatched))
        self.assertEqual((first.session, first.patches[0]["op"], first.patches[0]["id"]), (self.session.id, "put", rake.id))
        self.assertIn("listener", [each["name"] for each in self.session.state()["participants"]])
        with self.session.connect("Ada") as connection:
            arrived = next(each for each in received if isinstance(each, notifications.PresencePatched))
            self.assertIn("Ada", [each.get("name") for each in arrived.participants])
            connection.api.presence.update(pointer=(0.5, 0.5, 0.5), session=self.session.id)
            pointed = next(each for each in received if isinstance(each, notifications.PresencePatched))
            self.assertEqual(pointed.participants[0]["pointer"], [0.5, 0.5, 0.5])
        received.close()

    def test_fails_with_words_when_nothing_comes_or_the_server_goes(self):
        with self.assertRaises(wakesurf.WaitTimeout):
            next(self.session.watch(timeout=0.3))
        server = RealServer("flow:tornado")
        received = wakesurf.Client(server.url).session().watch(timeout=20)
        server.stop()
        with self.assertRaises(wakesurf.Unreachable):
            for _ in received:
                pass

    def test_with_asyncio_other_work_goes_on_and_leaving_the_loop_ends_it(self):
        async def main():
            ticks = 0

            async def other():
                nonlocal ticks
                while True:
                    ticks += 1
                    await asyncio.sleep(0.005)

            work = asyncio.create_task(other())
            received = self.session.watch_async("listener")
            first = asyncio.create_task(received.__anext__())
            while not [each for each in self.session.state()["participants"] if each["name"] == "listener"]:
                await asyncio.sleep(0.01)
            rake = self.session.rake(line=LINE, seeds=8)
            reported = await first
            while not isinstance(reported, notifications.SessionPatched):
                reported = await received.__anext__()
            self.assertEqual(reported.patches[0]["id"], rake.id)
            await asyncio.wait_for(received.aclose(), 15)  # before the server's next ping could end the wait
            work.cancel()
            return ticks

        self.assertGreater(asyncio.run(main()), 1)
        self.assertNotIn("wakesurf-watch", [each.name for each in threading.enumerate()])

    def test_what_a_newer_server_tells_is_given_as_it_is(self):
        from wakesurf.notifications import notification_of
        reported = notification_of("weather.changed", {"rain": True})
        self.assertEqual((reported.name, reported.params), ("weather.changed", {"rain": True}))
        known = notification_of("session.patched", {"session": "s", "seq": 1, "patches": [], "more": 2})
        self.assertEqual(known, notifications.SessionPatched("s", 1, []))


class StudyTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = RealServer("flow:tornado")
        cls.session = wakesurf.Client(cls.server.url).session()

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()

    def everything(self):
        state = self.session.state()
        return {name: state[name] for name in ("rakes", "surfaces", "bookmarks", "annotations", "clock")}, \
            [each.id for each in self.session.client.sessions()], [each.id for each in self.session.client.sessions(trash=True)]

    def test_has_a_case_for_each_combination_and_leaves_nothing_behind(self):
        self.session.suggested("stream")
        before, reported, rows = self.everything(), [], []
        study = self.session.study({"line": LINE}, {"seeds": [8, 16], "separation": [0.1, 0.05, 0.025]}, kind="path", dataset="tornado",
                                   to=1, progress=reported.append)
        for case in study:
            self.assertEqual(len(case.mesh().points), case.statistics["vertices"])
            rows.append(case.row())
        self.assertEqual([(row["seeds"], row["separation"]) for row in rows],
                         [(8, 0.1), (8, 0.05), (8, 0.025), (16, 0.1), (16, 0.05), (16, 0.025)])
        self.assertTrue(rows[0]["quads"] < rows[1]["quads"] < rows[2]["quads"])
        (coarse,) = self.session.study({"line": LINE}, {"max_quads": [500]}, kind="path", dataset="tornado", to=1, separation=0.02)
        row = coarse.row()
        self.assertEqual((row["separation"], row["requestedSeparation"], row["max_quads"]), (coarse.statistics["separation"], 0.02, 500))
        self.assertGreater(row["separation"], 0.02)
        self.assertEqual(reported[-1].share, 1.0)
        self.assertEqual(self.everything(), before)
        self.assertFalse(self.session.undo()["skipped"])

    def test_leaves_nothing_behind_where_a_case_fails_or_the_loop_is_left(self):
        before = self.everything()
        with self.assertRaises(wakesurf.InvalidParameters):
            list(self.session.study({"line": LINE}, {"separation": [0.1, -1]}, kind="path", dataset="tornado", to=1))
        for _ in self.session.study({"line": LINE}, {"separation": [0.1, 0.05]}, kind="path", dataset="tornado", to=1):
            break
        self.assertEqual(self.everything(), before)

    def test_says_what_cannot_be_varied(self):
        for vary, more, words in (({}, {}, "nothing is varied"), ({"separation": []}, {}, "nothing is varied"),
                                  ({"to": [1, 2]}, {"to": 1}, "`to` is varied and given"), ({"to": [1]}, {"seeds": 3}, "belongs to the rake"),
                                  ({"seperation": [1]}, {"to": 1}, "did you mean `separation`")):
            with self.assertRaisesRegex(wakesurf.InvalidParameters, words):
                list(self.session.study({"line": LINE}, vary, kind="path", dataset="tornado", **more))


if __name__ == "__main__":
    unittest.main()
