#!/usr/bin/env python3
"""protocol/api/*.schema.json and what is made from them: docs/api.md is up to date, examples are right, mistakes are refused."""
import copy
import os
import re
import subprocess
import sys
import tempfile
import json
import unittest

from jsonschema import Draft7Validator

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "protocol", "api"))
from generator import markdown, openrpc, outputs, schema  # noqa: E402


def example_faults(api):
    """What is wrong with the examples of methods, as messages."""
    components = {"schemas": openrpc.components(api)[0]}

    def check(value, shape, where):
        for each in Draft7Validator({"allOf": [shape], "components": components}).iter_errors(value):
            yield f"{where}: {'/'.join(map(str, each.absolute_path))}: {each.message}"

    for method in api.methods:
        example = method.data.get("x-example")
        if example is None:
            yield f"{method.name}: has no example"
            continue
        shapes = {each.name: openrpc.schema_json(each.node) for each in method.params.fields}
        for name in example["params"].keys() - shapes.keys():
            yield f"{method.name}: there is no parameter {name}"
        for each in method.params.fields:
            if each.name in example["params"]:
                yield from check(example["params"][each.name], shapes[each.name], f"{method.name} {each.name}")
            elif each.required:
                yield f"{method.name}: {each.name} is missing"
        yield from check(example["result"], openrpc.result_json(api, method), method.name)


def bare_methods(text, methods):
    """Methods that a sentence in C++ names without backticks: no front end could spell them its own way."""
    named = re.compile(r"(?<![`\w/.])(?:" + "|".join(map(re.escape, sorted(methods, key=len, reverse=True))) + r")(?![\w`])")
    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("//"):
            continue
        for said in re.findall(r'"((?:[^"\\]|\\.)*)"', line):
            if named.search(said) and said not in methods:
                yield f"{number}: {said}"


def sections(page):
    """Heading -> what is below it, without examples."""
    parts = re.split(r"(?m)^##+ (.*)\n", re.sub(r"(?s)```.*?```", "", page))
    return dict(zip(parts[1::2], parts[2::2]))


def members(text, below):
    """Names that a part of docs/api.md describes, or says to be described elsewhere."""
    found = set(re.findall(r"(?m)^(?:\| |- |Parameter |Member |Answers )`(\w+)`", text))
    for names in re.findall(r"(?:\[Common parameters\]|As in \[.*?\])\(.*?\): (.*)", text):
        found.update(re.findall(r"`(\w+)`", names))
    return found.union(*(members(below[shape], below) for shape in re.findall(r"With the members of \[(\w+)\]", text)))


class TheDescription(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.api = schema.load()

    def test_is_what_the_document_made_from_it_says(self):
        self.assertEqual(outputs.kept(outputs.CHECKED_IN), outputs.make(self.api)[outputs.CHECKED_IN], "run protocol/api/generate")

    def test_is_whole_in_the_document_although_it_says_things_once(self):
        below = sections(outputs.make(self.api)[outputs.CHECKED_IN])
        told = [(name, below[name], shape) for name, shape in self.api.shapes.items() if markdown.is_told(shape)]
        told += [(name, below[name + " (notification)"], params) for name, _, _, params in self.api.notifications]
        for method in self.api.methods:
            taken, answered = re.split(r"(?m)^(?=Answers)", below[method.name])
            told += [(method.name, taken, method.params)]
            told += [] if f"[{method.result.name}]" in answered else [(method.name, answered, method.result)]
        for name, text, node in told:
            with self.subTest(name):
                self.assertLessEqual({each.name for each in node.fields}, members(text, below))

    def test_is_named_in_backticks_by_all_that_is_said(self):
        methods = {each.name for each in self.api.methods}
        self.assertEqual(list(bare_methods('"call rake.list now" "rake.list" "`rake.list` lists" "rake.lists"', methods)), ["1: call rake.list now"])
        files = subprocess.run(["git", "ls-files", "core/*.cpp", "importer/*.cpp", "protocol/*.cpp", "store/*.cpp", "server/*.cpp"], cwd=ROOT, check=True,
                               stdout=subprocess.PIPE, text=True).stdout.split()
        for path in files:
            with open(os.path.join(ROOT, path), encoding="utf-8") as file:
                self.assertEqual(list(bare_methods(file.read(), methods)), [], path)

    def test_has_an_example_of_every_method_that_its_schemas_allow(self):
        self.assertEqual(list(example_faults(self.api)), [])

    def test_shows_the_limits_that_there_are(self):
        method = next(each for each in self.api.methods if each.name == "server.info")
        self.assertEqual(method.data["x-example"]["result"]["limits"],
                         {name: data["const"] for name, data in self.api.limits if name in self.api.told})

    def test_finds_what_is_wrong_with_an_example(self):
        changes = [
            lambda data: data.pop("x-example"),
            lambda data: data["x-example"]["params"].update(colours="#ffffff"),
            lambda data: data["x-example"]["params"].update(seeds=1),
            lambda data: data["x-example"]["params"].pop("points"),
            lambda data: data["x-example"]["result"].update(clipped="no"),
            lambda data: data["x-example"]["result"].pop("rake"),
            lambda data: data["x-example"]["result"].update(more=1)]
        for change in changes:
            api = copy.deepcopy(self.api)
            method = next(each for each in api.methods if each.name == "rake.set")
            change(method.data)
            self.assertEqual(len(list(example_faults(api))), 1)

    def test_gives_each_default_within_its_range(self):
        for method in self.api.methods:
            for each in method.params.fields:
                node = each.node
                if node.kind in ("number", "count") and "default" in node:
                    self.assertGreaterEqual(node["default"], node.get("minimum", node["default"]), each.name)
                    self.assertLessEqual(node["default"], node.get("maximum", node["default"]), each.name)
                if node.kind == "enum" and "default" in node:
                    self.assertIn(node["default"], node["enum"])


class TheLoader(unittest.TestCase):
    """A mistake in a schema file is a message, not an output."""

    def refused(self, noun, change):
        with tempfile.TemporaryDirectory() as folder:
            for name in (*schema.OTHERS, *schema.NOUNS):
                with open(os.path.join(schema.FOLDER, name + ".schema.json"), encoding="utf-8") as file:
                    data = json.load(file)
                if name == noun:
                    data = copy.deepcopy(data)
                    change(data)
                with open(os.path.join(folder, name + ".schema.json"), "w", encoding="utf-8") as file:
                    json.dump(data, file)
            with self.assertRaises(schema.SchemaError):
                schema.load(folder)

    def test_refuses_a_word_that_it_does_not_know(self):
        self.refused("rake", lambda data: data["$defs"]["RakeKind"].update(minimun=3))

    def test_refuses_a_reference_that_leads_nowhere(self):
        self.refused("rake", lambda data: data["x-methods"]["rake.list"].update(params={"$ref": "#/$defs/No"}))

    def test_refuses_a_limit_that_there_is_not(self):
        self.refused("rake", lambda data: data["$defs"]["RakeShape"]["properties"]["seeds"].update({"x-limit": {"maximum": "no"}}))

    def test_refuses_a_member_without_words(self):
        self.refused("surface", lambda data: data["x-methods"]["surface.set"]["params"]["properties"].update(
            {"speed": {"type": "number"}}))

    def test_refuses_a_required_member_that_is_not_described(self):
        self.refused("surface", lambda data: data["x-methods"]["surface.stop"]["params"]["required"].append("no"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]] + sys.argv[1:])
