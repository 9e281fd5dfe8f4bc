"""C++ of one noun: structs of records, of parameters and of what is told; readers with every check, and writers."""
import re
import textwrap

from .cpp_writers import Writers, names_in, quoted
from .schema import camel, either, snake

MADE = "// Made by protocol/api/generate from {}: do not edit."
CHECKS = {"^#[0-9a-fA-F]{6}$": ("is_colour", "must be written #rrggbb")}
KEYWORDS = {"default", "delete", "new", "class", "struct"}
LONGEST_TEXT = 256


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
         "Accuracy|Interpolation|Refine)", "surface_statistics": r"core::(SurfaceStatistics|Emptiness)", "value_range": r"core::ValueRange",
         "<vector>": "std::vector", "<utility>": "std::pair", "json_fwd": "nlohmann", "<cstdint>": "std::uint",
         "<optional>": "std::optional", "<string>": "std::string[ >]", "<string_view>": "std::string_view"}


def needed(line, used):
    """Whether a header that uses this keeps the line of its head."""
    return all(re.search(pattern, used) for word, pattern in NEEDS.items() if line.startswith("#include") and word in line)


class Cpp(Writers):
    """Writes the C++ of a description."""

    def __init__(self, api):
        self.api = api
        self.taken = names_in([each.params for each in api.methods])
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
        return ""

    # Structs.

    def struct(self, shape, name, words, method=""):
        record = bool(shape.get("x-record")) or not method
        in_session = bool(method) and self.in_session(shape)
        base = " : InSession" if in_session else "" if shape.fields else " : NoParameters"
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

    # Readers.

    def bound(self, node, word, otherwise):
        if word in node.get("x-named", {}):
            return "limits::" + limit_name(self.api, node["x-named"][word])
        if word in node:
            return number(node[word]) if node.kind == "number" else str(node[word])
        return otherwise

    def reader(self, shape, name, method=""):
        record = bool(shape.get("x-record")) or not method
        lines = [f"void read(CheckedJson& in, {name}& out) {{"]
        for each in shape.fields:
            if record and each.node.get("x-kept") is False:
                continue
            lines += ["    " + line for line in self.read_member(each, "out." + self.member(each), record)]
        lines += ["    " + line for line in self.together(shape)]
        return lines + ["}"]

    def read_member(self, each, to, record):
        name, node = quoted(each.name), each.node
        if self.is_nullable(each, record):
            lines = [f"{to}.given = in.given({name});"]
            if each.required:
                means = f"; null {node['x-nullable']}" if isinstance(node.get("x-nullable"), str) else ""
                lines += [f"if (!{to}.given)", f"    in.fault({name}, {quoted('is missing' + means)});"]
            return lines + self.read_optional(each, to + ".value")
        if self.is_optional(each, record):
            return self.read_optional(each, to)
        return self.read_plain(each, to, record)

    def range(self, node):
        # One that is excluded is compared by itself, in words of its own.
        least = "exclusiveMinimum" if node.get("maximum") is not None else "minimum"
        lo = self.bound(node, "minimum", self.bound(node, least, "-any_number" if node.kind == "number" else "0"))
        hi = self.bound(node, "maximum", "any_number" if node.kind == "number" else "most_whole")
        return f"{lo}, {hi}"

    def cast(self, node, value):
        kind = node.get("x-cpp-type")
        return f"static_cast<{kind}>({value})" if kind and kind != "std::uint64_t" else value

    def most(self, node):
        return self.bound(node, "maxItems", "most_items")

    def longest(self, node):
        return self.bound(node, "maxLength", str(LONGEST_TEXT))

    def read_optional(self, each, to):
        name, node, kind = quoted(each.name), each.node, each.node.kind
        if kind == "number":
            lines = [f"{to} = in.number_if({name}, {self.range(node)});"]
            if "exclusiveMinimum" in node:
                lines += [f"if ({to} && !(*{to} > {number(node['exclusiveMinimum'])}))",
                          f"    in.fault({name}, \"must be a number greater than {node['exclusiveMinimum']}\");"]
            return lines
        if kind == "count":
            if "x-cpp-type" in node:
                return [f"if (const auto number = in.count_if({name}, {self.range(node)}))",
                        f"    {to} = {self.cast(node, '*number')};"]
            return [f"{to} = in.count_if({name}, {self.range(node)});"]
        if kind == "point":
            return [f"{to} = in.point_if({name});"]
        if kind == "token":
            return [f"{to} = in.token_if({name}, {'true' if 'integer' in node.types else 'false'});"]
        if kind == "flag":
            return [f"if (in.has({name}))", f"    {to} = in.flag_or({name}, false);"]
        if kind == "object":
            return [f"if (in.has({name})) {{", f"    {to}.emplace();",
                    f"    in.inside({name}, [&](CheckedJson& inner) {{ read(inner, *{to}); }});", "}"]
        lines = [line.replace(f"*{to}.", f"{to}->") for line in self.read_plain(each, to, False, f"*{to}")]
        if len(lines) == 1 and kind == "text":
            return [f"{to} = in.{'some_text_if' if node.get('minLength') else 'text_if'}({name}, {self.longest(node)});"]
        if node.get("x-emptyIsMissing"):
            lines = (lines[:1] + [f"if ({to}->empty())", f"    {to}.reset();"]
                     + [line.replace("if (!", f"if ({to} && !") for line in lines[1:]])
        if len(lines) == 1:
            return [f"if (in.has({name}))", "    " + lines[0]]
        return [f"if (in.has({name})) {{", *["    " + line for line in lines], "}"]

    def read_plain(self, each, to, record, value=None):
        """`to` takes what is read; `value` is where it is found then."""
        name, node, kind = quoted(each.name), each.node, each.node.kind
        value = value or to
        has_default = "default" in node or (record and "x-older" in node)
        start = node.get("default", node.get("x-older"))
        if kind == "enum" and "x-cpp-type" in node:
            text = f"in.text_or({name}, {quoted(start)})" if has_default else f"in.text({name})"
            return [f"in.word({name}, {text}, {self.parser(node)}, {to}, {quoted(either(node['enum']))});"]
        if kind == "enum":
            known = " && ".join(f"{value} != {quoted(word)}" for word in node["enum"])
            return [f"{to} = in.text({name});", f"if ({known})",
                    f"    in.fault({name}, {quoted('must be ' + either(node['enum']))});"]
        if kind == "text":
            text = (f"in.text_or({name}, {quoted(start)}, {self.longest(node)})" if has_default
                    else f"in.{'some_text' if node.get('minLength') else 'text'}({name}, {self.longest(node)})")
            lines = [f"{to} = {text};"]
            if "pattern" in node:
                check, wrong = CHECKS[node["pattern"]]
                unless = f"!{value}.empty() && " if has_default else ""
                lines += [f"if ({unless}!{check}({value}))", f"    in.fault({name}, {quoted(wrong)});"]
            return lines
        if kind == "lines":
            return [f"{to} = in.lines({name}, {self.longest(node)});"]
        if kind == "json":
            return [f"{to} = in.object_text({name}, {self.bound(node, 'x-maxBytes', 'most_items')});"]
        if kind == "flag":
            return [f"{to} = in.flag_or({name}, {'true' if start else 'false'});"]
        if kind == "number":
            start = self.bound(node, "default", number(start or 0))
            lines = [f"{to} = in.number_or({name}, {self.range(node)}, {start});" if has_default or not each.required
                     else f"{to} = in.number({name}, {self.range(node)});"]
            if "exclusiveMinimum" in node:
                lines += [f"if (in.has({name}) && !({to} > {number(node['exclusiveMinimum'])}))",
                          f"    in.fault({name}, \"must be a number greater than {node['exclusiveMinimum']}\");"]
            return lines
        if kind == "count":
            start = self.bound(node, "default", str(start))
            read = (f"in.count_or({name}, {self.range(node)}, {start})" if has_default else f"in.count({name}, {self.range(node)})")
            return [f"{to} = {self.cast(node, read)};"]
        if kind == "point":
            return [f"{to} = in.point({name});"]
        if kind == "points":
            read = f"{to} = in.points({name}, {self.most(node)});"
            return [read] if each.required or value != to else [f"if (in.has({name}))", "    " + read]
        if kind == "texts":
            return [f"{to} = in.texts_or_none({name}, {self.most(node)});"]
        if kind == "token":
            return [f"{to} = in.token({name}, {'true' if 'integer' in node.types else 'false'});"]
        if kind == "object":
            return [f"in.inside({name}, [&](CheckedJson& inner) {{ read(inner, {to}); }});"]
        raise ValueError(f"no C++ for {each.name}: {kind}")

    def parser(self, node):
        return snake(node.name)

    def together(self, shape):
        """Checks of members beside each other."""
        lines = []
        members = {each.name: "out." + self.member(each) for each in shape.fields}
        if "x-ordered" in shape:
            first, second = shape["x-ordered"]
            lines += [f"if ({members[first]} && {members[second]} && !(*{members[first]} < *{members[second]}))",
                      f"    in.fault({quoted(second)}, \"must be later than `{first}`\");"]
        if "x-together" in shape:
            first, second = shape["x-together"]
            lines += [f"if ({members[first]}.has_value() != {members[second]}.has_value())",
                      f"    in.fault({quoted(second)}, \"goes with `{first}`\");"]
        for name, needed in shape.get("x-needs", {}).items():
            there = " && ".join(members[each] for each in needed)
            words = " and ".join(f"`{each}`" for each in needed)
            lines += [f"if ({members[name]} && !({there}))", f"    in.fault({quoted(name)}, \"needs {words}\");"]
        return lines

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
            if "x-differs" in each.node:
                other = each.node["x-differs"]
                lines += [f"    if (setting.{self.member(each)} == setting.{snake(other)})",
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

    def header(self, noun):
        structs = self.structs_of(noun)
        text = [MADE.format(f"{noun}.schema.json"),
                f"// {self.api.titles[noun][0]}: what methods take" + (", and the record" if any(each[0].get("x-record") for each in structs)
                                                                     else "") + ". Readers leave what is wrong in `in`.",
                "#pragma once", "",
                '#include "core/surface/family/family_record.hpp"', '#include "core/surface/rake.hpp"',
                '#include "core/surface/surface_parameters.hpp"', '#include "core/surface/surface_statistics.hpp"',
                '#include "core/surface/value_range.hpp"', '#include "protocol/api/base/checked_json.hpp"', "",
                "#include <nlohmann/json_fwd.hpp>", "", "#include <cstdint>", "#include <optional>", "#include <string>",
                "#include <string_view>", "#include <utility>", "#include <vector>", "", "namespace wakesurf::protocol {", ""]
        body, readers = [], []
        for shape, name, words, method in structs:
            body += self.struct(shape, name, words, method) + [""]
            if shape.get("x-record"):
                body += [f"void read(CheckedJson& in, {name}& out);", "",
                         f"nlohmann::json record_json(const {name}& record);", "",
                         "/// Returns it as it is kept: what read() reads.", f"nlohmann::json kept_json(const {name}& record);", ""]
            elif self.has_own(shape) and (method or not shape.name or shape.name in self.taken):
                readers.append(f"void read(CheckedJson& in, {name}& out);")
            if method and self.rules_of(noun) and method == self.rules_of(noun).name:
                body += ["/// What only some kinds take, and what they must have. Error: InvalidArgument, naming the parameter.",
                         f"core::Result<void> check_kind(const {name}& setting);", "",
                         "/// The same, and whether times follow each other; `from` is where the record has it. Error: as check_kind.",
                         f"core::Result<void> check_rules(const {name}& setting);", "",
                         "/// The optional numbers that were given, by their names.",
                         "std::vector<std::pair<std::string_view, double>> given_numbers(const core::SurfaceParameters& parameters);", ""]
        body += [*readers, ""] if readers else []
        writers = [self.writers(shape)[0].removesuffix(" {") + ";" for shape in self.written_shapes(noun) if not shape.get("x-record")]
        body += [*writers, ""] if writers else []
        used = "\n".join(body)
        if " : InSession" in used or " : NoParameters" in used:
            text.insert(text.index('#include "protocol/api/base/checked_json.hpp"') + 1, '#include "protocol/api/generated/shared.hpp"')
        text = [line for line in text if needed(line, used)]
        if "core::Vec3" in used and "core::Rake" not in used:
            text.insert(text.index('#include "protocol/api/base/checked_json.hpp"'), '#include "core/base/vec3.hpp"')
        return "\n".join(text + body + ["} // namespace wakesurf::protocol", ""])

    def shared(self):
        shape = self.api.shape("InSession")
        return "\n".join([MADE.format("shared.schema.json"), "// What the parameters of many methods share.", "#pragma once", "",
                          '#include "protocol/api/base/checked_json.hpp"', "", "#include <optional>", "#include <string>", "",
                          "namespace wakesurf::protocol {", "", *self.struct(shape, shape.name, shape.words), "",
                          "inline void read(CheckedJson& in, InSession& out) {",
                          *["    " + line for line in self.read_member(shape.fields[0], "out.session", False)], "}", "",
                          "/// Stands for the parameters of a method that takes none.", "struct NoParameters {};", "",
                          "inline void read(CheckedJson&, NoParameters&) {}", "", "} // namespace wakesurf::protocol", ""])

    def source(self, noun):
        structs = self.structs_of(noun)
        body = []
        for shape, name, _, method in structs:
            if self.has_own(shape) and (method or not shape.name or shape.name in self.taken or shape.get("x-record")):
                body += self.reader(shape, name, method) + [""]
            if method and self.rules_of(noun) and method == self.rules_of(noun).name:
                body += self.rules(self.rules_of(noun)) + [""]
        for shape in self.written_shapes(noun):
            body += self.writers(shape) + [""]
        used = "\n".join(body)
        includes = ['#include "protocol/api/generated/limits.hpp"'] if "limits::" in used else []
        includes += ['#include "protocol/api/generated/names.hpp"'] if "name(" in used or "in.word(" in used else []
        includes += ['#include "core/surface/request/surface_values.hpp"'] if "check_rules" in used else []
        includes += ['#include "protocol/api/base/list_json.hpp"'] if "point_json" in used or "points_json" in used else []
        text = [MADE.format(f"{noun}.schema.json"), f'#include "protocol/api/generated/{noun}.hpp"', "", *includes, ""]
        if "fmt::" in used:
            text += ["#include <fmt/format.h>"]
        if "nlohmann::json" in used:
            text += ["#include <nlohmann/json.hpp>", ""]
        text += ["namespace wakesurf::protocol {", ""]
        return "\n".join(text + body + ["} // namespace wakesurf::protocol", ""]) if body else ""
