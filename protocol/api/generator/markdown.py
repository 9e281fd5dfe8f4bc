"""docs/api.md: the reference, by noun and method."""
import json

from .openrpc import errors_of
from .schema import NOUNS, either

README = "protocol/api/README.md"
PROTOCOL = "protocol/README.md"
LEFT_OUT = "; it may be left out on a WebSocket that has joined a session, and with a share link"  # the introduction says it once
FLOAT = 3.4028234663852886e38
INTRO = """<!-- Made by protocol/api/generate from protocol/api/*.schema.json: do not edit. -->
# The API

Every method, notification, record, limit and error. [{protocol}](../{protocol}) says how messages are exchanged, [{readme}](../{readme})
how sessions and edits work. A server answers the same as an [OpenRPC](https://open-rpc.org) document: `rpc.discover`, or `GET /openrpc.json`.

- Parameters have names. An unknown one is refused; null counts as left out unless stated otherwise.
- `session` may be left out on a WebSocket that has joined a session, and with a share link.
- Numbers are finite. A whole number may be written `32` or `32.0`.
- Lengths of texts are bytes in UTF-8. Texts have no control characters unless they have several lines.
- Every method may answer the errors {always}; the entry of a method names the others.
- If the server keeps sessions, the answer to an *edit* also has `durable` and, if that is false, `hint`.
"""


def cell(text):
    return text.replace("|", "\\|").replace("\n", " ")


def plain(value):
    return f"{value:,}" if isinstance(value, int) and abs(value) >= 10000 else f"{value:g}" if isinstance(value, float) else str(value)


def type_of(node):
    if node.kind == "enum":
        words = " | ".join(json.dumps(each) for each in node["enum"])
    elif node.kind == "const":
        words = json.dumps(node["const"])
    elif node.kind == "point":
        words = "[x, y, z]"
    elif node.kind == "object":
        words = link(node) if node.name else "object"
    elif node.kind == "tuple":
        words = "[" + ", ".join(type_of(each) for each in node.parts) + "]"
    elif node.items is not None:
        words = f"list of {type_of(node.items)}"
    elif node.choices:
        words = " or ".join(type_of(each) for each in node.choices)
    else:
        words = {"text": "text", "lines": "text", "json": "object", "flag": "true or false", "number": "number", "count": "whole number",
                 "token": "text or number", "any": " or ".join(each for each in node.types if each != "null") or "anything"}.get(node.kind,
                                                                                                                        node.kind)
    return words + (" or null" if node.nullable else "")


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
    if node.kind != "point":
        if "maxItems" in node and node.get("minItems") == node["maxItems"]:
            words.append(f"{node['maxItems']} of them")
        elif "maxItems" in node:
            words.append(f"at most {plain(node['maxItems'])}")
    return ", ".join(words)


def words_of(each, parameters):
    words = each.node.words.removesuffix(LEFT_OUT)
    if "x-only-for" in each.node:
        words += f"; only for {either(each.node['x-only-for'])} surfaces"
    if "x-needed-for" in each.node:
        words += ", which need it"
    if parameters and each.required:
        words += "; **required**"
    if not parameters and not each.required:
        words += "; may be missing"
    return words


def table(fields, parameters):
    rows = []
    for each in fields:
        node = each.node
        default = f"`{json.dumps(node['default'])}`" if parameters and "default" in node else ""
        rows.append([f"`{each.name}`", type_of(node), node.get("x-unit", ""), default, range_of(node), words_of(each, parameters)])
    titles = ["", "type", "unit", "default", "range", "what it is"]
    keep = [i for i, title in enumerate(titles) if i in (0, 1, 5) or any(row[i] for row in rows)]
    lines = ["| " + " | ".join(titles[i] or "name" for i in keep) + " |", "|" + "---|" * len(keep)]
    return lines + ["| " + " | ".join(cell(row[i]) for i in keep) + " |" for row in rows]


def sentence(words):
    return words if words.endswith((".", ":")) else words + "."


def members(node, parameters=False):
    return table(node.fields, parameters) if node.fields else []


