"""Tools that measure: wait, numbers, compare, explain. The mathematics of meshes is at the end."""
from __future__ import annotations

from typing import Any, Dict, List, Mapping, Tuple, cast

import numpy as np

from ..errors import WaitTimeout
from ..mesh import Array, Mesh
from ..plain import Json
from ..progress import Progress
from ..surface import Surface
from .tool import SURFACE as SURFACE_ID, TIME, Answer, Call, tool
from .work import Work, short

_MOST_DISTANCES = 200_000_000  # of one comparison, from samples to vertices
_MOST_SAMPLES = 2000
_AT_ONCE = 4_000_000
_ENDS = {"time": "reached the end of the time that was asked for", "domain": "left the domain", "obstacle": "reached an obstacle",
         "stagnation": "came to rest", "budget": "used up the steps allowed: raise max_quads, or shorten the time"}
_KINDS = {"stream": "all streamlines of one frozen moment, from the rake on: the structure of the field then. Do not read motion from it in an "
                    "unsteady flow.",
          "path": "the ways of particles that leave the rake together: where does what passes here end up?",
          "streak": "all particles released from the rake since a time, as they lie now: smoke or dye. It shows roll-up and shedding best.",
          "time": "a patch of particles released together, as it lies now: how does this piece of fluid stretch and fold?",
          "level": "where a scalar field has one value. No particle is released for it."}
_REPORTED = ("surface", "complete", "kind", "quads", "vertices", "separation", "requestedSeparation", "coarsened", "maxEdge", "approximated",
         "error99", "uncertain", "intervalError99", "intervalUnresolved", "advisedInterval", "intervalLeftOut",
         "terminated", "torn", "dataEnd", "fieldRange", "stopped", "empty", "error")


def _statistics(stats: Mapping[str, Any]) -> Json:
    return cast(Json, short({name: stats[name] for name in _REPORTED if name in stats}))


def _wait(work: Work, given: Json, call: Call) -> Answer:
    surface = work.surface(given.get("surface"))

    def report(progress: Progress) -> None:
        call.progress(progress.share, progress.message or "computing")

    try:
        stats: Mapping[str, Any] = surface.wait(given.get("seconds", 60), report)
    except WaitTimeout:
        stats = surface.stats()
        if not stats["complete"]:
            return Answer(f"{surface.id} is still being computed: {stats['quads']} quads so far. Wait again, or change it: a larger "
                          "separation takes less time.", _statistics(stats))
    return Answer(f"{surface.id} is complete: {_size(stats)}{_error(stats)}.{_empty(stats)}", _statistics(stats))


def _size(stats: Mapping[str, Any]) -> str:
    return f"{stats['quads']} quads, {stats['vertices']} vertices"


def _error(stats: Mapping[str, Any]) -> str:
    if "error99" not in stats:
        return ""
    return f", 99 % of them within {stats['error99']:.2g} of the true surface, {stats.get('uncertain', 0)} uncertain"


def _empty(stats: Mapping[str, Any]) -> str:
    empty = stats.get("empty")
    return f" There is nothing to see: {empty['message']} ({empty['hint']})." if empty else ""


def _numbers(work: Work, given: Json, call: Call) -> Answer:
    surface = work.surface(given.get("surface"))
    call.check()
    if "through" in given or "times" in given:
        return _measured(surface, given)
    mesh = surface.mesh(time=given.get("time"))
    numbers: Json = {"surface": surface.id, **{name: mesh.about[name] for name in ("kind", "dataset", "time") if name in mesh.about},
               **_mesh_numbers(mesh)}
    if not len(mesh.points):
        return Answer(f"{surface.id} has no vertices{_at(numbers)}: ask explain why.", numbers)
    fields: Dict[str, Json] = numbers["fields"]
    speed = fields.get("speed", {})
    size = numbers["bounds"]
    box = " x ".join(f"{size[2 * i + 1] - size[2 * i]:.4g}" for i in range(3))
    return Answer(f"{surface.id}{_at(numbers)}: area {numbers['area']:.5g} in a box of {box}, {numbers['vertices']} vertices"
                  + (f", speed {speed['min']:.3g} to {speed['max']:.3g}, {speed['mean']:.3g} in the mean" if "mean" in speed else "") + ".",
                  numbers)


