"""All outputs, by path from the root of the repository."""
import os

from . import cpp_table, markdown, openrpc
from .cpp import Cpp
from .engine import Engine
from .python import Python
from .schema import FOLDER
from .typescript_table import Tables

ROOT = os.path.dirname(os.path.dirname(FOLDER))
CPP = "protocol/api/generated"
PYTHON = "python/wakesurf/generated"
ENGINE = "core/surface/request"
TYPESCRIPT = "web-client/src/protocol/generated"
CHECKED_IN = "docs/api.md"


def make(api):
    """path -> text."""
    out = {}
    for folder, files in ((CPP, cpp_table.files(api, Cpp(api))), (ENGINE, Engine(api).files()), (TYPESCRIPT, Tables(api).files()),
                          (PYTHON, Python(api).files())):
        out.update({f"{folder}/{name}": text for name, text in files.items()})
    out[f"{CPP}/openrpc.json"] = openrpc.document(api)
    out[CHECKED_IN] = markdown.text(api)
    return out


def kept(path):
    """What is there now, or nothing."""
    try:
        with open(os.path.join(ROOT, path), encoding="utf-8") as file:
            return file.read()
    except FileNotFoundError:
        return None


def left_over(made):
    """Files in folders of ours that nothing makes any more."""
    found = []
    for folder in (CPP, TYPESCRIPT, PYTHON):
        for at, folders, names in os.walk(os.path.join(ROOT, folder)):
            folders[:] = sorted(each for each in folders if each != "__pycache__")
            found += [os.path.relpath(os.path.join(at, name), ROOT) for name in sorted(names)]
    return [path for path in found if path not in made]


def write(path, text):
    """Nothing: the file goes."""
    full = os.path.join(ROOT, path)
    if text is None:
        os.remove(full)
        return
    os.makedirs(os.path.dirname(full), exist_ok=True)
    with open(full, "w", encoding="utf-8") as file:
        file.write(text)
