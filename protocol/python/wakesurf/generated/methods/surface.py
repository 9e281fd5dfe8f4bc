"""Surfaces: methods of the server.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Any, Literal, Mapping, Optional, Sequence, Union

from ...api_call import Noun
from ...names import named
from ...plain import Json, Point
from ..records import Statistics, SurfaceListResult, SurfaceSetResult, SurfaceStopResult, SurfaceSubscribeResult


class SurfaceMethods(Noun):
    """Surfaces."""

    @named
    def set(self, *, rake: str, dataset: str, kind: Literal["stream", "path", "streak", "time", "level"], to: float,
            surface: Optional[str] = None, rake2: Optional[str] = None, from_: Optional[float] = None,
            direction: Optional[Literal["forward", "backward", "both"]] = None,
            accuracy: Optional[Literal["fast", "balanced", "exact"]] = None,
            interpolation: Optional[Literal["linear", "smooth"]] = None, refine: Optional[Literal["on", "off"]] = None,
            release_until: Optional[float] = None, life: Optional[float] = None, sweep: Optional[Point] = None,
            field: Optional[str] = None, level: Optional[float] = None, merge: Optional[float] = None,
            angle: Optional[float] = None, stagnation_speed: Optional[float] = None, max_quads: Optional[int] = None,
            separation: Optional[float] = None, fields: Optional[Sequence[str]] = None, default: Optional[bool] = None,
            gesture: Optional[str] = None, if_rev: Optional[int] = None,
            session: Optional[str] = None) -> SurfaceSetResult:
        """Creates a surface, or replaces its record as a whole, and starts to build it.

        `rake`: an id from rake.list; the particles start from this rake. A level surface takes no more of it than its
            place in lists and its colour.
        `dataset`: an id from dataset.list.
        `kind`: stream: streamlines of the field frozen at `from_`; path: particles released together at `from_`;
            streak: particles released continuously from `from_` on; time: a patch of particles released at `from_`;
            level: where `field` has the value `level`, at the time that is shown between `from_` and `to`.
        `to`: where the surface ends: before `from_`, time runs backward. A stream surface is followed for `to` -
            `from_`, and `to` need not lie in the data; for the others it must (the dataset's unit of time).
        `surface`: id of the surface to replace; if left out, a new one is created.
        `rake2`: the patch lies between the rake and this second rake; only for time surfaces.
        `from_`: where the surface starts: the (first) release; for stream surfaces, the time at which the field is
            frozen; if left out, the first time of the data, or the last where `direction` is backward (the dataset's
            unit of time).
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
        `default`: true: make the record only if no one has edited the session and it has no such record yet; this does
            not count as an edit, and undo does not take it back; default False.
        `gesture`: a name for what the user is doing; consecutive edits with the same name are one step of undo.
        `if_rev`: the edit is refused if the record is at another revision; 0 or more.

        Error: Stale, NotFound, OutsideDomain, OutsideTimeRange, OverLimit, DatasetError. For editors.

        For example:

            api.surface.set(session='main', rake='r1', kind='stream', dataset='lamb-oseen', to=2, separation=0.1,
                            from_=0)
        """
        answer: SurfaceSetResult = self._call("surface.set", {"session": session, "rake": rake, "dataset": dataset,
                                                              "kind": kind, "to": to, "surface": surface,
                                                              "rake2": rake2, "from": from_, "direction": direction,
                                                              "accuracy": accuracy, "interpolation": interpolation,
                                                              "refine": refine, "releaseUntil": release_until,
                                                              "life": life, "sweep": sweep, "field": field,
                                                              "level": level, "merge": merge, "angle": angle,
                                                              "stagnationSpeed": stagnation_speed,
                                                              "maxQuads": max_quads, "separation": separation,
                                                              "fields": fields, "default": default, "gesture": gesture,
                                                              "ifRev": if_rev})
        return answer

    @named
    def delete(self, *, surface: str, gesture: Optional[str] = None, if_rev: Optional[int] = None,
               session: Optional[str] = None) -> Json:
        """Deletes a surface.

        `surface`: an id from surface.list.
        `gesture`: a name for what the user is doing; consecutive edits with the same name are one step of undo.
        `if_rev`: the edit is refused if the record is at another revision; 0 or more.

        Error: Stale, NotFound, OverLimit, DatasetError. For editors.

        For example:

            api.surface.delete(session='main', surface='s2')
        """
        answer: Json = self._call("surface.delete", {"session": session, "surface": surface, "gesture": gesture,
                                                     "ifRev": if_rev})
        return answer

    @named
    def stop(self, *, surface: str, session: Optional[str] = None) -> SurfaceStopResult:
        """Stops the computation of a surface, for everyone, within 50 ms. What has been computed stays; the
        surface's statistics and surface.done say who stopped it. The next edit of the surface or of its rake
        computes it again.

        `surface`: an id from surface.list.

        Error: NotFound, DatasetError. For editors.

        For example:

            api.surface.stop(session='main', surface='s2')
        """
        answer: SurfaceStopResult = self._call("surface.stop", {"session": session, "surface": surface})
        return answer

    @named
    def list(self, *, session: Optional[str] = None) -> SurfaceListResult:
        """Lists the surfaces of a session.

        Error: NotFound.

        For example:

            api.surface.list(session='main')
        """
        answer: SurfaceListResult = self._call("surface.list", {"session": session})
        return answer

    @named
    def stats(self, *, surface: str, session: Optional[str] = None) -> Statistics:
        """Returns statistics of the newest state of a surface.

        `surface`: an id from surface.list.

        Error: NotFound, DatasetError.

        For example:

            api.surface.stats(session='main', surface='s1')
        """
        answer: Statistics = self._call("surface.stats", {"session": session, "surface": surface})
        return answer

    @named
    def wait(self, *, surface: str, timeout_ms: int, epoch: Optional[int] = None,
             work_done_token: Optional[Union[str, int]] = None, session: Optional[str] = None) -> Statistics:
        """Returns once the surface is complete; `complete` is false if the time ran out.

        `surface`: an id from surface.list.
        `timeout_ms`: how long to wait, at most (ms); 0 to 600,000.
        `epoch`: epoch to wait for: this one or a later one; if left out, the current one; 0 or more.
        `work_done_token`: on a WebSocket: $/progress reports the progress of the work with this token.

        Error: NotFound, OverLimit, DatasetError.

        For example:

            api.surface.wait(session='main', surface='s1', timeout_ms=60000)
        """
        answer: Statistics = self._call("surface.wait", {"session": session, "surface": surface,
                                                         "timeoutMs": timeout_ms, "epoch": epoch,
                                                         "workDoneToken": work_done_token})
        return answer

    @named
    def subscribe(self, *, surface: str, from_: Optional[Mapping[str, Any]] = None,
                  session: Optional[str] = None) -> SurfaceSubscribeResult:
        """Sends the mesh of a surface as binary frames, now and after every change. It cannot be part of a batch.

        `surface`: an id from surface.list.
        `from_`: the last update that was applied before a connection was lost; the server goes on after it if possible.

        Error: NotFound, OutsideTimeRange, OverLimit, DatasetError. Only on a `Connection`.

        For example:

            api.surface.subscribe(session='main', surface='s1')
        """
        answer: SurfaceSubscribeResult = self._call("surface.subscribe", {"session": session, "surface": surface,
                                                                          "from": from_})
        return answer

    @named
    def unsubscribe(self, *, subscription: Optional[int] = None, surface: Optional[str] = None,
                    session: Optional[str] = None) -> Json:
        """Ends a subscription. A surface that someone had subscribed to, and that no one shows or waits for two
        seconds later, is not computed any further: until someone subscribes to it or waits for it.

        `subscription`: number of the subscription; or give `surface` instead; 0 or more.
        `surface`: id of the surface, instead of the number.

        Error: NotFound, DatasetError. Only on a `Connection`.

        For example:

            api.surface.unsubscribe(subscription=1)
        """
        answer: Json = self._call("surface.unsubscribe", {"session": session, "subscription": subscription,
                                                          "surface": surface})
        return answer