def _measured(surface: Surface, given: Json) -> Answer:
    found = surface.numbers(given.get("times"), given.get("through"), time=given.get("time"))
    last = found.row()
    rows = [{name: short(value) if np.isfinite(value) else None for name, value in found.row(i).items()} for i in range(len(found))]
    notes = "; ".join(dict.fromkeys(filter(None, found.notes)))
    return Answer(f"{surface.id}: area {last['area']:.5g}, {len(rows)} time(s) of {len(last)} numbers." + (f" {notes}." if notes else ""),
                  {"surface": surface.id, "units": dict(found.units), "rows": rows, "notes": found.notes})


def _at(numbers: Mapping[str, Any]) -> str:
    return f" at time {numbers['time']:g}" if isinstance(numbers.get("time"), (int, float)) else ""


def _compare(work: Work, given: Json, call: Call) -> Answer:
    one, other = work.surface(given["a"]), work.surface(given.get("b", given["a"]))
    meshes = []
    for surface, time in ((one, given.get("time_a")), (other, given.get("time_b"))):
        call.check()
        meshes.append(surface.mesh(time=time))
    a, b = (_mesh_numbers(each) for each in meshes)
    call.check()
    away: Json = {"a_from_b": _distance(*meshes), "b_from_a": _distance(meshes[1], meshes[0])}
    fields = {name: {"a": first, "b": second} for name, first, second in _change_of(a["fields"], b["fields"])}
    numbers: Json = {"a": {"surface": one.id, "time": given.get("time_a")}, "b": {"surface": other.id, "time": given.get("time_b")},
                     "area": {"a": a["area"], "b": b["area"], "ratio": _ratio(a["area"], b["area"])},
                     "vertices": {"a": a["vertices"], "b": b["vertices"]}, "bounds": {"a": a["bounds"], "b": b["bounds"]},
                     "means": fields, "distance": away}
    far = max((each.get("max", 0.0) for each in away.values()), default=0.0)
    mean = max((each.get("mean", 0.0) for each in away.values()), default=0.0)
    grown = "" if numbers["area"]["ratio"] is None else f"{numbers['area']['ratio']:.4g} times the area of"
    return Answer(f"b has {grown or 'a different area from'} a; they are {mean:.3g} apart in the mean, {far:.3g} where they are farthest.", numbers)


def _explain(work: Work, given: Json, call: Call) -> Answer:
    surface = work.surface(given.get("surface"))
    stats: Mapping[str, Any] = surface.stats()
    return Answer(" ".join(_sentences(surface, stats)), {**_statistics(stats), "parameters": short(surface.record())})


def _sentences(surface: Surface, stats: Mapping[str, Any]) -> List[str]:
    said = [f"{surface.id} is a {stats['kind']} surface: {_KINDS[stats['kind']]}"]
    if not stats["complete"]:
        said.append("It is still being computed.")
    if stats.get("error"):
        said.append(f"It cannot be computed: {stats['error'].get('message', '')} {stats['error'].get('hint', '')}".strip() + ".")
    ended = {name: count for name, count in stats.get("terminated", {}).items() if count}
    if ended:
        said.append("Of its particles " + "; ".join(f"{count} {_ENDS.get(name, name)}" for name, count in ended.items()) + ".")
    if stats.get("coarsened"):
        said.append(f"A separation of {stats['requestedSeparation']:.4g} needs more quads than allowed, so it is {stats['separation']:.4g}: "
                    "raise max_quads, or release fewer.")
    if stats.get("torn"):
        said.append(f"{stats['torn']} cells were torn where neighbours went apart.")
    if stats.get("uncertain"):
        said.append(f"{stats['uncertain']} of {stats['vertices']} vertices may be farther than the separation from the true surface: accuracy "
                    "exact places them better.")
    if stats.get("stopped"):
        said.append(f"It ends early: {stats['stopped']}.")
    if "dataEnd" in stats:
        said.append(f"Backward it ends at {stats['dataEnd']:g}, where the data begin.")
    return [*said, _empty(stats).strip()] if stats.get("empty") else said


