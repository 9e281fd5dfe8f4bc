"""A parameter study: one surface after the other, in a session of its own that is gone at the end."""
from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, Iterator, Mapping, Optional, Sequence

from .generated.records import Statistics
from .mesh import Mesh
from .names import meant
from .errors import InvalidParameters, UnknownParameter
from .progress import Report, Told
from .surface import Surface

if TYPE_CHECKING:
    from .client import Client

_OF_RAKE = ("line", "polyline", "circle", "points", "seeds")


@dataclass(frozen=True)
class Case:
    """Holds one case of a study: its parameters, its result, and the surface itself until the loop's next case."""

    parameters: Dict[str, Any]
    statistics: Statistics
    surface: Surface

    def mesh(self) -> Mesh:
        """Returns the mesh, as `Surface.mesh`."""
        return self.surface.mesh()

    def row(self) -> Dict[str, Any]:
        """Returns parameters and numbers of the statistics, for a table. `separation` is that of the mesh,
        `requestedSeparation` what was asked for."""
        numbers = {name: value for name, value in self.statistics.items() if isinstance(value, (int, float, str))}
        return {**self.parameters, **numbers, "seconds": self.statistics["seconds"]["total"]}


def study(client: Client, rake: Mapping[str, Any], vary: Mapping[str, Sequence[Any]], surface: Mapping[str, Any],
          progress: Optional[Told], timeout: Optional[float]) -> Iterator[Case]:
    """Makes a study; see `Session.study`. Parameters of the rake can be varied as well: seeds, line, ..."""
    if not vary or not all(len(values) for values in vary.values()):
        raise InvalidParameters("nothing is varied", -32602, "invalidParameters", "give vary={\"separation\": [0.1, 0.05]}")
    twice = [name for name in vary if name in surface]
    if twice:
        raise UnknownParameter(f"`{twice[0]}` is varied and given", -32602, "invalidParameters", "give it once")
    for name in set(surface) & set(_OF_RAKE):
        raise UnknownParameter(f"`{name}` belongs to the rake", -32602, "invalidParameters", f"put it into rake={{\"{name}\": ...}}")
    report = Report.to(progress)
    cases = [dict(zip(vary, values)) for values in itertools.product(*vary.values())]
    with client.scratch("study") as scratch:
        for i, case in enumerate(cases):
            report.share(i / len(cases), ", ".join(f"{name}={value}" for name, value in case.items()))
            of_rake = {name: value for name, value in case.items() if name in _OF_RAKE}
            of_surface: Dict[str, Any] = {name: value for name, value in case.items() if name not in _OF_RAKE}
            with scratch.rake(**{**rake, **of_rake}) as where:
                made = scratch.surface(where, **{**surface, **of_surface})
                yield Case(case, made.wait(timeout), made)
        report.done("complete")
