"""Checks of the parameters of pictures and films: errors that can be known are raised before a browser starts."""
from __future__ import annotations

import errno
import os
from typing import TYPE_CHECKING, Any, List, Mapping, Sequence, Tuple, Union

import numpy as np

from .errors import OutsideTimeRange
from .view_values import check_choice, wrong

if TYPE_CHECKING:
    from .session import Session

_SIDES, _PIXELS = (16, 16_384), 128_000_000  # as the page has them (capture.ts)


def check_size(size: Any) -> Tuple[int, int]:
    """Raises InvalidParameters for an invalid size."""
    least, most = _SIDES
    try:
        width, height = (int(each) for each in size if int(each) == each and least <= each <= most)
    except (TypeError, ValueError):
        raise wrong(f"`size` is {size!r}", f"width and height in whole pixels, each from {least} to {most}") from None
    if width * height > _PIXELS:
        raise wrong(f"`size` is {size!r}", f"a picture has at most {_PIXELS // 1_000_000} million pixels")
    return width, height


def check_background(background: Any) -> None:
    """Raises InvalidParameters for an invalid background."""
    check_choice(background, ("shown", "white", "clear"), "background")


def png_path(path: Union[str, bytes, "os.PathLike[Any]"]) -> str:
    """Returns the path of a picture. Error: InvalidParameters if it names another format; FileNotFoundError if its
    folder does not exist."""
    path = os.fsdecode(path)
    ending = os.path.splitext(path)[1]
    if ending.lower() != ".png":
        raise wrong(f"{path!r} ends in {ending or 'nothing'}", "pictures are written as .png")
    check_folder(path)
    return path


def check_folder(path: str) -> None:
    """Raises FileNotFoundError if the folder does not exist."""
    folder = os.path.dirname(path) or "."
    if not os.path.isdir(folder):
        raise FileNotFoundError(errno.ENOENT, "there is no folder for it", path)


def check_times(session: Session, surfaces: Sequence[Mapping[str, Any]], times: Sequence[float]) -> List[float]:
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
