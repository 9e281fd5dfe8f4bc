"""A Chromium without a window, driven over a pipe: no port is open that others on this machine could use. Its profile is a folder of its
own, gone afterwards, also where Python was killed."""
from __future__ import annotations

import atexit
import base64
import fcntl
import glob
import itertools
import json
import os
import select
import shutil
import signal
import subprocess
import tempfile
import time as clock
from typing import Any, Dict, List, Optional

from .errors import BrowserMissing, PictureFailed, WaitTimeout
from .plain import Json

_NAMES = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "chrome")
_FLAGS = ("--headless=new", "--remote-debugging-pipe", "--no-first-run", "--disable-background-networking", "--disable-component-update",
          "--disable-sync", "--disable-quic", "--force-color-profile=srgb", "--hide-scrollbars", "--use-angle=swiftshader",
          "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "about:blank")
_READ_BYTES = 1 << 20
_PROFILE_PREFIX = "wakesurf-chromium-"
_PATIENCE = 5.0  # s, for processes that were killed to be through with what they were writing


def find_browser() -> str:
    """Returns $WAKESURF_CHROMIUM, else the first browser that is installed. Error: BrowserMissing."""
    named = os.environ.get("WAKESURF_CHROMIUM")
    for name in (named,) if named else _NAMES:
        found = shutil.which(name)
        if found:
            return found
    raise BrowserMissing(f"{named!r} is not a program" if named else "pictures need Chromium, which is not on this machine",
                         kind="browserMissing", hint="Debian: chromium or chromium-headless-shell; or name one in $WAKESURF_CHROMIUM")


class Chrome:
    """One page in a browser of its own, with a profile that is removed at the end, or with Python."""

    def __init__(self, address: str, size: "tuple[int, int]") -> None:
        self._profile = _Profile()
        (its_in, self._out), (self._in, its_out) = os.pipe(), os.pipe()
        at = [fcntl.fcntl(each, fcntl.F_DUPFD_CLOEXEC, 10) for each in (its_in, its_out)]

        def as_it_wants_them() -> None:
            os.dup2(at[0], 3)
            os.dup2(at[1], 4)

        flags: List[str] = [*_FLAGS, f"--user-data-dir={self._profile.path}"]
        if os.geteuid() == 0:  # it refuses its sandbox to root
            flags.append("--no-sandbox")
        try:
            self._process = subprocess.Popen([find_browser(), *flags], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                             stderr=subprocess.DEVNULL, close_fds=False, preexec_fn=as_it_wants_them,
                                             start_new_session=True)
        except BaseException:
            self._profile.remove()
            raise
        finally:
            for each in (its_in, its_out, *at):
                os.close(each)
        self._numbers, self._text, self._target = itertools.count(1), b"", ""
        atexit.register(self.close)
        try:
            self._open(address, size)
        except BaseException:
            self.close()
            raise

    def _open(self, address: str, size: "tuple[int, int]") -> None:
        target = self.ask("Target.createTarget", {"url": "about:blank"})["targetId"]
        self._target = self.ask("Target.attachToTarget", {"targetId": target, "flatten": True})["sessionId"]
        self.ask("Emulation.setDeviceMetricsOverride", {"width": size[0], "height": size[1], "deviceScaleFactor": 1, "mobile": False})
        self.ask("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-reduced-motion", "value": "reduce"}]})
        # Someone who has never been here is shown a tour; and what is beside the picture would take its room.
        self.ask("Page.addScriptToEvaluateOnNewDocument", {"source": "if (origin !== 'null') { localStorage.setItem('wakesurf.tour', 'done');"
                                                                     "localStorage.setItem('wakesurf.panel', 'folded'); }"})
        moved = self.ask("Page.navigate", {"url": address})
        if "errorText" in moved:
            raise PictureFailed(f"the page does not open: {moved['errorText']}", hint="is the server running, with its page (--web)?")

    def close(self) -> None:
        """Ends the browser and removes its profile. Does nothing the second time."""
        if self._process.returncode is not None:
            return
        atexit.unregister(self.close)
        for each in (self._out, self._in):
            os.close(each)
        self._process.terminate()
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        try:  # its other processes outlive it for a while, and write into the profile
            os.killpg(self._process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self._profile.remove()

    def ask(self, method: str, parameters: Optional[Json] = None, timeout: float = 60.0) -> Json:
        """Sends a command of the DevTools protocol. Error: PictureFailed, WaitTimeout."""
        number = next(self._numbers)
        message: Dict[str, Any] = {"id": number, "method": method, "params": parameters or {}}
        if self._target:
            message["sessionId"] = self._target
        end = clock.monotonic() + timeout
        try:
            rest = json.dumps(message).encode() + b"\0"
            while rest:
                rest = rest[os.write(self._out, rest):]
            while True:
                answer = self._message(end)
                if answer.get("id") == number:
                    break
        except OSError as problem:
            raise PictureFailed(f"the browser has ended: {problem}") from None
        if "error" in answer:
            raise PictureFailed(f"{method}: {answer['error'].get('message', '')}")
        result: Json = answer["result"]
        return result

    def _message(self, end: float) -> Json:
        while b"\0" not in self._text:
            if not select.select([self._in], [], [], max(0.0, end - clock.monotonic()))[0]:
                raise WaitTimeout("the browser does not answer")
            part = os.read(self._in, _READ_BYTES)
            if not part:
                raise PictureFailed("the browser has ended", hint="does `chromium --headless` start here?")
            self._text += part
        message, self._text = self._text.split(b"\0", 1)
        found: Json = json.loads(message)
        return found

    def value(self, code: str, timeout: float = 60.0) -> Any:
        """Evaluates an expression in the page; of a promise, its result. Error: PictureFailed with what it threw."""
        answer = self.ask("Runtime.evaluate", {"expression": code, "awaitPromise": True, "returnByValue": True}, timeout)
        if "exceptionDetails" in answer:
            thrown = answer["exceptionDetails"]
            words = thrown.get("exception", {}).get("description") or thrown.get("text", "")
            raise PictureFailed(str(words).split("\n")[0])
        return answer["result"].get("value")

    def screenshot(self) -> bytes:
        """Returns the page as PNG."""
        return base64.b64decode(self.ask("Page.captureScreenshot", {"format": "png"})["data"])


class _Profile:
    """The folder of a profile: locked while it is used. An unlocked one belonged to a Python that was killed: the next profile
    removes it."""

    def __init__(self) -> None:
        for each in glob.glob(os.path.join(glob.escape(tempfile.gettempdir()), _PROFILE_PREFIX + "*")):
            lock = _lock(each)
            if lock is not None:
                _remove(each, 0.0)
                os.close(lock)
        while True:  # somebody may take it for one that was left, before it is locked
            self.path = tempfile.mkdtemp(prefix=_PROFILE_PREFIX)
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
