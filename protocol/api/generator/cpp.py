"""C++ of one noun: structs of records, of parameters and of what is told, and lists of their members."""
import re
import textwrap

from .schema import camel, either, snake

MADE = "// Made by protocol/api/generate from {}: do not edit."
KEYWORDS = {"default", "delete", "new", "class", "struct"}
LONGEST_TEXT = 256


def quoted(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def names_in(nodes):
    """Names of all shapes that these lead to."""
    found = set()
    for node in nodes:
        inner = [each.node for each in node.fields] + node.parts + node.choices + [each for each in (node.items, node.values) if each]
        found |= {node.name} | names_in(inner)
    return found


def number(value):
    """A double's literal."""
    text = repr(float(value))
    return text if any(letter in text for letter in ".en") else text + ".0"


def comment(words, indent=0):
    pad = " " * indent + "/// "
    return [pad + line for line in textwrap.wrap(words, 100 - len(pad), break_long_words=False, break_on_hyphens=False)]


def limit_name(api, name):
    return dict(api.limits)[name].get("x-cpp", snake(name))


# What a header includes where it uses what matches.
NEEDS = {"family_record": r"core::Family", "rake.hpp": r"core::Rake", "surface_parameters": r"core::(SurfaceParameters|SurfaceKind|Direction|"
         "Accuracy|Interpolation|Refine)", "surface_statistics": r"core::(SurfaceStatistics|Emptiness)", "value_range": r"core::ValueRange"}


def needed(line, used):
    """Whether a header that uses this keeps the line of its head."""
    return all(re.search(pattern, used) for word, pattern in NEEDS.items() if line.startswith("#include") and word in line)


class Cpp:
    """Writes the C++ of a description."""

    def __init__(self, api):
        self.api = api
        self.told = names_in([each.result for each in api.methods] + [params for *_, params in api.notifications])

    # Types and names.

    def struct_name(self, shape):
        return shape.get("x-cpp") or shape.name

    def is_struct(self, shape):
        return "x-cpp" in shape and shape.kind == "object"

    def member(self, each):
        name = each.node.get("x-cpp") if each.node.kind != "object" else None
        name = name or snake(each.name)
        return name + "_" if name in KEYWORDS else name

    def plain_type(self, node):
        if "x-cpp-type" in node:
            return node["x-cpp-type"]
        return {"text": "std::string", "lines": "std::string", "json": "std::string", "enum": "std::string", "token": "std::string",
                "flag": "bool", "number": "double", "count": "std::uint64_t", "point": "core::Vec3",
                "points": "std::vector<core::Vec3>", "texts": "std::vector<std::string>",
                "object": self.struct_name(node)}[node.kind]

    def is_optional(self, each, record):
        node = each.node
        if node.get("x-plain") or (record and (node.get("x-kept") is False or node.get("x-emptyIsMissing"))):
            return False
        if record and "x-older" in node:
            return node["x-older"] is None
        return each.optional

    def is_nullable(self, each, record):
        return not record and each.node.nullable and each.node.kind != "token"

    def full_type(self, each, record):
        plain = self.plain_type(each.node)
        if self.is_nullable(each, record):
            return f"Nullable<{plain}>"
        return f"std::optional<{plain}>" if self.is_optional(each, record) else plain

    def initial(self, each, record):
        kind = self.full_type(each, record)
        node = each.node
        start = node.get("default", node.get("x-older") if record else None)
        if kind == "bool":
            return " = true" if start else " = false"
        if kind == "double":
            return " = " + number(start or 0)
        if kind == "core::Vec3":
            return "{0.0}"
        if kind.startswith("std::uint"):
            return f" = {start or 0}"
        if kind == "std::string" and start:
            return f" = {quoted(start)}"
        if node.kind == "enum" and start:
            return f" = {kind}::{camel(start)}"
        return ""

    # Structs.

    def struct(self, shape, name, words, method=""):
        record = bool(shape.get("x-record")) or not method
        in_session = bool(method) and self.in_session(shape)
        base = " : InSession" if in_session else ""
        lines = [*comment(words), f"struct {name}{base} {{"]
        if method:
            lines += [f"    static constexpr std::string_view method = {quoted(method)};"] + [""] * self.has_own(shape)
        seen = set()
        for each in shape.fields[1 if in_session else 0:]:
            member = self.member(each)
            if "." in member:
                outer = member.split(".")[0]
                if outer not in seen:
                    seen.add(outer)
                    inner = [other.name for other in shape.fields if self.member(other).startswith(outer + ".")]
                    lines += comment(", ".join(inner), 4)
                    lines.append(f"    {shape['x-cpp-members'][outer]} {outer};")
                continue
            lines += comment(self.words(each), 4)
            lines.append(f"    {self.full_type(each, record)} {member}{self.initial(each, record)};")
        if not method:
            lines += ["", f"    bool operator==(const {name}&) const = default;"]
        return lines + ["};"]

    def has_own(self, shape):
        """There are parameters beside those that its base has."""
        return len(shape.fields) > self.in_session(shape)

    def in_session(self, shape):
        """The parameters begin with that of every method on a session."""
        return bool(shape.fields) and shape.fields[0].node.words == self.api.shape("InSession").fields[0].node.words

    def words(self, each):
        unit = each.node.get("x-unit")
        return each.node.words + (f" ({unit})" if unit else "")

    # Members.

    def bound(self, node, word):
        """The code of a limit, or nothing."""
        if word in node.get("x-named", {}):
            return "limits::" + limit_name(self.api, node["x-named"][word])
        if word in node:
            return number(node[word]) if node.kind == "number" else str(node[word])
        return None

    def rule(self, each, record):
        """What a value must be beyond its type, as the code of a Rule; empty: nothing."""
        node, kind = each.node, each.node.kind
        least = most = text = None
        if kind in ("number", "count"):
            # One that is excluded is compared by itself, in words of its own.
            least = self.bound(node, "minimum") or ("maximum" in node and self.bound(node, "exclusiveMinimum"))
            most = self.bound(node, "maximum") or ("most_whole" if kind == "count" else None)
        elif kind == "point":
            most = "largest_float"
        elif kind in ("points", "texts"):
            most = self.bound(node, "maxItems")
        elif kind == "json":
            text, most = "Object", self.bound(node, "x-maxBytes")
        elif kind == "token":
            text = "WholeToken" if "integer" in node.types else "Token"
        elif kind in ("text", "lines") or (kind == "enum" and "x-cpp-type" not in node):
            text = "Lines" if kind == "lines" else "Colour" if "pattern" in node else "Line"
            most = self.bound(node, "maxLength") or str(LONGEST_TEXT)
            may_be_empty = self.has_default(each, record) or node.get("x-emptyIsMissing")
            least = "1" if node.get("minLength") or ("pattern" in node and not may_be_empty) else None
        choices = ", ".join(map(quoted, node["enum"])) if text and kind == "enum" else None
        null = f"; null {node['x-nullable']}" if each.required and isinstance(node.get("x-nullable"), str) else None
        parts = (("lo", least), ("hi", most), ("above_zero", "exclusiveMinimum" in node and "true"), ("text", text and "Text::" + text),
                 ("choices", choices and "{" + choices + "}"), ("if_missing", null and quoted(null)))
        return ", ".join(f".{name} = {code}" for name, code in parts if code)

    def has_default(self, each, record):
        return "default" in each.node or (record and "x-older" in each.node)

    def use(self, each, record, told):
        """How a member is read and written."""
        node = each.node
        always = node.nullable or (not self.is_optional(each, record) and (each.required or node.get("x-plain")))
        if told or (record and node.get("x-kept") is False):
            return "told" if always else "some_told"
        if each.required and not self.has_default(each, record):
            return "needed"
        return "newer" if record and always else "some"

    def place(self, each):
        """What leads to a member of `of`."""
        outer, arrow, inner = self.member(each).partition("->")
        return f"of.{outer} ? std::optional(of.{outer}->{inner}) : std::nullopt" if arrow else "of." + outer

    def members(self, shape, name, method="", told=False):
        """The list of a struct's members: for calls, for what answers tell, or for both."""
        record = not method
        lines = []
        for each in shape.fields:
            if each.node.get("x-cpp", "") is not None:
                use = self.use(each, record, told)
                rule = "" if use.endswith("told") else self.rule(each, record)
                lines.append(f"    io.{use}({quoted(each.name)}, {self.place(each)}{', {' + rule + '}' if rule else ''});")
        lines += [f"    io.check({quoted(of)}, {wrong} ? {quoted(words)} : \"\");" for of, wrong, words in self.together(shape)]
        both = [] if method or told else [f"template void members(JsonReader&, {name}&);", f"template void members(JsonWriter&, const {name}&);", ""]
        return [self.declared(name, method, told).removesuffix(";") + " {", *lines, "}", "", *both] if lines else []

    def declared(self, name, method="", told=False):
        if told:
            return f"void members(JsonWriter& io, const {name}& of);"
        return f"void members(JsonReader& io, {name}& of);" if method else f"template <class Io>\nvoid members(Io& io, Of<Io, {name}>& of);"

    def together(self, shape):
        """Checks of members beside each other: (member, what is wrong, words)."""
        members = {each.name: "of." + self.member(each) for each in shape.fields}
        if "x-ordered" in shape:
            first, second = shape["x-ordered"]
            yield second, f"{members[first]} && {members[second]} && !(*{members[first]} < *{members[second]})", f"must be later than `{first}`"
        if "x-together" in shape:
            first, second = shape["x-together"]
            yield second, f"{members[first]}.has_value() != {members[second]}.has_value()", f"goes with `{first}`"
        for name, needed in shape.get("x-needs", {}).items():
            there = " && ".join(members[each] for each in needed)
            yield name, f"{members[name]} && !({there})", "needs " + " and ".join(f"`{each}`" for each in needed)

    # Rules on what goes with what.

    def rules_of(self, noun):
        """The method that has such rules, or nothing."""
        found = [each for each in self.api.of_noun(noun) if any("x-only-for" in one.node for one in each.params.fields)]
        return found[0] if found else None

    def rules(self, method):
        """What of the method the engine does not know: ids; the rest is its own."""
        name = method.params["x-cpp"]
        others = [each for each in method.params.fields if "x-only-for" in each.node and not self.of_engine(each)]
        lines = ["namespace {", "", f"core::SurfaceParameters with_rakes(const {name}& setting) {{",
                 "    core::SurfaceParameters out = setting.parameters;"]
        for each in others:
            lines += [f"    if (setting.{self.member(each)})", f"        out.{self.member(each)}.emplace();"]
        lines += ["    return out;", "}", "", "} // namespace", "", f"core::Result<void> check_kind(const {name}& setting) {{",
                 "    if (auto fits = core::check_kind(with_rakes(setting)); !fits)", "        return fits;"]
        for each in method.params.fields:
            if "x-needed-for" in each.node and not self.of_engine(each):
                kinds = [f"setting.parameters.kind == core::SurfaceKind::{camel(word)}" for word in each.node["x-needed-for"]]
                words = quoted(f"a {either(each.node['x-needed-for'])} surface needs `{each.name}`")
                lines += [f"    if (!setting.{self.member(each)} && ({' || '.join(kinds)}))",
                          f"        return core::fail(core::Error::Code::InvalidArgument, {words}, {quoted(each.node.words.split(';')[0])});"]
            if "x-differs" in each.node:
                other = each.node["x-differs"]
                lines += [f"    if (setting.{self.member(each)} && setting.{self.member(each)} == setting.{snake(other)})",
                          f"        return core::fail(core::Error::Code::InvalidArgument, \"`{each.name}` is the {other} itself\", "
                          "\"name another one\");"]
        return lines + ["    return {};", "}", "",
                        f"core::Result<void> check_rules(const {name}& setting) {{", "    if (auto sound = check_kind(setting); !sound)",
                        "        return sound;", "    return core::check_values(with_rakes(setting));", "}", "", *self.given(method)]

    def given(self, method):
        """What files say of a surface beside what every surface has."""
        lines = ["std::vector<std::pair<std::string_view, double>> given_numbers(const core::SurfaceParameters& p) {",
                 "    std::vector<std::pair<std::string_view, double>> out;"]
        for each in method.params.fields:
            if self.of_engine(each) and each.node.kind == "number" and self.is_optional(each, False):
                to = self.place_in_engine(each)
                lines += [f"    if ({to})", f"        out.emplace_back({quoted(each.name)}, *{to});"]
        return lines + ["    return out;", "}"]

    def of_engine(self, each):
        return each.node.get("x-cpp", "").startswith("parameters.")

    def place_in_engine(self, each):
        return "p." + self.member(each).removeprefix("parameters.")

    # Files.

    def structs_of(self, noun):
        """(shape, name, words, method), in the order in which they can be declared."""
        found = []
        for method in self.api.of_noun(noun):
            for each in method.params.fields:
                if each.node.kind == "object" and "x-cpp" in each.node and not each.node.name:
                    found.append((each.node, each.node["x-cpp"], each.node.words, ""))
        found += [(shape, self.struct_name(shape), shape.words, "") for shape in self.api.shapes_of(noun) if self.is_struct(shape)]
        for method in self.api.of_noun(noun):
            name = method.params.get("x-cpp") or camel(method.name)
            found.append((method.params, name, f"Holds the parameters of {method.name}.", method.name))
        return found

    def told_of(self, noun):
        """(shape, struct) of the engine's structs that answers have."""
        return [(shape, shape["x-cpp-type"]) for shape in self.api.shapes_of(noun)
                if shape.kind == "object" and shape.name in self.told and "x-cpp-type" in shape]

    def header(self, noun):
        structs = self.structs_of(noun)
        text = [MADE.format(f"{noun}.schema.json"),
                f"// {self.api.titles[noun][0]}: what methods take" + (", and the record." if any(each[0].get("x-record") for each in structs) else "."),
                "#pragma once", "",
                '#include "core/surface/family/family_record.hpp"', '#include "core/surface/rake.hpp"',
                '#include "core/surface/lines/line_seeds.hpp"', '#include "core/surface/surface_parameters.hpp"', '#include "core/surface/surface_statistics.hpp"',
                '#include "core/surface/value_range.hpp"', '#include "protocol/api/base/json_members.hpp"', "", "namespace wakesurf::protocol {", ""]
        body = []
        for shape, name, words, method in structs:
            body += self.struct(shape, name, words, method) + [""]
            if method and self.rules_of(noun) and method == self.rules_of(noun).name:
                body += ["/// What only some kinds take, and what they must have. Error: InvalidArgument, naming the parameter.",
                         f"core::Result<void> check_kind(const {name}& setting);", "",
                         "/// The same, and whether times follow each other; `from` is where the record has it. Error: as check_kind.",
                         f"core::Result<void> check_rules(const {name}& setting);", "",
                         "/// The optional numbers that were given, by their names.",
                         "std::vector<std::pair<std::string_view, double>> given_numbers(const core::SurfaceParameters& parameters);", ""]
        body += [self.declared(name, method) if shape.fields else f"inline void members(JsonReader&, {name}&) {{}}"
                 for shape, name, _, method in structs]
        body += [self.declared(struct, told=True) for _, struct in self.told_of(noun)]
        used = "\n".join(body)
        if " : InSession" in used:
            text.insert(text.index('#include "protocol/api/base/json_members.hpp"') + 1, '#include "protocol/api/generated/shared.hpp"')
        text = [line for line in text if needed(line, used)]
        return "\n".join(text + body + ["", "} // namespace wakesurf::protocol", ""])

    def shared(self):
        shape = self.api.shape("InSession")
        return "\n".join([MADE.format("shared.schema.json"), "// What the parameters of many methods share.", "#pragma once", "",
                          "#include <optional>", "#include <string>", "", "namespace wakesurf::protocol {", "",
                          *self.struct(shape, shape.name, shape.words), "", "} // namespace wakesurf::protocol", ""])

    def source(self, noun):
        body = []
        for shape, name, _, method in self.structs_of(noun):
            body += self.members(shape, name, method)
            if method and self.rules_of(noun) and method == self.rules_of(noun).name:
                body += self.rules(self.rules_of(noun)) + [""]
        for shape, struct in self.told_of(noun):
            body += self.members(shape, struct, told=True)
        check = ['#include "core/surface/request/surface_values.hpp"'] if "check_rules" in "".join(body) else []
        return "\n".join([MADE.format(f"{noun}.schema.json"), f'#include "protocol/api/generated/{noun}.hpp"', "", *check,
                          '#include "protocol/api/generated/limits.hpp"', '#include "protocol/api/generated/names.hpp"', "",
                          "#include <nlohmann/json.hpp>", "", "namespace wakesurf::protocol {", "", *body, "} // namespace wakesurf::protocol", ""])
