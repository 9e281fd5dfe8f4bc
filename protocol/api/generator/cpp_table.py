"""C++ of what is no noun's: limits, error codes, names of enumerations, the table of methods, options."""
from .cpp import MADE, limit_name, quoted
from .markdown import plain, range_of
from .schema import NOUNS, camel, either, snake

NAMESPACE = ["namespace wakesurf::protocol {", ""]
END = ["} // namespace wakesurf::protocol", ""]


def limits_header(api):
    lines = [MADE.format("limits.schema.json"), "// What one server grants, as far as users are told of it.", "#pragma once", "",
             "#include <cstddef>", "#include <cstdint>", "", "namespace wakesurf::protocol::limits {", ""]
    for name, data in api.limits:
        kind = data.get("x-cpp-type", "std::size_t")
        value = f"{data['const']}.0" if kind == "double" else str(data["const"])
        unit = f" ({data['x-unit']})" if "x-unit" in data else ""
        lines.append(f"inline constexpr {kind} {limit_name(api, name)} = {value}; ///< {data['description']}{unit}")
    lines += ["", "/// A limit that server.info tells.", "struct ToldLimit {", "    const char* name;", "    std::uint64_t value;", "};", "",
              "inline constexpr ToldLimit told[]{"]
    lines += [f"    {{{quoted(name)}, {data['const']}}}," for name, data in api.limits if name in api.told]
    return "\n".join(lines + ["};", "", "} // namespace wakesurf::protocol::limits", ""])


def errors_header(api):
    lines = [MADE.format("errors.schema.json"), "// The codes of errors.", "#pragma once", "", "#include <string_view>", "",
             *NAMESPACE, "enum class RpcCode : int {"]
    lines += [f"    {camel(kind)} = {data['code']}, ///< {data['description']}" for kind, data in api.errors.items()]
    lines += ["};", "", "/// The word for a code in error.data.kind: `notFound`, `outsideDomain`, ...",
              "std::string_view kind_of(RpcCode code);", ""]
    return "\n".join(lines + END)


def errors_source(api):
    words = ", ".join(f"{{RpcCode::{camel(kind)}, {quoted(kind)}}}" for kind in api.errors)
    lines = [MADE.format("errors.schema.json"), '#include "protocol/api/generated/errors.hpp"', "", "#include <utility>", "", *NAMESPACE,
             "std::string_view kind_of(RpcCode code) {",
             f"    static constexpr std::pair<RpcCode, std::string_view> kinds[]{{{words}}};",
             "    for (const auto& [each, kind] : kinds)", "        if (each == code)", "            return kind;", '    return "internal";', "}", ""]
    return "\n".join(lines + END)


def enums(api):
    return [shape for shape in api.shapes.values() if shape.kind == "enum" and "x-cpp-type" in shape]


def names_header(api):
    lines = [MADE.format("*.schema.json"),
             "// The words users and scripts write for the engine's enumerations: `stream`, `forward`, `balanced` ...", "#pragma once", "",
             '#include "core/surface/lines/line_seeds.hpp"', '#include "core/surface/surface_parameters.hpp"', '#include "core/surface/surface_statistics.hpp"',
             '#include "protocol/api/base/enum_words.hpp"', "", *NAMESPACE]
    for shape in enums(api):
        kind = shape["x-cpp-type"]
        words = ", ".join(f"{{{kind}::{camel(word)}, {quoted(word)}}}" for word in shape["enum"])
        lines += ["template <>", f"inline constexpr auto words_of<{kind}> = std::to_array<Word<{kind}>>({{{words}}});", ""]
    return "\n".join(lines + END)


def methods_source(api):
    lines = [MADE.format("*.schema.json"), '#include "protocol/api/base/methods.hpp"', "", "#include <algorithm>", "#include <array>", "",
             *NAMESPACE, "namespace {", "", "using Names = std::string_view;", ""]
    for method in api.methods:
        if method.params.fields:
            names = ", ".join(quoted(each.name) for each in method.params.fields)
            lines.append(f"constexpr Names of_{snake(method.name)}[]{{{names}}};")
    lines += ["", "constexpr MethodDescription described[]{"]
    for method in api.methods:
        flags = ", ".join("true" if method.flag(word) else "false" for word in ("x-websocketOnly", "x-edits", "x-wholeServer", "x-shared", "x-copier"))
        names = f"of_{snake(method.name)}" if method.params.fields else "{}"
        lines.append(f"    {{{quoted(method.name)}, {quoted(method.role)}, {flags}, {names}}},")
    lines += ["};", "", "} // namespace", "",
              "std::span<const MethodDescription> described_methods() {", "    return described;", "}", "",
              "const MethodDescription* described_method(std::string_view name) {",
              "    const auto found = std::ranges::find(described, name, &MethodDescription::name);",
              "    return found == std::end(described) ? nullptr : &*found;", "}", ""]
    return "\n".join(lines + END)


def options_header(api):
    """What the command line shares with surface.set."""
    lines = [MADE.format("surface.schema.json"), "// Options of `wakesurf surface` that are parameters of surface.set.", "#pragma once", "",
             "namespace wakesurf::protocol {", "", "struct SurfaceOption {", "    const char* option;", "    const char* parameter;",
             "    const char* type;  ///< text, number or point", "    const char* words; ///< with range and unit",
             "    const char* usual; ///< what holds where it is left out; empty: as the words say", "    bool required;", "};", "",
             "inline constexpr SurfaceOption surface_options[]{"]
    method = next(each for each in api.methods if each.name == "surface.set")
    for each in method.params.fields:
        node = each.node
        if "x-option" in node:
            kind = {"number": "number", "point": "point"}.get(node.kind, "text")
            usual = plain(node["default"]) if "default" in node else ""
            words = option_words(api, each)
            lines.append(f"    {{{quoted(node['x-option'])}, {quoted(each.name)}, {quoted(kind)}, {quoted(words)}, {quoted(usual)}, "
                         f"{'true' if node.kind == 'enum' and each.required else 'false'}}},")
    return "\n".join(lines + ["};", "", *END])


def option_words(api, each):
    node = each.node
    words = node.words[0].upper() + node.words[1:]
    if node.kind == "enum" and each.name != "kind":
        words = either(node["enum"]) + ": " + node.words
    if "x-only-for" in node:
        words = f"{either(node['x-only-for']).capitalize()}: {node.words}"
    extra = [each for each in (node.get("x-unit"), range_of(node) if node.kind == "number" and "32-bit" not in range_of(node) else "") if each]
    words += f" ({'; '.join(extra)})" if extra else ""
    method = next(one for one in api.methods if one.name == "surface.set")
    for other in method.params.fields:  # as the command line spells them
        if "x-option" in other.node:
            words = words.replace(f"`{other.name}`", other.node["x-option"])
    return words.replace("`maxQuads`", "--max-quads")


def files(api, cpp):
    """path below generated/ -> text."""
    out = {"limits.hpp": limits_header(api), "errors.hpp": errors_header(api), "errors.cpp": errors_source(api),
           "names.hpp": names_header(api), "methods.cpp": methods_source(api),
           "surface_options.hpp": options_header(api), "shared.hpp": cpp.shared()}
    for noun in NOUNS:
        out[f"{noun}.hpp"], out[f"{noun}.cpp"] = cpp.header(noun), cpp.source(noun)
    return out
