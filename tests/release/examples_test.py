"""The examples of the client's own documents, as they stand there: only the address of the server is another."""
import ast
import contextlib
import io
import os
import re
import tempfile
import textwrap
import unittest

from real_server import BINARY, ROOT, RealServer
import wakesurf

ADDRESS = "http://127.0.0.1:8080/#token=..."


def text_of(name):
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        return file.read()


def fenced(name):
    """The blocks of a document that begin with the import of the client."""
    blocks = re.findall(r"^```[\w ]*\n(.*?)^```$", text_of(name), re.S | re.M)
    return [block for block in blocks if "from wakesurf import" in block]


def docstring_example():
    lines = ast.get_docstring(ast.parse(text_of("python/wakesurf/__init__.py"))).split("\n")
    first = next(i for i, line in enumerate(lines) if line.startswith("    "))
    last = next(i for i in range(first, len(lines)) if lines[i] and not lines[i].startswith("    "))
    return textwrap.dedent("\n".join(lines[first:last]))


class ExamplesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.server = RealServer(os.path.join(ROOT, "data/sqcyl/sqcyl.pvd"), "flow:tornado", "--store", cls.folder.name)
        wakesurf.Client(cls.server.url).call("dataset.open", 120, dataset="sqcyl")

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()
        cls.folder.cleanup()

    def run_example(self, code):
        """What it prints, and the files it leaves, with their first bytes."""
        self.assertEqual(code.count(ADDRESS), 1, code)
        return self.run_plain(code.replace(ADDRESS, self.server.url))

    def run_plain(self, code):
        printed = io.StringIO()
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            try:
                os.chdir(folder)
                with contextlib.redirect_stdout(printed):
                    exec(compile(code, "example", "exec"), {})
            finally:
                os.chdir(here)
            files = {}
            for name in os.listdir(folder):
                with open(os.path.join(folder, name), "rb") as file:
                    files[name] = file.read(4)
        return printed.getvalue(), files

    def test_that_of_the_clients_docstring(self):
        printed, files = self.run_example(docstring_example())
        self.assertRegex(printed, r"'dataset': 'sqcyl'")
        self.assertGreater(int(printed.strip().split("\n")[-1]), 100)
        self.assertEqual(files, {"wake.vtp": b"<?xm"})

    def test_that_of_the_protocol(self):
        (block,) = fenced("protocol/README.md")
        printed, _ = self.run_example(block)
        self.assertGreater(float(printed), 0)

    def test_those_of_the_clients_page(self):
        blocks = re.findall(r"^```python\n(.*?)^```$", text_of("python/README.md"), re.S | re.M)
        self.assertEqual(len(blocks), 3)
        printed, _ = self.run_example(blocks[0])
        self.assertGreater(float(printed.split()[1]), 0)
        os.environ["WAKESURF"] = BINARY
        try:
            self.assertGreater(int(self.run_plain(blocks[1])[0]), 100)
            study = self.run_plain(blocks[2])[0].strip().split("\n")
        finally:
            del os.environ["WAKESURF"]
        self.assertEqual(len(study), 4)
        self.assertIn("'separation': 0.05, 'accuracy': 'exact'", study[3])


if __name__ == "__main__":
    unittest.main()
