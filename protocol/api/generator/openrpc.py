"""The description as an OpenRPC 1.3 document, whose schemas are those of JSON Schema draft 7."""
import json

from .schema import pretty

WIDE = 140
INFO = {"description": "Integral surfaces of flows, computed where the data are. Calls go to /rpc (POST) and /ws (WebSocket) of the server "
                       "that gave this document; `data` of errors is a components/schemas/ErrorData.",
        "title": "wakesurf", "version": ""}

PASSED = ("type", "enum", "const", "minimum", "maximum", "exclusiveMinimum", "minLength", "maxLength", "pattern", "minItems", "maxItems",
          "default", "description", "x-unit", "x-only-for", "x-needed-for")


def is_component(node):
    """What has a name of its own in the document."""
    return bool(node.name) and node.kind == "object"


def schema_json(node, whole=False):
    """As draft 7 has it; a reference where the shape has a name, unless `whole`."""
    if is_component(node) and not whole:
        reference = {"$ref": "#/components/schemas/" + node.name}
        return {"anyOf": [reference, {"type": "null"}]} if node.nullable else reference
    out = {key: node[key] for key in PASSED if key in node}
    if node.nullable and "type" in out and "null" not in node.types:
        out["type"] = [*node.types, "null"]
    if node.items is not None:
        out["items"] = schema_json(node.items)
    if node.get("x-partial"):
        out["items"] = {"type": "object"}
    if node.choices:
        out["anyOf"] = [schema_json(each) for each in node.choices]
    if node.kind == "object" and (node.fields or node.values or "additionalProperties" in node):
        object_json(node, out)
    elif node.kind == "json":
        out["additionalProperties"] = True
    return out


def object_json(node, out):
    out["properties"] = {each.name: schema_json(each.node) for each in node.fields}
    required = [each.name for each in node.fields if each.required]
    if required:
        out["required"] = required
    out["additionalProperties"] = schema_json(node.values) if node.values else node.get("additionalProperties", False) is True


def errors_of(api, method):
    """Kinds, in the order of the errors."""
    own = set(method.data.get("x-errors", []))
    unknown = own - set(api.errors)
    if unknown:
        raise ValueError(f"{method.name}: unknown errors {sorted(unknown)}")
    return [kind for kind, data in api.errors.items() if data.get("x-always") or kind in own]


def result_json(api, method):
    whole = method.flag("x-edits")
    out = schema_json(method.result, whole)
    if whole:  # what held answers add
        for each in api.shape("Durability").fields:
            out["properties"][each.name] = schema_json(each.node)
    return out


def parameter_json(each):
    return {"name": each.name, "required": each.required, "description": each.node.words, "schema": schema_json(each.node)}


def method_json(api, method):
    """An entry of `methods`."""
    fields = sorted(method.params.fields, key=lambda each: not each.required)
    out = {"name": method.name, "summary": method.words, "tags": [{"name": method.name.split(".")[0].split("/")[0]}],
           "paramStructure": "by-name", "params": [parameter_json(each) for each in fields],
           "result": {"name": "result", "description": method.result.words or "what it answers", "schema": result_json(api, method)},
           "errors": [{"$ref": "#/components/errors/" + kind} for kind in errors_of(api, method)],
           "x-leastRole": method.role, "x-websocketOnly": method.flag("x-websocketOnly")}
    if "x-example" in method.data:
        example = method.data["x-example"]
        out["examples"] = [{
            "name": method.name,
            "params": [{"name": each.name, "value": example["params"][each.name]} for each in fields if each.name in example["params"]],
            "result": {"name": "result", "value": example["result"]}}]
    return out


def components(api):
    """(shapes, errors) of `components`."""
    shapes = {name: schema_json(shape, whole=True) for name, shape in api.shapes.items() if is_component(shape)}
    errors = {kind: {"code": data["code"], "message": data["description"], "data": {"kind": kind, "hint": "what to do about it"}}
              for kind, data in api.errors.items() if data.get("x-always") is not False}
    return shapes, errors


def document(api):
    """The whole text. The program puts its version in, and a server does not know all of its addresses: there is no `servers`."""
    shapes, errors = components(api)
    methods = ",\n".join(pretty(method_json(api, method), WIDE) for method in api.methods)
    schemas, faults = (",\n".join(json.dumps(name) + ": " + pretty(value, WIDE) for name, value in named.items()) for named in (shapes, errors))
    info = json.dumps(INFO, separators=(",", ":"))
    return (f'{{"openrpc":"1.3.2","info":{info},"x-paths":{{"http":"/rpc","websocket":"/ws"}},"methods":[{methods}],'
            f'"components":{{"schemas":{{{schemas}}},"errors":{{{faults}}}}}}}')
