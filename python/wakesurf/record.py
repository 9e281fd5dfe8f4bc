"""Records of a session, which have an id and a revision, and rakes."""
from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any, List, Literal, Optional, Sequence, Tuple, TypeVar

import numpy as np

from .errors import InvalidPoints, NotFound
from .generated.records import RakeSetResult
from .mesh import Array
from .names import Helpful, named
from .plain import HasId, Json, Points

if TYPE_CHECKING:
    from .session import Session

Own = TypeVar("Own", bound="Record")
RakeKind = Literal["line", "polyline", "circle", "points"]


class Record(HasId, Helpful):
    """A record of a session, with an id and a revision."""

    noun = ""

    def __init__(self, session: Session, id: str) -> None:
        self.session, self.id = session, id

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.id!r})"

    def record(self) -> Json:
        """Returns the record as it is now. Error: NotFound."""
        for each in self.session.call(self.noun + ".list")[self.noun + "s"]:
            if each[self.noun] == self.id:
                return dict(each)
        raise NotFound(f"there is no {self.noun} {self.id}", -32004, "notFound")

    def __enter__(self: Own) -> Own:
        return self

    def __exit__(self, *_: object) -> None:
        """Deletes the record, unless it is gone already: `with session.surface(...) as surface:` leaves nothing
        behind."""
        try:
            self.delete()
        except NotFound:
            pass

    def delete(self) -> None:
        """Deletes the record, for everyone."""
        self.session.call(self.noun + ".delete", **{self.noun: self.id})

    def _change(self, members: Sequence[str], changes: Json, if_rev: Optional[int]) -> Any:
        """Sends the whole record, as setters want it, so that a repeated edit does no harm."""
        record = self.record()
        whole = {name: record[name] for name in members if name in record}
        whole.update(changes)
        return self.session.call(self.noun + ".set", **{self.noun: self.id}, **whole, ifRev=if_rev)


class Rake(Record):
    """A curve from which particles are released."""

    noun = "rake"

    @named
    def set(self, line: Optional[Points] = None, polyline: Optional[Points] = None, circle: Optional[Points] = None,
            points: Optional[Points] = None, seeds: Optional[int] = None, name: Optional[str] = None,
            colour: Optional[str] = None, if_rev: Optional[int] = None) -> RakeSetResult:
        """Changes the given parameters; the surfaces on it are computed again, unless only name or colour change.
        Returns {rev, clipped, points, surfaces, ...}

        >>> rake.set(seeds=12)["clipped"]
        False
        """
        given = (("seeds", seeds), ("name", name), ("colour", colour))
        changes: Json = {key: value for key, value in given if value is not None}
        if any(each is not None for each in (line, polyline, circle, points)):
            changes["kind"], changes["points"] = one_of(line=line, polyline=polyline, circle=circle, points=points)
        result: RakeSetResult = self._change(("kind", "points", "seeds", "name", "colour"), changes, if_rev)
        if "points" in changes:
            warn_of_cut(changes["kind"], changes["points"], result)
        return result

    @property
    def colour(self) -> str:
        """Returns the colour as #rrggbb."""
        return str(self.record()["colour"])

    @property
    def points(self) -> Array:
        """Returns (n, 3) points, as cut to the domain."""
        return np.array(self.record()["points"], dtype=float)

    @property
    def clipped(self) -> bool:
        return bool(self.record()["clipped"])


def warn_of_cut(kind: str, asked: Sequence[Sequence[float]], answer: RakeSetResult) -> None:
    """Warns (UserWarning) that a rake that was asked for lies outside of the domain in part, and of a line how much of it is left."""
    if not answer["clipped"]:
        return
    left = ""
    if kind in ("line", "polyline"):
        whole, inside = (float(np.sum(np.linalg.norm(np.diff(np.array(each, dtype=float), axis=0), axis=1))) for each in (asked, answer["points"]))
        left = f", {100 * inside / whole:.2g} % of it is left" if whole > 0 else ""
    warnings.warn(f"the rake lies outside of the domain in part, which is cut away{left}", stacklevel=4)


def one_of(**choices: Optional[Points]) -> Tuple[RakeKind, List[List[float]]]:
    given = [(kind, points) for kind, points in choices.items() if points is not None]
    if len(given) != 1:
        raise ValueError("give one of " + ", ".join(choices))
    kind: Any = given[0][0]
    return kind, points_of(kind, given[0][1])


_EXAMPLES = {"line": "line=[(-1.5, -1.2, 1), (-1.5, 1.2, 1)]", "polyline": "polyline=[(0, 0, 1), (0, 1, 1), (1, 1, 1)]",
             "circle": "circle=[(0, 0, 1), (0, 0.5, 1), (0, 0, 1.5)]", "points": "points=[(0, 0, 1), (0, 0.1, 1)]"}


def points_of(name: str, given: Points) -> List[List[float]]:
    """Converts points to lists of three numbers. Error: InvalidPoints, which says what is missing and how to write
    it."""
    example = f"write {_EXAMPLES[name]}"
    try:
        array = np.asarray(given, dtype=float)
    except (TypeError, ValueError):
        raise InvalidPoints(f"`{name}` is not a list of points of three numbers each", -32602, "invalidParameters", example) from None
    if array.shape == (3,):
        raise InvalidPoints(f"`{name}` is a single point, and takes a list of them", -32602, "invalidParameters", example)
    if array.ndim != 2 or array.shape[1] != 3:
        raise InvalidPoints(f"`{name}` is not a list of points of three numbers each: its shape is {array.shape}", -32602,
                            "invalidParameters", example)
    return [[float(x) for x in point] for point in array]
