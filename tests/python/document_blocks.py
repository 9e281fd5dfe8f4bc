"""The code blocks of README.md and docs/, and what their marks ask for.

A block of commands says behind its language what is done with it:

    sh run          runs with bash in a folder of its page, which has data/ and build/ as a clone has them
    sh run serve    one `wakesurf serve`; the page's later blocks reach it by the address in the documents, and by $WAKESURF_URL
    python run      runs with the client beside it
    bash tour       runs as one script with the page's others of that mark, and prints what its comments say (curl_tour_test.py)
    sh elsewhere    cannot run here (ssh, a batch system, a container): its syntax and its options are checked
    python elsewhere    the same (MPI): its syntax is checked
"""
import os
import re
import shlex
from dataclasses import dataclass

from real_server import ROOT

FENCE = re.compile(r"^```([^\n`]*)\n(.*?)^```$", re.S | re.M)
ADDRESS = "http://127.0.0.1:8080"
MARKS = ("sh run", "sh run serve", "bash tour", "sh elsewhere", "python run", "python elsewhere")
ENDS = ("|", "||", "&&", ";", "&", ">", ">>", "<", "2>&1")


@dataclass
class Block:
    page: str
    line: int
    mark: str
    code: str


def pages():
    """Paths of the documents for users; those for contributors are beside the code."""
    found = ["README.md"]
    for folder, names, files in os.walk(os.path.join(ROOT, "docs")):
        names[:] = [each for each in names if each != "site"]
        found += [os.path.relpath(os.path.join(folder, each), ROOT) for each in files if each.endswith(".md")]
    return sorted(found)


def text_of(page):
    with open(os.path.join(ROOT, page), encoding="utf-8") as file:
        return file.read()


def blocks(page, text=None):
    text = text_of(page) if text is None else text
    return [Block(page, text.count("\n", 0, found.start()) + 1, found.group(1).strip(), found.group(2))
            for found in FENCE.finditer(text)]


def logical_lines(code):
    """Lines of a script without comments, those that a backslash continues as one."""
    for line in code.replace("\\\n", " ").split("\n"):
        words = shlex.split(line, comments=True)
        if words:
            yield words


def parts(words):
    """The commands of a line: what lies between pipes and redirections."""
    part = []
    for word in [*words, ";"]:
        if word in ENDS:
            if part:
                yield part
            part = []
        else:
            part.append(word)


def wakesurf_calls(code):
    """Arguments of each call of the program; of an image of that name, as its entry point makes them."""
    for words in logical_lines(code):
        for part in parts(words):
            if part[:2] == ["docker", "build"]:
                continue
            at = next((i for i, word in enumerate(part) if word == "wakesurf" or word.endswith("/bin/wakesurf")), None)
            if at is not None and (part[at - 1] not in ("-v", "-t") if at else True):
                arguments = part[at + 1:]
                in_image = "docker" in part and (not arguments or arguments[0].startswith(("/", "--listen", "--origin")))
                yield ["serve", *arguments] if in_image else arguments


def inline_calls(text):
    """The same of what stands between backticks in prose: `wakesurf info FILE`."""
    for words in re.findall(r"`(wakesurf [^`]*)`", FENCE.sub("", text)):
        yield from wakesurf_calls(words)
