#!/usr/bin/env python3
"""Samples a case's velocity on a small grid at many times: the truth of tests/core/field/solver_truth_test.cpp.

    extract.py STORE FILE [--wakesurf PROGRAM]

STORE is the sphere's series, imported. The file has 13 x 9 x 9 nodes, x fastest, from (0.75, -1, -1) at a spacing of 0.25, at 49 times from 42
every 0.1: three components of 16 bits, in 1/16384 of the inflow's speed. Values inside the body are zero.
"""
from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))
import wakesurf  # noqa: E402

SCALE = 16384


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("store", type=Path)
    arguments.add_argument("file", type=Path)
    arguments.add_argument("--wakesurf", default="wakesurf")
    given = arguments.parse_args()
    z, y, x = np.meshgrid(np.arange(9) / 4 - 1, np.arange(9) / 4 - 1, np.arange(13) / 4 + 0.75, indexing="ij")
    nodes = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    with wakesurf.serve(str(given.store), binary=given.wakesurf) as session:
        probe, dataset = session.client.probe, session.dataset
        steps = [np.nan_to_num(probe(dataset, nodes, 42 + k / 10)["U"]) for k in range(49)]
    given.file.write_bytes(np.round(np.stack(steps) * SCALE).astype("<i2").tobytes())


if __name__ == "__main__":
    main()
