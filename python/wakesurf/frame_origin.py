"""The notebook that this Python runs for, and the origin of its pages."""
from __future__ import annotations

import glob
import json
import os
import sys
import urllib.parse
from typing import List, Optional


def notebook_address() -> Optional[str]:
    """Returns the address of the Jupyter server that started this kernel, from its runtime folder; None elsewhere."""
    parent = os.environ.get("JPY_PARENT_PID", "")
    for folder in _runtime_folders():
        for path in sorted(glob.glob(os.path.join(folder, "*server-*.json"))):
            try:
                with open(path, encoding="utf-8") as file:
                    entry = json.load(file)
            except (OSError, ValueError):
                continue
            if str(entry.get("pid", "")) == parent:
                return str(entry.get("url", "")) or None
    return None


def notebook_origins() -> List[str]:
    """Returns the origins whose pages may show the server's: $WAKESURF_FRAME_ORIGIN, several with spaces between
    them; else the notebook's, by the names that browsers know this machine by. Empty outside of a notebook."""
    named = os.environ.get("WAKESURF_FRAME_ORIGIN", "").split()
    address = notebook_address()
    if named or address is None:
        return named
    parts = urllib.parse.urlsplit(address)
    port = f":{parts.port}" if parts.port else ""
    hosts = ["localhost", "127.0.0.1"] if parts.hostname in ("localhost", "127.0.0.1", "0.0.0.0", "::1", "::") else [str(parts.hostname)]
    return [f"{parts.scheme}://{host}{port}" for host in hosts]


def in_notebook() -> bool:
    """Whether output goes to a notebook's page."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    in_marimo = getattr(sys.modules.get("marimo"), "running_in_notebook", lambda: False)()
    return in_marimo or (shell is not None and hasattr(shell, "kernel"))


def _runtime_folders() -> List[str]:
    named = os.environ.get("JUPYTER_RUNTIME_DIR")
    data = os.environ.get("JUPYTER_DATA_DIR") or os.path.join(
        os.environ.get("XDG_DATA_HOME") or os.path.expanduser("~/.local/share"), "jupyter")
    return [named] if named else [os.path.join(data, "runtime"), os.path.expanduser("~/Library/Jupyter/runtime")]
