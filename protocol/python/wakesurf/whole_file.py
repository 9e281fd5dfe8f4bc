"""Files that are there whole or not at all."""
from __future__ import annotations

import os
import secrets
from typing import Iterable


def write_whole(path: str, parts: Iterable[bytes]) -> None:
    """By a file beside it that is new, whatever lies there, and then takes its name: a reader, or a server that watches, sees no half
    of it. Error: OSError, which names `path`; nothing is left behind then."""
    part = f"{path}.{secrets.token_hex(6)}.part"
    try:
        with open(part, "xb") as file:
            file.writelines(parts)
        os.replace(part, path)
    except OSError as problem:
        _remove(part)
        raise type(problem)(problem.errno, problem.strerror, path) from None
    except BaseException:
        _remove(part)
        raise


def _remove(part: str) -> None:
    if os.path.exists(part):
        os.remove(part)
