"""Datasets: what the server answers. Members that may be missing are not there then.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Any, Dict, List, Literal, Optional, TYPE_CHECKING, TypedDict

if TYPE_CHECKING:
    from .shared import Lattice, Problem
    from .family import Family


class Steps(TypedDict, total=False):
    """Numbers of time-steps."""

    ready: int  # time-steps that can be used
    total: int  # time-steps that there will be after the import


class DatasetEntry(TypedDict, total=False):
    """A dataset as a list shows it."""

    dataset: str  # id of the dataset
    name: str  # display name
    state: Literal["ready", "importing", "failed", "stopped", "incomplete"]  # state of the import
    steps: Steps  # numbers of time-steps
    progress: float  # progress of the import; may be missing
    remaining: float  # time that the import still needs (s); may be missing
    values: str  # what the values that are stored are told from others by; left out for a built-in flow; may be missing
    velocities: List[str]  # of a dataset that failed because it is not clear which field is the velocity: what ...
    families: List[str]  # names of the families of stream surfaces that are kept with its data; left out if there ...
    error: Problem  # why the import failed or ended early; may be missing


class Field(TypedDict, total=False):
    """A field of a dataset."""

    name: str  # name of the field in the files
    components: int  # number of components; 3: a vector
    source: Literal["point", "cell"]  # whether the files have the values at points or in cells
    range: List[Optional[float]]  # smallest and largest value (for a vector, of its magnitude); null: unknown
    unit: str  # unit of the values, as stated in the files; may be missing
    family: bool  # true: a family of stream surfaces, which was made from the velocity by family.make; may be missing
    stored: bool  # false: imports leave it out, as they do masks and arrays that the velocity is made of; surfaces ...


class Dataset(TypedDict, total=False):
    """The description of a dataset."""

    dataset: str  # id of the dataset
    name: str  # display name
    reader: str  # name of the reader that read the files
    grid: Literal["uniform", "rectilinear", "curvilinear", "unstructured", "analytic"]  # kind of grid
    bounds: List[float]  # bounding box: x0, x1, y0, y1, z0, z1 (the dataset's unit of length)
    points: int  # number of points of the grid
    cells: int  # number of cells of the grid
    times: List[float]  # times of the time-steps (the dataset's unit of time)
    steady: bool  # true: the flow does not change in time
    fields: List[Field]  # all fields
    velocity: str  # name of the field that particles follow
    why: str  # why this field was taken as the velocity
    obstacle: bool  # true: there is an obstacle in the flow
    bytesPerStep: int  # memory that one time-step takes (bytes)
    finestSpacing: float  # smallest spacing of the grid (the dataset's unit of length)
    lattice: Lattice  # lattice of the frames of its surfaces
    smooth: bool  # true: surface.set accepts `interpolation` smooth
    surfaceFields: List[str]  # names that `fields` of surface.set accepts
    families: List[Family]  # families of stream surfaces, which are among its fields; left out if there are none; ...
    note: str  # a remark about the data, for people; may be missing
    lengthUnit: str  # unit of lengths and coordinates; left out if the files do not state it; may be missing
    timeUnit: str  # unit of times; left out if the files do not state it; may be missing
    precision: Literal["half"]  # half: the values are stored with 16 bits each; may be missing
    dimensions: List[int]  # number of points along x, y and z; may be missing
    spacing: List[float]  # spacing of a uniform grid along x, y and z (the dataset's unit of length); may be missing


SuggestedSurface = TypedDict("SuggestedSurface", {  # Parameters to begin a surface with, as surface.set takes them.
    "kind": 'Literal["stream", "path", "streak", "time", "level"]',  # stream: streamlines of the field frozen at ...
    "from": "float",  # where the surface starts (the dataset's unit of time)
    "to": "float",  # where it ends (the dataset's unit of time)
    "separation": "float",  # longest edge allowed (the dataset's unit of length)
    "sweep": "List[float]",  # of a time surface: the patch is the rake swept along this vector (the dataset's unit ...
}, total=False)


class SuggestedRake(TypedDict, total=False):
    """A line to release particles from, as rake.set takes it."""

    kind: Literal["line"]  # kind of rake
    points: List[List[float]]  # both ends of the line (the dataset's unit of length)
    seeds: int  # initial number of seeds


class CacheStatus(TypedDict, total=False):
    """Which time-steps are in memory, and how much of each."""

    dataset: str  # id of the dataset
    steps: List[Literal["resident", "loading", "cold"]]  # state of each time-step; empty for a built-in flow
    held: List[Any]  # of the velocity of each time-step, how many bytes are in memory and how many are being read, ...
    bytesPerStep: int  # of a time-step that is in memory as a whole, in `held` (bytes)
    bytes: int  # memory that the time-steps take (bytes)
    budget: int  # memory that the time-steps may take (bytes)


class DatasetListResult(TypedDict, total=False):
    """What dataset.list answers."""

    datasets: List[DatasetEntry]  # all datasets


class DatasetSuggestResult(TypedDict, total=False):
    """What dataset.suggest answers."""

    rake: SuggestedRake  # the rake
    surfaces: List[SuggestedSurface]  # one of each kind that the data allow: a single time-step of an unsteady flow ...
    why: str  # what was chosen and why, for people


class ProbeSampleResult(TypedDict, total=False):
    """What probe.sample answers."""

    values: Dict[str, List[Any]]  # for each field, by its name, one value for each point; null: there is no value ...
    inside: List[bool]  # for each point, whether it is in the fluid
