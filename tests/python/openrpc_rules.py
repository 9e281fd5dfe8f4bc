"""What the OpenRPC specification, version 1.3, asks of a document (spec.open-rpc.org, section by section), as a JSON
Schema and the rules that no schema can say."""
import re

from jsonschema import Draft7Validator

_ANY = {"type": "object"}
_REFERENCE = {"type": "object", "required": ["$ref"], "properties": {"$ref": {"type": "string"}},
              "additionalProperties": False}


def _object(needed, **properties):
    """With the members named, and extensions."""
    return {"type": "object", "required": needed, "properties": properties, "patternProperties": {"^x-": {}},
            "additionalProperties": False}


def _or_reference(schema):
    return {"oneOf": [_REFERENCE, {"allOf": [schema, {"not": {"required": ["$ref"]}}]}]}


_TEXT = {"type": "string"}
_CONTENT = _object(["name", "schema"], name=_TEXT, summary=_TEXT, description=_TEXT, required={"type": "boolean"},
                   schema={"type": ["object", "boolean"]}, deprecated={"type": "boolean"})
_ERROR = _object(["code", "message"], code={"type": "integer"}, message=_TEXT, data={})
_TAG = _object(["name"], name=_TEXT, summary=_TEXT, description=_TEXT, externalDocs=_ANY)
_SERVER = _object(["url"], name=_TEXT, url=_TEXT, summary=_TEXT, description=_TEXT, variables=_ANY)
_METHOD = _object(["name", "params"], name={"type": "string", "minLength": 1}, summary=_TEXT, description=_TEXT,
                  tags={"type": "array", "items": _or_reference(_TAG)}, externalDocs=_ANY,
                  params={"type": "array", "items": _or_reference(_CONTENT)}, result=_or_reference(_CONTENT),
                  deprecated={"type": "boolean"}, servers={"type": "array", "items": _SERVER},
                  errors={"type": "array", "items": _or_reference(_ERROR)}, links={"type": "array"},
                  paramStructure={"enum": ["by-name", "by-position", "either"]}, examples={"type": "array"})
_COMPONENTS = _object([], contentDescriptors=_ANY, schemas={"type": "object", "additionalProperties": _ANY},
                      examples=_ANY, links=_ANY, errors={"type": "object", "additionalProperties": _ERROR},
                      examplePairingObjects=_ANY, tags=_ANY)
DOCUMENT = _object(["openrpc", "info", "methods"], openrpc={"type": "string", "pattern": r"^1\.3\.\d+$"},
                   info=_object(["title", "version"], title=_TEXT, version=_TEXT, description=_TEXT,
                                termsOfService=_TEXT, contact=_ANY, license=_ANY),
                   servers={"type": "array", "items": _SERVER}, methods={"type": "array", "items": _or_reference(_METHOD)},
                   components=_COMPONENTS, externalDocs=_ANY)


def references(value):
    if isinstance(value, dict):
        if isinstance(value.get("$ref"), str):
            yield value["$ref"]
        for each in value.values():
            yield from references(each)
    elif isinstance(value, list):
        for each in value:
            yield from references(each)


def resolve(document, reference):
    at = document
    for word in reference[2:].split("/"):
        at = at[word.replace("~1", "/").replace("~0", "~")]
    return at


def faults(document):
    """Messages, one for each rule that is broken. The shape comes first: the other rules rely on it."""
    shape = [f"{'/'.join(map(str, each.absolute_path))}: {each.message[:200]}"
             for each in Draft7Validator(DOCUMENT).iter_errors(document)]
    return shape or list(_other_faults(document))


def _other_faults(document):
    names = [method["name"] for method in document["methods"]]
    for name in {name for name in names if names.count(name) > 1}:
        yield f"{name} is there twice"
    for reference in references(document):
        try:
            if not re.match(r"#/components/", reference):
                raise KeyError
            resolve(document, reference)
        except KeyError:
            yield f"{reference} leads nowhere"
    for method in document["methods"]:
        given = [each["name"] for each in method["params"]]
        if len(set(given)) != len(given):
            yield f"{method['name']}: a parameter is there twice"
        required = [bool(each.get("required")) for each in method["params"]]
        if required != sorted(required, reverse=True):
            yield f"{method['name']}: a required parameter comes after an optional one"
        for schema in [each["schema"] for each in method["params"]] + [method["result"]["schema"]]:
            try:
                Draft7Validator.check_schema(schema)
            except Exception as problem:  # jsonschema's own hierarchy differs between its versions
                yield f"{method['name']}: no JSON Schema: {problem}"
