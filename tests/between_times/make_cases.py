#!/usr/bin/env python3
"""Computes flows with OpenFOAM and keeps their velocity at every few steps of the solver: the truth of the benchmark.

    make_cases.py FOLDER [CASE ...] [--cells FACTOR] [--dye]

writes FOLDER/CASE, an OpenFOAM case with the times of its window only. --cells makes cells narrower by FACTOR in each
direction; --dye lets the solver carry two dyes, above and below the rake at the inlet. Needs Debian's `openfoam`.
"""
from __future__ import annotations

import argparse
import json
import math
import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any, Dict

TEMPLATES = Path(__file__).resolve().parent / "cases"
CASES = sorted(folder.name for folder in TEMPLATES.iterdir() if folder.name != "common")
SYSTEM = {"controlDict", "fvSchemes", "fvSolution", "blockMeshDict", "snappyHexMeshDict"}
FIELDS = {"U": ("volVectorField", "[0 1 -1 0 0 0 0]"), "p": ("volScalarField", "[0 2 -2 0 0 0 0]"),
          "dyeAbove": ("volScalarField", "[0 0 0 0 0 0 0]"), "dyeBelow": ("volScalarField", "[0 0 0 0 0 0 0]")}


def write(case: Path, place: str, text: str) -> None:
    """Writes a dictionary with the header that OpenFOAM asks for."""
    path = case / place
    kind, dimensions = FIELDS.get(path.name, ("dictionary", ""))
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"FoamFile {{ version 2.0; format ascii; class {kind}; object {path.name}; }}\n"
                    + (f"dimensions {dimensions};\n" if dimensions else "") + text)


def filled(path: Path, values: Dict[str, Any], factor: float) -> str:
    """Returns a template with its @names@ replaced, and its @numbers@ of cells multiplied by the factor."""
    def value(match: "re.Match[str]") -> str:
        name = match.group(1)
        return str(round(int(name) * factor)) if name.isdigit() else str(values[name])
    return re.sub(r"@(\w+)@", value, path.read_text())


def run(case: Path, *command: str) -> None:
    with open(case / "log", "a") as log:
        subprocess.run([*command, "-case", str(case)], check=True, stdout=log, stderr=log)


def control(case: Path, values: Dict[str, Any], end: float, step: float, functions: str) -> None:
    write(case, "system/controlDict",
          filled(TEMPLATES / "common/controlDict", {**values, "end": end, "step": step, "functions": functions}, 1))


def dye(expression: str) -> str:
    return f"""internalField uniform 0;
boundaryField
{{
    inlet {{ type exprFixedValue; value uniform 0; valueExpr "{expression}"; }}
    ".*"  {{ type inletOutlet; inletValue uniform 0; value uniform 0; }}
}}
"""


def make(name: str, folder: Path, factor: float, with_dye: bool) -> None:
    source, case = TEMPLATES / name, folder / name
    values: Dict[str, Any] = {"nonOrthogonal": 0, **json.loads((source / "case.json").read_text())}
    finer = max(1, math.ceil(factor)) # narrower cells ask for shorter steps; the stored interval stays
    values["spinUpStep"] = values["spinUp"] / (finer * math.ceil(values["spinUp"] / values["spinUpStep"]))
    values["interval"] = values["every"] * values["step"]
    values["step"] /= finer
    case.mkdir(parents=True)
    for path in [*(TEMPLATES / "common").iterdir(), *source.iterdir()]:
        if path.name in FIELDS:
            write(case, f"0/{path.name}", filled(path, values, factor))
        elif path.name in SYSTEM - {"controlDict"}:
            write(case, f"system/{path.name}", filled(path, values, factor))
        elif path.name.endswith("Properties"):
            write(case, f"constant/{path.name}", filled(path, values, factor))
    start = values["spinUp"]
    control(case, values, start, values["spinUpStep"], "")
    run(case, "blockMesh")
    if (source / "snappyHexMeshDict").exists():
        run(case, "snappyHexMesh", "-overwrite")
    run(case, "pimpleFoam")
    functions = filled(TEMPLATES / "common/writeVelocity", values, 1)
    if with_dye:
        above = values["dye"]["above"].replace("@width@", str(values["dye"]["width"] / factor))
        write(case, f"{start}/dyeAbove", dye(above))
        write(case, f"{start}/dyeBelow", dye(f"1 - ({above})"))
        functions += filled(TEMPLATES / "common/carryDye", {"dyeInterval": values["window"] / 4}, 1)
    control(case, values, start + values["window"], values["step"], functions)
    run(case, "pimpleFoam")
    keep_velocity(case, start)


def keep_velocity(case: Path, start: float) -> None:
    """Deletes what is not of the window: the initial state, the pressure and the fluxes."""
    shutil.rmtree(case / "0")
    for time in case.iterdir():
        if re.fullmatch(r"[0-9.]+", time.name):
            for path in time.iterdir():
                if path.name != "U" and not path.name.startswith("dye"):
                    shutil.rmtree(path) if path.is_dir() else path.unlink()
    (case / "case.foam").touch()


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("cases", nargs="*", metavar="CASE", help=f"of {', '.join(CASES)}; all if none is named")
    arguments.add_argument("--cells", type=float, default=1.0, metavar="FACTOR")
    arguments.add_argument("--dye", action="store_true")
    given = arguments.parse_args()
    os.environ.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
    for name in given.cases or CASES:
        make(name, given.folder, given.cells, given.dye)


if __name__ == "__main__":
    main()
