"""TypeScript: types and checks of shapes, and what methods take and answer, a file a noun."""
import textwrap

from .schema import NOUNS, SchemaError, camel

MADE = "// Made by protocol/api/generate from {}: do not edit."


def quoted(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def word(value):
    return quoted(value) if isinstance(value, str) else str(value)


def lower(name):
    return name[0].lower() + name[1:]


def comment(words, indent):
    pad = " " * indent
    lines = textwrap.wrap(words, 116 - indent, break_long_words=False, break_on_hyphens=False)
    if len(lines) == 1:
        return [f"{pad}/** {lines[0]} */"]
    return [f"{pad}/**", *[f"{pad} * {line}" for line in lines], f"{pad} */"]


def nodes_of(node):
    """What a node is made of."""
    parts = [each.node for each in node.fields] + [node.items, node.values] + node.parts + node.choices
    return [each for each in parts if each is not None]


class TypeScript:
    """Writes the TypeScript of a description."""

    def __init__(self, api):
        self.api = api
        self.by_noun = False  # the file being written says `session.Snapshot`, for it needs something of every noun
        self.nouns = {*NOUNS, "shared"}
        self.used = {}  # what the file being written needs of others: module -> names
        self.partial = set()  # shapes of which only what has changed is told
        told = [method.result for method in api.methods] + [params for *_, params in api.notifications]
        self.checked = self.reached(told)  # shapes that come from the server
        self.named = self.checked | self.reached(each.node for method in api.methods for each in method.params.fields)

    def reached(self, nodes):
        """Names of the shapes that there are in nodes, however deep."""
        found = set()
        left = list(nodes)
        while left:
            node = left.pop()
            if node.get("x-partial"):
                self.partial.add(node.items.name)
            if self.is_named(node):
                if node.name in found:
                    continue
                found.add(node.name)
            left += nodes_of(node)
        return found

    def use(self, module, name):
        """Notes that the file being written needs a name of a module; returns the name."""
        self.used.setdefault(module, set()).add(name)
        noun = module.removeprefix("./").removesuffix(".ts")
        return f"{noun}.{name}" if self.by_noun and noun in self.nouns else name

    def use_shape(self, node, name):
        return self.use(f"./{self.api.home[node.name]}.ts", name)

    def primitive(self, name):
        return self.use("../checks.ts", name)

    def name(self, node):
        return node["x-cpp"] if node.get("x-record") else node.name

    def change_name(self, node):
        return self.name(node) + "Change"

    def is_named(self, node):
        return bool(node.name) and node.name in self.api.shapes and (
            node.kind in ("enum", "tuple") or (node.kind == "object" and bool(node.fields)))

    # Types.

    def type(self, node):
        plain = self.plain_type(node)
        return plain + " | null" if node.nullable else plain

    def plain_type(self, node):
        kind = node.kind
        simple = {"text": "string", "lines": "string", "number": "number", "count": "number", "flag": "boolean",
                  "token": "string | number", "json": "Record<string, unknown>"}
        if node.get("x-partial"):
            return self.use_shape(node.items, self.change_name(node.items)) + "[]"
        if self.is_named(node):
            return self.use_shape(node, self.name(node))
        if kind in simple:
            return simple[kind]
        if kind == "point":
            return self.use("../vec3.ts", "Vec3")
        if kind == "enum":
            return " | ".join(word(each) for each in node["enum"])
        if kind == "tuple":
            return "[" + ", ".join(self.type(each) for each in node.parts) + "]"
        if node.items is not None:
            return self.list_type(node)
        if node.choices:
            return " | ".join(self.type(each) for each in node.choices)
        if kind == "object":
            return self.object_type(node)
        raise SchemaError(f"{node.name or node.words}: no type of TypeScript is like it")

    def list_type(self, node):
        inner = self.type(node.items)
        if node.get("minItems") == node.get("maxItems") and "minItems" in node:
            return "[" + ", ".join([inner] * node["minItems"]) + "]"
        return f"({inner})[]" if " " in inner else inner + "[]"

    def object_type(self, node):
        if node.fields:
            return "{ " + " ".join(f"{each.name}{'' if each.required else '?'}: {self.type(each.node)};" for each in node.fields) + " }"
        if node.get("additionalProperties"):
            return f"Record<string, {self.type(node.values) if node.values else 'unknown'}>"
        return "Record<string, never>"

    def interface(self, name, words, fields, base=""):
        lines = [*comment(words, 0), f"export interface {name}{base} {{"]
        for each in fields:
            unit = each.node.get("x-unit")
            lines += comment(each.node.words + (f" ({unit})" if unit else ""), 4)
            lines.append(f"    {each.name}{'' if each.required else '?'}: {self.type(each.node)};")
        return lines + ["}", ""]

    # Checks.

    def check(self, node):
        plain = self.plain_check(node)
        return f"{self.primitive('orNull')}({plain})" if node.nullable else plain

    def plain_check(self, node):
        kind = node.kind
        simple = {"number": "number", "flag": "flag", "point": "point", "count": "whole", "token": "token", "json": "anyObject"}
        if node.get("x-partial"):
            inner = self.use_shape(node.items, lower(self.change_name(node.items)) + "Check")
            return f"{self.primitive('list')}({inner})"
        if self.is_named(node):
            return self.use_shape(node, lower(self.name(node)) + "Check")
        if kind in simple:
            return self.primitive(simple[kind])
        if kind in ("text", "lines"):
            return f"{self.primitive('matching')}(/{node['pattern']}/)" if "pattern" in node else self.primitive("text")
        if kind == "enum":
            return self.primitive("oneOf") + "([" + ", ".join(word(each) for each in node["enum"]) + "])"
        if kind == "tuple":
            return self.primitive("tuple") + "([" + ", ".join(self.check(each) for each in node.parts) + "])"
        if node.items is not None:
            size = f", {node['minItems']}" if node.get("minItems") == node.get("maxItems") and "minItems" in node else ""
            return f"{self.primitive('list')}({self.check(node.items)}{size})"
        if node.choices:
            return self.primitive("either") + "([" + ", ".join(self.check(each) for each in node.choices) + "])"
        if kind == "object" and node.fields:
            return self.members("", node.fields)
        if kind == "object":
            return f"{self.primitive('mapOf')}({self.check(node.values)})" if node.values else self.primitive("anyObject")
        raise SchemaError(f"{node.name or node.words}: no check is like it")

    def members(self, type_name, fields, needed=None):
        """@param needed  the members that there must be; left out: those that are required"""
        checks = []
        for each in fields:
            there = each.required if needed is None else each.name in needed
            inner = self.check(each.node)
            checks.append((each.name, inner if there else f"{self.primitive('optional')}({inner})"))
        about = " ".join(f"{name}," if name == check else f"{name}: {check}," for name, check in checks)
        return self.primitive("members") + (f"<{type_name}>" if type_name else "") + "({ " + about + " })"

    # Files.

    def shape(self, node):
        """A type, and its check where the server sends it."""
        name = self.name(node)
        if node.kind == "enum":
            many = lower(name[:-1] + "ies" if name.endswith("y") else name + "s")
            lines = [*comment(node.words, 0), f"export const {many} = [{', '.join(word(each) for each in node['enum'])}] as const;",
                     f"export type {name} = (typeof {many})[number];"]
            check = f"{self.primitive('oneOf')}({many})" if node.name in self.checked else ""
        elif node.kind == "tuple":
            parts = [[fun(each) for each in node.parts] for fun in (self.type, self.check)]
            lines = [*comment(node.words, 0), f"export type {name} = [{', '.join(parts[0])}];"]
            check = f"{self.primitive('tuple')}<{name}>([{', '.join(parts[1])}])"
        else:
            lines = self.interface(name, node.words, node.fields)
            check = self.members(name, node.fields) if node.name in self.checked else ""
        lines += [f"export const {lower(name)}Check = {check};", ""] if check else [""]
        return lines + (self.change(node) if node.name in self.partial else [])

    def change(self, node):
        """Of a shape of which only what has changed is told: the first member says which one it is."""
        name, change, identity = self.name(node), self.change_name(node), node.fields[0]
        return [f"/** What has changed of a {name}; null: it has been taken away. */",
                f"export type {change} = Partial<{name}> & {{ {identity.name}: {self.type(identity.node)} }};",
                f"export const {lower(change)}Check = {self.members(change, node.fields, {identity.name})};", ""]

    def noun(self, noun):
        """Shapes of a file, and what its methods take and answer."""
        body, self.used = [], {}
        if noun == "shared":
            shape = self.api.shape("InSession")
            body += self.interface(shape.name, shape.words, shape.fields)
        for node in self.api.shapes_of(noun):
            if node.name in self.named:
                body += self.shape(node)
        for method in self.api.of_noun(noun):
            body += self.parameters(method)
            if not self.is_named(method.result) and method.result.fields:
                body += self.interface(camel(method.name) + "Result", f"What {method.name} answers.", method.result.fields)
            body += self.kinds_of(method)
        return self.with_imports(noun, f"{noun}.schema.json", body)

    def parameters(self, method):
        """An interface, which shares what all methods on a session take."""
        name, words, fields = camel(method.name) + "Params", f"Parameters of {method.name}.", method.params.fields
        own = [each for each in fields if each.name != "session" or each.node.words != self.session_field().node.words]
        if len(own) == len(fields):
            return self.interface(name, words, fields) if fields else []
        base = self.use("./shared.ts", "InSession")
        if not own:
            return [*comment(words, 0), f"export type {name} = {base};", ""]
        return self.interface(name, words, own, f" extends {base}")

    def session_field(self):
        return self.api.shape("InSession").fields[0]

    def kinds_of(self, method):
        """Of a setter that does not take the same of all kinds of a record: from what one makes a setting of a record."""
        limited = {each.name: each.node["x-only-for"] for each in method.params.fields if "x-only-for" in each.node}
        if not limited:
            return []
        noun, setter = method.noun, lower(camel(method.name))
        kept = {each.name for shape in self.api.shapes_of(noun) if shape.get("x-record") for each in shape.fields} - {noun}
        asked = [each for each in method.params.fields if each.name in kept]
        return [f"/** What of a record {method.name} asks for, beside its id. */",
                f"export const {noun}AskedNames = [{', '.join(quoted(each.name) for each in asked)}] as const;", "",
                f"/** What holds of a {noun} where {method.name} is not told. */", f"export const {noun}Defaults = {{",
                *[f"    {each.name}: {self.value(each.node)}," for each in asked if "default" in each.node], "};", "",
                f"/** Least and most of what is a number in {method.name}; the least itself may be left out of the range. */",
                f"export const {setter}Ranges = {{",
                *[f"    {each.name}: [{least:g}, {each.node['maximum']:g}]," for each in asked if "maximum" in each.node
                  for least in [each.node.get("minimum", each.node.get("exclusiveMinimum"))] if least is not None], "} as const;", "",
                f"/** Which kinds take a parameter of {method.name} that not all take. */", f"export const {setter}OnlyFor = {{",
                *[f"    {name}: [{', '.join(quoted(kind) for kind in kinds)}]," for name, kinds in limited.items()], "} as const;", ""]

    def value(self, node):
        value = node["default"]
        if isinstance(value, str):
            return f"{quoted(value)} as {self.type(node)}" if node.kind == "enum" else quoted(value)
        return f"[] as {self.type(node)}" if value == [] else str(value).lower()

    def with_imports(self, name, source, body):
        """A whole file: what it is made from, what it needs of others, and its body."""
        lines = [MADE.format(source)]
        for module in sorted(set(self.used) - {f"./{name}.ts"}):
            names, types = sorted(self.used[module]), [each[0].isupper() for each in sorted(self.used[module])]
            if self.by_noun and module[2:-3] in self.nouns:
                lines.append(f"import {'type ' if all(types) else ''}* as {module[2:-3]} from '{module}';")
                continue
            if not all(types):
                names = [f"type {name}" if is_type else name for name, is_type in zip(names, types)]
            lines.append(f"import {'type ' if all(types) else ''}{{ {', '.join(names)} }} from '{module}';")
        return "\n".join([*lines, "", *body])
