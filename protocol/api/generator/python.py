"""python/wakesurf/generated: types of what the server answers and tells, numbers of the description, and what python_methods makes."""
import json
import keyword
import os
import re
import textwrap

from .markdown import is_told
from .schema import FOLDER, NOUNS, camel, snake

WIDTH = 120
HEAD = "Made by protocol/api/generate from protocol/api/*.schema.json: do not edit."
CLASSES = {"parseError": "InvalidRequest", "internal": "ServerFault"}
NOT_RECORDS = ("Empty", "Durability", "AfterEdit", "WorkDoneToken")
NOTIFICATIONS = {"$/progress": "WorkProgress"}
TYPING = ("Any", "Callable", "ClassVar", "Dict", "List", "Literal", "Mapping", "Optional", "Sequence", "Tuple", "TypedDict", "Union")


def python_name(name):
    name = snake(name)
    return name + "_" if keyword.iskeyword(name) else name


def group_of(method):
    """The attribute of `api` that a method is under, and its name there."""
    noun, _, verb = method.name.replace("$/", "rpc.").partition(".")
    return noun, python_name(verb)


class Types:
    """What Python calls the shapes of the description."""

    def __init__(self, api):
        self.api = api
        self.records = {self.name(node): home for node, home in ((api.shapes[each], api.home[each]) for each in api.shapes)
                        if is_told(node) and node.name not in NOT_RECORDS}
        for method in api.methods:
            if self.own_result(method):
                self.records[camel(method.name) + "Result"] = method.noun

    def name(self, node):
        return node["x-cpp"] if node.get("x-record") else node.name

    def own_result(self, method):
        return bool(method.result.fields) and not self.is_record(method.result) and method.result.name not in NOT_RECORDS

    def is_record(self, node):
        return node.kind == "object" and bool(node.name) and is_told(node) and node.name not in NOT_RECORDS

    def result(self, method):
        if self.is_record(method.result):
            return self.name(method.result)
        return camel(method.name) + "Result" if self.own_result(method) else "Json"

    def told(self, node):
        """Of what the server says."""
        plain_type = self.plain(node)
        return f"Optional[{plain_type}]" if node.nullable else plain_type

    def plain(self, node):
        kind = node.kind
        if self.is_record(node):
            return self.name(node)
        if kind == "enum":
            return "Literal[" + ", ".join(json.dumps(each) for each in node["enum"]) + "]"
        if kind in ("text", "lines", "token", "number", "count", "flag", "point"):
            return {"text": "str", "lines": "str", "token": "Union[str, int]", "number": "float", "count": "int", "flag": "bool",
                    "point": "List[float]"}[kind]
        if node.items is not None:
            return f"List[{self.told(node.items)}]"
        if kind == "object" and node.values:
            return f"Dict[str, {self.told(node.values)}]"
        return "Json" if kind in ("object", "json") else "Any"

    def asked(self, node):
        """Of what a caller gives; None stands for null where that means something."""
        kind = node.kind
        if kind in ("point", "points", "texts"):
            plain_type = {"point": "Point", "points": "Points", "texts": "Sequence[str]"}[kind]
        elif kind in ("object", "json"):
            plain_type = self.name(node) if self.is_record(node) else "Mapping[str, Any]"
        else:
            plain_type = self.plain(node)
        return f"Optional[{plain_type}]" if node.nullable else plain_type


