"""Parts of protocol/python/wakesurf.py, which is one file that users copy: each stands between two markers there."""
import keyword
import re
import textwrap

from .markdown import is_told, plain, range_of
from .schema import either, snake

WIDTH = 120
CLASSES = {"parseError": "InvalidRequest", "internal": "ServerFault"}
LEFT_TO_THE_CLIENT = ("session", "surface", "default", "gesture", "ifRev")
FIRST = ("rake", "kind", "dataset", "to", "from")


def python_name(name):
    name = snake(name)
    return name + "_" if keyword.iskeyword(name) else name


class Python:
    """Writes the parts."""

    def __init__(self, api):
        self.api = api

    def type(self, node):
        plain_type = self.plain_type(node)
        return f"Optional[{plain_type}]" if node.nullable else plain_type

    def plain_type(self, node):
        kind = node.kind
        if kind == "object" and node.name and is_told(node):
            return self.name(node)
        if kind in ("text", "lines") or kind == "enum":
            return "str" if kind != "enum" or isinstance(node["enum"][0], str) else "int"
        if kind == "token":
            return "Union[str, int]"
        if kind in ("number", "count", "flag"):
            return {"number": "float", "count": "int", "flag": "bool"}[kind]
        if kind == "point":
            return "List[float]"
        if node.items is not None:
            return f"List[{self.type(node.items)}]"
        if kind == "object" and node.values:
            return f"Dict[str, {self.type(node.values)}]"
        return "Json" if kind in ("object", "json") else "Any"

    def name(self, node):
        return node["x-cpp"] if node.get("x-record") else node.name

    def records(self):
        """A TypedDict for each shape; those with a member that is a keyword of Python as a call."""
        lines = []
        for node in self.api.shapes.values():
            if not is_told(node) or node.name in ("Empty", "Durability", "AfterEdit", "WorkDoneToken"):
                continue
            about = [(each.name, self.type(each.node), self.words(each)) for each in node.fields]
            if any(keyword.iskeyword(name) for name, _, _ in about):
                lines += [f"{self.name(node)} = TypedDict(\"{self.name(node)}\", {{  # {first_line(node.words)}"]
                lines += [comment(f'    "{name}": "{kind}",', words) for name, kind, words in about]
                lines += ["}, total=False)", "", ""]
            else:
                lines += [f"class {self.name(node)}(TypedDict, total=False):", f'    """{first_line(node.words)}"""', ""]
                lines += [comment(f"    {name}: {kind}", words) for name, kind, words in about] + ["", ""]
        return lines[:-2]

    def words(self, each):
        unit = each.node.get("x-unit")
        return each.node.words + (f" ({unit})" if unit else "") + ("" if each.required else "; may be missing")

    def errors(self):
        words = [f"{data['code']}: {CLASSES.get(kind, kind[0].upper() + kind[1:])}" for kind, data in self.api.errors.items()]
        return wrapped("_BY_CODE = {", words, "}")

    def limits(self):
        data = dict(self.api.limits)
        return [f"_PROBE_POINTS = {data['probePoints']['const']}  # of one call",
                f"_MESSAGE_BYTES = {data['messageBytes']['const']}  # that the server takes"]

    # surface.set

    def settable(self):
        method = next(each for each in self.api.methods if each.name == "surface.set")
        fields = {each.name: each for each in method.params.fields if each.name not in LEFT_TO_THE_CLIENT}
        order = [*FIRST, *[name for name in fields if name not in FIRST]]
        return [fields[name] for name in order]

    def spelling(self):
        return wrapped("_SURFACE_NAMES = {", [f'"{python_name(each.name)}": "{each.name}"' for each in self.settable()], "}")

    def argument_type(self, each):
        if each.name in ("rake", "rake2"):
            return 'Union["Rake", str]'
        return {"point": "Point", "texts": "Sequence[str]"}.get(each.node.kind, self.plain_type(each.node))

    def surface(self):
        arguments = ["self"]
        for each in self.settable():
            kind = self.argument_type(each)
            arguments.append(f"{python_name(each.name)}: {kind}" if each.required else
                             f"{python_name(each.name)}: Optional[{kind}] = None")
            if each.name == FIRST[-1]:
                arguments.append("*")
        arguments.append("**more: Any")
        head = "    def surface("
        lines = wrapped(head, arguments, ') -> "Surface":')
        lines += ['        """Makes a surface and starts computing it. What is left out has the default of `surface.set`, whose spelling, as in',
                  "        maxQuads, is taken too. What `fields` names is also in `Surface.mesh`, by name.", ""]
        for each in self.settable():
            lines += textwrap.wrap(self.about(each), WIDTH, initial_indent="        ", subsequent_indent="            ",
                                   break_on_hyphens=False)
        entries = [f'"{each.name}": {self.value(each)}' for each in self.settable()]
        lines += ['        """', *wrapped("        given: Json = {", entries, "}"), "        return self._surface(given, more)"]
        return lines

    def value(self, each):
        return "_id(rake)" if each.name == "rake" else python_name(each.name)

    def about(self, each):
        node, more = each.node, []
        if "x-only-for" in node:
            more.append(f"only for {either(node['x-only-for'])} surfaces")
        if node.kind in ("number", "count") and range_of(node) and "float" not in range_of(node):
            more.append(range_of(node))
        if "default" in node and node["default"] != []:
            more.append(f"default {plain(node['default'])}")
        unit = f" ({node['x-unit']})" if "x-unit" in node else ""
        return f"`{python_name(each.name)}`: " + "; ".join([node.words.replace("maxQuads", "max_quads") + unit, *more]) + "."

    def text(self, old):
        """The file with its parts made again. Error: ValueError where a marker is missing."""
        for name in ("records", "errors", "limits", "spelling", "surface"):
            lines = getattr(self, name)()
            pattern = re.compile(rf"(?m)^([ ]*)# <{name}: made by protocol/api/generate>\n(?:.*\n)*?\1# </{name}>\n")
            if not pattern.search(old):
                raise ValueError(f"wakesurf.py has no markers of {name}")
            old = pattern.sub(lambda m, lines=lines, name=name: "\n".join(
                [f"{m[1]}# <{name}: made by protocol/api/generate>", *lines, f"{m[1]}# </{name}>", ""]), old)
        return old


def wrapped(head, parts, tail):
    """`head`, the parts with commas between them, `tail`; lines end between parts, and go on below the first part."""
    lines, line = [], head
    for i, each in enumerate(parts):
        piece = each + (tail if i + 1 == len(parts) else ",")
        if len(line) + len(piece) + 1 > WIDTH:
            lines.append(line)
            line = " " * len(head) + piece
        else:
            line += ("" if line == head else " ") + piece
    return [*lines, line]


def first_line(words):
    return words.split(". ")[0].rstrip(".") + "."


def comment(code, words):
    """A line of code with a comment behind it, as far as there is room."""
    room = WIDTH - len(code) - 4
    return f"{code}  # {words}" if len(words) <= room else f"{code}  # {textwrap.shorten(words, room, placeholder=' ...')}"
