#!/usr/bin/env python3
"""Compares where particles come to with where the full series takes them.

    score.py PLACES [CASE ...] [--between linear]     a table of what trace.py wrote
    score.py --truth TRUTH.csv TOOL.csv [--length 1]  of files of any tool

Distances are in body lengths. "off" is the distance from the truth of half, 90 % and 99 % of the particles; "lost" the part
that arrives in one of the two only. Of each particle the same series predicts the distance when it is thinned twice more
(Richardson); "within 3" is the part of the resolved ones whose prediction is within a factor of 3.
"""
from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Dict, Optional, Tuple

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
from particles import Array, read_places  # noqa: E402

HERE = Path(__file__).resolve().parent


def distance(a: Array, b: Array) -> Array:
    out: Array = np.linalg.norm(a - b, axis=-1)
    return out


def percentiles(off: Array) -> Array:
    out: Array = np.percentile(off[np.isfinite(off)], [50, 90, 99])
    return out


def largest_around(values: Array, rings: int = 2) -> Array:
    """Returns the largest of the neighbours; not a number where one of them is none."""
    padded = np.pad(values, rings, mode="edge")
    windows = np.lib.stride_tricks.sliding_window_view(padded, (2 * rings + 1, 2 * rings + 1))
    out: Array = windows.max(axis=(2, 3))
    return out


def predicted(here: Array, second: Array, fourth: Array) -> Tuple[Array, Array]:
    """Returns the distance that is predicted from every 2nd and 4th stored time, and whether the two agree."""
    error = (second - here) / 3
    near, far = np.linalg.norm(error, axis=-1), np.linalg.norm((fourth - here) / 15 - error, axis=-1)
    return near, largest_around(far) <= 0.5 * largest_around(near)


def within(prediction: Array, truth: Array, factor: float = 3) -> float:
    return float(np.mean((prediction <= factor * truth) & (truth <= factor * prediction))) if len(truth) else float("nan")


def score(folder: Path, between: str, length: float) -> None:
    for truth_file in sorted(folder.glob("*-every-1.csv")):
        stem = truth_file.name[:-len("-every-1.csv")]
        suffix = "" if between == "linear" else "-" + between
        series: Dict[int, Array] = {}
        for path in folder.glob(f"{stem}-every-*{suffix}.csv"):
            number = path.name[len(f"{stem}-every-"):-len(f"{suffix}.csv")]
            if number.isdigit():
                series[int(number)] = read_places(path)
        truth = read_places(truth_file)
        for every, places in sorted(series.items()):
            if every == 1:
                continue
            off = distance(places, truth)
            lost = np.mean(np.isnan(off) & ~(np.isnan(places[..., 0]) & np.isnan(truth[..., 0])))
            # beside one that has left, a place may be that where a particle left
            off[np.isnan(largest_around(off, 1))] = np.nan
            stated = json.loads((folder / f"{stem}-every-{every}{suffix}.json").read_text())
            line = f"{folder.name:9} {stem:20} {every:3} {number_text(percentiles(off / length))}  lost {lost:5.1%}"
            line += f"  states {stated['intervalError99'] / length:.3g}" if "intervalError99" in stated else "  states -"
            line += f" {stated.get('intervalUnresolved', float('nan')):4.0%} unresolved"
            if 2 * every in series and 4 * every in series:
                prediction, resolved = predicted(places, series[2 * every], series[4 * every])
                resolved &= np.isfinite(off) & np.isfinite(prediction)
                line += f"  resolved {resolved.mean():4.0%} within 3 {within(prediction[resolved], off[resolved]):4.0%}"
                if resolved.any():
                    line += f" p99 {np.percentile(prediction[resolved], 99) / length:.3g} truly {np.percentile(off[resolved], 99) / length:.3g}"
            print(line)


def number_text(values: Array) -> str:
    return " ".join(f"{value:8.2g}" for value in values)


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("places", type=Path)
    arguments.add_argument("names", nargs="*", metavar="CASE")
    arguments.add_argument("--truth", type=Path)
    arguments.add_argument("--between", default="linear")
    arguments.add_argument("--length", type=float, default=1.0)
    given = arguments.parse_args()
    if given.truth:
        off = distance(read_places(given.places), read_places(given.truth))
        print(number_text(percentiles(off / given.length)))
        return
    for name in given.names or sorted(path.name for path in given.places.iterdir()):
        score(given.places / name, given.between, json.loads((HERE / "cases" / name / "case.json").read_text())["length"])


if __name__ == "__main__":
    main()
