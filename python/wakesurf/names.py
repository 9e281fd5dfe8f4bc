"""Wrong names of parameters and of methods: suggests the right one."""
from __future__ import annotations

import difflib
import functools
import inspect
import re
import warnings
from typing import TYPE_CHECKING, Any, Callable, Iterable, Optional, TypeVar

from .errors import MissingParameter, UnknownParameter

Function = TypeVar("Function", bound=Callable[..., Any])


def snake(name: str) -> str:
    """Converts maxQuads to max_quads."""
    return re.sub(r"(?<=[a-z0-9])[A-Z]", lambda m: "_" + m[0].lower(), name).lower()


def meant(name: str, known: Iterable[str]) -> Optional[str]:
    """Returns the known name that is most similar, if one is.

    >>> meant("maxQuads", ["max_quads", "merge"]), meant("seperation", ["separation"]), meant("colour", ["to"])
    ('max_quads', 'separation', None)
    """
    names = list(known)
    for each in (snake(name), snake(name) + "_", name + "_"):
        if each in names:
            return each
    return next(iter(difflib.get_close_matches(snake(name), names, 1, 0.6)), None)


def check_names(given: Iterable[str], known: Iterable[str], where: str) -> None:
    """Raises UnknownParameter for an unknown name."""
    names = list(known)
    for name in given:
        if name not in names:
            right = meant(name, names)
            raise UnknownParameter(f"{where} has no `{name}`", -32602, "invalidParameters",
                                   f"did you mean `{right}`?" if right else "there are " + (", ".join(names) or "none"))


def _missing(function: Callable[..., Any], name: str) -> MissingParameter:
    """Names a missing parameter, with its words in the docstring."""
    text = re.sub(r"\s*\n\s+", " ", inspect.cleandoc(function.__doc__ or "").replace("\n`", "\0`"))
    said = re.search(rf"\0`{name}`: ([^\0]*?)\.(?: |$|\0)", text)
    return MissingParameter(f"{function.__name__} needs `{name}`", -32602, "invalidParameters",
                            said[1] if said else f"help() of {function.__name__} has its parameters")


def named(function: Function) -> Function:
    """Returns a function that suggests the right parameter for a wrong name, and names a missing one. Names as the
    server spells them, as maxQuads, are accepted with a warning."""
    signature = inspect.signature(function)
    needed = [name for name, each in signature.parameters.items() if name != "self" and each.default is inspect.Parameter.empty
              and each.kind not in (inspect.Parameter.VAR_KEYWORD, inspect.Parameter.VAR_POSITIONAL)]
    known = [name for name, each in signature.parameters.items() if name != "self" and each.kind is not inspect.Parameter.VAR_KEYWORD]

    @functools.wraps(function)
    def called(*arguments: Any, **parameters: Any) -> Any:
        for name in [each for each in parameters if each not in known]:
            right = meant(name, known)
            if right is None or right.rstrip("_") != snake(name):
                hint = f"did you mean `{right}`?" if right else "there are " + ", ".join(known)
                raise UnknownParameter(f"{function.__name__} has no parameter `{name}`", -32602, "invalidParameters", hint)
            if right in parameters:
                raise UnknownParameter(f"`{right}` is given twice, once as `{name}`", -32602, "invalidParameters", "give it once")
            warnings.warn(f"`{name}` of {function.__name__} is spelt `{right}` in Python: did you mean that? It is taken for it "
                          "until version 0.3", DeprecationWarning, stacklevel=2)
            parameters[right] = parameters.pop(name)
        if needed:
            there = signature.bind_partial(*arguments, **parameters).arguments
            for name in needed:
                if name not in there:
                    raise _missing(function, name)
        return function(*arguments, **parameters)

    return called  # type: ignore[return-value]


class Helpful:
    """Gives an object an AttributeError that suggests a name."""

    if not TYPE_CHECKING:  # or every name would do for a type checker

        def __getattr__(self, name: str) -> Any:
            right = None if name.startswith("_") else meant(name, [each for each in dir(self) if not each.startswith("_")])
            raise AttributeError(f"{type(self).__name__} has no `{name}`" + (f": did you mean `{right}`?" if right else ""))
