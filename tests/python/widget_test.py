"""`session.show()` where anywidget is installed, by a stand-in for it: what Python gives it, and what its module does in a browser."""
import base64
import http.server
import json
import sys
import threading
import time
import types
import unittest
from unittest import mock

import traitlets

from real_server import RealServer
import wakesurf
from wakesurf.notebook import ESM, _page_kind
from wakesurf.chrome import Chrome

# What a notebook is to the module: an element, and a model whose messages the test carries.
NOTEBOOK = """<!doctype html><title>notebook</title><div id="cell"></div><script type="module">
const code = %s;
const { default: made } = await import(URL.createObjectURL(new Blob([code], { type: "text/javascript" })));
const values = { width: "800px", height: 500 }, heard = new Map();
globalThis.sent = [];
globalThis.model = {
  get: (name) => values[name],
  on: (name, heed) => heard.set(name, heed),
  off: (name) => heard.delete(name),
  send: (message) => sent.push(message),
};
globalThis.change = (name, value) => { values[name] = value; heard.get(`change:${name}`)(); };
globalThis.tell = (message) => heard.get("msg:custom")(message);
globalThis.tidy = await made.render({ model, el: document.getElementById("cell") });
globalThis.heard = heard;
</script>"""


class AnyWidget(traitlets.HasTraits):
    """What ipywidgets and anywidget have of it."""

    def __init__(self, **values):
        super().__init__(**values)
        self.sent, self.heeds = [], []

    def on_msg(self, heed):
        self.heeds.append(heed)

    def send(self, content, buffers=None):
        self.sent.append(content)

    def _repr_mimebundle_(self, **_):
        return {"application/vnd.jupyter.widget-view+json": {"model_id": "1"}}, {}


class WidgetTest(unittest.TestCase):
    def shown(self, origin="http://localhost:8888", **modules):
        _page_kind.cache_clear()
        self.addCleanup(_page_kind.cache_clear)
        server = RealServer("flow:tornado", "--frame-origin", "http://localhost:8888")
        self.addCleanup(server.stop)
        shell = types.SimpleNamespace(get_ipython=lambda: types.SimpleNamespace(kernel=1))
        with mock.patch.dict(sys.modules, IPython=shell, **modules), mock.patch.dict("os.environ", WAKESURF_FRAME_ORIGIN=origin):
            session = wakesurf.Client(server.url).session()
            session.picture = lambda **_: wakesurf.picture.Picture(b"\x89PNG", (1, 1))
            return server.url, session.show(width=800, height=500)

    def test_is_shown_where_anywidget_is_installed_and_keeps_the_token_to_itself(self):
        url, shown = self.shown(anywidget=types.SimpleNamespace(AnyWidget=AnyWidget))
        data, _ = shown._repr_mimebundle_()
        self.assertEqual(set(data), {"application/vnd.jupyter.widget-view+json"})
        page = shown.widget
        synced = {name: getattr(page, name) for name in page.traits(sync=True)}
        self.assertEqual(synced, {"width": "800", "height": 500})
        self.assertEqual(page.sent, [])
        page.heeds[0](page, {"wants": "address"}, [])
        address, token = url.split("/#token=")
        self.assertEqual(page.sent, [{"address": f"{address}/#session=main&token={token}"}])
        self.assertIs(shown._display_(), page)

    def test_is_a_frame_without_it_and_a_picture_where_the_page_may_not_be_in_a_frame(self):
        _, shown = self.shown(anywidget=None)
        self.assertIn("<iframe", shown._repr_mimebundle_()["text/html"])
        self.assertIn("<iframe", shown._display_()._repr_html_())
        _, shown = self.shown(origin="https://elsewhere.example", anywidget=types.SimpleNamespace(AnyWidget=AnyWidget))
        self.assertEqual((shown.widget, "image/png" in shown._repr_mimebundle_()), (None, True))

    def test_its_module_asks_for_the_address_and_brings_up_the_page_that_joins_the_session(self):
        page = (NOTEBOOK % json.dumps(ESM).replace("</", "<\\/")).encode()

        class Handler(http.server.BaseHTTPRequestHandler):
            def do_GET(self):
                self.send_response(200)
                self.send_header("Content-Type", "text/html")
                self.end_headers()
                self.wfile.write(page)

            def log_message(self, *_):
                pass

        notebook = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.addCleanup(notebook.server_close)
        self.addCleanup(notebook.shutdown)
        threading.Thread(target=notebook.serve_forever, daemon=True).start()
        origin = f"http://localhost:{notebook.server_port}"
        server = RealServer("flow:tornado", "--frame-origin", origin)
        self.addCleanup(server.stop)
        session = wakesurf.Client(server.url).session()
        chrome = Chrome(origin + "/", (900, 600))
        self.addCleanup(chrome.close)
        self.until(lambda: chrome.value("globalThis.tidy !== undefined"))
        self.assertEqual(chrome.value("sent"), [{"wants": "address"}])
        frame = "document.querySelector('#cell iframe')"
        self.assertEqual(chrome.value(f"[{frame}.width, {frame}.height, {frame}.src]"), ["800px", "500", ""])
        chrome.value("change('height', 400)")
        self.assertEqual(chrome.value(frame + ".height"), "400")
        chrome.value(f"tell({{address: {json.dumps(server.url.replace('#', '#session=main&'))}}})")
        self.assertTrue(chrome.value(frame + ".src").startswith("http://localhost:"), "by the notebook's name, not 127.0.0.1")
        self.until(lambda: any(each["connected"] for each in session.state()["participants"]))
        chrome.value("tidy()")
        self.assertEqual(chrome.value("[document.getElementById('cell').childElementCount, heard.size]"), [0, 0])

    def test_its_module_goes_through_colabs_proxy(self):
        page = base64.b64encode(("<!doctype html><div id=cell></div>").encode()).decode()
        chrome = Chrome("data:text/html;base64," + page, (400, 300))
        self.addCleanup(chrome.close)
        code = """(async () => {
          globalThis.google = { colab: { kernel: { proxyPort: async (port) => `https://proxy.example/${port}/` } } };
          const { default: made } = await import("data:text/javascript," + encodeURIComponent(%s));
          let tell;
          const model = { get: () => "1", on: (name, heed) => { if (name === "msg:custom") tell = heed; }, send() {} };
          made.render({ model, el: document.body });
          await tell({ address: "http://127.0.0.1:8123/#session=main&token=t" });
          return document.querySelector("iframe").src;
        })()""" % json.dumps(ESM)
        self.assertEqual(chrome.value(code), "https://proxy.example/8123/#session=main&token=t")

    def until(self, is_so):
        end = time.monotonic() + 60
        while not is_so():
            self.assertLess(time.monotonic(), end, "it has not come to pass")


if __name__ == "__main__":
    unittest.main()
