"""Reads the schema files: follows references, merges what is shared, and returns methods, shapes, limits and errors.

A *node* is a schema with all its references followed. A node that stands for a named definition keeps its `name`.
"""
import json
import os
import re
from dataclasses import dataclass, field

FOLDER = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
NOUNS = ("server", "dataset", "family", "mean", "session", "share", "presence", "rake", "surface", "subscription", "slice", "lines", "bookmark", "annotation",
         "history", "time")
OTHERS = ("shared", "limits", "errors")

# Words beside a reference that say something of its use and leave the shape what it is.
OF_USE = {"description", "default", "x-cpp", "x-option", "x-only-for", "x-needed-for", "x-older", "x-unit", "x-kept", "x-plain",
          "x-nullable", "x-emptyIsMissing", "x-partial", "x-nonzero", "x-between", "x-differs"}
OF_SHAPE = {"type", "enum", "const", "minimum", "maximum", "exclusiveMinimum", "minLength", "maxLength", "pattern", "items", "minItems",
            "maxItems", "properties", "required", "additionalProperties", "unevaluatedProperties", "allOf", "anyOf", "prefixItems", "$ref",
            "x-limit", "x-shape", "x-cpp-type", "x-cpp-members", "x-order", "x-record", "x-ordered", "x-together", "x-needs",
            "x-exactly-one", "x-maxBytes"}
LAST = ("default", "gesture", "ifRev")  # what all edits have comes after what is their own
OF_METHOD = {"description", "x-role", "x-edits", "x-websocketOnly", "x-wholeServer", "x-shared", "x-copier", "x-errors", "params", "result", "x-example"}


class SchemaError(Exception):
    """What is wrong in a schema file, and where."""


@dataclass
class Node:
    """A schema without references. `fields`: of an object its members, in order."""

    data: dict
    name: str = ""
    fields: list = field(default_factory=list)
    items: "Node" = None
    parts: list = field(default_factory=list)  # of a list of which each entry is of a kind of its own
    choices: list = field(default_factory=list)
    values: "Node" = None  # of an object: what members that are not named must be

    def __getitem__(self, key):
        return self.data[key]

    def get(self, key, otherwise=None):
        return self.data.get(key, otherwise)

    def __contains__(self, key):
        return key in self.data

    @property
    def words(self):
        return self.data.get("description", "")

    @property
    def types(self):
        kinds = self.data.get("type", [])
        return [kinds] if isinstance(kinds, str) else list(kinds)

    @property
    def nullable(self):
        return "null" in self.types or bool(self.data.get("x-nullable"))

    @property
    def kind(self):
        """One word for what it is: point, points, texts, text, lines, flag, number, count, enum, const, token, tuple, object, list ..."""
        shape = self.data.get("x-shape")
        if shape == "text":
            return "json"
        if shape in ("point", "token", "lines"):
            return shape
        if "const" in self.data:
            return "const"
        if "enum" in self.data:
            return "enum"
        plain = [each for each in self.types if each != "null"]
        if plain == ["string"]:
            return "text"
        if plain in (["boolean"], ["number"]):
            return {"boolean": "flag", "number": "number"}[plain[0]]
        if plain == ["integer"]:
            return "count"
        if plain == ["array"] and self.parts:
            return "tuple"
        if plain == ["array"]:
            inner = self.items.kind
            return {"point": "points", "text": "texts"}.get(inner, "list")
        if plain == ["object"]:
            return "object"
        return "any"


@dataclass
class Field:
    """A member of an object."""

    name: str
    node: Node
    required: bool

    @property
    def optional(self):
        """It may be missing, and nothing stands for it then."""
        return not self.required and "default" not in self.node


@dataclass
class Method:
    name: str
    noun: str
    data: dict
    params: Node
    result: Node

    @property
    def words(self):
        return self.data["description"]

    @property
    def role(self):
        return self.data["x-role"]

    def flag(self, word):
        return bool(self.data.get(word))


@dataclass
class Api:
    """All there is."""

    files: dict
    titles: dict
    methods: list
    notifications: list
    shapes: dict  # name -> Node, of all $defs, in the order of the files
    home: dict  # name of a shape -> its file
    limits: list  # (name, data), those told by server.info first
    told: set
    errors: dict

    def of_noun(self, noun):
        return [each for each in self.methods if each.noun == noun]

    def shapes_of(self, noun):
        return [self.shapes[name] for name, home in self.home.items() if home == noun]

    def shape(self, name):
        return self.shapes[name]


