"""The examples of the client's docstrings, against the real server."""
import doctest
import importlib
import os
import pkgutil
import tempfile
import unittest

import numpy as np

from real_server import BINARY, RealServer
import wakesurf

LINE = [(0.4, 0.4, 0.1), (0.6, 0.6, 0.1)]
OPTIONS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE | doctest.IGNORE_EXCEPTION_DETAIL


def modules():
    for each in pkgutil.walk_packages(wakesurf.__path__, "wakesurf."):
        yield importlib.import_module(each.name)


class DocstringTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        os.environ["WAKESURF"] = BINARY
        cls.server = RealServer("flow:tornado")
        cls.client = wakesurf.Client(cls.server.url)

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()
        del os.environ["WAKESURF"]

    def names(self, session):
        """What every example begins with."""
        rake = session.rake(line=LINE, seeds=8)
        surface = session.surface(rake, "stream", dataset="tornado", to=1, separation=0.1)
        return {"wakesurf": wakesurf, "np": np, "os": os, "url": self.server.url, "client": self.client, "session": session,
                "rake": rake, "surface": surface, "mesh": surface.mesh()}

    def test_every_example_says_what_comes_out(self):
        finder, tried, here = doctest.DocTestFinder(exclude_empty=True), [], os.getcwd()
        for module in modules():
            for each in finder.find(module):
                if not each.examples or each.name in tried:
                    continue
                with self.subTest(each.name), tempfile.TemporaryDirectory() as folder, self.client.scratch() as session:
                    tried.append(each.name)
                    os.chdir(folder)
                    try:
                        each.globs.update(self.names(session))
                        said = []
                        result = doctest.DocTestRunner(optionflags=OPTIONS).run(each, out=said.append)
                    finally:
                        os.chdir(here)
                    self.assertEqual(result.failed, 0, "".join(said))
        self.assertGreater(len(tried), 20)


if __name__ == "__main__":
    unittest.main()
