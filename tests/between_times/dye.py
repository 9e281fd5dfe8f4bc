#!/usr/bin/env python3
"""Compares a streak surface with the front of a dye that the solver itself carried.

    dye.py CASES [CASE ...] [--wakesurf PROGRAM] [--pictures FOLDER]

CASES is the folder that `make_cases.py --dye` wrote: since the window began, what enters above the rake at the inlet is dyed
in one colour and what enters below it in another. Where the two meet is the streak surface of the rake. Prints which part
of the front is within one cell (the cube root of its volume) of the surface, which part of the surface is within one cell of
the front, and the distances in cells. --pictures draws sections of both. Needs VTK (Debian: python3-vtk9).
"""
from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any, Optional, Tuple

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))
from wakesurf.mesh import Mesh  # noqa: E402

Array = NDArray[Any]


def distances(points: Array, surface: Any) -> Tuple[Array, Array]:
    """Returns the distance of each point from a vtkPolyData, and the number of the nearest cell."""
    locator, cell, part = vtkStaticCellLocator(), reference(0), reference(0)
    locator.SetDataSet(surface)
    locator.BuildLocator()
    squares, cells, square, nearest = np.empty(len(points)), np.empty(len(points), dtype=int), reference(0.0), [0.0, 0.0, 0.0]
    for k, point in enumerate(points):
        locator.FindClosestPoint(point, nearest, cell, part, square)
        squares[k], cells[k] = square, cell
    return np.sqrt(squares), cells


def of_triangles(points: Array, triangles: Array) -> Any:
    return Mesh(points, triangles.ravel(), np.arange(len(triangles) + 1) * 3, {}, {}).to_vtk()


def run(*command: str) -> None:
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def surface(program: str, data: Path, out: Path, *options: str) -> Mesh:
    run(program, "surface", str(data), *options, "-o", str(out))
    return Mesh.from_vtp(out.read_bytes())


def alone(case: Path, time: str) -> Path:
    """Returns a case of one time: scalars that are not at every time are not read. It needs a velocity, which may be of another time."""
    moment = case / f"moment-{time}"
    (moment / time).mkdir(parents=True, exist_ok=True)
    nearest = min(case.glob("[0-9]*/U"), key=lambda file: abs(float(file.parent.name) - float(time)))
    for file in (case / "constant", case / "system", *(case / time).iterdir(), nearest):
        link = moment / (file.relative_to(case) if file != nearest else Path(time, "U"))
        if not link.exists():
            link.symlink_to(file.resolve())
    (moment / "case.foam").touch()
    return moment / "case.foam"


def measure(weights: Array, cells: Array) -> str:
    order = np.argsort(cells)
    share = np.cumsum(weights[order]) / weights.sum()
    at = [cells[order][min(np.searchsorted(share, q), len(order) - 1)] for q in (0.5, 0.9, 0.95, 0.99)]
    return f"{weights[cells <= 1].sum() / weights.sum():6.1%} within a cell; p50 {at[0]:.2f} p90 {at[1]:.2f} p95 {at[2]:.2f} p99 {at[3]:.2f} cells"


def section(points: Array, triangles: Array, z: float) -> Array:
    """Returns the segments [n, 2, 2] in which triangles meet the plane of this z, in x and y."""
    above = points[triangles][:, :, 2] > z
    cut = triangles[above.any(axis=1) & ~above.all(axis=1)]
    ends = []
    for i, j in ((0, 1), (1, 2), (2, 0)):
        a, b = points[cut[:, i]], points[cut[:, j]]
        crosses = (a[:, 2] > z) != (b[:, 2] > z)
        share = np.where(crosses, (z - a[:, 2]) / np.where(crosses, b[:, 2] - a[:, 2], 1.0), np.nan)
        ends.append(a[:, :2] + share[:, None] * (b - a)[:, :2])
    found = np.stack(ends, axis=1)
    return found[~np.isnan(found)].reshape(-1, 2, 2)


