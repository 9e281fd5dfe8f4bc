"""The live page in a notebook, or a picture of it where the page cannot be.

A server shows its page only in frames of origins that it was told (`--frame-origin`). `serve` asks for the notebook's own, which it finds in
what Jupyter writes down for its kernels; to a server that runs already, its operator gives the option. The page keeps its login in
storage that browsers part by site, so the frame takes the name by which the notebook was opened, localhost or 127.0.0.1.

Behind jupyter-server-proxy the page has the notebook's own origin: `session.show(proxy=True)`, or $WAKESURF_PROXY=1. On JupyterHub, which
sets $JUPYTERHUB_SERVICE_PREFIX, that is the default.

Where anywidget is installed the page is one, else a frame among the cell's outputs, else a picture. A widget needs no script among the
outputs, and the address, which has the token, is asked for by a message: neither the notebook's file nor the state of its widgets that is
saved with it has the token.

Tested in Debian's notebook 6.4 and tried by hand in JupyterLab 4.0, as a frame. anywidget, VS Code, Colab, marimo and jupyter-server-proxy are
served by their documented interfaces and untested.
"""
from __future__ import annotations

import base64
import functools
import html
import importlib
import json
import os
import urllib.parse
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, Optional, Union

from .errors import WakesurfError
from .frame_origin import in_notebook, notebook_address, notebook_origins
from .picture import Picture

if TYPE_CHECKING:
    from .session import Session

_LOCAL = ("127.0.0.1", "localhost", "::1")


@dataclass(frozen=True)
class Shown:
    """What a notebook shows: a frame, or a picture, or words."""

    address: str  # of the page, with its token
    frame: bool
    width: str
    height: int
    picture: Optional[Picture] = None
    why: str = ""  # there is no frame
    widget: Optional[Any] = None  # the same as an anywidget, where that is installed

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> Any:
        if self.widget is not None:
            return self.widget._repr_mimebundle_(include=include, exclude=exclude)
        bundle: Dict[str, Any] = {"text/plain": repr(self), "text/html": self._repr_html_()}
        if self.picture is not None:
            bundle["image/png"] = base64.b64encode(self.picture.data).decode()
            del bundle["text/html"]
        return bundle

    def _display_(self) -> Any:
        """Returns what marimo shows."""
        return self.widget or self.picture or _Html(self._repr_html_())

    def __repr__(self) -> str:
        return "wakesurf in a frame" if self.frame else f"wakesurf, not in a frame: {self.why}"

    def _repr_html_(self) -> str:
        if not self.frame:
            return f"<p>wakesurf: {html.escape(self.why)}. <a href={_quoted(self.address)} target=\"_blank\">Open the page</a>.</p>"
        parts = urllib.parse.urlsplit(self.address)
        frame = (f"<iframe title=\"wakesurf\" width={_quoted(self.width)} height=\"{self.height}\" style=\"border:0\" "
                 "allow=\"clipboard-write; fullscreen\"")
        if parts.hostname not in _LOCAL or not parts.scheme:
            return f"{frame} src={_quoted(self.address)}></iframe>"
        # By the name by which the notebook was opened: another one would be another site, whose storage is another one.
        name = "wakesurf-" + os.urandom(6).hex()
        return (f"{frame} id=\"{name}\"></iframe><script>{{const address = new URL({_script(self.address)});"
                "if (['localhost', '127.0.0.1'].includes(location.hostname)) address.hostname = location.hostname;"
                f"document.getElementById(\"{name}\").src = address.href;}}</script>")


@dataclass(frozen=True)
class _Html:
    text: str

    def _repr_html_(self) -> str:
        return self.text


def _script(text: str) -> str:
    return json.dumps(text).replace("<", "\\u003c")


def _quoted(text: str) -> str:
    return '"' + html.escape(text) + '"'


def show(session: Session, width: Union[int, str], height: int, *, proxy: Optional[bool], static: Optional[bool]) -> Shown:
    """Shows the page; see `Session.show`. `static`: True, a picture in any case; left out, if the page cannot be in a
    frame."""
    address = _address(session)
    why = "a picture was asked for" if static else ""
    if proxy or (proxy is None and _proxied()):
        address = _through_proxy(address)
    elif not static:
        why = _why_no_frame(session)
    if not why:
        return Shown(address, True, str(width), height, widget=page_widget(address, str(width), height))
    pixels = int(width) if isinstance(width, int) else 960
    try:
        return Shown(address, False, str(width), height, session.picture(size=(pixels, height)), why)
    except WakesurfError as problem:
        return Shown(address, False, str(width), height, None, f"{why}; and no picture: {problem}")


