"""The documents as mkdocs takes them: copied with what they link to, and written as its Markdown reads them.

GitHub's Markdown begins a list or a table without an empty line before it and nests lists by two spaces; that of mkdocs does not.
"""
import os
import re
import shutil

from . import outputs
from .base import ROOT, read

SETTINGS = "docs/site/mkdocs.yml"
LINK = re.compile(r"\[[^\]]*\]\((?!\w+:)([^)#\s]+)(?:#[^)]*)?\)")
FENCE = re.compile(r"^( *)(```)(\w*)[^`]*$")
ITEM = re.compile(r"^( *)([-*+]|\d+\.) ")


def settings_pages():
    """Documents that the navigation names."""
    return re.findall(r"([\w./-]+\.md)$", read(SETTINGS), re.M)


def linked(path, text):
    """Files of the repository that a document links to."""
    for target in LINK.findall(text):
        found = os.path.normpath(os.path.join(os.path.dirname(path), target))
        if not found.startswith("..") and os.path.isfile(os.path.join(ROOT, found)):
            yield found


def documents():
    """Paths of all documents of the site, and of the other files that they link to."""
    found, waiting = [], settings_pages()
    while waiting:
        path = waiting.pop()
        if path in found:
            continue
        found.append(path)
        if path.endswith(".md"):
            waiting += linked(path, read(path))
    return sorted(found)


def rewritten(text):
    """For mkdocs: the same document."""
    out, fence = [], False
    for line in text.split("\n"):
        marks = FENCE.match(line)
        before = out[-1] if out else ""
        if marks:
            fence = not fence
            line = marks.group(1) + marks.group(2) + (marks.group(3) if fence else "")
        elif not fence:
            item, table = ITEM.match(line), line.startswith("|")
            inside = before.strip() == "" or ITEM.match(before) or before.startswith((" ", "#"))
            if (item and item.group(1) == "" and not inside) or (table and before.strip() and not before.startswith(("|", "#"))):
                out.append("")
            if item or before.startswith("    "):
                line = re.sub(r"^( +)", lambda spaces: spaces.group(1) * 2, line)
        out.append(line)
    return "\n".join(out)


def stage(folder):
    """Copies all documents into the folder, with what the program adds to them; the paths of those that are pages."""
    pages, additions = [], outputs.from_program()
    for path in documents():
        full = os.path.join(folder, path)
        os.makedirs(os.path.dirname(full), exist_ok=True)
        if path.endswith(".md"):
            pages.append(path)
            with open(full, "w", encoding="utf-8") as file:
                file.write(rewritten("\n".join([read(path), *filter(None, [additions.get(path)])])))
        else:
            shutil.copyfile(os.path.join(ROOT, path), full)
    return pages


def write_settings(path, pages, site):
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"{read(SETTINGS)}docs_dir: {pages}\nsite_dir: {site}\n")
