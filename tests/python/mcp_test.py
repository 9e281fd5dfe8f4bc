"""The tools for AI agents, as a client has them: over the standard streams of the real program."""
import base64
import ctypes
import json
import os
import re
import signal
import sys
import tempfile
import unittest

from mcp_client import Agent
from real_server import BINARY, ROOT, RealServer
import wakesurf

NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e-?\d+)?")
LINE = [[0.4, 0.4, 0.1], [0.6, 0.6, 0.1]]


class McpCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def agent(self, *arguments, **more):
        agent = Agent(*arguments, folder=self.folder, **more)
        self.addCleanup(agent.__exit__)
        return agent


class ProtocolTest(McpCase):
    """Nothing here needs a flow, so no server is started."""

    def test_agrees_on_the_version_that_the_client_asks_for_or_offers_its_newest(self):
        for asked, agreed in (("2025-06-18", "2025-06-18"), ("2024-11-05", "2024-11-05"), ("2031-01-01", "2025-06-18")):
            result = self.agent("flow:tornado").begin(asked)
            self.assertEqual(result["protocolVersion"], agreed)
            self.assertEqual(result["serverInfo"]["name"], "wakesurf")
            self.assertIn("tools", result["capabilities"])

    def test_lists_twelve_tools_whose_arguments_are_described(self):
        agent = self.agent("flow:tornado")
        agent.begin()
        tools = {each["name"]: each for each in agent.ask("tools/list")["result"]["tools"]}
        self.assertEqual(list(tools), ["open", "suggest", "rake", "surface", "wait", "numbers", "compare", "picture", "film", "export",
                                       "explain", "undo"])
        surface = tools["surface"]["inputSchema"]["properties"]
        self.assertEqual(surface["kind"]["enum"], ["stream", "path", "streak", "time", "level"])
        self.assertEqual(surface["max_quads"], {"type": "integer", "description": surface["max_quads"]["description"]})
        self.assertIn("dataset's unit of length", surface["separation"]["description"])
        for tool in tools.values():
            for name, each in tool["inputSchema"]["properties"].items():
                self.assertTrue(each["type"], (tool["name"], name))
        self.assertEqual({name for name, each in tools.items() if each["annotations"]["readOnlyHint"]},
                         {"suggest", "wait", "numbers", "compare", "explain"})

    def test_says_what_is_wrong_with_a_message_and_goes_on(self):
        agent = self.agent("flow:tornado")
        cases = (("{", -32700, "not JSON"), (b"\xff\xfe{}", -32700, "not JSON"), ('{"jsonrpc":"2.0","id":1,"method":"ping","params":{"x":NaN}}',
                 -32700, "NaN"), ("[" * 100_000, -32700, "not JSON"), ("[]", -32600, "2025-03-26"), ("7", -32600, "jsonrpc"),
                 ('{"id":1,"method":"ping"}', -32600, "jsonrpc"), ('{"jsonrpc":"2.0","id":{},"method":"ping"}', -32600, "an id"),
                 ('{"jsonrpc":"2.0","id":1,"method":"ping","params":[]}', -32602, "object"),
                 ('{"jsonrpc":"2.0","id":1,"method":"resources/list"}', -32601, "resources/list"),
                 ('{"jsonrpc":"2.0","id":1,"method":"initialize"}', -32602, "protocolVersion"),
                 ('{"jsonrpc":"2.0","id":1,"method":"tools/call","params":{"name":"rm"}}', -32602, "there is no tool `rm`"),
                 ('{"jsonrpc":"2.0","id":1,"method":"tools/call","params":{"name":"wait","arguments":[1]}}', -32602, "object"),
                 ('"' + "x" * (3 << 20) + '"', -32600, "longer than 1048576"))
        for text, code, words in cases:
            agent.write(text)
            error = agent.read()["error"]
            self.assertEqual((error["code"], words in error["message"]), (code, True), error)
        self.assertEqual(agent.ask("ping")["result"], {})

    def test_ignores_notifications_it_does_not_know_answers_and_empty_lines(self):
        agent = self.agent("flow:tornado")
        agent.notify("notifications/roots/list_changed")
        agent.notify("notifications/cancelled", requestId=99)
        agent.notify("notifications/cancelled", requestId=[])
        agent.write('{"jsonrpc":"2.0","id":5,"result":{}}')
        agent.write("")
        self.assertEqual(agent.ask("ping")["result"], {})

    def test_answers_several_messages_in_one_where_the_version_has_that(self):
        agent = self.agent("flow:tornado")
        agent.begin("2025-03-26")
        agent.write(json.dumps([{"jsonrpc": "2.0", "id": "a", "method": "ping"}, {"jsonrpc": "2.0", "method": "notifications/initialized"},
                                {"jsonrpc": "2.0", "id": "b", "method": "nothing"}]))
        answers = {each["id"]: each for each in agent.read()}
        self.assertEqual((answers["a"]["result"], answers["b"]["error"]["code"]), ({}, -32601))

    def test_says_in_each_tool_that_there_is_no_server_and_stays(self):
        agent = self.agent("/nowhere/case.foam")
        self.assertIn("case.foam", agent.refusal("open"))
        self.assertIn("case.foam", agent.refusal("suggest"))
        agent = self.agent("flow:tornado", environment={"WAKESURF": "/nowhere/wakesurf"})
        self.assertIn("is not a program", agent.refusal("open"))
        agent = self.agent("--url", "http://127.0.0.1:9/#token=x")
        self.assertIn("no answer from http://127.0.0.1:9", agent.refusal("open"))


