"""TypeScript: types and checks of every shape, parameters and result of every method, limits."""
import textwrap

from .schema import NOUNS, camel

MADE = "// Made by protocol/api/generate from {}: do not edit."


def quoted(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def lower(name):
    return name[0].lower() + name[1:]


def comment(words, indent):
    pad = " " * indent
    lines = textwrap.wrap(words, 116 - indent, break_long_words=False, break_on_hyphens=False)
    if len(lines) == 1:
        return [f"{pad}/** {lines[0]} */"]
    return [f"{pad}/**", *[f"{pad} * {line}" for line in lines], f"{pad} */"]


class TypeScript:
    """Writes the TypeScript of a description."""

    def __init__(self, api):
        self.api = api
        self.used = {}  # what the file being written needs of others: module -> names

    def use(self, module, name):
        """Notes that the file being written needs a name of a module; returns the name."""
        self.used.setdefault(module, set()).add(name)
        return name

    def use_shape(self, node, name):
        return self.use(f"./{self.api.home[node.name]}.ts", name)

    def primitive(self, name):
        return self.use("../checks.ts", name)

    def vec3(self):
        return self.use("../vec3.ts", "Vec3")

    def name(self, node):
        return node["x-cpp"] if node.get("x-record") else node.name

    def is_named(self, node):
        return bool(node.name) and node.name in self.api.shapes and node.kind in ("object", "enum") and bool(node.fields or "enum" in node)

    # Types.

    def type(self, node):
        plain = self.plain_type(node)
        return plain + " | null" if node.nullable else plain

    def plain_type(self, node):
        kind = node.kind
        if node.get("x-partial"):
            inner = self.use_shape(node.items, self.name(node.items))
            return f"(Partial<{inner}> & {{ {node.items.fields[0].name}: string }})[]"
        if self.is_named(node):
            return self.use_shape(node, self.name(node))
        if kind == "enum":
            return " | ".join(quoted(each) if isinstance(each, str) else str(each) for each in node["enum"])
        if kind in ("text", "lines"):
            return "string"
        if kind in ("number", "count"):
            return "number"
        if kind == "flag":
            return "boolean"
        if kind == "point":
            return self.vec3()
        if kind == "token":
            return "string | number"
        if kind == "json":
            return "Record<string, unknown>"
        if node.items is not None:
            inner = self.type(node.items)
            if node.get("minItems") == node.get("maxItems") and "minItems" in node:
                return "[" + ", ".join([inner] * node["minItems"]) + "]"
            return f"({inner})[]" if " " in inner else inner + "[]"
        if node.choices:
            return " | ".join(self.type(each) for each in node.choices)
        if kind == "object" and node.fields:
            return "{ " + " ".join(f"{each.name}{'' if each.required else '?'}: {self.type(each.node)};" for each in node.fields) + " }"
        if kind == "object":
            return f"Record<string, {self.type(node.values) if node.values else 'unknown'}>" if node.get(
                "additionalProperties") else "Record<string, never>"
        return "unknown"

    def interface(self, name, words, fields):
        lines = [*comment(words, 0), f"export interface {name} {{"]
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
        if self.is_named(node):
            return self.use_shape(node, lower(self.name(node)) + "Check")
        if kind == "enum":
            return self.primitive("oneOf") + "([" + ", ".join(quoted(each) if isinstance(each, str) else str(each) for each in node["enum"]) + "])"
        if kind in ("text", "lines"):
            return f"{self.primitive('matching')}(/{node['pattern']}/)" if "pattern" in node else self.primitive("text")
        if kind in ("number", "flag", "point"):
            return self.primitive(kind)
        if kind == "count":
            return self.primitive("whole")
        if kind == "json":
            return self.primitive("anyObject")
        if node.items is not None:
            size = f", {node['minItems']}" if node.get("minItems") == node.get("maxItems") and "minItems" in node else ""
            return f"{self.primitive('list')}({self.check(node.items)}{size})"
        if node.choices:
            return self.primitive("either") + "([" + ", ".join(self.check(each) for each in node.choices) + "])"
        if kind == "object" and node.fields:
            return self.primitive("members") + "({ " + self.member_checks(node.fields) + " })"
        if kind == "object" and node.values:
            return f"{self.primitive('mapOf')}({self.check(node.values)})"
        return self.primitive("anyObject" if kind == "object" else "anything")

    def member_checks(self, fields):
        checks = [(each.name, self.member_check(each)) for each in fields]
        return " ".join(f"{name}," if name == check else f"{name}: {check}," for name, check in checks)

    def member_check(self, each):
        check = self.check(each.node)
        return check if each.required else f"{self.primitive('optional')}({check})"

    # Files.

    def shape(self, node):
        name = self.name(node)
        if node.kind == "enum":
            words = ", ".join(quoted(each) for each in node["enum"])
            many = lower(name[:-1] + "ies" if name.endswith("y") else name + "s")
            return [*comment(node.words, 0), f"export const {many} = [{words}] as const;",
                    f"export type {name} = (typeof {many})[number];",
                    f"export const {lower(name)}Check = {self.primitive('oneOf')}({many});", ""]
        return [*self.interface(name, node.words, node.fields),
                f"export const {lower(name)}Check = {self.primitive('members')}<{name}>({{ {self.member_checks(node.fields)} }});", ""]

    def noun(self, noun):
        """Shapes of a file, and what its methods take and answer."""
        body, self.used = [], {}
        for node in self.api.shapes_of(noun):
            if self.is_named(node):
                body += self.shape(node)
        for method in self.api.of_noun(noun):
            if method.params.fields:
                body += self.interface(camel(method.name) + "Params", f"Parameters of {method.name}.", method.params.fields)
            if not self.is_named(method.result) and method.result.fields:
                body += self.interface(camel(method.name) + "Result", f"What {method.name} answers.", method.result.fields)
        rules = self.only_for(noun)
        return self.with_imports(noun, body + rules)

    def only_for(self, noun):
        lines = []
        for method in self.api.of_noun(noun):
            kept = [each.name for shape in self.api.shapes_of(noun) if shape.get("x-record") for each in shape.fields]
            if method.name == noun + ".set" and kept:
                names = ", ".join(quoted(each.name) for each in method.params.fields if each.name in kept and each.name != noun)
                lines += [f"/** What of a record {method.name} asks for, beside its id. */",
                          f"export const {noun}AskedNames = [{names}] as const;", ""]
            usual = [each for each in method.params.fields if method.name == noun + ".set" and each.name in kept and "default" in each.node]
            if usual:
                lines += [f"/** What holds of a {noun} where {method.name} is not told. */", f"export const {noun}Defaults = {{"]
                lines += [f"    {each.name}: {self.value(each.node)}," for each in usual] + ["};", ""]
            limited = {each.name: each.node["x-only-for"] for each in method.params.fields if "x-only-for" in each.node}
            if limited:
                lines += [f"/** Which kinds take a parameter of {method.name} that not all take. */",
                          f"export const {lower(camel(method.name))}OnlyFor = {{"]
                lines += [f"    {name}: [{', '.join(quoted(kind) for kind in kinds)}]," for name, kinds in limited.items()]
                lines += ["} as const;", ""]
            ranged = [each for each in method.params.fields if each.node.kind in ("number", "count") and (
                "default" in each.node or ("minimum" in each.node and "maximum" in each.node and each.node["maximum"] < 2**40))]
            if limited and ranged:
                lines += [f"/** Numbers that {method.name} takes: what holds where one is left out, and the range. */",
                          f"export const {lower(camel(method.name))}Numbers = {{"]
                for each in ranged:
                    words = [f"{key}: {each.node[word]}" for key, word in (("usual", "default"), ("least", "minimum"), ("most", "maximum"))
                             if word in each.node]
                    lines.append(f"    {each.name}: {{ {', '.join(words)} }},")
                lines += ["} as const;", ""]
        return lines

    def value(self, node):
        value = node["default"]
        if isinstance(value, str):
            return f"{quoted(value)} as {self.type(node)}" if node.kind == "enum" else quoted(value)
        return f"[] as {self.type(node)}" if value == [] else str(value).lower()

    def with_imports(self, noun, body):
        own = f"./{noun}.ts"
        lines = [MADE.format(f"{noun}.schema.json")]
        for module in sorted(self.used):
            if module != own:
                names = sorted(name if name[0].islower() else "type " + name for name in self.used[module])
                lines.append(f"import {{ {', '.join(names)} }} from '{module}';")
        return "\n".join([*lines, "", *body])

    def methods(self):
        imports, entries = {}, []
        for method in self.api.methods:
            params = camel(method.name) + "Params" if method.params.fields else "Record<string, never>"
            if method.params.fields:
                imports.setdefault(method.noun, set()).add(params)
            if self.is_named(method.result):
                result = self.name(method.result)
                imports.setdefault(self.api.home[method.result.name], set()).add(result)
            elif method.result.fields:
                result = camel(method.name) + "Result"
                imports.setdefault(method.noun, set()).add(result)
            else:
                result = "object"
            entries += [*comment(method.words, 4), f"    {quoted(method.name)}: {{ params: {params}; result: {result} }};"]
        lines = [MADE.format("*.schema.json")]
        lines += [f"import type {{ {', '.join(sorted(names))} }} from './{noun}.ts';" for noun, names in imports.items()]
        return "\n".join([*lines, "", "/** Every method of the server. */", "export interface Methods {", *entries, "}", ""])

    def limits(self):
        lines = [MADE.format("limits.schema.json"), "", "/** What one server of this version grants. */", "export const limits = {"]
        for name, data in self.api.limits:
            unit = f" ({data['x-unit']})" if "x-unit" in data else ""
            lines += comment(data["description"] + unit, 4) + [f"    {name}: {data['const']:_},"]
        lines += ["} as const;", ""]
        self.used = {}
        lines += self.shape(self.api.shape("Limits"))
        return self.with_imports("limits", lines[2:])

    def error_kinds(self):
        words = ", ".join(f"{kind}: {data['code']}" for kind, data in self.api.errors.items())
        return "\n".join([MADE.format("errors.schema.json"), "", "/** Codes of errors, by kind. */", f"export const errorCodes = {{ {words} }} as const;",
                          ""])

    def files(self):
        out = {f"{noun}.ts": self.noun(noun) for noun in (*NOUNS, "shared")}
        out["methods.ts"] = self.methods()
        out["limits.ts"] = self.limits()
        out["errors.ts"] = self.error_kinds()
        return out
