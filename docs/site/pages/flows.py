"""docs/reference/flows.md: the built-in flows, as `wakesurf info` and the catalogue in core/field tell them."""
import json
import re

from .base import MADE, read, said, table

INTRO = """# Built-in flows

`flow:NAME` stands for a dataset wherever a command takes one. Their velocity is a formula, so there is nothing to load and nothing is
interpolated. Parameters are written behind the name: `flow:sphere?u=2,a=0.4`. `wakesurf generate` samples one into a store.

"""
WORDS = {
    "uniform": "the same velocity everywhere",
    "oscillating": "a uniform flow that swings to the side: stream, path and streak surfaces differ most simply here",
    "rotation": "solid rotation around the z axis, with a drift along it",
    "shear": "plane shear: speed grows with height",
    "strain": "pure strain: a saddle in every plane",
    "rotating-strain": "a saddle that turns: unsteady, with a closed solution",
    "lamb-oseen": "a viscous vortex with a core, and a drift along its axis: sheets roll up",
    "sphere": "potential flow around a sphere: sheets tear",
    "cylinder": "potential flow around a cylinder, with a drift along it",
    "hill": "Hill's spherical vortex: inside the ball nothing leaves",
    "abc": "Arnold, Beltrami and Childress: steady and chaotic",
    "double-gyre": "two gyres whose border swings: the usual test of mixing",
    "tornado": "the drifting tornado of Crawfis and Max",
    "stagnation": "flow against a plane: a sheet is stretched without end",
}


def names():
    return re.findall(r"choose one of ([^)]*)\)", said("info", "flow:there-is-none", check=False))[0].split(", ")


def parameters(name):
    source = read("core/field/analytic_catalogue.cpp")
    found = re.search(r'\{"' + re.escape(name) + r'",\s*\{((?:\{"\w+", [^}]*\}(?:, )?)*)\}', source)
    return re.findall(r'\{"(\w+)", ([^}]*)\}', found.group(1))


def span(bounds):
    return ", ".join(f"{axis} {low:g} to {high:g}" for axis, low, high in zip("xyz", bounds[::2], bounds[1::2]))


def text():
    rows = []
    for name in names():
        about = json.loads(said("info", "flow:" + name, "--json"))
        given = ", ".join(f"{key} = {value.replace('2 * std::numbers::pi', '2π')}" for key, value in parameters(name))
        rows.append([f"`flow:{name}`", WORDS[name], given, span(about["bounds"]), "yes" if about["steady"] else "no",
                     "yes" if about["obstacle"] else ""])
    return (MADE.format(source="wakesurf info and core/field/analytic_catalogue.cpp") + INTRO
            + table(["dataset", "what it is", "parameters", "domain", "steady", "body"], rows)
            + "\nUnsteady flows go from time 0 to 10 unless you ask for other times.\n")
