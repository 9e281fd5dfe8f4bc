"""The server's words for a model that has tools: names the tool that does what a method does, and arguments as the
tools have them."""
from __future__ import annotations

import re
from typing import Mapping

from ..name_mapping import named_methods, names

# What no tool does is not here.
TOOL_OF: Mapping[str, str] = {
    "dataset.list": "open", "dataset.describe": "open", "dataset.open": "open", "dataset.suggest": "suggest", "rake.set": "rake",
    "rake.list": "open", "rake.delete": "rake", "surface.set": "surface", "surface.list": "open", "surface.delete": "surface",
    "surface.wait": "wait", "surface.stats": "explain", "history.undo": "undo", "history.redo": "undo", "session.state": "open",
    "session.create": "open"}


def in_tools(words: str) -> str:
    """Replaces methods by tools.

    >>> in_tools("raise `maxQuads`, or look with `surface.list`")
    'raise `max_quads`, or look with the tool `open`'
    """
    for method in named_methods(words):
        if method in TOOL_OF:
            words = words.replace(f"`{method}`", f"the tool `{TOOL_OF[method]}`")
    parameters = names()[1]
    return re.sub(r"`(\w+)`", lambda found: f"`{parameters.get(found[1], found[1]).rstrip('_')}`", words)


def hint_in_tools(hint: str) -> str:
    """Returns the hint with tools; empty if it needs a method that no tool has.

    >>> hint_in_tools("`session.shares` lists them")
    ''
    """
    return in_tools(hint) if named_methods(hint) <= set(TOOL_OF) else ""