def _address(session: Session) -> str:
    words = {"session": session.id, "token": session.client._token}
    return session.client.url + "/#" + urllib.parse.urlencode({name: value for name, value in words.items() if value})


def _why_no_frame(session: Session) -> str:
    """Returns None if the page may be in a frame of this notebook, else the reason."""
    status, headers, _ = session.client._request("/")
    if status != 200:
        return f"the server has no page (status {status})"
    if not in_notebook():
        return "this is not a notebook"
    names = {name.lower(): value for name, value in headers.items()}
    policy = next((part for part in names.get("content-security-policy", "").split(";") if part.strip().startswith("frame-ancestors")), "")
    if "x-frame-options" in names or not policy or "'none'" in policy:
        where = " --frame-origin ".join(notebook_origins()) or "the notebook's origin, as http://localhost:8888"
        return f"the server shows its page in no frame: start it with --frame-origin {where}"
    origins = notebook_origins()
    if origins and not any(each in policy.split() for each in origins):
        return f"the server shows its page in frames of others than this notebook: start it with --frame-origin {origins[0]}"
    return ""


def _proxied() -> bool:
    named = os.environ.get("WAKESURF_PROXY")
    return named not in ("", "0") if named is not None else "JUPYTERHUB_SERVICE_PREFIX" in os.environ


def _through_proxy(address: str) -> str:
    parts = urllib.parse.urlsplit(address)
    prefix = os.environ.get("JUPYTERHUB_SERVICE_PREFIX") or urllib.parse.urlsplit(notebook_address() or "/").path or "/"
    return f"{prefix.rstrip('/')}/proxy/{parts.port}/#{parts.fragment}"


# See https://anywidget.dev/en/afm: `render` gets the model and an element, and returns what tidies up.
ESM = """
const HERE = ["localhost", "127.0.0.1"];

/** The address as this browser reaches it. */
async function reachable(address) {
  const url = new URL(address, location.href);
  const colab = globalThis.google?.colab?.kernel;
  if (colab?.proxyPort !== undefined && HERE.includes(url.hostname)) {
    const outside = new URL(await colab.proxyPort(Number(url.port), { cache: true }));
    outside.hash = url.hash;
    return outside.href;
  }
  // By the name by which the notebook was opened: another one would be another site, whose storage is another one.
  if (HERE.includes(url.hostname) && HERE.includes(location.hostname)) url.hostname = location.hostname;
  return url.href;
}

function render({ model, el }) {
  const frame = document.createElement("iframe");
  frame.title = "wakesurf";
  frame.allow = "clipboard-write; fullscreen";
  frame.style.border = "0";
  const fit = () => {
    frame.width = model.get("width");
    frame.height = model.get("height");
  };
  const receive = async (message) => {
    if (message?.address !== undefined && !frame.src) frame.src = await reachable(message.address);
  };
  fit();
  model.on("change:width", fit);
  model.on("change:height", fit);
  model.on("msg:custom", receive);
  el.append(frame);
  model.send({ wants: "address" });
  return () => {
    model.off("change:width", fit);
    model.off("change:height", fit);
    model.off("msg:custom", receive);
    frame.remove();
  };
}

export default { render };
"""


@functools.lru_cache(maxsize=None)
def _page_kind() -> Any:
    anywidget, traitlets = importlib.import_module("anywidget"), importlib.import_module("traitlets")

    class Page(anywidget.AnyWidget):  # type: ignore[misc, name-defined]
        """Shows a page; its size can be changed, its address is hidden."""

        _esm = ESM
        width = traitlets.Unicode("100%").tag(sync=True)
        height = traitlets.Int(600).tag(sync=True)

        def __init__(self, address: str, **size: Any) -> None:
            super().__init__(**size)
            self._address = address
            self.on_msg(self._answer)

        def _answer(self, _: Any, content: Any, __: Any) -> None:
            if content == {"wants": "address"}:
                self.send({"address": self._address})

    return Page


def page_widget(address: str, width: str, height: int) -> Optional[Any]:
    """Returns None if anywidget is not installed."""
    try:
        kind = _page_kind()
    except ImportError:
        return None
    return kind(address, width=width, height=height)
