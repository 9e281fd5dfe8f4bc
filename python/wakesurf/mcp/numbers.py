"""Meshes in numbers: their size, their place, the values of their fields, and the distance of two of them."""
from __future__ import annotations

from typing import Any, Dict, List, Tuple

import numpy as np

from ..mesh import Array, Mesh
from ..plain import Json
from .work import short

_MOST_DISTANCES = 200_000_000  # of one comparison, from samples to vertices
_MOST_SAMPLES = 2000
_AT_ONCE = 4_000_000


def bounds_of(mesh: Mesh) -> List[float]:
    """Returns x0, x1, y0, y1, z0, z1; empty for an empty mesh."""
    if not len(mesh.points):
        return []
    return [float(each) for pair in zip(mesh.points.min(axis=0), mesh.points.max(axis=0)) for each in pair]


def vertex_areas(mesh: Mesh, triangles: Array) -> Array:
    """Gives each vertex a third of the area of the triangles round it."""
    areas = np.zeros(len(mesh.points))
    np.add.at(areas, triangles, (mesh.areas(triangles) / 3)[:, None])
    return areas


def field_numbers(mesh: Mesh, weights: Array) -> Dict[str, Json]:
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


def mesh_numbers(mesh: Mesh) -> Json:
    """Returns all numbers of a mesh."""
    triangles = mesh.triangles()
    weights = vertex_areas(mesh, triangles)
    numbers: Json = {"vertices": len(mesh.points), "cells": max(0, len(mesh.offsets) - 1), "area": float(weights.sum()),
                     "bounds": bounds_of(mesh), "fields": field_numbers(mesh, weights) if len(mesh.points) else {}}
    made: Json = short(numbers)
    return made


def distance(of: Mesh, to: Mesh) -> Json:
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


def ratio(a: float, b: float) -> Any:
    """Returns the ratio of b to a; None if it is undefined."""
    return short(b / a) if a else None


def change_of(a: Dict[str, Json], b: Dict[str, Json]) -> List[Tuple[str, Any, Any]]:
    """Returns name and both means of the fields that both have."""
    return [(name, a[name].get("mean"), b[name].get("mean")) for name in a if name in b]
