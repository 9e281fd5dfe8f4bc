"""A film: a picture for each time, as PNG files or, by ffmpeg, as one .mp4 or .webm."""
from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from typing import TYPE_CHECKING, List, Optional, Sequence, Tuple, Union

from .errors import PictureFailed
from .picture import Painter
from .picture_checks import check_background, check_folder, check_size
from .progress import Report, Told
from .view import Look
from .view_values import wrong

if TYPE_CHECKING:
    from .session import Background, Session

_CODECS = {".mp4": ["-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart"],
           ".webm": ["-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0"]}


def film(session: Session, path: Union[str, os.PathLike[str]], times: Sequence[float], size: Tuple[int, int], *, fps: float,
         view: Optional[Look], background: Background, bar: bool, axes: bool, rakes: bool, caption: Optional[str],
         progress: Optional[Told], timeout: float) -> List[str]:
    """Makes a film; see `Session.film`."""
    path, size = os.fsdecode(path), check_size(size)
    check_background(background)
    codec = _CODECS.get(os.path.splitext(path)[1].lower())
    if os.path.splitext(path)[1] and codec is None:
        raise ValueError(f"{path!r} is neither a folder nor one of {', '.join(_CODECS)}")
    if not 0 < fps <= 1000:
        raise wrong(f"`fps` is {fps!r}", "pictures a second, above 0 and at most 1000")
    captions = _captions(caption, times)
    if codec:
        check_folder(path)
    if codec and not shutil.which("ffmpeg"):
        raise PictureFailed("films as one file need ffmpeg, which is not on this machine",
                            hint="Debian: ffmpeg; or give a folder, for a series of PNG files")
    if codec:
        size = (size[0] // 2 * 2, size[1] // 2 * 2)  # half the colours of a row and of a column
        with tempfile.TemporaryDirectory(prefix="wakesurf-film-") as folder:
            frames(session, folder, times, size, view, background, bar, axes, rakes, captions, Report.to(progress), timeout)
            _encode(folder, path, fps, codec)
        return [path]
    return frames(session, path, times, size, view, background, bar, axes, rakes, captions, Report.to(progress), timeout)


def frames(session: Session, folder: str, times: Sequence[float], size: Tuple[int, int], view: Optional[Look],
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
