"""docs/api.md: the reference, by noun and method. What several methods or records share is described once, and linked."""
import json
import re
from collections import Counter

from .examples import Examples
from .openrpc import errors_of
from .schema import NOUNS, either

README = "protocol/api/README.md"
PROTOCOL = "protocol/README.md"
FLOAT = 3.4028234663852886e38
COMMON = ("Edit", "FirstRecord", "WorkDoneToken")  # whose parameters a section of their own describes
UNITS = {"the dataset's unit of length": "length", "the dataset's unit of time": "time"}
INTRO = """<!-- Made by protocol/api/generate from protocol/api/*.schema.json: do not edit. -->
# The API

Every method, notification, record, limit and error. [{protocol}](../{protocol}) says how messages are exchanged,
[{readme}](../{readme}) how sessions and edits work. A server returns the same, with the examples whole, as an
[OpenRPC](https://open-rpc.org) document: `rpc.discover`, or `GET /openrpc.json`.

- `name`?: a parameter that may be left out, or a member that may be missing. An unknown parameter is refused; null counts as left out, unless
  the type includes null.
- A unit follows the type in parentheses; *length* and *time* are the dataset's own units, and [x, y, z] is in the unit of length.
- Numbers are finite. Integers are 0 or more, except codes of errors, and may be written `32` or `32.0`.
- Lengths of strings are bytes in UTF-8: ids have 1 to 256, and string parameters at most 256 unless stated otherwise. Strings have no control
  characters unless they are multi-line.
- Any role may call a method that names none.
- Every method may answer the errors {always}; the entry of a method names the others.
- If the server keeps sessions, the answer to an *edit* also has the members of [Durability](#durability).
- In examples, `...` stands for a record that another example or a table shows, and for further ones in a list.
"""


def cell(text):
    return text.replace("|", "\\|").replace("\n", " ")


def plain(value):
    return f"{value:,}" if isinstance(value, int) and abs(value) >= 10000 else f"{value:g}" if isinstance(value, float) else str(value)


def type_of(node, known=()):
    """`known`: shapes that are no objects and have an entry of their own."""
    if node.name in known:
        words = link(node)
    elif node.kind == "enum":
        words = " | ".join(json.dumps(each) for each in node["enum"])
    elif node.kind == "const":
        words = json.dumps(node["const"])
    elif node.kind == "point":
        words = "[x, y, z]"
    elif node.kind == "object":
        words = link(node) if node.name else "object"
    elif node.kind == "text" and node.name == "Id":
        words = "id"
    elif node.kind == "tuple":
        words = "[" + ", ".join(type_of(each, known) for each in node.parts) + "]"
    elif node.items is not None:
        words = type_of(node.items, known)
        words = f"list of {length_of(node)} {words.replace(' or ', 's or ')}s" if length_of(node) else f"list of {words}"
    elif node.choices:
        words = " or ".join(type_of(each, known) for each in node.choices)
    else:
        words = {"text": "string", "lines": "multi-line string", "json": "object", "flag": "boolean", "count": "integer",
                 "token": "string or any integer", "any": " or ".join(each for each in node.types if each != "null") or "anything"}.get(
                     node.kind, node.kind)
    return words + (" or null" if node.nullable else "")


def full_type(node, known=()):
    """With unit and range, unless the introduction says them."""
    if node.name in known:
        return type_of(node, known)
    unit = UNITS.get(node.get("x-unit"), node.get("x-unit")) if "[x, y, z]" not in type_of(node) else None
    limits = range_of(node)
    implied = node.kind == "count" and limits == "0 or more" or node.kind == "text" and limits in ("at most 256 bytes", "1 to 256 bytes")
    words = type_of(node, known)
    if unit:
        null = " or null" if node.nullable else ""
        words = f"{words.removesuffix(null)} ({unit}){null}"
    return words + (f", {limits}" if limits and not implied else "")


def length_of(node):
    """Of a list of a fixed length, or 0."""
    return node["maxItems"] if "maxItems" in node and node.get("minItems") == node["maxItems"] else 0


def link(node):
    return f"[{node.name}](#{node.name.lower()})"


def range_of(node):
    lo, hi = node.get("minimum", node.get("exclusiveMinimum")), node.get("maximum")
    if hi == FLOAT:
        return "finite as a 32-bit float"
    words = []
    if "exclusiveMinimum" in node:
        words.append(f"above {plain(lo)}" + (f", at most {plain(hi)}" if hi is not None else ""))
    elif lo is not None and hi is not None:
        words.append(f"{plain(lo)} to {plain(hi)}" if hi < 2**32 - 1 else f"{plain(lo)} or more")
    elif lo is not None:
        words.append(f"{plain(lo)} or more")
    elif hi is not None:
        words.append(f"at most {plain(hi)}")
    if "maxLength" in node:
        words.append(f"{plain(node['minLength'])} to {plain(node['maxLength'])} bytes" if node.get("minLength") else
                     f"at most {plain(node['maxLength'])} bytes")
    if "x-maxBytes" in node:
        words.append(f"at most {plain(node['x-maxBytes'])} bytes as JSON text")
    if "pattern" in node:
        words.append(f"`{node['pattern']}`")
    if "maxItems" in node and not length_of(node):
        words.append(f"at most {plain(node['maxItems'])}")
    return ", ".join(words)


