"""Files that are complete or do not exist."""
from __future__ import annotations

import os
import secrets
from typing import Iterable


def write_whole(path: str, parts: Iterable[bytes]) -> None:
    """Writes a new file beside the old one and renames it: a reader, or a server that watches, sees no half of it.
    Error: OSError, which names `path`; nothing is left behind then."""
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
