"""The table by which hints name tools for methods (mcp/name_mapping) beside what the tools send when they work."""
import tempfile
import unittest
from collections import defaultdict
from unittest import mock

from real_server import RealServer
from wakesurf.client import Client
from wakesurf.connection import Connection
from wakesurf.mcp.name_mapping import TOOL_OF, hint_in_tools
from wakesurf.mcp.server import TOOLS
from wakesurf.mcp.tool import Call
from wakesurf.mcp.work import Place, Work
from wakesurf.name_mapping import names

LINE = [[0.4, 0.4, 0.1], [0.6, 0.6, 0.1]]
# Each tool at its work, but picture and film: what these send is the page's.
CALLS = (("open", {"session": "new"}), ("suggest", {}), ("rake", {"points": LINE}), ("surface", {"kind": "stream", "rake": "r1", "to": 1}),
         ("surface", {"surface": "s1", "to": 2}), ("wait", {}), ("numbers", {}), ("compare", {"a": "s1"}), ("explain", {}),
         ("export", {"path": "a.vtp"}), ("open", {}), ("surface", {"surface": "s1", "delete": True}), ("undo", {}), ("undo", {"redo": True}),
         ("rake", {"rake": "r1", "delete": True}))
# What `open` tells by another method, and what it does only while a dataset is being imported.
OTHERWISE = {"rake.list", "surface.list", "dataset.open"}


class McpWordsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """What each tool sends, and the last that it answers."""
        cls.sent, cls.answers = defaultdict(set), {}
        server = RealServer("flow:tornado")
        cls.addClassCleanup(server.stop)
        tool = ""

        def noted(function):
            def call(self, method, *positional, **named):
                cls.sent[tool].add(method)
                return function(self, method, *positional, **named)
            return call

        with tempfile.TemporaryDirectory() as folder, mock.patch.object(Client, "call", noted(Client.call)), \
                mock.patch.object(Connection, "start", noted(Connection.start)):
            work = Work([], server.url, None, Place(folder))
            for tool, given in CALLS:
                TOOLS[tool].check(given)
                cls.answers[tool] = TOOLS[tool].function(work, given, Call()).numbers

    def test_names_tools_and_methods_that_there_are(self):
        self.assertLessEqual(set(TOOL_OF.values()), set(TOOLS))
        self.assertLessEqual(set(TOOL_OF), set(names()[0]))

    def test_names_a_tool_that_does_what_the_method_does(self):
        for method in set(TOOL_OF) - OTHERWISE:
            with self.subTest(method):
                self.assertIn(method, self.sent[TOOL_OF[method]])
        self.assertEqual((self.answers["open"]["rakes"], [each["surface"] for each in self.answers["open"]["surfaces"]]), (["r1"], ["s1"]))

    def test_has_every_method_that_a_tool_sends(self):
        sent = {method: tool for tool, methods in self.sent.items() for method in methods if method not in ("session.join", "server.info")}
        self.assertEqual({method: tool for method, tool in sent.items() if method not in TOOL_OF}, {})

    def test_leaves_a_hint_out_that_no_tool_could_follow(self):
        self.assertEqual(hint_in_tools("`session.state` lists them"), "the tool `open` lists them")
        self.assertEqual(hint_in_tools("revoke some with `session.unshare`"), "")


if __name__ == "__main__":
    unittest.main()