def method_text(api, method):
    role = {"viewer": "any role", "editor": "editors", "host": "hosts"}[method.role]
    who = [f"For {role}"]
    if method.flag("x-wholeServer"):
        who.append("with the server's own token")
    if method.flag("x-shared") and not method.flag("x-wholeServer"):  # which no link allows
        who.append("in a copy by the role of the link that its maker came by")
    if method.flag("x-copier"):
        who.append("or who made the session, a copy, by a share link")
    if method.flag("x-websocketOnly"):
        who.append("on a WebSocket only")
    if method.flag("x-edits"):
        who.append("an edit")
    always = {kind for kind, data in api.errors.items() if data.get("x-always")}
    own = [kind for kind in errors_of(api, method) if kind not in always]
    lines = [f"### {method.name}", "", sentence(method.words), "",
             ", ".join(who) + "." + (f" Errors: {', '.join(own)}." if own else "")]
    if method.params.fields:
        lines += ["", *members(method.params, True)]
    exactly = method.data.get("x-exactly-one", {})
    for kind, rule in exactly.items():
        names = " and ".join(f"`{name}`" for name in rule["of"])
        lines += ["", f"A {kind} surface takes exactly one of {names}: {rule['hint']}."]
    if method.result.name and method.result.kind == "object" and method.result.fields:
        lines += ["", f"Answers {link(method.result)}."]
    elif method.result.fields:
        lines += ["", "Answers:", "", *members(method.result)]
    else:
        lines += ["", "Answers an empty object."]
    if "x-example" in method.data:
        example = method.data["x-example"]
        lines += ["", "```json", f"{json.dumps({'method': method.name, 'params': example['params']})}",
                  f"{json.dumps({'result': example['result']})}", "```"]
    return lines + [""]


def shape_text(shape):
    return [f"### {shape.name}", "", sentence(shape.words), "", *members(shape), ""]


def is_told(shape):
    return shape.kind == "object" and shape.fields and shape.name not in (
        "InSession", "Edit", "FirstRecord", "RakeShape", "SurfaceFields", "BookmarkFields", "AnnotationFields", "Limits", "ErrorData")


def text(api):
    always = either(kind for kind, data in api.errors.items() if data.get("x-always"))
    lines = [INTRO.replace("{always}", always).replace("{readme}", README).replace("{protocol}", PROTOCOL), "Contents: " + ", ".join(
        f"[{api.titles[noun][0].lower()}](#{api.titles[noun][0].lower().replace(' ', '-')})" for noun in (*NOUNS, "shared", "limits", "errors"))
        + ".", ""]
    for noun in NOUNS:
        title, words = api.titles[noun]
        lines += [f"## {title}", "", words, ""]
        for method in api.of_noun(noun):
            lines += method_text(api, method)
        for name, home, told, params in api.notifications:
            if home == noun:
                lines += [f"### {name} (notification)", "", sentence(told), ""]
                lines += [f"With the members of {link(params)}."] if params.name else members(params)
                lines += [""]
        for shape in api.shapes_of(noun):
            if is_told(shape):
                lines += shape_text(shape)
    title, words = api.titles["shared"]
    lines += [f"## {title}", "", words, ""]
    for shape in api.shapes_of("shared"):
        if is_told(shape):
            lines += shape_text(shape)
    lines += ["## Limits", "", api.titles["limits"][1], "", "| name | limit | what it is of |", "|---|---|---|"]
    for name, data in api.limits:
        told = "" if name in api.told else " (not in server.info)"
        lines.append(f"| `{name}` | {plain(data['const'])} {data.get('x-unit', '')} | {data['description']}{told} |")
    lines += ["", "## Errors", "", api.titles["errors"][1], "", "| code | kind | when |", "|---|---|---|"]
    for kind, data in api.errors.items():
        lines.append(f"| {data['code']} | `{kind}` | {cell(data['description'])} |")
    lines += ["", "`data` has:", "", *members(api.shape("ErrorData")), ""]
    return "\n".join(lines).rstrip() + "\n"
