"""A folder for a browser's profile: its own, and gone afterwards, also where Python was killed."""
from __future__ import annotations

import fcntl
import glob
import os
import shutil
import tempfile
import time as clock
from typing import Optional

_PREFIX = "wakesurf-chromium-"
_PATIENCE = 5.0  # s, for processes that were killed to be through with what they were writing


class Profile:
    """Locks the folder while it is used. An unlocked one belonged to a Python that was killed: the next profile
    removes it."""

    def __init__(self) -> None:
        for each in glob.glob(os.path.join(glob.escape(tempfile.gettempdir()), _PREFIX + "*")):
            lock = _lock(each)
            if lock is not None:
                _remove(each, 0.0)
                os.close(lock)
        while True:  # somebody may take it for one that was left, before it is locked
            self.path = tempfile.mkdtemp(prefix=_PREFIX)
            lock = _lock(self.path)
            if lock is not None:
                self._lock = lock
                return

    def remove(self) -> None:
        """Removes the folder once the browser does not write into it any more."""
        _remove(self.path, _PATIENCE)
        os.close(self._lock)


def _lock(path: str) -> Optional[int]:
    """Locks a folder of this user that still exists and is not locked."""
    try:
        lock = os.open(path, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW)
    except OSError:
        return None
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        if os.fstat(lock).st_uid == os.geteuid() and os.path.samestat(os.fstat(lock), os.lstat(path)):
            return lock
    except OSError:
        pass
    os.close(lock)
    return None


def _remove(path: str, patience: float) -> None:
    end = clock.monotonic() + patience
    while True:
        shutil.rmtree(path, ignore_errors=True)
        if not os.path.lexists(path) or clock.monotonic() >= end:
            return
        clock.sleep(0.01)
