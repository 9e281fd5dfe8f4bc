"""The live page as an anywidget, where that package is installed: for JupyterLab, VS Code, Colab and marimo.

Unlike a frame among a cell's outputs, it needs no script among them, and the address, which has the token, is asked for by a message: neither
the notebook's file nor the state of its widgets that is saved with it has the token.
"""
from __future__ import annotations

import functools
import importlib
from typing import Any, Optional

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
  const told = async (message) => {
    if (message?.address !== undefined && !frame.src) frame.src = await reachable(message.address);
  };
  fit();
  model.on("change:width", fit);
  model.on("change:height", fit);
  model.on("msg:custom", told);
  el.append(frame);
  model.send({ wants: "address" });
  return () => {
    model.off("change:width", fit);
    model.off("change:height", fit);
    model.off("msg:custom", told);
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
            self.on_msg(self._asked)

        def _asked(self, _: Any, content: Any, __: Any) -> None:
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