def table(titles, rows):
    return "\n".join(["| " + " | ".join(titles) + " |", "|" + "---|" * len(titles), *("| " + " | ".join(map(cell, row)) + " |" for row in rows)])


def sentence(words, begins=True):
    words = words[:1].upper() + words[1:] if begins else words
    return words if words.endswith((".", ":")) else words + "."


def in_words(name, kind, words):
    begins = re.match(r"\w+:", words)
    return f"{name}, {kind}" + (". " if begins else ": " if words else ".") + (sentence(words, begins) if words else "")


def anchor(title, space=""):
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", space)


def named(fields):
    return ", ".join(f"`{each.name}`" + ("" if each.required else "?") for each in fields)


def is_told(shape):
    return shape.kind == "object" and shape.fields and shape.name not in (
        "InSession", "Edit", "FirstRecord", "RakeShape", "SurfaceFields", "SliceFields", "LinesFields", "BookmarkFields", "AnnotationFields", "Limits", "ErrorData")


def who_may(method):
    """Sentences; none if anybody may call it, anywhere."""
    role = {"viewer": "", "editor": "For editors", "host": "For hosts"}[method.role]
    if method.flag("x-wholeServer"):
        role += " with the server's own token"
    elif method.flag("x-shared"):
        role += "; in a copy made with a share link, the role of that link counts"
    elif method.flag("x-copier"):
        role += ", and for whoever made this session, as a copy, with a share link"
    return [each + "." for each, holds in ((role, role), ("On a WebSocket only", method.flag("x-websocketOnly")), ("An edit", method.flag("x-edits")))
            if holds]