class Python:
    """Writes the files that have types and numbers."""

    def __init__(self, api):
        self.api, self.types = api, Types(api)

    def files(self):
        """name -> text, in the folder of what is made."""
        from .python_methods import PythonMethods
        made = {"__init__.py": f'"""{HEAD}"""\n', "error_codes.py": self.errors(), "limits.py": self.limits(), "version.py": self.version(),
                "notifications.py": self.notifications(), "records/__init__.py": self.all_records()}
        for noun in self.noun_files():
            made[f"records/{noun}.py"] = self.records_of(noun)
        made.update(PythonMethods(self.api, self.types).files())
        return made

    def noun_files(self):
        return [noun for noun in ("shared", "limits", *NOUNS) if noun in self.types.records.values()]

    # What the server answers.

    def records_of(self, noun):
        lines = []
        for name, home in self.api.home.items():
            node = self.api.shapes[name]
            if home == noun and self.types.name(node) in self.types.records:
                lines += ["", "", *self.record(self.types.name(node), first_line(node.words), node.fields)]
        for method in self.api.of_noun(noun):
            if self.types.own_result(method):
                name = camel(method.name) + "Result"
                lines += ["", "", *self.record(name, f"What {method.name} answers.", method.result.fields)]
        title = self.api.titles[noun][0]
        return module(f"{title}: what the server answers. Members that may be missing are not there then.", lines,
                      self.imports(lines, noun))

    def imports(self, lines, noun=None, depth="."):
        """Those of records that the lines name; for types alone, as records of two files may name each other."""
        words = set(re.findall(r"\w+", "\n".join(code_of(line) for line in lines)))
        of = {}
        for name, home in self.types.records.items():
            if name in words and home != noun:
                of.setdefault(home, []).append(name)
        return [each for home in of for each in wrapped(f"    from {depth}{home} import (", sorted(of[home]), ")")]

    def record(self, name, words, fields):
        """A TypedDict; with a member that is a keyword of Python as a call."""
        about = [(each.name, self.types.told(each.node), self.words(each)) for each in fields]
        if any(keyword.iskeyword(member) for member, _, _ in about):
            lines = [f"{name} = TypedDict(\"{name}\", {{  # {words}"]
            lines += [comment(f'    "{member}": {quoted(kind)},', text) for member, kind, text in about]
            return [*lines, "}, total=False)"]
        lines = [f"class {name}(TypedDict, total=False):", f'    """{words}"""', ""]
        return lines + [comment(f"    {member}: {kind}", text) for member, kind, text in about]

    def words(self, each):
        unit = each.node.get("x-unit")
        return each.node.words + (f" ({unit})" if unit else "") + ("" if each.required else "; may be missing")

    def all_records(self):
        lines = docstring(["All records.", HEAD], "")
        for noun in self.noun_files():
            names = [name for name, home in self.types.records.items() if home == noun]
            lines += wrapped(f"from .{noun} import (", names, ")")
        lines += ["", *wrapped("__all__ = [", [f'"{name}"' for name in self.types.records], "]")]
        return "\n".join(lines) + "\n"

    # What the server tells.

    def notifications(self):
        lines, names = [], []
        for name, _, words, node in self.api.notifications:
            title = NOTIFICATIONS.get(name, camel(name))
            names.append((name, title))
            lines += ["", "", "@dataclass(frozen=True)", f"class {title}(Notification):",
                      *docstring(sentences(words), "    "), "", f'    method: ClassVar[str] = "{name}"']
            fields = sorted(node.fields, key=lambda each: not each.required)
            for each in fields:
                kind = self.types.told(each.node)
                member = f"    {python_name(each.name)}: {kind}" if each.required else \
                    f"    {python_name(each.name)}: {kind if each.node.nullable else f'Optional[{kind}]'} = None"
                lines.append(comment(member, self.words(each)))
        lines += ["", "", *wrapped("BY_METHOD: Dict[str, Type[Notification]] = {", [f'"{name}": {title}' for name, title in names], "}")]
        lines += ["", *wrapped("__all__ = [", ['"BY_METHOD"', *[f'"{title}"' for _, title in names]], "]")]
        known = self.imports(lines, depth=".records.")
        return module("What the server tells those who listen, as `Session.watch` gives it. Members that are missing are None.", lines, known,
                      ["from dataclasses import dataclass"], ["from ..api_base import Notification"], ("Type",))

    # Numbers.

    def errors(self):
        names = [CLASSES.get(kind, kind[0].upper() + kind[1:]) for kind in self.api.errors]
        codes = [f"{data['code']}: {name}" for name, data in zip(names, self.api.errors.values())]
        lines = [*docstring(["Which exception each code of an error is.", HEAD], ""), "from typing import Dict, Type", "",
                 *wrapped("from ..errors import (", sorted({*names, "WakesurfError"}), ")"), "",
                 *wrapped("BY_CODE: Dict[int, Type[WakesurfError]] = {", codes, "}")]
        return "\n".join(lines) + "\n"

    def limits(self):
        data = dict(self.api.limits)
        return "\n".join([*docstring(["Limits of the server that the client keeps to.", HEAD], ""),
                          f"PROBE_POINTS = {data['probePoints']['const']}  # of one call",
                          f"MESSAGE_BYTES = {data['messageBytes']['const']}  # that the server takes", ""])

    def version(self):
        with open(os.path.join(os.path.dirname(os.path.dirname(FOLDER)), "CMakeLists.txt"), encoding="utf-8") as file:
            version = re.search(r"project\(wakesurf VERSION ([\d.]+)", file.read())[1]
        return "\n".join([*docstring(["The version, as in CMakeLists.txt.", HEAD], ""), f'VERSION = "{version}"', ""])


