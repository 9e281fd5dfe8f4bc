"""Pictures and films of a session, drawn by the server's own page in a Chromium without a window.

Why the page, and not VTK: the picture is the one that people see, with its colours, transparency, lines, texture, cuts, axes and scalar
bar, drawn by the same code; a script needs neither a display nor VTK. It costs a start of the browser, some seconds, and drawing without
graphics hardware: `Painter` starts it once for several pictures.

The page looks on: it comes with a link for viewers, which is taken back at the end. What would change the session, as another time, happens
in a copy of it, which is deleted for good.
"""
from __future__ import annotations

import base64
import errno
import json
import os
import shutil
import subprocess
import tempfile
import time as clock
import urllib.parse
import warnings
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from .chrome import Chrome, find_browser
from .errors import NotPermitted, OutsideTimeRange, PictureFailed, WaitTimeout, WakesurfError
from .files import write_whole
from .plain import Json
from .progress import ProgressTarget, Report
from .surface import Surface
from .view import Look, SurfaceLook, check_choice, check_colour_by, fields_for, looks_of, page_state, wrong

if TYPE_CHECKING:
    from .session import Background, Session

_SMALLEST, _LARGEST = (800, 540), (1600, 1200)  # of the page, larger than a telephone's; the picture has its own size
_POLL_SECONDS = 0.05
_SIDES, _PIXELS = (16, 16_384), 128_000_000  # as the page has them (capture.ts)
_CODECS = {".mp4": ["-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart"],
           ".webm": ["-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0"]}


@dataclass(frozen=True)
class Picture:
    """A PNG. Notebooks show it."""

    data: bytes = field(repr=False)
    size: Tuple[int, int]
    path: Optional[str] = None
    bar_left_out: bool = False  # there was no room for the scalar bar

    def _repr_png_(self) -> bytes:
        return self.data

    def write(self, path: Union[str, os.PathLike[str]]) -> str:
        """Writes the file whole, or not at all."""
        path = _png_path(path)
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
        self._page = _page_size(_check_size(size))
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
        return _check_times(self._session, self._surfaces, times)

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
        width, height = _check_size(size)
        _check_background(background)
        path = None if path is None else _png_path(path)
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
            clock.sleep(_POLL_SECONDS)
        words = chrome.value("document.querySelector('wakesurf-app')?.shadowRoot?.textContent?.trim().slice(0, 300) ?? ''")
        raise WaitTimeout(f"the picture is not whole after {self._timeout:g} s: {why}", hint=str(words or "").strip())


def _page_size(size: Tuple[int, int]) -> Tuple[int, int]:
    """Returns a size of the same shape as the picture, so that the view is the same."""
    scale = min(1.0, *(most / each for most, each in zip(_LARGEST, size)))
    scale = max(scale, *(least / each for least, each in zip(_SMALLEST, size)))
    width, height = (min(most, round(each * scale)) for most, each in zip(_LARGEST, size))
    return width, height


def _check_size(size: Any) -> Tuple[int, int]:
    """Raises InvalidParameters for an invalid size."""
    least, most = _SIDES
    try:
        width, height = (int(each) for each in size if int(each) == each and least <= each <= most)
    except (TypeError, ValueError):
        raise wrong(f"`size` is {size!r}", f"width and height in whole pixels, each from {least} to {most}") from None
    if width * height > _PIXELS:
        raise wrong(f"`size` is {size!r}", f"a picture has at most {_PIXELS // 1_000_000} million pixels")
    return width, height


def _check_background(background: Any) -> None:
    """Raises InvalidParameters for an invalid background."""
    check_choice(background, ("shown", "white", "clear"), "background")


def _png_path(path: Union[str, bytes, "os.PathLike[Any]"]) -> str:
    """Returns the path of a picture. Error: InvalidParameters if it names another format; FileNotFoundError if its
    folder does not exist."""
    path = os.fsdecode(path)
    ending = os.path.splitext(path)[1]
    if ending.lower() != ".png":
        raise wrong(f"{path!r} ends in {ending or 'nothing'}", "pictures are written as .png")
    _check_folder(path)
    return path


def _check_folder(path: str) -> None:
    """Raises FileNotFoundError if the folder does not exist."""
    folder = os.path.dirname(path) or "."
    if not os.path.isdir(folder):
        raise FileNotFoundError(errno.ENOENT, "there is no folder for it", path)