class Reference:
    def __init__(self, api):
        self.api = api
        self.examples = Examples(api)
        self.common = list({each.name: each for name in COMMON for each in api.shape(name).fields}.values())
        self.common.append(next(each for method in api.methods for each in method.params.fields if each.node.name == "WorkDoneToken"))
        self.shared = [each for each in sorted(api.shapes.values(), key=lambda each: -len(each.fields)) if len(each.fields) > 3 and is_told(each)]
        self.known = ()
        rows = [each.node for node, home, parameters in self.described() for each in self.split(node, home, parameters)[0]]
        own_words = Counter(each.name for each in rows if each.name and each.words == api.shape(each.name).words and len(each.words.split()) > 3)
        enums = Counter(each.name for each in rows if each.kind == "enum")
        self.known = [name for name, shape in api.shapes.items() if shape.kind != "object" and (own_words[name] > 1 or enums[name] > 2)]

    def described(self):
        """(node, noun, whether its members are parameters) of all that has a table of its own."""
        for method in self.api.methods:
            yield method.params, method.noun, True
            if not is_told(method.result) or not method.result.name:
                yield method.result, method.noun, False
        for _, home, _, params in self.api.notifications:
            if not params.name:
                yield params, home, False
        for name, home in self.api.home.items():
            if is_told(self.api.shape(name)):
                yield self.api.shape(name), home, False

    def row(self, each, parameters):
        node = each.node
        default = f", default `{json.dumps(node['default'])}`" if parameters and "default" in node else ""
        words = "" if node.name in self.known and node.words == self.api.shape(node.name).words else node.words
        if "x-only-for" in node:
            words += f"; only for {either(node['x-only-for'])} surfaces" + (", which need it" if "x-needed-for" in node else "")
        elif "x-needed-for" in node:
            words += f"; {either(node['x-needed-for'])} surfaces need it"
        return [f"`{each.name}`" + ("" if each.required else "?"), full_type(node, self.known) + default, words]

    def split(self, node, noun, parameters):
        """(the members that are described here, sentences that say where the others are)."""
        fields, elsewhere = node.fields, []

        def among(others, optional_too=False):
            theirs = {each.name: each for each in others}
            return [each for each in fields if each.name in theirs and self.row(each, False)[1:] == self.row(theirs[each.name], False)[1:]
                    and (optional_too or each.required == theirs[each.name].required)]

        def leave_out(found, words):
            nonlocal fields
            fields = [each for each in fields if each not in found]
            elsewhere.append(words)

        for shape in self.shared:
            found = among(shape.fields) if shape is not node and len(shape.fields) <= len(fields) else []
            if len(found) == len(shape.fields):
                leave_out(found, f"With the members of {link(shape)}.")
        found = among(self.common) if parameters else []
        if found:
            leave_out(found, f"[Common parameters](#common-parameters): {named(found)}")
        for method in [] if parameters else self.api.of_noun(noun):
            found = among(self.split(method.params, noun, True)[0], True)
            if len(found) > 2:
                leave_out(found, f"As in [{method.name}](#{anchor(method.name)}): {named(found)}")
        return fields, elsewhere

    def members(self, node, noun, parameters=False):
        """Lines after an empty one."""
        title = "parameter" if parameters else "member"
        fields, elsewhere = self.split(node, noun, parameters)
        rows = [self.row(each, parameters) for each in fields]
        if len(rows) == 1:
            elsewhere.insert(0, f"{title.capitalize()} {in_words(*rows[0])}")
        lines = ["", table([title, "type", "meaning"], rows)] if len(rows) > 2 else []
        if len(rows) == 2:
            lines = [*(["", "Parameters:"] if parameters else []), "", *(f"- {in_words(*row)}" for row in rows)]
        return lines + (["", " ".join(elsewhere)] if elsewhere else [])

    def method(self, method):
        always = [kind for kind, data in self.api.errors.items() if data.get("x-always")]
        errors = [kind for kind in errors_of(self.api, method) if kind not in always]
        may = who_may(method) + ([f"Errors: {', '.join(errors)}."] if errors else [])
        lines = [f"### {method.name}", "", sentence(method.words), *(["", " ".join(may)] if may else [])]
        lines += self.members(method.params, method.noun, True)
        for kind, rule in method.data.get("x-exactly-one", {}).items():
            lines += ["", f"A {kind} surface takes exactly one of {' and '.join(f'`{name}`' for name in rule['of'])}: {rule['hint']}."]
        if method.result.name and method.result.fields:
            lines += ["", f"Answers {link(method.result)}."]
        elif method.result.fields:
            lines += ["", "Answers:", *self.members(method.result, method.noun)]
            if lines[-2:-1] == [""] and lines[-1].startswith("Member "):
                lines[-3:] = ["Answers " + lines[-1].removeprefix("Member ")]
        else:
            lines += ["", "Answers an empty object."]
        return lines + self.examples.lines(method) + [""]

    def notification(self, name, home, words, params):
        lines = [f"### {name} (notification)", "", sentence(words)]
        return lines + (["", f"With the members of {link(params)}."] if params.name else self.members(params, home)) + [""]

    def shape(self, shape, noun):
        lines = [f"### {shape.name}", ""]
        if shape.kind == "object":
            return lines + [sentence(shape.words), *self.members(shape, noun), ""]
        return lines + [full_type(shape) + ".", "", sentence(shape.words, shape.kind != "enum"), ""]

    def noun(self, noun):
        title, words = self.api.titles[noun]
        lines = [f"## {title}", "", words, ""]
        for method in self.api.of_noun(noun):
            lines += self.method(method)
        for name, home, told, params in self.api.notifications:
            if home == noun:
                lines += self.notification(name, home, told, params)
        for shape in self.api.shapes_of(noun):
            if is_told(shape) or shape.name in self.known:
                lines += self.shape(shape, noun)
        return lines

    def limits(self):
        lines = ["## Limits", "", self.api.titles["limits"][1]]
        for told, words in ((True, []), (False, ["", "These are not in server.info:"])):
            lines += [*words, "", table(["name", "limit", "of"], [
                [f"`{name}`", f"{plain(data['const'])} {data.get('x-unit', '')}".strip(), data["description"]]
                for name, data in self.api.limits if (name in self.api.told) == told])]
        return [*lines, ""]

    def errors(self):
        lines = ["## Errors", "", self.api.titles["errors"][1], "", table(["code", "kind", "when"], [
            [str(data["code"]), f"`{kind}`", data["description"]] for kind, data in self.api.errors.items()])]
        return [*lines, "", "`data` has:", *self.members(self.api.shape("ErrorData"), "errors")]


def text(api):
    reference = Reference(api)
    titles = ["Common parameters", *(api.titles[each][0] for each in (*NOUNS, "shared", "limits", "errors"))]
    always = either(kind for kind, data in api.errors.items() if data.get("x-always"))
    lines = [INTRO.format(always=always, protocol=PROTOCOL, readme=README),
             "Contents: " + ", ".join(f"[{each.lower()}](#{anchor(each, '-')})" for each in titles) + ".", ""]
    lines += ["## Common parameters", "", table(["parameter", "type", "meaning"], [reference.row(each, True) for each in reference.common]), ""]
    for noun in (*NOUNS, "shared"):
        lines += reference.noun(noun)
    lines += [*reference.limits(), *reference.errors()]
    return "\n".join(lines).rstrip() + "\n"