WAIT = tool("wait", "Wait for a surface", "Waits until a surface is complete, and tells its size and its estimated error. Tells how far it is.",
            {"surface": SURFACE_ID, "seconds": {"type": "number", "minimum": 0, "maximum": 3600, "description": "at most so long; 60"}},
            reads_only=True)(_wait)
NUMBERS = tool("numbers", "Measure a surface", "Area, bounds, and the least, greatest and mean value (by area) of each field on a surface: speed, t (age), s "
               "(place on the rake), deformation, and the fields that it was made with. With `through` or `times` instead: area, flux, ages and times of "
               "stay, each with its errors.",
               {"surface": SURFACE_ID, "time": TIME,
                "through": {"type": "string", "description": "plane:x,y,z:nx,ny,nz or box:x,y,z:x,y,z: ages where the surface meets it, and what is inside"},
                "times": {"type": "string", "description": "FIRST:LAST:EVERY: a row each; of a stream surface `from` plus the age"}},
               reads_only=True)(_numbers)
COMPARE = tool("compare", "Compare two surfaces", "Areas, bounds, means of fields, and how far two surfaces are apart; or one at two times.",
               {"a": {"type": "string", "description": "id of a surface"}, "b": {"type": "string", "description": "id of another; left out, `a` itself"},
                "time_a": {**TIME, "description": "time at which a is taken"}, "time_b": {**TIME, "description": "time at which b is taken"}},
               ["a"], reads_only=True)(_compare)
EXPLAIN = tool("explain", "Why it is as it is", "In words: what this kind of surface means, why its particles ended, whether it is coarser than asked for, "
               "how exact it is, and what to do about it.", {"surface": SURFACE_ID}, reads_only=True)(_explain)


def _bounds_of(mesh: Mesh) -> List[float]:
    """Returns x0, x1, y0, y1, z0, z1; empty for an empty mesh."""
    if not len(mesh.points):
        return []
    return [float(each) for pair in zip(mesh.points.min(axis=0), mesh.points.max(axis=0)) for each in pair]


def _vertex_areas(mesh: Mesh, triangles: Array) -> Array:
    """Gives each vertex a third of the area of the triangles round it."""
    areas = np.zeros(len(mesh.points))
    np.add.at(areas, triangles, (mesh.areas(triangles) / 3)[:, None])
    return areas


def _field_numbers(mesh: Mesh, weights: Array) -> Dict[str, Json]:
    """Returns least, greatest and mean of each array; of vectors, of their magnitude. The mean is by area: vertices
    are dense where a surface is folded."""
    found: Dict[str, Json] = {}
    for name, values in mesh.arrays.items():
        if name in ("velocity", "component"):  # speed is its magnitude; a number of a piece says nothing in the mean
            continue
        numbers = np.linalg.norm(values, axis=1) if values.ndim > 1 else values.astype(float)
        known = np.isfinite(numbers)
        if not known.any():
            found[name] = {"undefined": int(len(numbers))}
            continue
        numbers, weight = numbers[known], weights[known]
        mean = float(np.average(numbers, weights=weight)) if weight.sum() > 0 else float(numbers.mean())
        found[name] = {"min": float(numbers.min()), "max": float(numbers.max()), "mean": mean}
        if not known.all():
            found[name]["undefined"] = int((~known).sum())
    return found


def _mesh_numbers(mesh: Mesh) -> Json:
    """Returns all numbers of a mesh."""
    triangles = mesh.triangles()
    weights = _vertex_areas(mesh, triangles)
    numbers: Json = {"vertices": len(mesh.points), "cells": max(0, len(mesh.offsets) - 1), "area": float(weights.sum()),
                     "bounds": _bounds_of(mesh), "fields": _field_numbers(mesh, weights) if len(mesh.points) else {}}
    made: Json = short(numbers)
    return made


