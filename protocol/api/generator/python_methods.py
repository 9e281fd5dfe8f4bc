"""python/wakesurf/generated: every method with a signature, and those of surfaces that Session and Surface have."""
import re
import textwrap

from .markdown import plain, range_of
from .python import HEAD, TYPING, WIDTH, docstring, group_of, python_name, sentences, wrapped
from .schema import either

GROUPS = {"rpc": "About calls", "server": "The server", "dataset": "Datasets", "cache": "Time-steps in memory", "probe": "Values at points",
          "family": "Families of stream surfaces", "mean": "Means over time", "session": "Sessions and their people", "presence": "Presence", "rake": "Rakes",
          "surface": "Surfaces", "frame": "Mesh frames", "slice": "Slices", "lines": "Streamlines", "bookmark": "Bookmarks", "annotation": "Annotations", "history": "Undo", "time": "The clock"}
LEFT_TO_THE_CLIENT = ("session", "surface", "default", "gesture", "ifRev")
FIRST = ("rake", "kind", "dataset", "to", "from")


class PythonMethods:
    def __init__(self, api, types):
        self.api, self.types = api, types
        self.groups = {}
        for method in api.methods:
            self.groups.setdefault(group_of(method)[0], []).append(method)

    def files(self):
        made = {f"methods/{name}.py": self.group(name) for name in self.groups}
        made["methods/__init__.py"] = self.all_groups()
        made["surfaces.py"] = self.surfaces()
        return made

    def all_groups(self):
        lines = [*docstring(["Every method of the server, by noun.", HEAD], ""), "from __future__ import annotations", "",
                 "from typing import Optional", "", "from ...api_base import ApiCall"]
        lines += [f"from .{name} import {self.title(name)}" for name in sorted(self.groups)]
        lines += ["", "", "class Methods:", '    """Every method of the server: `api.rake.set(...)` is `rake.set`. With a session, those that need one take it."""',
                  "", "    def __init__(self, call: ApiCall, session: Optional[str] = None) -> None:"]
        lines += [f"        self.{name} = {self.title(name)}(call, session)" for name in self.groups]
        return "\n".join(lines) + "\n"

    def title(self, name):
        return name.capitalize() + "Methods"

    def group(self, name):
        body = ["", "", f"class {self.title(name)}(Noun):", f'    """{GROUPS[name]}."""']
        for method in self.groups[name]:
            body += ["", *self.method(method)]
        head = [*docstring([f"{GROUPS[name]}: methods of the server.", HEAD], ""), "from __future__ import annotations", ""]
        return "\n".join([*head, *self.imports(body, ["Noun"], "..."), *body]) + "\n"

    def words_and_records(self, body):
        """The words of the code, and the records among them."""
        words = set(re.findall(r"\w+", re.sub(r'""".*?"""', "", "\n".join(body), flags=re.S)))
        return words, sorted(name for name in self.types.records if name in words)

    def imports(self, body, of_call, dots):
        words, records = self.words_and_records(body)
        typing = [each for each in TYPING if each in words]
        lines = wrapped("from typing import (", sorted(typing), ")") + [""] if typing else []
        lines.append(f"from {dots}api_base import {', '.join([*of_call, *(each for each in ('LEFT_OUT', 'LeftOut') if each in words)])}")
        lines.append(f"from {dots}names import named")
        own = [each for each in ("Json", "NULL", "Point", "Points") if each in words]
        lines += [f"from {dots}plain import {', '.join(own)}"] if own else []
        lines += wrapped(f"from {dots[:-1]}records import (", records, ")") if records else []
        return lines

    def method(self, method):
        fields = [each for each in method.params.fields if each.name != "session"]
        has_session = len(fields) < len(method.params.fields)
        fields.sort(key=lambda each: not each.required)
        arguments = ["self", *(["*"] if method.params.fields else []), *[self.argument(each) for each in fields]]
        if has_session:
            arguments.append("session: Optional[str] = None")
        lines = ["    @named", *wrapped(f"    def {group_of(method)[1]}(", arguments, f") -> {self.types.result(method)}:")]
        lines += self.about_method(method, fields)
        entries = [f'"{each.name}": {self.given(each)}' for each in fields]
        if has_session:
            entries.insert(0, '"session": session')
        call = f'        answer: {self.types.result(method)} = self._call("{method.name}", {{'
        return [*lines, *(wrapped(call, entries, "})") if entries else [call + "})"]), "        return answer"]

    def argument(self, each):
        name, kind = python_name(each.name), self.types.asked(each.node)
        if each.required:
            return f"{name}: {kind}"
        return f"{name}: Union[{kind}, LeftOut] = LEFT_OUT" if each.node.nullable else f"{name}: Optional[{kind}] = None"

    def given(self, each):
        name = python_name(each.name)
        return f"NULL if {name} is None else {name}" if each.node.nullable else name

    def about_method(self, method, fields):
        lines = docstring(sentences(method.words), "        ")
        lines[-1] = lines[-1][:-3].rstrip()
        lines = lines if lines[-1] else lines[:-1]
        if fields:
            lines.append("")
            for each in fields:
                lines += hanging(self.about(each))
        notes = []
        if method.data.get("x-errors"):
            notes.append("Error: " + ", ".join(kind[0].upper() + kind[1:] for kind in method.data["x-errors"]) + ".")
        if method.role != "viewer":
            notes.append(f"For {method.role}s.")
        if method.flag("x-websocketOnly"):
            notes.append("Only on a `Connection`.")
        if notes:
            lines += ["", *hanging(" ".join(notes), "        ")]
        group, name = group_of(method)
        example = [f"{python_name(key)}={value!r}" for key, value in method.data["x-example"]["params"].items()]
        code = f"            api.{group}.{name}("
        longest = max(map(len, example), default=0)
        if longest + len(code) < WIDTH:
            lines += ["", "        For example:", "", *(wrapped(code, example, ")") if example else [code + ")"])]
        return [*lines, '        """']

    def about(self, each):
        node, more = each.node, []
        if "x-only-for" in node:
            more.append(f"only for {either(node['x-only-for'])} surfaces")
        elif "x-needed-for" in node:
            more.append(f"needed for {either(node['x-needed-for'])} surfaces")
        if node.kind in ("number", "count") and range_of(node) and "float" not in range_of(node):
            more.append(range_of(node))
        if "default" in node and node["default"] not in ([], ""):
            more.append(f"default {plain(node['default'])}")
        unit = f" ({node['x-unit']})" if "x-unit" in node else ""
        words = re.sub(r"`(\w+)`", lambda m: f"`{self.spelt(m[1])}`", node.words)
        return f"`{python_name(each.name)}`: " + "; ".join([words.rstrip(".") + unit, *more]) + "."

    def spelt(self, word):
        return python_name(word) if word in self.parameters() else word

    def parameters(self):
        return {each.name for method in self.api.methods for each in method.params.fields}

    # What Session and Surface have of surface.set.

    def settable(self):
        method = next(each for each in self.api.methods if each.name == "surface.set")
        fields = {each.name: each for each in method.params.fields if each.name not in LEFT_TO_THE_CLIENT}
        return [fields[name] for name in [*FIRST, *[name for name in fields if name not in FIRST]]]

    def surface_argument(self, each, all_optional):
        kind = 'Union[Record, str]' if each.name in ("rake", "rake2") else self.types.asked(each.node)
        name = python_name(each.name)
        if not all_optional and "x-needed-for" in each.node and "x-only-for" not in each.node:
            return f"{name}: Optional[{kind}]"  # said by most; None by the kinds that have none
        return f"{name}: {kind}" if each.required and not all_optional else f"{name}: Optional[{kind}] = None"

    def surfaces(self):
        fields = self.settable()
        making = ["self"]
        for each in fields:
            making.append(self.surface_argument(each, False))
            if each.name == FIRST[-1]:
                making.append("*")
        setting = ["self", "*", *[self.surface_argument(each, True) for each in fields], "if_rev: Optional[int] = None"]
        entries = wrapped("        return self._made({", [f'"{each.name}": {python_name(each.name)}' for each in fields], "})")
        changes = wrapped("        return self._changed({", [f'"{each.name}": {python_name(each.name)}' for each in fields], "}, if_rev)")
        about = [line for each in fields for line in hanging(self.about(each))]
        body = ["", "", "class SurfaceMaker(Generic[Made]):", '    """What `Session` has of surface.set."""', "",
                "    def _made(self, given: Json) -> Made:", "        raise NotImplementedError", "",
                "    @named", *wrapped("    def surface(", making, ") -> Made:"),
                '        """Makes a surface and starts computing it. What is left out has the default of `surface.set`. What `fields`',
                "        names is also in `Surface.mesh`, by name.", "", *about, "",
                "        >>> surface = session.surface(rake, \"stream\", dataset=\"tornado\", to=2, separation=0.05)",
                "        >>> surface.wait()[\"complete\"]", "        True", '        """', *entries,
                "", "", "class SurfaceChanger:", '    """What `Surface` has of surface.set."""', "",
                "    def _changed(self, changes: Json, if_rev: Optional[int]) -> SurfaceSetResult:", "        raise NotImplementedError", "",
                "    @named", *wrapped("    def set(", setting, ") -> SurfaceSetResult:"),
                '        """Changes the parameters given, as `Session.surface` has them, and computes the surface again. Where `from_`',
                "        or `to` change, forward or backward follows from them. `if_rev`: only if the record is at this revision.",
                "        Error: Stale.", "",
                "        >>> before = surface.wait()[\"quads\"]",
                "        >>> surface.set(separation=0.025)[\"surface\"] == surface.id", "        True",
                "        >>> surface.wait()[\"quads\"] > before", "        True", '        """', *changes]
        head = [*docstring(["Making and changing surfaces, with every parameter of surface.set.", HEAD], ""),
                "from __future__ import annotations", ""]
        names = ["Generic", "Literal", "Optional", "Sequence", "TypeVar", "Union"]
        head += ["from typing import " + ", ".join(["TYPE_CHECKING", *names]), "", "from ..names import named", "from ..plain import Json, Point",
                 *wrapped("from .records import (", self.words_and_records(body)[1], ")"), "", "if TYPE_CHECKING:", "    from ..record import Record", "",
                 'Made = TypeVar("Made")']
        head += wrapped("SETTABLE = (", [f'"{each.name}"' for each in fields], ")")
        return "\n".join([*head, *body]) + "\n"


def hanging(words, first="        "):
    return textwrap.wrap(words, WIDTH, initial_indent=first, subsequent_indent="            " if words.startswith("`") else first,
                         break_on_hyphens=False)
