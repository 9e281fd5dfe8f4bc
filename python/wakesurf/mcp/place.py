"""The folder that files are written to: no file is written outside of it, nor over a file of others."""
from __future__ import annotations

import os
from typing import Sequence, Set

from ..errors import InvalidParameters, NotPermitted


_LONGEST_NAME = 200  # with what is added while it is written, less than file systems take
_LONGEST_PATH = 1000


class Place:
    """A folder. Links are followed before it is decided whether a path lies in it."""

    def __init__(self, folder: str) -> None:
        self.folder = os.path.realpath(folder)
        self._made: Set[str] = set()

    def take(self, path: str, extensions: Sequence[str], overwrite: bool = False) -> str:
        """Returns the path to write to; folders on the way are made. From now on it may be written again, also if
        this time fails. An extension of "" allows a folder. Error: NotPermitted, InvalidParameters."""
        if not path.strip() or not path.isprintable():  # nothing that acts on a terminal, or cannot be seen
            raise _wrong(f"{path!r} is not a file name", "give a path below the folder, of visible characters")
        if any(len(os.fsencode(part)) > _LONGEST_NAME for part in path.split("/")) or len(os.fsencode(path)) > _LONGEST_PATH:
            raise _wrong("`path` is too long", f"names have at most {_LONGEST_NAME} bytes, a path {_LONGEST_PATH}")
        ending = os.path.splitext(path)[1].lower()
        if ending not in extensions:
            raise _wrong(f"`path` ends in {ending or 'nothing'}", "one of " + ", ".join(each or "a folder" for each in extensions))
        full = os.path.realpath(os.path.join(self.folder, path))
        if os.path.commonpath([self.folder, full]) != self.folder or full == self.folder:
            raise NotPermitted(f"{path!r} is not below the folder for files", 0, "notPermitted",
                               "give a path relative to it; the folder is chosen by --folder where this program is started")
        there = os.listdir(full) if os.path.isdir(full) and ending == "" else os.path.lexists(full)
        if there and full not in self._made and not overwrite:
            raise NotPermitted(f"{self.shown(full)} is there already, and not from here", 0, "notPermitted",
                               "give another name, or overwrite=true if its owner agrees")
        os.makedirs(os.path.dirname(full), exist_ok=True)
        self._made.add(full)
        return full

    def shown(self, full: str) -> str:
        """Returns the path below the folder, as people would write it."""
        return os.path.relpath(full, self.folder)


def _wrong(message: str, hint: str) -> InvalidParameters:
    return InvalidParameters(message, -32602, "invalidParameters", hint)
