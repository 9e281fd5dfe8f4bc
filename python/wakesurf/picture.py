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
import warnings
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from .chrome import Chrome, find_browser
from .errors import NotPermitted, PictureFailed, WaitTimeout, WakesurfError
from .picture_checks import check_background, check_size, check_times, png_path
from .plain import Json
from .surface import Surface
from .view import Look, SurfaceLook, fields_for, looks_of, page_state
from .view_values import check_colour_by
from .whole_file import write_whole

if TYPE_CHECKING:
    from .session import Background, Session

_SMALLEST, _LARGEST = (800, 540), (1600, 1200)  # of the page, larger than a telephone's; the picture has its own size
_ASK_AGAIN = 0.05  # s


@dataclass(frozen=True)
class Picture:
    """Holds a PNG. Notebooks show it."""

    data: bytes = field(repr=False)
    size: Tuple[int, int]
    path: Optional[str] = None
    bar_left_out: bool = False  # there was no room for the scalar bar

    def _repr_png_(self) -> bytes:
        return self.data

    def write(self, path: Union[str, os.PathLike[str]]) -> str:
        """Writes the file whole, or not at all."""
        path = png_path(path)
        write_whole(path, [self.data])
        return path


class Painter:
    """Draws pictures of a session by a page, for as long as the block runs. It starts with the first picture, so that
    a refused one costs nothing. `own_time`: a copy of the session is drawn, so that its clock can be set."""

    def __init__(self, session: Session, size: Tuple[int, int], *, timeout: float = 120.0, own_time: bool = False,
                 view: Optional[Look] = None) -> None:
        self._timeout, self._grant = timeout, ""
        self._copy: Optional[Session] = None
        self._chrome: Optional[Chrome] = None
        self._session, self._drawn = session, session
        self._page = _page_size(check_size(size))
        self._surfaces: List[Json] = [dict(each) for each in session.api.surface.list()["surfaces"]]
        self._own_time = own_time
        ids = [each["surface"] for each in self._surfaces]
        self._state = page_state(view, ids)
        self._fields = self._missing_fields(looks_of(view, ids))
        find_browser()

    def _missing_fields(self, looks: Mapping[str, SurfaceLook]) -> Dict[str, List[str]]:
        """Returns the fields that the server must send with surfaces besides present ones. Error: InvalidParameters
        if their data do not have them."""
        found: Dict[str, List[str]] = {}
        for each in self._surfaces:
            look = looks[each["surface"]]
            if "colour_by" in look:
                check_colour_by(look["colour_by"], self._session.client.describe(each["dataset"]))
            missing = [name for name in fields_for(look) if name not in each["fields"]]
            if missing:
                found[each["surface"]] = [*each["fields"], *missing]
        return found

    def _begin(self) -> Chrome:
        if self._chrome is None:
            if self._own_time or self._fields:
                self._copy = self._drawn = self._session.fork("picture")
            if self._fields and self._drawn.client is not self._session.client:  # what was edited could not be deleted by a link
                surface, fields = next(iter(self._fields.items()))
                raise PictureFailed(f"{surface} does not carry {fields[-1]}, which this view needs, and by a share link it cannot be asked for",
                                    hint=f"an editor can, for everyone: fields={fields}")
            for surface, fields in self._fields.items():
                Surface(self._drawn, surface).set(fields=fields)
            self._chrome = Chrome(self._address(self._state), self._page)
        return self._chrome

    def check_times(self, times: Sequence[float]) -> List[float]:
        """Raises OutsideTimeRange if the data do not reach so far."""
        return check_times(self._session, self._surfaces, times)

    def __enter__(self) -> Painter:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Ends the browser and deletes its link, or its copy of the session."""
        try:
            if self._chrome is not None:
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
        """Draws a picture like `Session.picture`. `time` only if the painter has a copy of its own."""
        width, height = check_size(size)
        check_background(background)
        path = None if path is None else png_path(path)
        if time is not None:
            if not self._own_time:
                raise PictureFailed("this painter draws the session itself, whose time is everyone's", hint="Session.picture takes a time")
            (time,) = self.check_times([time])
        chrome = self._begin()
        if time is not None:
            self._drawn.set_time(time)
        self._until_whole(chrome, time)
        setting = {"width": width, "height": height, "background": background, "bar": bar, "axes": axes, "rake": rakes,
                   "caption": caption}
        text = chrome.value(f"window.wakesurf.picture({json.dumps(setting)})", self._timeout)
        left_out = bool(chrome.value("window.wakesurf.barLeftOut ?? false"))
        if left_out:
            warnings.warn(f"{width} x {height} pixels are too small for the scalar bar, which is left out: bar=False does without", stacklevel=4)
        drawn = Picture(base64.b64decode(str(text).partition(",")[2]), (width, height), None, left_out)
        return drawn if path is None else replace(drawn, path=drawn.write(path))

    def _until_whole(self, chrome: Chrome, time: Optional[float]) -> None:
        end, why = clock.monotonic() + self._timeout, "the page has not begun"
        code = f"window.wakesurf?.unfinished?.({json.dumps(time)}) ?? 'the page has not begun'"
        while clock.monotonic() < end:
            why = str(chrome.value(code))
            if why == "":
                return
            if why.startswith("!"):
                raise PictureFailed(why[1:])
            clock.sleep(_ASK_AGAIN)
        words = chrome.value("document.querySelector('wakesurf-app')?.shadowRoot?.textContent?.trim().slice(0, 300) ?? ''")
        raise WaitTimeout(f"the picture is not whole after {self._timeout:g} s: {why}", hint=str(words or "").strip())


def _page_size(size: Tuple[int, int]) -> Tuple[int, int]:
    """Returns a size of the same shape as the picture, so that the view is the same."""
    scale = min(1.0, *(most / each for most, each in zip(_LARGEST, size)))
    scale = max(scale, *(least / each for least, each in zip(_SMALLEST, size)))
    width, height = (min(most, round(each * scale)) for most, each in zip(_LARGEST, size))
    return width, height