def draw(file: Path, front: Array, surface: Array) -> None:
    """Writes an SVG: the dye's front broad and pale, the surface thin and dark."""
    both = np.concatenate([front, surface]).reshape(-1, 2)
    (left, low), (right, high) = both.min(axis=0) - 0.3, both.max(axis=0) + 0.3
    def path(segments: Array, stroke: str) -> str:
        steps = "".join(f"M{a[0] - left:.3f} {high - a[1]:.3f}L{b[0] - left:.3f} {high - b[1]:.3f}" for a, b in segments)
        return f'<path d="{steps}" fill="none" stroke-linecap="round" {stroke}/>'
    file.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {right - left:.3f} {high - low:.3f}" width="1000">'
                    '<rect width="100%" height="100%" fill="white"/>'
                    + path(front, 'stroke="#f0a860" stroke-width="0.09"') + path(surface, 'stroke="#124" stroke-width="0.02"') + "</svg>\n")


def compare(program: str, case: Path, name: str, pictures: Optional[Path]) -> None:
    about = json.loads((HERE / "cases" / name / "case.json").read_text())
    start, rake = about["spinUp"], about["dye"]["rake"]
    series = case / "series"
    last = max(float(file.parent.name) for file in case.glob("[0-9]*/U"))
    run(program, "import", str(case / "case.foam"), str(series), "--times", f"{start}:{start + about['window']}")
    for part in (0.5, 1.0):
        time = f"{start + part * about['window']:g}"
        if not (case / time / "dyeAbove").exists():
            continue
        run("postProcess", "-func", "writeCellVolumes", "-time", time, "-case", str(case))
        moment = alone(case, time)
        front = surface(program, moment, case / f"front-{time}.vtp", "--kind", "level", "--field", "dyeAbove", "--level", "0.5",
                        "--from", time, "--to", time, "--fields", "dyeBelow,V", "--separation", str(about["length"]))
        triangles = front.triangles()
        # where dyed fluid touches what was there before, the other dye is not near
        triangles = triangles[(front["dyeBelow"] > 0.25)[triangles].all(axis=1)]
        corners, width = front.points[triangles], np.cbrt(front["V"][triangles].mean(axis=1))
        streak = surface(program, series, case / f"streak-{time}.vtp", "--kind", "streak", "--rake", rake,
                         "--rake-kind", about["dye"].get("rakeKind", "line"), "--seeds", "65", "--accuracy", "exact",
                         "--separation", str(np.percentile(width, 5)), "--from", str(start), "--to", f"{min(float(time), last):g}")
        sheet = streak.triangles()
        to_sheet, _ = distances(corners.mean(axis=1), of_triangles(streak.points, sheet))
        to_front, nearest = distances(streak.points[sheet].mean(axis=1), of_triangles(front.points, triangles))
        print(f"{name}, t {time}: {len(corners)} triangles of the front, {len(sheet)} of the surface; cells {width.min():.3f} to {width.max():.3f}")
        print("  front to surface", measure(front.areas(triangles), to_sheet / width))
        if pictures is not None:
            z = float(np.mean([float(point.split(",")[2]) for point in rake.split(" ")[:1 if "rakeKind" in about["dye"] else 2]]))
            draw(pictures / f"dye-{name}-{time}.svg", section(front.points, triangles, z), section(streak.points, sheet, z))
        print("  surface to front", measure(streak.areas(sheet), to_front / width[nearest]), flush=True)


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("cases", type=Path)
    arguments.add_argument("names", nargs="*", metavar="CASE")
    arguments.add_argument("--wakesurf", default="wakesurf")
    arguments.add_argument("--pictures", type=Path)
    given = arguments.parse_args()
    os.environ.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
    for name in given.names or [n for n in ("cylinder", "jet", "sphere") if (given.cases / n).exists()]:
        compare(given.wakesurf, given.cases / name, name, given.pictures)


if __name__ == "__main__":
    main()
