"""A tool: its description, the check of its arguments, and its answer."""
from __future__ import annotations

import inspect
import re
import threading
import typing
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Literal, Mapping, Optional, Sequence, Tuple

from ..errors import InvalidParameters, WakesurfError
from ..names import meant
from ..plain import Json

if TYPE_CHECKING:
    from .work import Work

_JSON_TYPES: Dict[str, Tuple[type, ...]] = {"string": (str,), "boolean": (bool,), "integer": (int,), "number": (int, float),
                                            "array": (list,), "object": (dict,)}
_TYPE_NAMES: Dict[Any, str] = {str: "string", bool: "boolean", int: "integer", float: "number"}

POINT: Json = {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3}
PAIR: Json = {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2}
SURFACE: Json = {"type": "string", "description": "id of a surface; left out, the newest"}
TIME: Json = {"type": "number", "description": "time of the flow at which the surface is shown; left out, that of the session's clock"}


class Stopped(WakesurfError):
    """The client has cancelled the call, or has gone."""


class Call:
    """One call, from the view of the tool: whether it was cancelled, and who receives its progress."""

    def __init__(self, report: Optional[Callable[[float, str], None]] = None) -> None:
        self.cancelled = threading.Event()
        self._report, self._percent = report, -1.0

    def check(self) -> None:
        """Raises Stopped if the call was cancelled."""
        if self.cancelled.is_set():
            raise Stopped("the call was cancelled")

    def progress(self, share: Optional[float], words: str) -> None:
        """Reports progress, which must grow, as the protocol wants it. Error: Stopped."""
        self.check()
        percent = -1.0 if share is None else round(100 * share, 1)
        if self._report is not None and percent > self._percent:
            self._percent = percent
            self._report(percent, words)


@dataclass
class Answer:
    """A sentence for people and models, the numbers behind it, and a picture."""

    text: str
    numbers: Json
    png: Optional[bytes] = field(default=None, repr=False)


Function = Callable[["Work", Json, Call], Answer]


@dataclass(frozen=True)
class Tool:
    """A function with a name, words, and a schema of its arguments."""

    name: str
    title: str
    description: str
    properties: Mapping[str, Json]
    required: Sequence[str]
    reads_only: bool
    function: Function

    def described(self) -> Json:
        """Returns the description of tools/list."""
        return {"name": self.name, "title": self.title, "description": self.description,
                "inputSchema": {"type": "object", "properties": dict(self.properties), "required": list(self.required),
                                "additionalProperties": False},
                "annotations": {"title": self.title, "readOnlyHint": self.reads_only, "openWorldHint": False,
                                "destructiveHint": bool(self.properties.keys() & {"delete", "overwrite", "redo"})}}

    def check(self, given: Json) -> None:
        """Checks the arguments. Error: InvalidParameters, which names the argument."""
        for name in given:
            if name not in self.properties:
                right = meant(name, self.properties)
                raise _wrong(f"`{name}` is not an argument of {self.name}",
                             f"did you mean `{right}`?" if right else "there are " + (", ".join(self.properties) or "none"))
        for name in self.required:
            if name not in given:
                raise _wrong(f"{self.name} needs `{name}`", str(self.properties[name].get("description", "")))
        for name, value in given.items():
            check_value(value, self.properties[name], name)


def tool(name: str, title: str, description: str, properties: Mapping[str, Json], required: Sequence[str] = (),
         reads_only: bool = False) -> Callable[[Function], Tool]:
    """Makes a tool of a function."""
    return lambda function: Tool(name, title, description, properties, required, reads_only, function)


def _wrong(message: str, hint: str = "") -> InvalidParameters:
    return InvalidParameters(message, -32602, "invalidParameters", hint)


def check_value(value: Any, schema: Json, where: str) -> None:
    """Checks a value against the few words of JSON Schema that the tools use. Error: InvalidParameters."""
    kind = schema.get("type")
    if kind is not None:
        fits = isinstance(value, _JSON_TYPES[kind]) and (kind == "boolean" or not isinstance(value, bool))
        if not fits:
            raise _wrong(f"`{where}` is not of the type {kind}", str(schema.get("description", "")))
    if "enum" in schema and value not in schema["enum"]:
        raise _wrong(f"`{where}` is not one of {', '.join(schema['enum'])}")
    if "minimum" in schema and value < schema["minimum"] or "maximum" in schema and value > schema["maximum"]:
        raise _wrong(f"`{where}` is not from {schema.get('minimum')} to {schema.get('maximum')}")
    if kind == "array":
        least, most = schema.get("minItems", 0), schema.get("maxItems", len(value))
        if not least <= len(value) <= most:
            raise _wrong(f"`{where}` has {len(value)} items, not {least if least == most else f'{least} to {most}'}")
        for i, each in enumerate(value):
            check_value(each, schema.get("items", {}), f"{where}[{i}]")
    if kind == "object" and "properties" in schema:
        for name, each in value.items():
            if name not in schema["properties"]:
                right = meant(name, schema["properties"])
                raise _wrong(f"`{where}` has no `{name}`", f"did you mean `{right}`?" if right else "")
            check_value(each, schema["properties"][name], f"{where}.{name}")


def properties_of(method: Callable[..., Any], without: Sequence[str], **others: Json) -> Dict[str, Json]:
    """Returns the arguments of a generated method of the API, with its types and words; `from_` is `from` here.
    `others` replace them."""
    hints = typing.get_type_hints(method)
    words = _words_of(method)
    made: Dict[str, Json] = {}
    for name in inspect.signature(method).parameters:
        if name == "self" or name in without:
            continue
        made[name.rstrip("_")] = {**others.get(name, schema_of(hints[name])), "description": words.get(name, "")}
    return made


def _words_of(method: Callable[..., Any]) -> Dict[str, str]:
    """Returns the docstring's words for each parameter."""
    text = re.sub(r"\s*\n\s{4,}", " ", inspect.cleandoc(method.__doc__ or ""))
    found = re.findall(r"^`(\w+)`: (.*)$", text, re.M)
    return {name: re.sub(r"\ban id from (\w+)\.list", r"id of a \1", words.replace("`from_`", "`from`")) for name, words in found}


def schema_of(hint: Any) -> Json:
    """Returns the schema of a type of Python."""
    origin, parts = typing.get_origin(hint), typing.get_args(hint)
    if origin is typing.Union:
        return schema_of(next(each for each in parts if each is not type(None)))
    if origin is Literal:
        return {"type": "string", "enum": list(parts)}
    if origin is not None and parts and hint is not Any:
        return {"type": "array", "items": schema_of(parts[0])}
    if hasattr(hint, "__required_keys__"):  # a TypedDict
        return {"type": "object", "properties": {name: schema_of(each) for name, each in typing.get_type_hints(hint).items()}}
    return {"type": _TYPE_NAMES[hint]} if hint in _TYPE_NAMES else {}


def names_of(items: Sequence[Mapping[str, Any]], key: str) -> List[str]:
    """Returns the ids of records."""
    return [str(each[key]) for each in items]
