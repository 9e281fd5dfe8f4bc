"""All pages that are made, by path from the root of the repository."""
import os

from . import command_line, errors, gallery, metrics
from .base import ROOT


def from_files():
    """path -> text, of pages that are checked in."""
    return {
        "docs/troubleshooting.md": errors.text(),
        "docs/gallery.md": gallery.text(),
    }


def from_program():
    """path -> text, of what the program says, which the site has at the end of a page."""
    return {
        "docs/reference/command-line.md": command_line.text(),
        "docs/reference/metrics.md": metrics.text(),
    }


def kept(path):
    try:
        with open(os.path.join(ROOT, path), encoding="utf-8") as file:
            return file.read()
    except FileNotFoundError:
        return None


def write(path, text):
    full = os.path.join(ROOT, path)
    os.makedirs(os.path.dirname(full), exist_ok=True)
    with open(full, "w", encoding="utf-8") as file:
        file.write(text)
