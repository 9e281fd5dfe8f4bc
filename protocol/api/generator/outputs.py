"""All outputs, by path from the root of the repository, formatted as the tools of the repository format."""
import os
import shutil
import subprocess
import tempfile

from . import cpp_table, markdown, openrpc
from .cpp import Cpp
from .engine import Engine
from .python import Python
from .schema import FOLDER
from .typescript_table import Tables

ROOT = os.path.dirname(os.path.dirname(FOLDER))
CPP = "protocol/api/generated"
PYTHON = "protocol/python/wakesurf/generated"
ENGINE = "core/surface/request"
TYPESCRIPT = "web-client/src/protocol/generated"


class ToolError(Exception):
    """A formatter is missing, or refuses what was made."""


def clang_format():
    tool = shutil.which("clang-format") or shutil.which("clang-format-14")
    if tool is None:
        raise ToolError("clang-format is missing: see docker/packages.txt")
    return tool


def formatted_cpp(files):
    """name -> text, all in one run of clang-format."""
    with tempfile.TemporaryDirectory(dir=os.path.join(ROOT, "protocol")) as folder:
        for name, text in files.items():
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        done = subprocess.run([clang_format(), "-i", *sorted(files)], cwd=folder, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise ToolError(done.stderr)
        return {name: text_of(os.path.join(folder, name)) for name in files}


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def formatted_typescript(files):
    """name -> text, all in one run of prettier."""
    web = os.path.join(ROOT, "web-client")
    tool = os.path.join(web, "node_modules", "prettier", "bin", "prettier.cjs")
    if shutil.which("node") is None or not os.path.isfile(tool):
        raise ToolError("prettier is missing: run npm ci in web-client")
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        command = ["node", tool, "--config", os.path.join(web, ".prettierrc.json"), "--log-level", "warn", "--write", *sorted(files)]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise ToolError(done.stderr)
        return {name: text_of(os.path.join(folder, name)) for name in files}


def make(api):
    """path -> text. Error: ToolError."""
    out = {f"{CPP}/{name}": text for name, text in formatted_cpp(cpp_table.files(api, Cpp(api))).items()}
    out.update({f"{ENGINE}/{name}": text for name, text in formatted_cpp(Engine(api).files()).items()})
    out.update({f"{TYPESCRIPT}/{name}": text for name, text in formatted_typescript(Tables(api).files()).items()})
    out[f"{CPP}/openrpc.json"] = openrpc.document(api)
    out["docs/api.md"] = markdown.text(api)
    out.update({f"{PYTHON}/{name}": text for name, text in Python(api).files().items()})
    return out


def kept(path):
    """What is there now, or nothing."""
    try:
        return text_of(os.path.join(ROOT, path))
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
