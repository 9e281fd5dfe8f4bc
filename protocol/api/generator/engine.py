"""The engine's check of the values that it is asked for: callers from C++ come past the readers of the API."""
from .cpp import MADE, Cpp, number, quoted
from .schema import camel, either


class Engine(Cpp):
    """Writes what the description of surfaces says of values, in the engine's own terms."""

    def wrong_range(self, each):
        """When a number is outside its range, and what is said then."""
        node = {word: value for word, value in each.node.data.items() if word not in each.node.get("x-named", {})}
        to = ("*" if self.is_optional(each, False) else "") + self.place_in_engine(each)
        bounds, words = [], []
        for word, comparison in (("minimum", ">="), ("exclusiveMinimum", ">"), ("maximum", "<=")):
            if word in node:
                bounds.append(f"{to} {comparison} {number(node[word]) if each.node.kind == 'number' else node[word]}")
        if "exclusiveMinimum" in node:
            words.append(f"a number greater than {node['exclusiveMinimum']}")
        if "maximum" in node:
            words.append(f"at most {node['maximum']}" if "minimum" not in node else f"a number between {node['minimum']} and {node['maximum']}")
        elif "minimum" in node:
            words.append(f"at least {node['minimum']}")
        there = f"{self.place_in_engine(each)} && " if self.is_optional(each, False) else ""
        return f"{there}!({' && '.join(bounds)})", f"must be {' and '.join(words)}"

    def files(self):
        """name -> text"""
        method = next(filter(None, (self.rules_of(noun) for noun in self.api.titles)))
        fields = {each.name: each for each in method.params.fields}
        record = {each.name: each for shape in self.api.shapes_of(method.noun) if shape.get("x-record") for each in shape.fields}
        kinds = fields["kind"].node["x-cpp-type"].removeprefix("core::")

        def refuse(condition, message, hint):
            return [f"    if ({condition})", f"        return wrong({message}, {quoted(hint)});"]

        body = ["Result<void> check_kind(const SurfaceParameters& p) {"]
        for each in fields.values():
            words = each.node.get("x-only-for", [])
            if words:
                others = " && ".join(f"p.kind != {kinds}::{camel(word)}" for word in words)
                body += refuse(f"{self.place_in_engine(each)} && {others}",
                               quoted(f"`{each.name}` belongs to {either(words)} surfaces"), "leave it out")
        for each in filter(self.of_engine, fields.values()):
            for word in each.node.get("x-needed-for", []):
                body += refuse(f"p.kind == {kinds}::{camel(word)} && !{self.place_in_engine(each)}",
                               quoted(f"a {word} surface needs `{each.name}`"), each.node.words)
        for word, rule in method.data.get("x-exactly-one", {}).items():
            there = " == ".join(f"{self.place_in_engine(fields[one])}.has_value()" for one in rule["of"])
            names = " and ".join(f"`{one}`" for one in rule["of"])
            body += refuse(f"p.kind == {kinds}::{camel(word)} && {there}", quoted(f"a {word} surface takes one of {names}"), rule["hint"])
        for each in fields.values():
            if each.node.get("x-nonzero"):
                to = self.place_in_engine(each)
                body += refuse(f"{to} && !(finite(*{to}) && glm::length(*{to}) > 0.0)", quoted(f"`{each.name}` has no length"),
                               "give a finite vector that is not zero")
        body += ["    return {};", "}", "", "Result<void> check_values(const SurfaceParameters& p) {",
                 "    if (auto fits = check_kind(p); !fits)", "        return fits;"]
        for each in fields.values():
            node = each.node
            limited = any(word in node for word in ("minimum", "exclusiveMinimum", "maximum")) and not node.get("x-plain")
            if self.of_engine(each) and limited and node.name != "Time":
                condition, message = self.wrong_range(each)
                body += refuse(condition, quoted(f"`{each.name}` {message}"), "leave it out for the default"
                               if "default" in node or "x-named" in node else "leave it out, or correct it")
            if "x-between" in node:
                to = self.place_in_engine(each)
                lo, hi = (self.place_in_engine(record[one]) for one in node["x-between"])
                words = " + \" and ".join(f"`{one}` \" + time_text({at})" for one, at in zip(node["x-between"], (lo, hi)))
                body += refuse(f"{to} && !between(*{to}, {lo}, {hi})",
                               f"\"`{each.name}` \" + time_text(*{to}) + \" does not lie between {words}",
                               "leave it out, or choose a time between them")
        body += ["    return {};", "}", ""]
        made = MADE.format(f"{method.noun}.schema.json")
        header = [made, f"// Checks what the description of {method.name} says about values, for C++ callers, who come past its readers.",
                  "#pragma once", "", '#include "core/base/result.hpp"', '#include "core/surface/surface_parameters.hpp"', "",
                  "namespace wakesurf::core {", "",
                  "/// Checks what only some kinds take, and what they must have. Error: InvalidArgument, naming the parameter.",
                  "Result<void> check_kind(const SurfaceParameters& parameters);", "",
                  "/// Checks the kind, ranges of numbers, and times beside each other. Error: that of check_kind.",
                  "Result<void> check_values(const SurfaceParameters& parameters);", "", "} // namespace wakesurf::core", ""]
        source = [made, '#include "core/surface/request/surface_values.hpp"', "", '#include "core/surface/time_direction.hpp"', "",
                  "#include <string>", "", "namespace wakesurf::core {", "", "namespace {", "",
                  "tl::unexpected<Error> wrong(const std::string& message, const std::string& hint) {",
                  "    return fail(Error::Code::InvalidArgument, message, hint);", "}", "", "} // namespace", "", *body,
                  "} // namespace wakesurf::core", ""]
        return {"surface_values.hpp": "\n".join(header), "surface_values.cpp": "\n".join(source)}