class ToolsTest(McpCase):
    def setUp(self):
        super().setUp()
        server = RealServer("flow:tornado")
        self.addCleanup(server.stop)
        self.url = server.url
        self.person = wakesurf.Client(self.url).session()

    def on_server(self, environment=(), **more):
        return self.agent(environment={"WAKESURF_URL": self.url, **dict(environment)}, **more)

    def test_works_in_the_session_that_people_look_at(self):
        agent = self.on_server()
        self.assertEqual(agent.numbers("open")["dataset"]["dataset"], "tornado")
        rake = agent.numbers("rake", points=LINE, seeds=12)
        self.assertEqual(self.person.rakes()[0].record()["seeds"], 12)
        made = agent.numbers("surface", rake=rake["rake"], kind="path", to=1, separation=0.1, **{"from": 0})
        record = self.person.surfaces()[0].record()
        self.assertEqual((made["surface"], record["to"], record["separation"]), (record["surface"], 1, 0.1))
        self.assertTrue(agent.numbers("wait")["complete"])
        changed = agent.numbers("rake", rake=rake["rake"], seeds=24)
        self.assertEqual((changed["seeds"], changed["surfaces"]), (24, [made["surface"]]))
        agent.numbers("surface", surface=made["surface"], separation=0.05)
        self.assertEqual(self.person.surfaces()[0].record()["separation"], 0.05)
        self.assertIn("Taken back: surface", agent.call("undo")["content"][0]["text"])
        self.assertEqual(self.person.surfaces()[0].record()["separation"], 0.1)
        agent.numbers("undo", redo=True)
        agent.numbers("surface", surface=made["surface"], delete=True)
        agent.numbers("rake", rake=rake["rake"], delete=True)
        self.assertEqual((self.person.surfaces(), self.person.rakes()), ([], []))
        self.assertEqual(agent.numbers("open", session="new")["rakes"], [])
        self.assertNotEqual(agent.numbers("open")["session"], "main")

    def test_numbers_are_those_of_the_mesh_and_two_equal_surfaces_are_no_distance_apart(self):
        agent = self.on_server()
        first = agent.numbers("surface", kind="path", to=1, separation=0.1, **{"from": 0})
        agent.numbers("wait")
        numbers = agent.numbers("numbers")
        mesh = self.person.surfaces()[0].mesh()
        self.assertEqual(numbers["vertices"], len(mesh.points))
        self.assertAlmostEqual(numbers["area"], mesh.areas(mesh.triangles()).sum(), delta=1e-5 * numbers["area"])
        self.assertAlmostEqual(numbers["fields"]["speed"]["max"], mesh["speed"].max(), delta=1e-5)
        self.assertAlmostEqual(numbers["bounds"][5], mesh.points[:, 2].max(), delta=1e-5)
        second = agent.numbers("surface", kind="path", to=1, separation=0.05, rake=first["rake"], **{"from": 0})
        agent.numbers("wait")
        same = agent.numbers("compare", a=first["surface"])
        self.assertEqual((same["area"]["ratio"], same["distance"]["a_from_b"]["max"] < 1e-12), (1.0, True))
        finer = agent.numbers("compare", a=first["surface"], b=second["surface"])
        self.assertLess(finer["distance"]["a_from_b"]["max"], 0.05)
        self.assertGreater(finer["vertices"]["b"], finer["vertices"]["a"])
        self.assertIn("reached the end of the time", agent.call("explain", surface=first["surface"])["content"][0]["text"])

    def test_says_what_is_wrong_with_the_arguments_of_each_tool(self):
        agent = self.on_server()
        for tool, arguments, words in (
                ("open", {"session": "session-99"}, "session-99"), ("open", {"dataset": "other"}, "name one: tornado"),
                ("open", {"seconds": "long"}, "`seconds` is not of the type number"), ("suggest", {"data": "x"}, "did you mean `dataset`"),
                ("rake", {}, "rake needs `points`"), ("rake", {"points": [[0, 0]]}, "`points[0]` has 2 items, not 3"),
                ("rake", {"points": [[0, 0, 0], [1, True, 0]]}, "`points[1][1]`"), ("rake", {"delete": True}, "delete needs `rake`"),
                ("rake", {"points": [[7, 7, 7], [8, 8, 8]]}, "outside"), ("rake", {"rake": "r99", "seeds": 4}, "r99"),
                ("surface", {}, "needs `kind`"), ("surface", {"kind": "smoke"}, "not one of stream, path, streak"),
                ("surface", {"kind": "path", "rake": "r99"}, "r99"), ("surface", {"kind": "stream", "seperation": 1}, "did you mean `separation`"),
                ("surface", {"kind": "stream", "separation": -1}, "separation"), ("surface", {"surface": "s9", "to": 1}, "no surface"),
                ("wait", {}, "make one with the tool"), ("wait", {"seconds": -1}, "0 to 3600"), ("numbers", {"surface": "s9"}, "no surface"),
                ("compare", {}, "compare needs `a`"), ("compare", {"a": "s9"}, "no surface"), ("explain", {"why": 1}, "not an argument"),
                ("picture", {"width": 10}, "64 to 4096"), ("picture", {"camera": {"positon": [0, 0, 1]}}, "did you mean `position`"),
                ("picture", {"look": {"color_by": "age"}}, "did you mean `colour_by`"),
                ("picture", {"look": {"map": "jet"}}, "not one of viridis, cividis"), ("picture", {"background": "black"}, "not one of shown, white, clear"),
                ("picture", {"camera": {"position": [1, 1, 1]}}, "a camera needs `target`"), ("picture", {"path": "a.jpg"}, "one of .png"),
                ("film", {"path": "film", "from": 0}, "film needs `to`"), ("film", {"path": "a.gif", "from": 0, "to": 1}, ".webm"),
                ("export", {}, "export needs `path`"), ("undo", {"steps": 2}, "not an argument")):
            with self.subTest(tool, **arguments):
                self.assertIn(words, agent.refusal(tool, **arguments))
        self.assertEqual(agent.ask("ping")["result"], {})
        self.assertEqual(self.person.rakes(), [], "none is left of a surface that was refused")

    def test_refuses_pictures_and_films_of_what_the_data_do_not_have_and_leaves_nothing(self):
        agent = self.on_server(environment={"WAKESURF_CHROMIUM": sys.executable})  # no browser, but a program
        agent.numbers("surface", kind="path", to=1, separation=0.1)
        for tool, arguments, words in (("picture", {"look": {"colour_by": "jet"}}, "there are speed, age"), ("picture", {"time": 99}, "0 to 10"),
                                       ("film", {"path": "film", "from": 0, "to": 11}, "0 to 10"),
                                       ("film", {"path": "film", "from": 0, "to": 1, "look": {"colour_by": "field:x"}}, "there are speed, age")):
            self.assertIn(words, agent.refusal(tool, **arguments))
        self.assertEqual([each.id for each in self.person.client.sessions()], ["main"])
        self.assertEqual(sorted(os.listdir(self.folder)), ["store"] if os.path.exists(os.path.join(self.folder, "store")) else [])

    def test_deletes_and_takes_back_only_what_is_named_or_was_done_by_its_link(self):
        surface = self.person.surface(self.person.rake(line=LINE), "stream", dataset="tornado", to=1, separation=0.1)
        agent = self.agent("--url", self.person.share("editor"))
        self.assertIn("delete needs `surface`", agent.refusal("surface", delete=True))
        self.assertEqual(agent.numbers("undo")["changes"], [])
        self.assertEqual([each.id for each in self.person.surfaces()], [surface.id])

    def test_writes_below_its_folder_only_and_not_over_what_others_made(self):
        agent = self.on_server()
        agent.numbers("surface", kind="stream", to=1, separation=0.1)
        with tempfile.TemporaryDirectory() as elsewhere:
            os.symlink(elsewhere, os.path.join(self.folder, "out"))
            for path in ("../a.vtp", os.path.join(elsewhere, "a.vtp"), "out/a.vtp", "x/../../a.vtp"):
                self.assertIn("not below the folder", agent.refusal("export", path=path))
            self.assertIn("one of .vtp", agent.refusal("export", path=".bashrc"))
            for hidden in ("a\0.vtp", "a\u202eptv.exe.vtp", "a\x1b[2J.vtp"):
                self.assertIn("not a file name", agent.refusal("export", path=hidden))
            for long in (300 * "a" + ".vtp", 600 * "c/" + "a.vtp"):
                refusal = agent.refusal("export", path=long)
                self.assertIn("too long", refusal)
                self.assertNotIn(self.folder, refusal)
            self.assertEqual(os.listdir(elsewhere), [])
        self.assertEqual(agent.numbers("export", path="made/wake.vtp")["path"], "made/wake.vtp")
        self.assertGreater(agent.numbers("export", path=os.path.join(self.folder, "made/wake.vtp"))["bytes"], 1000)
        kept = os.path.join(self.folder, "kept.obj")
        with open(kept, "w", encoding="utf-8") as file:
            file.write("mine")
        self.assertIn("there already", agent.refusal("export", path="kept.obj"))
        self.assertEqual(os.path.getsize(kept), 4)
        agent.numbers("export", path="kept.obj", overwrite=True)

    def test_says_what_to_do_in_the_words_of_its_tools(self):
        agent = self.on_server()
        agent.numbers("surface", kind="stream", to=2, separation=0.05, max_quads=1)
        said = agent.refusal("wait")
        self.assertIn("raise `max_quads`", said)
        rake = agent.refusal("surface", kind="stream", rake="r99", to=1)
        self.assertIn("the tool `open` lists them", rake)
        self.assertNotIn("rake.list", rake)
        seeds = agent.refusal("rake", points=LINE, seeds=1)
        self.assertNotIn("help(", seeds)
        self.assertNotIn("rpc.discover", seeds)

    def test_writes_no_file_that_a_link_beside_it_names(self):
        agent = self.on_server()
        agent.numbers("surface", kind="stream", to=1, separation=0.1)
        with tempfile.TemporaryDirectory() as elsewhere:
            victim = os.path.join(elsewhere, "victim")
            with open(victim, "w", encoding="utf-8") as file:
                file.write("mine")
            os.symlink(victim, os.path.join(self.folder, "a.vtp.part"))
            agent.numbers("export", path="a.vtp")
            self.assertEqual(os.path.getsize(victim), 4)
            self.assertTrue(os.path.isfile(os.path.join(self.folder, "a.vtp")))
            self.assertFalse(os.path.islink(os.path.join(self.folder, "a.vtp")))

    def test_may_do_what_its_link_may(self):
        self.person.surface(self.person.rake(line=LINE), "stream", dataset="tornado", to=1, separation=0.1)
        agent = self.agent("--url", self.person.share("viewer"))
        self.assertTrue(agent.numbers("wait")["complete"])
        self.assertGreater(agent.numbers("numbers")["area"], 0)
        for tool, arguments in (("rake", {"points": LINE}), ("surface", {"kind": "stream"}), ("undo", {}), ("open", {"session": "new"})):
            self.assertRegex(agent.refusal(tool, **arguments), "viewer|share link", tool)
        self.assertEqual(len(self.person.rakes()), 1)

    def test_tells_how_far_it_is_and_gives_up_what_is_cancelled(self):
        agent = self.on_server()
        agent.numbers("surface", kind="streak", to=12, separation=0.004, max_quads=4_000_000, accuracy="exact")
        number = agent.start("tools/call", name="wait", arguments={"seconds": 600}, _meta={"progressToken": "p"})
        self.assertEqual(agent.ask("ping")["result"], {})  # while it waits
        agent.notify("notifications/cancelled", requestId=number, reason="enough")
        short = agent.numbers("wait", seconds=0)
        self.assertFalse(short["complete"])
        agent.numbers("surface", surface=short["surface"], to=1, separation=0.2)
        agent.start("tools/call", name="wait", arguments={}, _meta={"progressToken": 7})
        self.assertTrue(agent.read()["result"]["structuredContent"]["complete"])
        last = [each["params"] for each in agent.notifications if each["params"]["progressToken"] == 7][-1]
        self.assertEqual((last["progress"], last["total"]), (100, 100))

    def test_draws_a_picture_and_a_film(self):
        agent = self.on_server()
        agent.numbers("surface", kind="path", to=1, separation=0.1, **{"from": 0})
        content = agent.call("picture", width=320, height=200, look={"colour_by": "age"}, path="a.png")["content"]
        self.assertEqual(content[2]["mimeType"], "image/png")
        data = base64.b64decode(content[2]["data"])
        with open(os.path.join(self.folder, "a.png"), "rb") as file:
            self.assertEqual(file.read(), data)
        self.assertTrue(data.startswith(b"\x89PNG"))
        agent.numbers("film", path="film", frames=2, width=320, height=200, **{"from": 0.5, "to": 1})
        agent.numbers("film", path="film", frames=1, width=320, height=200, **{"from": 0.5, "to": 1})
        self.assertEqual(os.listdir(os.path.join(self.folder, "film")), ["frame_0000.png"], "nothing of the longer film is left")
        agent = self.agent(environment={"WAKESURF_URL": self.url, "WAKESURF_CHROMIUM": "/nowhere"})
        self.assertIn("is not a program", agent.refusal("picture"))


