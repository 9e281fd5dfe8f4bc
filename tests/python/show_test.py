"""What `show` gives a notebook: a frame where the server allows it, else a picture or words that say why."""
import os
import re
import sys
import types
import unittest
from unittest import mock

from real_server import RealServer
import wakesurf
from wakesurf.picture import Picture

HERE = "http://localhost:8888"


class ShowTest(unittest.TestCase):
    def shown(self, *options, proxy=None, environment=(), **more):
        """As in a notebook at HERE; the picture is another test's."""
        shell = types.SimpleNamespace(get_ipython=lambda: types.SimpleNamespace(kernel=1))
        server = RealServer("flow:tornado", *options)
        self.addCleanup(server.stop)
        session = wakesurf.Client(server.url).session()
        session.picture = lambda **_: Picture(b"\x89PNG", (1, 1))
        with mock.patch.dict(sys.modules, IPython=shell), mock.patch.dict(os.environ, WAKESURF_FRAME_ORIGIN=HERE, **dict(environment)):
            return server.url, session.show(proxy=proxy, **more)

    def test_a_frame_where_the_server_was_told_this_notebook(self):
        url, shown = self.shown("--frame-origin", HERE)
        html = shown._repr_mimebundle_()["text/html"]
        self.assertIn('<iframe title="wakesurf" width="100%" height="600"', html)
        address, token = url.split("/#token=")
        self.assertIn(f"{address}/#session=main&token={token}", html.replace("&amp;", "&"))

    def test_a_picture_and_the_option_that_is_missing_where_it_was_told_none_or_another(self):
        for options in ((), ("--frame-origin", "https://wiki.example")):
            _, shown = self.shown(*options)
            bundle = shown._repr_mimebundle_()
            self.assertEqual((set(bundle), shown.frame), ({"text/plain", "image/png"}, False))
            self.assertIn(f"--frame-origin {HERE}", bundle["text/plain"])

    def test_a_picture_where_one_is_asked_for(self):
        _, shown = self.shown("--frame-origin", HERE, static=True)
        self.assertIn("image/png", shown._repr_mimebundle_())

    def test_words_with_a_link_where_there_is_no_picture_either(self):
        with mock.patch.dict(os.environ, WAKESURF_CHROMIUM="/nowhere"):
            server = RealServer("flow:tornado")
            self.addCleanup(server.stop)
            shown = wakesurf.Client(server.url).session().show()
        html = shown._repr_mimebundle_()["text/html"]
        self.assertIn("this is not a notebook; and no picture", html)
        self.assertRegex(html, r'<a href="http://127\.0\.0\.1:\d+/#session=main')

    def test_the_notebooks_own_address_behind_jupyter_server_proxy(self):
        for proxy, environment in ((True, {}), (None, {"WAKESURF_PROXY": "1"}), (None, {"JUPYTERHUB_SERVICE_PREFIX": "/user/ada/"})):
            url, shown = self.shown(proxy=proxy, environment=environment)
            port = re.search(r":(\d+)/", url)[1]
            prefix = environment.get("JUPYTERHUB_SERVICE_PREFIX", "/")
            self.assertIn(f'src="{prefix}proxy/{port}/#session=main', shown._repr_html_())


if __name__ == "__main__":
    unittest.main()
