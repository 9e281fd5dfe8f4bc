"""Examples of methods as docs/api.md shows them: each record once, at a method of its own noun if one answers it, and `...` elsewhere.

The OpenRPC document has them whole.
"""
import json

WIDTH = 120
SHORT = 100  # what is no longer as text is always shown
MORE = "\u2026"


def filled(value, indent=0):
    """JSON text in as few lines as fit; what takes several begins a line of its own."""
    flat = json.dumps(value, ensure_ascii=False)
    if len(flat) + indent <= WIDTH or not isinstance(value, (dict, list)):
        return flat
    items = [json.dumps(key) + ": " + filled(each, indent + 1) for key, each in value.items()] if isinstance(value, dict) else \
        [filled(each, indent + 1) for each in value]
    lines = [items[0]]
    for each in items[1:]:
        if "\n" in lines[-1] + each or indent + len(lines[-1] + each) + 4 > WIDTH:
            lines.append(each)
        else:
            lines[-1] += ", " + each
    return flat[0] + (",\n" + " " * (indent + 1)).join(lines) + flat[-1]


def records(node, value):
    """Shapes of the named objects in a value."""
    if isinstance(value, list) and node.items is not None:
        for each in value:
            yield from records(node.items, each)
    elif isinstance(value, dict):
        if node.kind == "object" and node.name:
            yield node.name
        for each in node.fields:
            if each.name in value:
                yield from records(each.node, value[each.name])


class Examples:
    def __init__(self, api):
        self.shown = {"Limits"}  # by a table
        self.places = {}  # shape -> the method that shows it
        for method in api.methods:
            for name in records(method.result, method.data["x-example"]["result"]):
                if name not in self.places or (method.noun == api.home[name] != self.places[name].noun):
                    self.places[name] = method

    def cut(self, node, value, method):
        if isinstance(value, list) and node.items is not None:
            cut = [self.cut(node.items, each, method) for each in value]
            return cut[:cut.index(MORE) + 1] if MORE in cut else cut
        if not isinstance(value, dict):
            return value
        if node.kind == "object" and node.name and len(json.dumps(value)) > SHORT:
            if node.name in self.shown or self.places[node.name] is not method:
                return MORE
            self.shown.add(node.name)
        nodes = {each.name: each.node for each in node.fields}
        return {name: self.cut(nodes[name], each, method) if name in nodes else each for name, each in value.items()}

    def lines(self, method):
        """None for a method that takes and answers nothing of its own."""
        example = method.data["x-example"]
        if not example["result"] and not example["params"].keys() - {"session"}:
            return []
        answer = filled({"result": self.cut(method.result, example["result"], method)}).replace(f'"{MORE}"', "...")
        return ["", "```js", filled({"method": method.name, "params": example["params"]}), *([answer] if example["result"] else []), "```"]
