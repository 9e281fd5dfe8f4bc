#!/usr/bin/env python3
"""Traces the benchmark's particles with wakesurf, through every 1st, 2nd, 4th, ... stored time of the cases.

    trace.py CASES PLACES [CASE ...] [--every 1,2,4,8,16] [--between linear] [--kinds streak,path]
             [--wakesurf PROGRAM]

CASES is the folder that make_cases.py wrote. Writes PLACES/CASE/RAKE-KIND-every-N[-BETWEEN].csv, and beside each the
statistics that wakesurf states.
"""
from __future__ import annotations

import argparse
import json
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict, List

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "python")]
from particles import ACROSS, ALONG, T, Array, write_places  # noqa: E402
from wakesurf.mesh import Mesh  # noqa: E402

ROWS = 4 * ALONG  # of the surface that places are taken from, at least


def along(times: Array, rows: Array, at: Array) -> Array:
    """Returns the places between rows, by the cubic through four of them; not a number where one of these is none."""
    first = np.clip(np.searchsorted(times, at) - 2, 0, len(times) - 4)
    out = np.zeros((len(at), *rows.shape[1:]))
    for j in range(4):
        weight = np.ones(len(at))
        for k in range(4):
            if k != j:
                weight *= (at - times[first + k]) / (times[first + j] - times[first + k])
        out += weight[:, None, None] * rows[first + j]
    return out


def places(mesh: Mesh, start: float, end: float) -> Array:
    """Returns where the particles of the benchmark are, (ACROSS, ALONG, 3), from a surface with a column for each."""
    origin = mesh["t"] if mesh.about["kind"] == "streak" else mesh["t"] + start
    times, row = np.unique(origin.round(9), return_inverse=True)
    rows = np.full((len(times), ACROSS, 3), np.nan)
    rows[row, np.rint(mesh["s"] * (ACROSS - 1)).astype(int)] = mesh.points
    assert np.allclose(mesh["s"] * (ACROSS - 1), np.rint(mesh["s"] * (ACROSS - 1)))
    return along(times, rows, start + T * (end - start)).transpose(1, 0, 2)


def trace(program: str, store: Path, rake: str, kind: str, times: List[float], between: str, out: Path) -> None:
    start, end = times
    surface = out.with_suffix(".vtp")
    separation = 4 * (end - start) / ROWS
    while True:
        separation /= 2
        subprocess.run([program, "surface", str(store), "--kind", kind, "--rake", rake, "--seeds", str(ACROSS), "--refine", "off",
                        "--accuracy", "exact", "--separation", str(separation), "--from", str(start), "--to", str(end),
                        *([] if between == "linear" else ["--between", between]), "--stats", str(out.with_suffix(".json")),
                        "-o", str(surface)], check=True, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        mesh = Mesh.from_vtp(surface.read_bytes())
        if len(np.unique(mesh["t"].round(9))) >= ROWS:
            break
    write_places(out, places(mesh, start, end))
    surface.unlink()


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("cases", type=Path)
    arguments.add_argument("places", type=Path)
    arguments.add_argument("names", nargs="*", metavar="CASE")
    arguments.add_argument("--every", default="1,2,4,8,16")
    arguments.add_argument("--between", default="linear")
    arguments.add_argument("--kinds", default="streak,path")
    arguments.add_argument("--wakesurf", default="wakesurf")
    given = arguments.parse_args()
    for name in given.names or sorted(path.parent.name for path in given.cases.glob("*/case.foam")):
        case: Dict[str, Any] = json.loads((HERE / "cases" / name / "case.json").read_text())
        times = [float(case["spinUp"]), float(case["spinUp"] + case["followed"])]
        out = given.places / name
        out.mkdir(parents=True, exist_ok=True)
        for every in map(int, given.every.split(",")):
            store = out / f"every-{every}"
            subprocess.run([given.wakesurf, "import", str(given.cases / name / "case.foam"), str(store), "--times",
                            f"{times[0]}:{case['spinUp'] + case['window']}:{every}"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            for rake, points in case["rakes"].items():
                for kind in given.kinds.split(","):
                    print(name, rake, kind, every, flush=True)
                    trace(given.wakesurf, store, points, kind, times, given.between,
                          out / f"{rake.replace(' ', '-')}-{kind}-every-{every}{'' if given.between == 'linear' else '-' + given.between}.csv")


if __name__ == "__main__":
    main()