def _distance(of: Mesh, to: Mesh) -> Json:
    """Returns the mean and greatest distance of vertices of one from the other surface. Of many vertices, evenly
    chosen ones are measured; each against the triangles round the nearest vertex, so that it is never too small."""
    if not len(of.points) or not len(to.points):
        return {}
    most = int(max(50, min(_MOST_SAMPLES, _MOST_DISTANCES // len(to.points))))
    chosen = np.unique(np.linspace(0, len(of.points) - 1, min(most, len(of.points))).astype(int))
    points = of.points[chosen]
    found = _to_triangles(points, _nearest(points, to.points), to)
    made: Json = short({"mean": float(found.mean()), "max": float(found.max()), "measured": int(len(points))})
    return made


def _nearest(points: Array, vertices: Array) -> Array:
    """Returns the index of the nearest vertex to each point."""
    middle = vertices.mean(axis=0)  # small numbers, whose squares lose less
    near, far = points - middle, vertices - middle
    squares = (far ** 2).sum(axis=1)
    step = max(1, _AT_ONCE // len(vertices))
    parts = [(squares - 2 * near[i:i + step] @ far.T).argmin(axis=1) for i in range(0, len(points), step)]
    return np.concatenate(parts)


def _to_triangles(points: Array, nearest: Array, mesh: Mesh) -> Array:
    """Returns the distance of each point to the nearest of the triangles round a vertex; to the vertex if it has
    none."""
    found: Array = np.linalg.norm(points - mesh.points[nearest], axis=1)
    triangles = mesh.triangles()
    wanted = np.isin(triangles, nearest).any(axis=1)
    triangles = triangles[wanted]
    corner = triangles.reshape(-1)
    order = np.argsort(corner, kind="stable")
    first = np.searchsorted(corner[order], nearest, "left")
    count = np.searchsorted(corner[order], nearest, "right") - first
    which = np.repeat(np.arange(len(points)), count)
    inner = np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)
    pairs = triangles[order[np.repeat(first, count) + inner] // 3]
    a, b, c = (mesh.points[pairs[:, i]] for i in range(3))
    np.minimum.at(found, which, _to_triangle(points[which], a, b, c))
    return found


def _to_triangle(p: Array, a: Array, b: Array, c: Array) -> Array:
    """Returns distances row by row: to the plane if the foot lies inside, else to the nearest side."""
    normal = np.cross(b - a, c - a)
    square = (normal ** 2).sum(axis=1)
    inside = square > 0
    for start, end in ((a, b), (b, c), (c, a)):
        inside &= (np.cross(end - start, p - start) * normal).sum(axis=1) >= 0
    sides = np.min([_to_segment(p, start, end) for start, end in ((a, b), (b, c), (c, a))], axis=0)
    height = np.abs(((p - a) * normal).sum(axis=1)) / np.sqrt(np.where(square > 0, square, 1.0))
    nearest: Array = np.where(inside, height, sides)
    return nearest


def _to_segment(p: Array, a: Array, b: Array) -> Array:
    along, square = b - a, ((b - a) ** 2).sum(axis=1)
    share = np.clip(((p - a) * along).sum(axis=1) / np.where(square > 0, square, 1.0), 0.0, 1.0)
    length: Array = np.linalg.norm(p - a - share[:, None] * along, axis=1)
    return length


def _ratio(a: float, b: float) -> Any:
    """Returns the ratio of b to a; None if it is undefined."""
    return short(b / a) if a else None


def _change_of(a: Dict[str, Json], b: Dict[str, Json]) -> List[Tuple[str, Any, Any]]:
    """Returns name and both means of the fields that both have."""
    return [(name, a[name].get("mean"), b[name].get("mean")) for name in a if name in b]
