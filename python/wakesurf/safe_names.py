"""Names of files that are made of names from anywhere."""
from __future__ import annotations

import hashlib
import re
from typing import List, Sequence, Set

_DEVICES = re.compile(r"^(con|prn|aux|nul|(com|lpt)[1-9])(?=\.|$)", re.IGNORECASE)  # to Windows, whatever the extension
_LONGEST = 40  # letters, of at most four bytes; file systems take 255 bytes


def safe_names(names: Sequence[str], others: Sequence[str] = ()) -> List[str]:
    """Returns a name of a file for each, below no other folder and hidden nowhere, different ones for different names, also where
    letters differ in case alone, and but for that the same one in whatever company a name is. What has to be changed gets a checksum.
    `others`: names that are in use.

    >>> safe_names(["wing", "y=0.5", "Wing"])
    ['wing', 'y=0.5', 'Wing-...']
    >>> safe_names(["../../etc"])[0][:4]
    'etc-'
    """
    taken: Set[str] = {each.casefold() for each in others}
    out = []
    for name in names:
        safe = _DEVICES.sub(r"\1_", re.sub(r"[^\w.=+,-]+", "-", name).strip("-. ")[:_LONGEST])
        if safe != name or not safe or safe.casefold() in taken:
            safe = f"{safe}-{hashlib.sha256(name.encode(errors='surrogatepass')).hexdigest()[:10]}".lstrip("-")
        while safe.casefold() in taken:
            safe += "_"
        taken.add(safe.casefold())
        out.append(safe)
    return out