def module(words, lines, for_types=(), standard=(), ours=(), more=()):
    """A file: docstring, the imports that its lines need, the lines."""
    used = set(re.findall(r"\w+", "\n".join(code_of(line) for line in lines)))
    typing = sorted([each for each in (*TYPING, *more) if each in used] + (["TYPE_CHECKING"] if for_types else []))
    head = [*docstring([words, HEAD], ""), "from __future__ import annotations", "", *standard]
    head += wrapped("from typing import (", typing, ")") if typing else []
    plain = [each for each in ("Json", "Point", "Points") if each in used]
    head += [""] if plain or ours else []
    dots = "..." if not ours else ".."
    head += [f"from {dots}plain import {', '.join(plain)}"] if plain else []
    head += list(ours)
    head += ["", "if TYPE_CHECKING:", *for_types] if for_types else []
    return "\n".join([*head, *lines]) + "\n"


def code_of(line):
    return line.split("  # ")[0]


def docstring(paragraphs, indent):
    """Lines of one; each paragraph is wrapped by itself."""
    first = textwrap.wrap('"""' + paragraphs[0], WIDTH - 3, initial_indent=indent, subsequent_indent=indent, break_on_hyphens=False)
    lines = list(first)
    for each in paragraphs[1:]:
        lines += ["", *textwrap.wrap(each, WIDTH, initial_indent=indent, subsequent_indent=indent, break_on_hyphens=False)]
    return [*lines, indent + '"""'] if len(lines) > 1 else [lines[0] + '"""']


def wrapped(head, parts, tail):
    """`head`, the parts with commas between them, `tail`; lines end between parts, and go on below the first part."""
    if tail == ")" and head.endswith("import (") and len(head) + len(", ".join(parts)) <= WIDTH:
        return [head[:-1] + ", ".join(parts)]
    lines, line = [], head
    for i, each in enumerate(parts):
        piece = each + (tail if i + 1 == len(parts) else ",")
        if len(line) + len(piece) + 1 > WIDTH:
            lines.append(line.rstrip())
            line = " " * len(head) + piece
        else:
            line += ("" if line == head else " ") + piece
    return [*lines, line]


def quoted(text):
    return repr(text) if '"' in text else f'"{text}"'


def sentences(words):
    return [words if words.endswith(".") else words + "."]


def first_line(words):
    return words.split(". ")[0].rstrip(".") + "."


def comment(code, words):
    """A line of code with a comment behind it, as far as there is room."""
    room = WIDTH - len(code) - 4
    if room < 20:
        return code
    return f"{code}  # {words}" if len(words) <= room else f"{code}  # {textwrap.shorten(words, room, placeholder=' ...')}"
