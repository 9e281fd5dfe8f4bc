"""What the server says, in the words of who reads it.

The server writes names of its API in backticks, as `maxQuads` and `session.list`; names of data stand bare. Each front end spells these names its own
way: the command line has server/app/name_mapping, Python and the tools for agents have this.
"""
from __future__ import annotations

import functools
import inspect
import re
from typing import Any, Dict, Mapping, Set, Tuple

from .errors import WakesurfError
from .generated.error_codes import BY_CODE
from .generated.methods import Methods

_NAME = re.compile(r"`([A-Za-z$/.]+)`")


def _of_api(name: str) -> str:
    """Converts max_quads to maxQuads and from_ to from."""
    return re.sub(r"_([a-z])", lambda found: found[1].upper(), name.rstrip("_"))


@functools.lru_cache(maxsize=None)
def names() -> Tuple[Mapping[str, str], Mapping[str, str]]:
    """Returns methods and parameters of the API, as they are written in Python.

    >>> methods, parameters = names()
    >>> methods["session.list"], parameters["maxQuads"], parameters["from"]
    ('session.api.session.list()', 'max_quads', 'from_')
    """
    methods: Dict[str, str] = {}
    parameters: Dict[str, str] = {}
    for noun, group in vars(Methods(lambda *_, **__: None)).items():
        for verb, function in inspect.getmembers(type(group), inspect.isfunction):
            if verb.startswith("_"):
                continue
            methods[f"{noun}.{_of_api(verb)}"] = f"session.api.{noun}.{verb}()"
            for each in inspect.signature(function).parameters:
                parameters[_of_api(each)] = each
    return methods, parameters


def in_python(words: str) -> str:
    """Replaces the API's names by those of Python.

    >>> in_python("raise `maxQuads`; `session.list` lists them, `wallShearStress` is no parameter")
    'raise `max_quads`; `session.api.session.list()` lists them, `wallShearStress` is no parameter'
    """
    methods, parameters = names()
    return _NAME.sub(lambda found: f"`{methods.get(found[1]) or parameters.get(found[1], found[1])}`", words)


def error_of(fault: Mapping[str, Any]) -> WakesurfError:
    """Returns the exception for the `error` of an answer, in the words of Python."""
    data = dict(fault.get("data") or {})
    kind = BY_CODE.get(fault.get("code", 0), WakesurfError)
    message, hint = str(fault.get("message", "")), str(data.pop("hint", ""))
    problem = kind(in_python(message), fault.get("code", 0), data.pop("kind", ""), in_python(hint), data)
    problem.original = message, hint
    return problem


def named_methods(words: str) -> Set[str]:
    """Returns the methods of the API that a text names."""
    return {each for each in _NAME.findall(words) if each in names()[0]}


def in_options(message: str, hint: str) -> str:
    """Replaces the API's names by those of the command line, whose options are named like parameters. It has no
    methods: a hint that needs one is left out.

    >>> in_options("more than `maxQuads` 7 allows", "raise `maxQuads`"), in_options("no session", "`session.list` lists them")
    ('more than --max-quads 7 allows (raise --max-quads)', 'no session')
    """
    parameters = names()[1]

    def spelt(words: str) -> str:
        return _NAME.sub(lambda found: "--" + parameters[found[1]].strip("_").replace("_", "-") if found[1] in parameters else found[0], words)

    return spelt(message) + (f" ({spelt(hint)})" if hint and not named_methods(hint) else "")
