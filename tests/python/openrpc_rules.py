"""What the OpenRPC specification, version 1.3, asks of a document (spec.open-rpc.org) and no schema can say. What its own schema
says is checked in tests/end_to_end/openrpc.spec.ts."""
import re

from jsonschema import Draft7Validator


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
    """Messages, one for each rule that is broken."""
    return list(_faults(document))


def _faults(document):
    names = [method["name"] for method in document["methods"]]
    for name in {name for name in names if names.count(name) > 1}:
        yield f"{name} appears twice"
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
            yield f"{method['name']}: a parameter appears twice"
        required = [bool(each.get("required")) for each in method["params"]]
        if required != sorted(required, reverse=True):
            yield f"{method['name']}: a required parameter comes after an optional one"
        for schema in [each["schema"] for each in method["params"]] + [method["result"]["schema"]]:
            try:
                Draft7Validator.check_schema(schema)
            except Exception as problem:  # jsonschema's own hierarchy differs between its versions
                yield f"{method['name']}: no JSON Schema: {problem}"