class Loader:
    def __init__(self, folder=FOLDER):
        self.files = {}
        for name in (*OTHERS, *NOUNS):
            with open(os.path.join(folder, name + ".schema.json"), encoding="utf-8") as file:
                self.files[name] = json.load(file)
        limits = self.files["limits"]["$defs"]
        self.limits = {**limits["Limits"]["properties"], **limits["Bounds"]["properties"]}
        self.told = set(limits["Limits"]["properties"])

    def lookup(self, reference, noun):
        """(schema, noun of its file, name of the definition, or nothing)."""
        file, _, path = reference.partition("#")
        home = file.removesuffix(".schema.json") if file else noun
        at = self.files[home]
        words = [word for word in path.split("/") if word]
        for word in words:
            if word not in at:
                raise SchemaError(f"{noun}: {reference} leads nowhere")
            at = at[word]
        return at, home, words[1] if len(words) == 2 and words[0] == "$defs" else ""

    def resolve(self, schema, noun, name=""):
        unknown = set(schema) - OF_USE - OF_SHAPE
        if unknown:
            raise SchemaError(f"{noun}: {name or schema.get('description', schema)}: unknown words {sorted(unknown)}")
        data = {key: value for key, value in schema.items() if key not in ("$ref", "allOf", "x-limit")}
        base = Node({})
        if "$ref" in schema:
            target, home, named = self.lookup(schema["$ref"], noun)
            base = self.resolve(target, home, named)
            if set(schema) - {"$ref"} <= OF_USE:
                name = name or base.name
        merged = {**base.data, **data}
        for keyword, limit in schema.get("x-limit", {}).items():
            if limit not in self.limits:
                raise SchemaError(f"{noun}: there is no limit {limit}")
            merged[keyword] = self.limits[limit]["const"]
            merged.setdefault("x-named", {})
            merged["x-named"] = {**merged["x-named"], keyword: limit}
        node = Node(merged, name)
        node.items = self.resolve(schema["items"], noun) if "items" in schema else base.items
        node.parts = [self.resolve(each, noun) for each in schema.get("prefixItems", [])] or base.parts
        node.choices = [self.resolve(each, noun) for each in schema.get("anyOf", [])] or base.choices
        values = schema.get("additionalProperties")
        node.values = self.resolve(values, noun) if isinstance(values, dict) else base.values
        node.fields = self.fields_of(schema, noun, base)
        return node

    def fields_of(self, schema, noun, base):
        found = {each.name: each for each in base.fields}
        required = {each.name for each in base.fields if each.required} | set(schema.get("required", []))
        for part in schema.get("allOf", []):
            for each in self.resolve(part, noun).fields:
                found[each.name] = each
                if each.required:
                    required.add(each.name)
        for name, value in schema.get("properties", {}).items():
            found[name] = Field(name, self.resolve(value, noun), False)
        missing = required - set(found)
        if missing:
            raise SchemaError(f"{noun}: required, but not described: {sorted(missing)}")
        first = [name for name in (*schema.get("x-order", ["session"]), *base.data.get("x-order", [])) if name in found]
        last = [name for name in found if name in LAST and name not in first]
        middle = [name for name in found if name not in first and name not in last]
        return [Field(name, found[name].node, name in required) for name in (*dict.fromkeys(first), *middle, *last)]


def load(folder=FOLDER):
    """The whole description. Error: SchemaError."""
    loader = Loader(folder)
    shapes, home, methods, notifications = {}, {}, [], []
    for noun, file in loader.files.items():
        for name, schema in file.get("$defs", {}).items():
            if name in shapes:
                raise SchemaError(f"{noun}: {name} is described twice")
            if noun == "limits" and name == "Bounds":
                continue
            shapes[name] = loader.resolve(schema, noun, name) if noun != "limits" else limits_shape(loader)
            home[name] = noun
        for name, schema in file.get("x-methods", {}).items():
            if set(schema) - OF_METHOD - {"x-exactly-one"}:
                raise SchemaError(f"{name}: unknown words {sorted(set(schema) - OF_METHOD)}")
            methods.append(Method(name, noun, schema, loader.resolve(schema["params"], noun), loader.resolve(schema["result"], noun)))
        for name, schema in file.get("x-notifications", {}).items():
            notifications.append((name, noun, schema["description"], loader.resolve(schema["params"], noun)))
    check(methods, shapes)
    return Api(loader.files, {noun: (file["title"], file["description"]) for noun, file in loader.files.items()}, methods,
               notifications, shapes, home, list(loader.limits.items()), loader.told, loader.files["errors"]["x-errors"])


def limits_shape(loader):
    """The limits as server.info tells them: numbers, not what they happen to be here."""
    node = Node({"type": "object", "description": loader.files["limits"]["$defs"]["Limits"]["description"],
                 "additionalProperties": False}, "Limits")
    for name, data in loader.limits.items():
        if name in loader.told:
            words = {key: data[key] for key in ("description", "x-unit") if key in data}
            node.fields.append(Field(name, Node({"type": "integer", "minimum": 0, **words}), True))
    return node


def check(methods, shapes):
    """Every member of a shape, a result and a method's parameters has words."""
    for method in methods:
        for each in method.params.fields + method.result.fields:
            if not each.node.words:
                raise SchemaError(f"{method.name}: {each.name} has no description")
    for name, shape in shapes.items():
        for each in shape.fields:
            if not each.node.words:
                raise SchemaError(f"{name}: {each.name} has no description")


def snake(name):
    """maxQuads -> max_quads; $/cancelRequest -> cancel_request."""
    return re.sub(r"(?<=[a-z0-9])([A-Z])", lambda m: "_" + m.group(1).lower(), re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_")).lower()


def camel(name):
    """rake.set -> RakeSet; session.setRole -> SessionSetRole."""
    return "".join(word[:1].upper() + word[1:] for word in re.split(r"[^A-Za-z0-9]+", name) if word)


def either(words):
    """a, b or c."""
    words = list(words)
    return words[0] if len(words) == 1 else ", ".join(words[:-1]) + " or " + words[-1]


def pretty(value, width=110, indent=0):
    """JSON text with what fits into a line on one line."""
    flat = json.dumps(value, ensure_ascii=False)
    if len(flat) + indent <= width or not isinstance(value, (dict, list)) or not value:
        return flat
    pad = " " * (indent + 1)
    if isinstance(value, dict):
        inner = ",\n".join(pad + json.dumps(key) + ": " + pretty(each, width, indent + 1) for key, each in value.items())
        return "{\n" + inner + "}"
    return "[\n" + ",\n".join(pad + pretty(each, width, indent + 1) for each in value) + "]"
