"""A surface of which only the kind must be given: the server suggests the other parameters for the data."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Mapping

from .errors import InvalidParameters, WakesurfError
from .plain import Json
from .surface import Surface

if TYPE_CHECKING:
    from .session import Session


def begin(session: Session, dataset: str, setting: Json) -> Surface:
    """Makes a surface. `setting`: parameters of surface.set by their names in Python, but `from`. Error: as
    Session.surface."""
    found: Mapping[str, Any] = session.client.suggest(dataset) if not {"rake", "to", "separation"} <= setting.keys() else {"surfaces": []}
    usual: Dict[str, Any] = dict(next((each for each in found["surfaces"] if each["kind"] == setting["kind"]), {}))
    if setting.keys() & {"from", "to", "direction"}:
        usual = {name: value for name, value in usual.items() if name not in ("from", "to")}
    if setting.keys() & {"sweep", "rake2"}:
        usual.pop("sweep", None)
    merged: Json = {**usual, **setting, "dataset": dataset}
    if "to" not in merged:
        merged["to"] = last_time(session, merged)
    merged.pop("rake", None)
    rake = setting["rake"] if "rake" in setting else session.api.rake.set(**found["rake"])["rake"]
    try:
        return session.surface(rake, **{"from_" if name == "from" else name: value for name, value in merged.items()})
    except WakesurfError:
        if "rake" not in setting:
            session.api.rake.delete(rake=rake)  # nobody asked for it alone
        raise


def last_time(session: Session, setting: Json) -> float:
    """Returns the last time of the data, or the first for a surface that goes backward. A flow of one time stands still:
    as long after it, or before it, as a suggested surface of that kind takes."""
    times = session.client.describe(setting["dataset"])["times"]
    if not times:
        raise InvalidParameters("a surface of this dataset needs `to`", -32602, "invalidParameters", "the time at which it ends")
    backward = setting.get("direction") == "backward"
    if len(times) == 1 and setting["kind"] != "level":
        found: Any = session.client.suggest(setting["dataset"])["surfaces"]
        length = next((each["to"] - each["from"] for each in found if each["kind"] == setting["kind"]), 1.0)
        return float(setting.get("from", times[0]) + (-length if backward else length))
    return float(times[0] if backward else times[-1])
