"""Pictures of a session, drawn by the server's own page in a Chromium without a window.

Why the page, and not VTK: the picture is the one that people see, with its colours, transparency, lines, texture, cuts, axes and scalar
bar, drawn by the same code; a script needs neither a display nor VTK. It costs a start of the browser, some seconds, and drawing without
graphics hardware: `Painter` starts it once for several pictures.

The page looks on: it comes with a link for viewers, which is taken back at the end. What would change the session, as another time, happens
in a copy of it, which is deleted for good.
"""
from __future__ import annotations

import base64
import json
import os
import time as clock
import urllib.parse
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Optional, Tuple, Union

from .chrome import Chrome
from .errors import NotPermitted, PictureFailed, WaitTimeout, WakesurfError
from .view import Look, page_state
from .whole_file import write_whole

if TYPE_CHECKING:
    from .session import Background, Session

_SMALLEST, _LARGEST = (320, 200), (1600, 1200)  # of the page; the picture has its own size
_ASK_AGAIN = 0.05  # s


@dataclass(frozen=True)
class Picture:
    """A PNG. Notebooks show it."""

    data: bytes = field(repr=False)
    size: Tuple[int, int]
    path: Optional[str] = None

    def _repr_png_(self) -> bytes:
        return self.data

    def write(self, path: Union[str, os.PathLike[str]]) -> str:
        """Writes it whole, or not at all."""
        path = os.fspath(path)
        write_whole(path, [self.data])
        return path


class Painter:
    """A page that draws pictures of a session, for as long as the block runs. `own_time`: a copy of the session is drawn, so that
    its clock can be set."""

    def __init__(self, session: Session, size: Tuple[int, int], *, timeout: float = 120.0, own_time: bool = False,
                 view: Optional[Look] = None) -> None:
        self._timeout, self._grant = timeout, ""
        self._copy: Optional[Session] = None
        self._session, self._drawn = session, session
        surfaces = [each.id for each in session.surfaces()]
        state = page_state(view, surfaces)
        try:
            if own_time:
                self._copy = self._drawn = session.fork("picture")
            self._chrome = Chrome(self._address(state), _page_size(size))
        except BaseException:
            self._tidy()
            raise

    def __enter__(self) -> Painter:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Ends the browser and takes its link, or its copy of the session, away."""
        try:
            self._chrome.close()
        finally:
            self._tidy()

    def _address(self, state: str) -> str:
        client = self._drawn.client
        token = client._token
        try:
            made = self._drawn.api.session.share(role="viewer", expires_in=86_400)
            self._grant, token = made["grant"], made["key"]
        except (NotPermitted, WakesurfError):
            pass  # who may not make links looks on with their own
        words = {"session": self._drawn.id, "token": token, "state": state}
        return client.url + "/#" + urllib.parse.urlencode({name: value for name, value in words.items() if value})

    def _tidy(self) -> None:
        try:
            if self._copy is not None:
                self._copy.discard()
            elif self._grant:
                self._session.api.session.unshare(grant=self._grant)
        except WakesurfError:
            pass  # the server may have ended

    def picture(self, path: Union[str, os.PathLike[str], None] = None, size: Tuple[int, int] = (1600, 1000), *,
                time: Optional[float] = None, background: Background = "shown", bar: bool = True, axes: bool = True,
                rakes: bool = False, caption: Optional[str] = None) -> Picture:
        """As `Session.picture`. `time` only where the painter has a copy of its own."""
        if time is not None:
            if self._copy is None:
                raise PictureFailed("this painter draws the session itself, whose time is everyone's", hint="Session.picture takes a time")
            self._copy.set_time(time)
        self._until_whole(time)
        setting = {"width": size[0], "height": size[1], "background": background, "bar": bar, "axes": axes, "rake": rakes,
                   "caption": caption}
        text = self._chrome.value(f"window.wakesurf.picture({json.dumps(setting)})", self._timeout)
        drawn = Picture(base64.b64decode(str(text).partition(",")[2]), (size[0], size[1]))
        return drawn if path is None else Picture(drawn.data, drawn.size, drawn.write(path))

    def _until_whole(self, time: Optional[float]) -> None:
        end, why = clock.monotonic() + self._timeout, "the page has not begun"
        code = f"window.wakesurf?.unfinished?.({json.dumps(time)}) ?? 'the page has not begun'"
        while clock.monotonic() < end:
            why = str(self._chrome.value(code))
            if why == "":
                return
            if why.startswith("!"):
                raise PictureFailed(why[1:])
            clock.sleep(_ASK_AGAIN)
        words = self._chrome.value("document.querySelector('wakesurf-app')?.shadowRoot?.textContent?.trim().slice(0, 300) ?? ''")
        raise WaitTimeout(f"the picture is not whole after {self._timeout:g} s: {why}", hint=str(words or "").strip())


def _page_size(size: Tuple[int, int]) -> Tuple[int, int]:
    """Of the same shape as the picture, so that the view is; text keeps its share of it."""
    scale = min(1.0, *(most / each for most, each in zip(_LARGEST, size)))
    scale = max(scale, *(least / each for least, each in zip(_SMALLEST, size)))
    return round(size[0] * scale), round(size[1] * scale)