class TranscriptTest(McpCase):
    """docs/how-to/agents.md: an agent finds the wake of the bundled simulation."""

    def calls(self):
        """(tool, arguments, answer) of each call in the document."""
        with open(os.path.join(ROOT, "docs/how-to/agents.md"), encoding="utf-8") as file:
            transcript = file.read().split("```text\n")[1].split("```")[0]
        for each in transcript.split("> ")[1:]:
            call, answer = each.strip().split("\n", 1)
            tool, arguments = call.split(" ", 1)
            yield tool, json.loads(arguments), answer

    def test_is_what_the_program_answers(self):
        agent = self.agent()
        agent.begin()
        tools = []
        for tool, arguments, answer in self.calls():
            with self.subTest(tool, **arguments):
                result = agent.call(tool, **arguments)
                said = result["content"][0]["text"]
                self.assertEqual(NUMBER.sub("#", said), NUMBER.sub("#", answer))
                for here, there in zip(NUMBER.findall(said), NUMBER.findall(answer)):
                    self.assertAlmostEqual(float(here), float(there), delta=0.02 * abs(float(there)) + 1e-9, msg=said)
                self.assertEqual(json.loads(result["content"][1]["text"]), result["structuredContent"])
                tools.append(tool)
        self.assertEqual(tools, ["open", "suggest", "surface", "wait", "numbers", "compare", "explain", "picture", "export", "rake", "undo"])
        with open(os.path.join(self.folder, "wake.vtp"), "rb") as file:
            mesh = wakesurf.Mesh.from_vtp(file.read())
        self.assertGreater(mesh["q_criterion"].max(), 3, "there are vortices on it")
        self.assertTrue(os.path.getsize(os.path.join(self.folder, "wake.png")) > 50_000)


