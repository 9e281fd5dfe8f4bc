#!/usr/bin/env python3
"""The modules of python/wakesurf import one another in no circle, neither at the top nor inside of functions; and only its own modules import
the optional part for agents. Imports for types alone, which Python does not run, may point both ways: a session has surfaces, a surface its session.

Standard library only. Run it alone with: python3 tests/lint/python_imports_test.py
"""
import ast
import glob
import graphlib
import os
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PACKAGE = os.path.join(ROOT, "python/wakesurf")


def modules():
    """The syntax of each module, by its name below the package; a package's own is NAME, the outermost one's is empty."""
    found = {}
    for path in glob.glob(PACKAGE + "/**/*.py", recursive=True):
        name = os.path.relpath(path, PACKAGE)[:-len(".py")].replace("/", ".")
        with open(path, encoding="utf-8") as file:
            found[name] = ast.parse(file.read())
    return found


def executed(node):
    """All nodes below, without the blocks for type checkers."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.If) and isinstance(child.test, ast.Name) and child.test.id == "TYPE_CHECKING":
            continue
        yield child
        yield from executed(child)


def imports_of(name, tree, names):
    """The modules of the package that one imports. An import of a name from a package is that of the submodule, if it is one."""
    for node in executed(tree):
        if isinstance(node, ast.Import):
            wanted = [each.name for each in node.names]
        elif isinstance(node, ast.ImportFrom):
            above = ("wakesurf." + name).split(".")[:-node.level] if node.level else []
            base = ".".join(above + ([node.module] if node.module else []))
            submodules = {f"wakesurf.{known}" for known in names}
            wanted = [each if each in submodules else base for each in (f"{base}.{each.name}" for each in node.names)]
        else:
            continue
        for each in wanted:
            below = each.partition(".")[2]
            found = next((known for known in (below, (below + ".__init__").lstrip(".")) if known in names), None)
            if each.partition(".")[0] == "wakesurf" and found is not None and found not in ("__init__", name):
                yield found


def circle(trees):
    """A circle of modules, or None."""
    try:
        list(graphlib.TopologicalSorter({name: set(imports_of(name, tree, trees)) for name, tree in trees.items()}).static_order())
    except graphlib.CycleError as problem:
        return problem.args[1]
    return None


class ImportsTest(unittest.TestCase):
    def test_no_modules_import_one_another_in_a_circle(self):
        trees = modules()
        self.assertGreater(len(trees), 30)
        self.assertIsNone(circle(trees))

    def test_a_circle_is_found_at_the_top_and_in_functions_but_not_among_types(self):
        def of(text):
            return circle({"a": ast.parse("from .b import x"), "b": ast.parse(text)})

        self.assertEqual(set(of("from .a import y")), {"a", "b"})
        self.assertEqual(set(of("def f():\n    from . import a")), {"a", "b"})
        self.assertEqual(set(of("import wakesurf.a")), {"a", "b"})
        self.assertIsNone(of("if TYPE_CHECKING:\n    from .a import y"))

    def test_nothing_but_its_own_modules_imports_the_tools_for_agents(self):
        trees = modules()
        for name, tree in trees.items():
            if not name.startswith("mcp."):
                self.assertEqual([each for each in imports_of(name, tree, trees) if each.startswith("mcp.")], [], name)


if __name__ == "__main__":
    unittest.main()
