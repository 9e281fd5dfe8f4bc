"""Rakes: methods of the server.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Literal, Optional

from ...api_call import Noun
from ...names import named
from ...plain import Json, Points
from ..records import RakeListResult, RakeSetResult


class RakeMethods(Noun):
    """Rakes."""

    @named
    def set(self, *, kind: Literal["line", "polyline", "circle", "points"], points: Points, seeds: int,
            rake: Optional[str] = None, name: Optional[str] = None, colour: Optional[str] = None,
            dragging: Optional[bool] = None, force: Optional[bool] = None, default: Optional[bool] = None,
            gesture: Optional[str] = None, if_rev: Optional[int] = None,
            session: Optional[str] = None) -> RakeSetResult:
        """Creates a rake, or replaces one as a whole. The surfaces of the rake are rebuilt at once, unless only its
        name or colour changes.

        `kind`: what the points are; line: 2 points; polyline and points: 2 or more; circle: the centre and two points
            on the rim.
        `points`: where the rake lies; parts outside the domain are cut off, and a circle releases from its longest arc
            inside (the dataset's unit of length).
        `seeds`: number of seeds on the rake; 2 to 4096.
        `rake`: id of the rake to replace; if left out, a new one is created.
        `name`: display name.
        `colour`: #rrggbb; if left out, a rake keeps its colour, and a new rake gets one that few others have.
        `dragging`: true: no one else may edit the rake for 5 s from now; false: others may edit it again; if left out,
            nothing changes.
        `force`: true: lets a host edit the rake although someone else holds the lease; default False.
        `default`: true: make the record only if no one has edited the session and it has no such record yet; this does
            not count as an edit, and undo does not take it back; default False.
        `gesture`: a name for what the user is doing; consecutive edits with the same name are one step of undo.
        `if_rev`: the edit is refused if the record is at another revision; 0 or more.

        Error: Stale, NotFound, Leased, OutsideDomain, OverLimit. For editors.

        For example:

            api.rake.set(session='main', kind='line', points=[[0.2, 0, -1], [1, 0, -1]], seeds=9)
        """
        answer: RakeSetResult = self._call("rake.set", {"session": session, "kind": kind, "points": points,
                                                        "seeds": seeds, "rake": rake, "name": name, "colour": colour,
                                                        "dragging": dragging, "force": force, "default": default,
                                                        "gesture": gesture, "ifRev": if_rev})
        return answer

    @named
    def delete(self, *, rake: str, force: Optional[bool] = None, gesture: Optional[str] = None,
               if_rev: Optional[int] = None, session: Optional[str] = None) -> Json:
        """Deletes a rake and its surfaces.

        `rake`: an id from rake.list.
        `force`: true: lets a host delete the rake although someone else holds the lease; default False.
        `gesture`: a name for what the user is doing; consecutive edits with the same name are one step of undo.
        `if_rev`: the edit is refused if the record is at another revision; 0 or more.

        Error: Stale, NotFound, Leased, OverLimit. For editors.

        For example:

            api.rake.delete(session='main', rake='r1')
        """
        answer: Json = self._call("rake.delete", {"session": session, "rake": rake, "force": force, "gesture": gesture,
                                                  "ifRev": if_rev})
        return answer

    @named
    def list(self, *, session: Optional[str] = None) -> RakeListResult:
        """Lists the rakes of a session.

        Error: NotFound.

        For example:

            api.rake.list(session='main')
        """
        answer: RakeListResult = self._call("rake.list", {"session": session})
        return answer
