"""Making and changing surfaces, with every parameter of surface.set.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import TYPE_CHECKING, Generic, Literal, Optional, Sequence, TypeVar, Union

from ..names import named
from ..plain import Json, Point
from .records import SurfaceSetResult

if TYPE_CHECKING:
    from ..record import Record

Made = TypeVar("Made")
SETTABLE = ("rake", "kind", "dataset", "to", "from", "rake2", "direction", "accuracy", "interpolation", "refine",
            "releaseUntil", "life", "sweep", "field", "level", "merge", "angle", "stagnationSpeed", "maxQuads",
            "separation", "fields")


class SurfaceMaker(Generic[Made]):
    """What `Session` has of surface.set."""

    def _made(self, given: Json) -> Made:
        raise NotImplementedError

    @named
    def surface(self, rake: Union[Record, str], kind: Literal["stream", "path", "streak", "time", "level"],
                dataset: str, to: float, from_: Optional[float] = None, *, rake2: Optional[Union[Record, str]] = None,
                direction: Optional[Literal["forward", "backward", "both"]] = None,
                accuracy: Optional[Literal["fast", "balanced", "exact"]] = None,
                interpolation: Optional[Literal["linear", "smooth"]] = None,
                refine: Optional[Literal["on", "off"]] = None, release_until: Optional[float] = None,
                life: Optional[float] = None, sweep: Optional[Point] = None, field: Optional[str] = None,
                level: Optional[float] = None, merge: Optional[float] = None, angle: Optional[float] = None,
                stagnation_speed: Optional[float] = None, max_quads: Optional[int] = None,
                separation: Optional[float] = None, fields: Optional[Sequence[str]] = None) -> Made:
        """Makes a surface and starts computing it. What is left out has the default of `surface.set`. What `fields`
        names is also in `Surface.mesh`, by name.

        `rake`: an id from rake.list; the particles start from this rake. A level surface takes no more of it than its
            place in lists and its colour.
        `kind`: stream: streamlines of the field frozen at `from_`; path: particles released together at `from_`;
            streak: particles released continuously from `from_` on; time: a patch of particles released at `from_`;
            level: where `field` has the value `level`, at the time that is shown between `from_` and `to`.
        `dataset`: an id from dataset.list.
        `to`: where the surface ends: before `from_`, time runs backward. A stream surface is followed for `to` -
            `from_`, and `to` need not lie in the data; for the others it must (the dataset's unit of time).
        `from_`: where the surface starts: the (first) release; for stream surfaces, the time at which the field is
            frozen; if left out, the first time of the data, or the last where `direction` is backward (the dataset's
            unit of time).
        `rake2`: the patch lies between the rake and this second rake; only for time surfaces.
        `direction`: if left out, forward or backward as `from_` and `to` say; it must not contradict them. both: to the
            later time `to`, and as long before `from_`, a path surface as far as there are data; only for stream and
            path surfaces.
        `accuracy`: how accurately particles are traced and vertices inserted; default balanced.
        `interpolation`: of stored velocity. linear: between the nodes of a cell and in time, as ParaView shows it;
            smooth: cubic in space and time, for uniform grids only, see `smooth` of dataset.describe; default linear.
        `refine`: whether quads are cut, joined and reconnected, and torn at obstacles. off: the grid that the rake
            begins with stays as it is, with a column a seed, as in smoke surfaces; `merge` and `angle` then count for
            nothing, and `separation` only along the flow. Quads with a particle that has ended are left out; default
            on.
        `release_until`: time at which the release stops; if left out, `to` (the dataset's unit of time); only for
            streak surfaces.
        `life`: longest age of a particle: it ends so long after its release; if left out, it lives as long as the
            surface (the dataset's unit of time); only for path, streak or time surfaces; above 0.
        `sweep`: the patch is the rake swept along this vector (the dataset's unit of length); only for time surfaces.
        `field`: scalar field of the dataset, or derived from its velocity, of which the surface is a level set: its
            magnitude by the velocity's name, `vorticity`, `q_criterion`, `velocity_x` and the like; only for level
            surfaces.
        `level`: value that the field has on the surface (the field's unit); only for level surfaces.
        `merge`: quads smaller than this are joined; 0: never (part of the separation); 0 to 0.5; default 0.35.
        `angle`: neighbouring quads at a larger angle are refined, as far as the separation and `max_quads` allow; 180:
            never (degrees); above 0, at most 180; default 20.
        `stagnation_speed`: a slower particle counts as at rest and ends; 0: only a particle that does not move at all
            (part of the largest speed); 0 to 0.1; default 1e-06.
        `max_quads`: maximum number of quads; 1 to 4,000,000; default 1,000,000.
        `separation`: longest edge allowed; if left out, the dataset's finest spacing (the dataset's unit of length);
            above 0.
        `fields`: additional attributes of the vertices, in frames and exports: scalar fields of the dataset, its
            velocity (the magnitude), `deformation`, `approximated`, `error`, `vorticity` (its magnitude),
            `vorticity_x`, `vorticity_y`, `vorticity_z`, `q_criterion`, `velocity_x`, `velocity_y`, `velocity_z`,
            `normal_x`, `normal_y`, `normal_z` (of the surface).

        >>> surface = session.surface(rake, "stream", dataset="tornado", to=2, separation=0.05)
        >>> surface.wait()["complete"]
        True
        """
        return self._made({"rake": rake, "kind": kind, "dataset": dataset, "to": to, "from": from_, "rake2": rake2,
                           "direction": direction, "accuracy": accuracy, "interpolation": interpolation,
                           "refine": refine, "releaseUntil": release_until, "life": life, "sweep": sweep,
                           "field": field, "level": level, "merge": merge, "angle": angle,
                           "stagnationSpeed": stagnation_speed, "maxQuads": max_quads, "separation": separation,
                           "fields": fields})


class SurfaceChanger:
    """What `Surface` has of surface.set."""

    def _changed(self, changes: Json, if_rev: Optional[int]) -> SurfaceSetResult:
        raise NotImplementedError

    @named
    def set(self, *, rake: Optional[Union[Record, str]] = None,
            kind: Optional[Literal["stream", "path", "streak", "time", "level"]] = None, dataset: Optional[str] = None,
            to: Optional[float] = None, from_: Optional[float] = None, rake2: Optional[Union[Record, str]] = None,
            direction: Optional[Literal["forward", "backward", "both"]] = None,
            accuracy: Optional[Literal["fast", "balanced", "exact"]] = None,
            interpolation: Optional[Literal["linear", "smooth"]] = None, refine: Optional[Literal["on", "off"]] = None,
            release_until: Optional[float] = None, life: Optional[float] = None, sweep: Optional[Point] = None,
            field: Optional[str] = None, level: Optional[float] = None, merge: Optional[float] = None,
            angle: Optional[float] = None, stagnation_speed: Optional[float] = None, max_quads: Optional[int] = None,
            separation: Optional[float] = None, fields: Optional[Sequence[str]] = None,
            if_rev: Optional[int] = None) -> SurfaceSetResult:
        """Changes the parameters given, as `Session.surface` has them, and computes the surface again. Where `from_`
        or `to` change, forward or backward follows from them. `if_rev`: only if the record is at this revision.
        Error: Stale.

        >>> before = surface.wait()["quads"]
        >>> surface.set(separation=0.025)["surface"] == surface.id
        True
        >>> surface.wait()["quads"] > before
        True
        """
        return self._changed({"rake": rake, "kind": kind, "dataset": dataset, "to": to, "from": from_, "rake2": rake2,
                              "direction": direction, "accuracy": accuracy, "interpolation": interpolation,
                              "refine": refine, "releaseUntil": release_until, "life": life, "sweep": sweep,
                              "field": field, "level": level, "merge": merge, "angle": angle,
                              "stagnationSpeed": stagnation_speed, "maxQuads": max_quads, "separation": separation,
                              "fields": fields}, if_rev)
