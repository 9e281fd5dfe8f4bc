"""The live page in Debian's notebook: a cell shows it in a frame, where it logs in and joins the session."""
import importlib.util
import json
import os
import socket
import subprocess
import sys
import tempfile
import time
import unittest

from notebooks_test import BROWSER, PAGE, environment
import wakesurf
from wakesurf.chrome import Chrome

CELL = """
import wakesurf
server = wakesurf.serve("flow:tornado")
server.session.suggested("stream")
open("url", "w").write(server.url)
server.session.show(height=400)
"""


def until(met, seconds=60):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = met()
        if found:
            return found
        time.sleep(0.1)
    raise TimeoutError


@unittest.skipUnless(importlib.util.find_spec("notebook"), "not installed: Debian's jupyter-notebook")
@unittest.skipUnless(BROWSER and os.path.exists(PAGE), "needs Chromium and the built page")
class NotebookPageTest(unittest.TestCase):
    def test_the_page_comes_up_in_the_frame_of_a_cell_by_either_name_of_the_machine(self):
        with tempfile.TemporaryDirectory() as folder:
            cell = {"cell_type": "code", "id": "a", "metadata": {}, "source": CELL, "outputs": [], "execution_count": None}
            notebook = {"cells": [cell], "metadata": {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}},
                        "nbformat": 4, "nbformat_minor": 5}
            with open(os.path.join(folder, "a.ipynb"), "w", encoding="utf-8") as file:
                json.dump(notebook, file)
            with socket.create_server(("127.0.0.1", 0)) as free:  # of port 0 the notebook does not say what it has become
                port = free.getsockname()[1]
            with open(os.path.join(folder, "log"), "w", encoding="utf-8") as log:
                server = subprocess.Popen(
                    [sys.executable, "-m", "notebook", "--no-browser", "--allow-root", "--ip=127.0.0.1", f"--port={port}",
                     "--NotebookApp.token=t", f"--notebook-dir={folder}"], env=environment(folder), cwd=folder, stdout=log, stderr=log)
            try:
                runtime = os.path.join(folder, "runtime", f"nbserver-{server.pid}.json")
                until(lambda: os.path.exists(runtime) and os.path.getsize(runtime))
                with open(runtime, encoding="utf-8") as file:
                    port = json.load(file)["port"]  # another one, where that was taken meanwhile
                for host in ("localhost", "127.0.0.1"):
                    with self.subTest(host):
                        self.shows(f"http://{host}:{port}/notebooks/a.ipynb?token=t", folder)
            finally:
                server.terminate()
                server.wait(30)

    def shows(self, address, folder):
        said = os.path.join(folder, "url")
        if os.path.exists(said):
            os.remove(said)
        chrome = Chrome(address, (1000, 800))
        try:
            until(lambda: chrome.value("!!(window.Jupyter?.notebook?.kernel?.is_connected() && Jupyter.notebook._fully_loaded)"))
            chrome.value("Jupyter.notebook.clear_all_output(), Jupyter.notebook.execute_all_cells(), 1")
            until(lambda: os.path.exists(said) and os.path.getsize(said))
            with open(said, encoding="utf-8") as file:
                session = wakesurf.Client(file.read()).session()
            (visitor,) = until(lambda: session.state()["participants"])
            self.assertEqual((visitor["role"], visitor["connected"]), ("host", True))
            source = chrome.value("document.querySelector('iframe[title=wakesurf]').src")
            self.assertEqual(source.split(":")[1], "//" + address.split("/")[2].split(":")[0])
        finally:
            chrome.close()


if __name__ == "__main__":
    unittest.main()
