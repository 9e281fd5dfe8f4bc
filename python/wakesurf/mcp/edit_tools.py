"""Tools that list what there is, and that change it: open, suggest, rake, surface, undo."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, Mapping, cast

from ..errors import InvalidParameters
from ..generated.methods.rake import RakeMethods
from ..generated.methods.surface import SurfaceMethods
from ..plain import Json
from ..record import Rake
from ..surface import Surface, begin
from .tool import POINT, Answer, Call, names_of, properties_of, tool
from .work import Work, short

if TYPE_CHECKING:
    from ..session import Session

_OWN = ("session", "default", "gesture", "if_rev")  # what the tools decide
_KINDS = ["stream", "path", "streak", "time", "level"]
_DATASET: Json = {"type": "string", "description": "id of a dataset; left out, the only one"}
_MOST_FIELDS = 24


def _open(work: Work, given: Json, call: Call) -> Answer:
    if "session" in given:
        work.enter(given["session"])
    state = work.session.state()
    datasets: List[Json] = [dict(each) for each in work.client.datasets()]
    if "dataset" in given or len(datasets) == 1:
        entry = work.ready(work.dataset(given.get("dataset")), given.get("seconds", 60), call)
        datasets = [entry if each["dataset"] == entry["dataset"] else each for each in datasets]
    numbers: Json = {"session": state["session"], "datasets": [_entry(each) for each in datasets],
                     "rakes": names_of(state["rakes"], "rake"), "surfaces": [_summary(dict(each)) for each in state["surfaces"]],
                     "participants": [each["name"] for each in state["participants"]]}
    text = (f"Session {state['session']}: {len(numbers['rakes'])} rakes, {len(numbers['surfaces'])} surfaces. Datasets: "
            + (", ".join(f"{each['dataset']} ({each['state']})" for each in datasets) or "none") + ".")
    if "dataset" not in given and len(datasets) != 1:
        return Answer(text, numbers)
    dataset = entry["dataset"]
    if entry["state"] in ("importing", "failed"):
        numbers["dataset"] = _entry(entry)
        problem = entry.get("error", {})
        return Answer(f"{text} {dataset} is {entry['state']}: {problem.get('message', 'open it again to wait for it')}.", numbers)
    about: Mapping[str, Any] = work.client.describe(dataset)
    numbers["dataset"] = _described(about)
    times = about["times"]
    span = "steady" if about["steady"] or not times else f"{len(times)} times from {times[0]:g} to {times[-1]:g}"
    low, high = about["bounds"][::2], about["bounds"][1::2]
    return Answer(f"{text} {dataset}: {about['grid']} grid, {span}, from {_point(low)} to {_point(high)}"
                  f"{', with an obstacle' if about['obstacle'] else ''}.", numbers)


def _entry(entry: Mapping[str, Any]) -> Json:
    return cast(Json, short({name: entry[name] for name in ("dataset", "name", "state", "progress", "remaining", "error") if name in entry}))


def _described(about: Mapping[str, Any]) -> Json:
    members = ("dataset", "grid", "bounds", "points", "cells", "dimensions", "spacing", "steady", "velocity", "obstacle", "finestSpacing",
               "surfaceFields", "lengthUnit", "timeUnit", "note")
    numbers = {name: about[name] for name in members if name in about}
    numbers["times"] = {"count": len(about["times"]), "first": about["times"][:1], "last": about["times"][-1:]}
    numbers["fields"] = [{name: each[name] for name in ("name", "components", "range", "unit") if name in each}
                         for each in about["fields"][:_MOST_FIELDS]]
    return cast(Json, short(numbers))


def _summary(record: Json) -> Json:
    return cast(Json, short({name: record[name] for name in ("surface", "rake", "dataset", "kind", "from", "to", "separation")
                             if name in record}))


def _point(values: Any) -> str:
    return "(" + ", ".join(f"{each:g}" for each in values) + ")"


def _suggest(work: Work, given: Json, call: Call) -> Answer:
    dataset = work.dataset(given.get("dataset"))
    found: Mapping[str, Any] = work.client.suggest(dataset)
    kinds = [each["kind"] for each in found["surfaces"]]
    ends = [_point(each) for each in found["rake"]["points"]]
    return Answer(f"{found['why']} Rake from {' to '.join(ends)}; kinds: {', '.join(kinds) or 'none'}.",
                  short({"dataset": dataset, "rake": found["rake"], "surfaces": found["surfaces"]}))


def _rake(work: Work, given: Json, call: Call) -> Answer:
    session = work.session
    if given.get("delete"):
        if "rake" not in given:
            raise InvalidParameters("delete needs `rake`", -32602, "invalidParameters", "the id of the one to delete")
        session.api.rake.delete(rake=given["rake"])
        return Answer(f"Rake {given['rake']} and its surfaces are deleted.", {"rake": given["rake"], "deleted": True})
    shape = {}
    if "points" in given:
        shape = {given.get("kind") or ("line" if len(given["points"]) == 2 else "polyline"): given["points"]}
    elif "rake" not in given or "kind" in given:
        raise InvalidParameters("rake needs `points`", -32602, "invalidParameters", "a line has two: [[x, y, z], [x, y, z]]")
    rest = {name: given[name] for name in ("seeds", "name", "colour") if name in given}
    if "rake" in given:
        rake = Rake(session, given["rake"])
        rake.set(**shape, **rest)
    else:
        rake = session.rake(**shape, **rest)
    record = rake.record()
    numbers = short({name: record[name] for name in ("rake", "kind", "points", "seeds", "clipped") if name in record})
    numbers["surfaces"] = [each["surface"] for each in session.state()["surfaces"] if each.get("rake") == rake.id]
    cut = " What lay outside of the domain was cut off." if record["clipped"] else ""
    again = f" Surfaces on it are computed again: {', '.join(numbers['surfaces'])}." if numbers["surfaces"] else ""
    ends = " to ".join(_point(each) for each in record["points"][:4])
    return Answer(f"Rake {rake.id}: {record['kind']} {ends}, {record['seeds']} seeds.{cut}{again}", numbers)


def _surface(work: Work, given: Json, call: Call) -> Answer:
    session = work.session
    if given.get("delete"):
        if "surface" not in given:
            raise InvalidParameters("delete needs `surface`", -32602, "invalidParameters", "the id of the one to delete")
        surface = work.surface(given["surface"])
        surface.delete()
        return Answer(f"Surface {surface.id} is deleted.", {"surface": surface.id, "deleted": True})
    setting = {name: value for name, value in given.items() if name not in ("surface", "delete")}
    if "surface" in given:
        surface = work.surface(given["surface"])
        surface.set(**{"from_" if name == "from" else name: value for name, value in setting.items()})
    else:
        surface = _new(work, session, setting)
    work.made(surface.id)
    record = surface.record()
    what = (f"where {record['field']} of {record['dataset']} is {record['level']:.6g}" if record["kind"] == "level" else
            f"{record['kind']} of {record['dataset']} on rake {record['rake']}")
    return Answer(f"Surface {surface.id}: {what}, from {record['from']:.6g} to {record['to']:.6g}, separation {record['separation']:.4g}. "
                  "It is being computed: wait for it.", _summary(record))


def _new(work: Work, session: Session, setting: Json) -> Surface:
    if "kind" not in setting:
        raise InvalidParameters("a new surface needs `kind`", -32602, "invalidParameters", "one of " + ", ".join(_KINDS))
    return begin(session, work.dataset(setting.get("dataset")), setting)


def _undo(work: Work, given: Json, call: Call) -> Answer:
    session = work.session
    redo = given.get("redo", False)
    answer: Mapping[str, Any] = session.redo() if redo else session.undo()
    changes = answer.get("redone" if redo else "undone") or []
    numbers: Json = {"changes": changes, "skipped": answer.get("skipped", []), "undo": answer["undo"], "redo": answer["redo"]}
    if not changes:
        return Answer("Nothing is left to be repeated." if redo else "Nothing is left to be taken back.", numbers)
    words = ", ".join(f"{each.get('type', 'record')} {each.get('id', '')}" for each in changes)
    return Answer(f"{'Repeated' if redo else 'Taken back'}: {words}. {answer['undo']} edits can still be taken back, {answer['redo']} "
                  "repeated.", numbers)


OPEN = tool("open", "See what there is", "The session's rakes and surfaces, the datasets, and of one dataset its grid, bounds, times, fields and "
            "their ranges. Enters another session where one is named. Waits for a dataset that is being imported.",
            {"dataset": _DATASET, "session": {"type": "string", "description": "id of the session to work in from now on; new: an empty one"},
             "seconds": {"type": "number", "minimum": 0, "maximum": 3600, "description": "how long to wait for an import; 60"}})(_open)
SUGGEST = tool("suggest", "What to begin with", "A rake and surfaces to begin with in a dataset, and why. Changes nothing: give `kind` to the tool "
               "surface to make one of them.", {"dataset": _DATASET}, reads_only=True)(_suggest)
RAKE = tool("rake", "Place a rake", "Makes a rake, the line that particles are released from, or changes or deletes one. Changing it computes its "
            "surfaces again.",
            {**properties_of(RakeMethods.set, (*_OWN, "dragging", "force"), points={"type": "array", "items": POINT}),
             "delete": {"type": "boolean", "description": "true: deletes the rake and its surfaces"}})(_rake)
SURFACE = tool("surface", "Make or change a surface", "Makes a surface and starts to compute it; with `surface`, changes what is given of that one, or "
               "deletes it. Of a new one only `kind` must be given: dataset, rake, times and separation are then chosen by the data; for level also `field` "
               "and `level`, and no rake.",
               {**properties_of(SurfaceMethods.set, _OWN, sweep=POINT),
                "delete": {"type": "boolean", "description": "true: deletes the surface"}})(_surface)
UNDO = tool("undo", "Take back an edit", "Takes back the newest edit that was made with this link, or repeats it. Edits by other links stay; a person or script "
            "that came by the same link has the same edits.",
            {"redo": {"type": "boolean", "description": "true: repeats what was taken back last"}})(_undo)
