"""C++ that writes records, and what results and notifications tell, as JSON."""
from .schema import snake


def quoted(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def names_in(nodes):
    """Names of all shapes that these lead to."""
    found = set()
    for node in nodes:
        inner = [each.node for each in node.fields] + node.parts + node.choices + [each for each in (node.items, node.values) if each]
        found |= {node.name} | names_in(inner)
    return found


class Writers:
    """What Cpp needs for writers beside the names and types of members, which it knows."""

    def writers(self, shape):
        """Functions that write the shape: of a record one for who asks, and one of what is kept."""
        kind = shape.get("x-cpp-type") or self.struct_name(shape)
        if not shape.get("x-record"):
            fields = [each for each in shape.fields if each.node.get("x-cpp", "") is not None]
            return self.writer(f"{snake(shape.name)}_json", kind, "", fields)
        kept = [each for each in shape.fields if each.node.get("x-kept") is not False]
        passing = [each for each in shape.fields if each.node.get("x-kept") is False]
        return self.writer("record_json", kind, "kept_json(record)", passing) + [""] + self.writer("kept_json", kind, "", kept)

    def writer(self, function, kind, start, fields):
        """`start`: what there is before the fields."""
        pairs, later = [], []
        for each in fields:
            place, name = "record." + self.member(each), quoted(each.name)
            there = self.there(each, place)
            if there or start:
                value = self.written(each.node, "*" + place if there == place else place)
                later += [f"    if ({there})"] * bool(there) + [("    " if there else "") + f"    out[{name}] = {value};"]
            elif each.node.nullable:
                pairs.append(f"{{{name}, {place} ? nlohmann::json({self.written(each.node, '*' + place)}) : nlohmann::json(nullptr)}}")
            else:
                pairs.append(f"{{{name}, {self.written(each.node, place)}}}")
        made = start or "{" + ", ".join(pairs) + "}"
        lines = [f"nlohmann::json {function}(const {kind}& record) {{"]
        if not later:
            return lines + [f"    return {made};", "}"]
        first = f"nlohmann::json out = {made};" if start else f"nlohmann::json out{made};"
        return lines + ["    " + first, *later, "    return out;", "}"]

    def there(self, each, place):
        """The condition on which a member is written; empty: it always is."""
        if each.node.nullable:
            return ""
        if self.is_optional(each, True):
            return place.split("->")[0]
        return "" if each.required or each.node.get("x-plain") else f"!{place}.empty()"

    def written(self, node, value):
        if node.kind == "enum" and "x-cpp-type" in node:
            return f"name({value})"
        if node.kind == "point":
            return f"point_json({value})"
        if node.kind == "points":
            return f"points_json({value})"
        if node.kind == "json":
            return f"nlohmann::json::parse({value})"
        return f"{snake(node.name)}_json({value})" if node.kind == "object" else value

    def written_shapes(self, noun):
        """Those of a noun that the program has as structs and tells to others, or keeps."""
        return [shape for shape in self.api.shapes_of(noun) if shape.kind == "object" and shape.name in self.told
                and ("x-cpp" in shape or "x-cpp-type" in shape)]