class EndTest(McpCase):
    def test_ends_its_server_when_the_client_has_gone_or_says_so(self):
        for way in ("gone", signal.SIGTERM, signal.SIGHUP, "input, then terminated", "a thread that does not read the input"):
            with self.subTest(way):
                agent = self.agent("flow:tornado")
                agent.numbers("surface", kind="streak", to=12, separation=0.004, max_quads=4_000_000)
                agent.start("tools/call", name="wait", arguments={"seconds": 600})
                server = self.child(agent.process.pid)
                if way in ("gone", "input, then terminated"):
                    agent.process.stdin.close()
                if way == "gone":
                    agent.process.stdout.close()
                elif way == "a thread that does not read the input":
                    agent.ask("ping")  # then the main thread reads the input again
                    thread = max(int(each) for each in os.listdir(f"/proc/{agent.process.pid}/task"))
                    self.assertEqual(ctypes.CDLL(None).tgkill(agent.process.pid, thread, signal.SIGTERM), 0)
                else:
                    agent.process.send_signal(signal.SIGTERM if isinstance(way, str) else way)
                self.assertEqual(agent.process.wait(timeout=60), 0)
                self.assertFalse(os.path.exists(f"/proc/{server}"))

    def test_answers_all_that_it_was_asked_before_its_input_ended(self):
        calls = (("open", {}), ("rake", {"points": LINE, "seeds": 12}), ("surface", {"kind": "path", "to": 2, "separation": 0.02}), ("wait", {}),
                 ("numbers", {}), ("numbers", {"surface": "s9"}), ("export", {"path": "a.ply"}))
        lines = [{"jsonrpc": "2.0", "id": i, "method": "tools/call", "params": {"name": name, "arguments": given}}
                 for i, (name, given) in enumerate(calls)]
        agent = self.agent("flow:tornado")
        agent.process.stdin.write("\n".join(map(json.dumps, lines)).encode())  # nor is there an end of the last line
        agent.process.stdin.close()
        answers = [json.loads(line) for line in agent.process.stdout]
        self.assertEqual([each["id"] for each in answers], list(range(len(calls))))
        self.assertEqual([each["result"]["isError"] for each in answers], [name == "numbers" and "surface" in given for name, given in calls])
        self.assertTrue(answers[3]["result"]["structuredContent"]["complete"])
        self.assertEqual(agent.process.wait(timeout=60), 0)

    def child(self, process):
        """The only one; the kernel lists them by the thread that started them."""
        found = ""
        for thread in os.listdir(f"/proc/{process}/task"):
            with open(f"/proc/{process}/task/{thread}/children", encoding="utf-8") as file:
                found += file.read()
        (child,) = found.split()
        return child

    def test_is_a_command_of_the_program_whatever_lies_in_the_folder(self):
        for name in ("wakesurf.py", "json.py"):
            with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
                file.write("raise SystemExit('this is not it')")
        agent = self.agent("flow:tornado", command=(BINARY, "mcp"), environment={"PYTHONPATH": ""})
        self.assertEqual(agent.begin()["serverInfo"]["version"], wakesurf.__version__)
        self.assertEqual(agent.numbers("open")["dataset"]["dataset"], "tornado")


if __name__ == "__main__":
    unittest.main()
