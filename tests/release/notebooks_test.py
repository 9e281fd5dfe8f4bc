"""docs/notebooks, executed as a reader would: every cell runs, and shows what it says."""
import importlib.util
import os
import shutil
import tempfile
import unittest

from real_server import BINARY, ROOT

NOTEBOOKS = os.path.join(ROOT, "docs/notebooks")
PAGE = os.path.join(ROOT, "web-client/dist/index.html")
BROWSER = shutil.which("chromium") or shutil.which("chromium-headless-shell")
MISSING = [each for each in ("nbclient", "nbformat", "ipykernel", "matplotlib", "pandas") if importlib.util.find_spec(each) is None]


def environment(folder):
    """Of a kernel: the client, the server, and nothing that belongs to whoever runs the tests."""
    return {**{name: value for name, value in os.environ.items() if not name.startswith("WAKESURF_") or name == "WAKESURF_CHROMIUM"},
            "PYTHONPATH": os.path.join(ROOT, "python"), "WAKESURF": BINARY, "WAKESURF_STORE": os.path.join(folder, "store"),
            "HOME": folder, "JUPYTER_RUNTIME_DIR": os.path.join(folder, "runtime"), "IPYTHONDIR": os.path.join(folder, "ipython"),
            "MPLBACKEND": "module://matplotlib_inline.backend_inline", "MPLCONFIGDIR": os.path.join(folder, "mpl")}


class OtherEnvironment:
    def __init__(self, folder):
        self.values = environment(folder)

    def __enter__(self):
        self.before = dict(os.environ)
        os.environ.clear()
        os.environ.update(self.values)

    def __exit__(self, *_):
        os.environ.clear()
        os.environ.update(self.before)


@unittest.skipIf(MISSING, f"not installed: {', '.join(MISSING)} (Debian: python3-nbclient, python3-ipykernel, python3-matplotlib, ...)")
class NotebooksTest(unittest.TestCase):
    def executed(self, name):
        """The notebook with its outputs."""
        import nbformat
        from nbclient import NotebookClient
        notebook = nbformat.read(os.path.join(NOTEBOOKS, name + ".ipynb"), as_version=4)
        nbformat.validate(notebook)
        self.assertTrue(all(not cell.get("outputs") for cell in notebook.cells), "outputs are kept in the repository")
        with tempfile.TemporaryDirectory() as folder, OtherEnvironment(folder):
            NotebookClient(notebook, timeout=150, kernel_name="python3", resources={"metadata": {"path": folder}}).execute()
        return notebook

    def shown(self, notebook, kind):
        return [output["data"][kind] for cell in notebook.cells for output in cell.get("outputs", []) if kind in output.get("data", {})]

    def said(self, notebook):
        return "".join(output.get("text", "") for cell in notebook.cells for output in cell.get("outputs", []))

    def test_first_steps(self):
        notebook = self.executed("first_steps")
        self.assertIn("quads, 99 % of the vertices within", self.said(notebook))
        pictures = 1 + (os.path.exists(PAGE) and bool(BROWSER))  # the plot, and the picture in place of the page
        self.assertEqual(len(self.shown(notebook, "image/png")), pictures)

    def test_a_parameter_study(self):
        notebook = self.executed("parameter_study")
        (table,) = self.shown(notebook, "text/html")
        self.assertEqual(table.count("<tr"), 7)
        self.assertEqual(len(self.shown(notebook, "image/png")), 1)

    def test_an_own_flow(self):
        self.assertRegex(self.said(self.executed("own_flow")), r"22 files\n(.|\n)*age .* to 4\.0")

    def test_there_is_no_other(self):
        self.assertEqual(sorted(os.listdir(NOTEBOOKS)), ["README.md", "first_steps.ipynb", "own_flow.ipynb", "parameter_study.ipynb"])


if __name__ == "__main__":
    unittest.main()