def _check_times(session: Session, surfaces: Sequence[Mapping[str, Any]], times: Sequence[float]) -> List[float]:
    """Checks that the data of these surfaces, or they themselves, reach so far. Error: InvalidParameters,
    OutsideTimeRange."""
    found = np.asarray(times)
    if found.ndim != 1 or found.size == 0 or found.dtype.kind not in "iuf" or not np.isfinite(found).all():
        raise wrong(f"the time is {times[0]!r}" if len(times) == 1 else f"`times` is {times!r}", "one or more times of the dataset")
    datasets = [session.client.describe(each)["times"] for each in sorted({each["dataset"] for each in surfaces})]
    if datasets and all(datasets):  # where one has no times, any will do
        ends = [each for some in datasets for each in some] + [each[end] for each in surfaces for end in ("from", "to")]
        low, high = min(ends), max(ends)
        slack = 1e-9 * max(high - low, abs(low), abs(high))
        for time in found.tolist():
            if not low - slack <= time <= high + slack:
                raise OutsideTimeRange(f"the time {time:g} is outside of the data", -32013, "outsideTimeRange", f"they have {low:g} to {high:g}")
    return [float(each) for each in found]


def film(session: Session, path: Union[str, os.PathLike[str]], times: Sequence[float], size: Tuple[int, int], *, fps: float,
         view: Optional[Look], background: Background, bar: bool, axes: bool, rakes: bool, caption: Optional[str],
         progress: Optional[ProgressTarget], timeout: float) -> List[str]:
    """Makes a film; see `Session.film`."""
    path, size = os.fsdecode(path), _check_size(size)
    _check_background(background)
    codec = _CODECS.get(os.path.splitext(path)[1].lower())
    if os.path.splitext(path)[1] and codec is None:
        raise ValueError(f"{path!r} is neither a folder nor one of {', '.join(_CODECS)}")
    if not 0 < fps <= 1000:
        raise wrong(f"`fps` is {fps!r}", "pictures a second, above 0 and at most 1000")
    captions = _captions(caption, times)
    if codec:
        _check_folder(path)
    if codec and not shutil.which("ffmpeg"):
        raise PictureFailed("films as one file need ffmpeg, which is not on this machine",
                            hint="Debian: ffmpeg; or give a folder, for a series of PNG files")
    if codec:
        size = (size[0] // 2 * 2, size[1] // 2 * 2)  # half the colours of a row and of a column
        with tempfile.TemporaryDirectory(prefix="wakesurf-film-") as folder:
            _frames(session, folder, times, size, view, background, bar, axes, rakes, captions, Report.to(progress), timeout)
            _encode(folder, path, fps, codec)
        return [path]
    return _frames(session, path, times, size, view, background, bar, axes, rakes, captions, Report.to(progress), timeout)


def _frames(session: Session, folder: str, times: Sequence[float], size: Tuple[int, int], view: Optional[Look],
            background: Background, bar: bool, axes: bool, rakes: bool, captions: Sequence[Optional[str]], report: Report,
            timeout: float) -> List[str]:
    """Writes frame_0000.png and so on."""
    files: List[str] = []
    with Painter(session, size, timeout=timeout, own_time=True, view=view) as painter:
        times = painter.check_times(times)
        os.makedirs(folder, exist_ok=True)
        for i, time in enumerate(times):
            report.share(i / len(times), f"t = {time:g}")
            file = os.path.join(folder, f"frame_{i:04}.png")
            painter.picture(file, size, time=time, background=background, bar=bar, axes=axes, rakes=rakes, caption=captions[i])
            files.append(file)
    report.done("drawn")
    return files


def _captions(caption: Optional[str], times: Sequence[float]) -> List[Optional[str]]:
    """Returns the caption of each frame. Error: InvalidParameters."""
    try:
        return [None if caption is None else caption.format(time=float(time), frame=i) for i, time in enumerate(times)]
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as problem:
        raise wrong(f"`caption` is {caption!r}, which cannot be filled in: {problem}", "it may use {time} and {frame}, as in t = {time:g}") from None


def _encode(folder: str, path: str, fps: float, codec: Sequence[str]) -> None:
    command = ["ffmpeg", "-loglevel", "error", "-y", "-framerate", f"{fps:g}", "-i", os.path.join(folder, "frame_%04d.png"), *codec, path]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise PictureFailed(f"ffmpeg has failed: {done.stderr.strip()[-500:]}")
