"""docs/reference/formats.md: what is read, from the importer's own document, and what is written, from that of the writers."""
import re

from .base import MADE, UP, read

INTRO = """# Formats

What wakesurf reads and writes. `wakesurf info FILE` shows what was understood of your data before anything is converted.

## What is read

Velocity may be a vector, three fields with the names of components, or momentum over density. Data are converted once, and sampled on their own
grid: uniform, rectilinear, curvilinear or unstructured. Planes are given a thickness. What moves its mesh or has curved cells is refused with the
reason.

"""

IN_PLACE = f"""Arrays of **Zarr** are served where they are, in a folder or on the web, without an import:
[larger than memory]({UP}docs/how-to/larger-than-memory.md#arrays-of-zarr-where-they-are)."""


def section(document, title):
    """The text below a heading, up to the next."""
    return re.search(rf"^## {re.escape(title)}\n(.*?)(?=^## |\Z)", read(document), re.S | re.M).group(1).strip("\n")


def first_table(text):
    return re.search(r"^\|.*?(?=^[^|]|\Z)", text, re.S | re.M).group(0).strip("\n")


def without_code_places(text):
    """Without the names of files of code, which are for contributors."""
    return re.sub(r" \((?:fields|sources)/[^)]*\)", "", re.sub(r"\((?:fields|sources)/[^)]*, ", "(", text))


def written():
    tables = re.findall(r"^\| format \|.*?(?=^[^|])", read("protocol/files/README.md"), re.S | re.M)
    return tables[0].strip("\n")


def text():
    units = without_code_places(section("importer/README.md", "Units"))
    units = re.sub(r",\s*by\s*\n?UDUNITS(?: \((?:fields|sources)/[^)]*\))?", ", by UDUNITS", units)
    return (MADE.format(source="importer/README.md and protocol/files/README.md") + INTRO
            + first_table(section("importer/README.md", "Formats")).replace(", see Files that a source names", "")
            + "\n\n" + IN_PLACE + "\n\n## Units\n\n" + units
            + "\n\n## What is written\n\n`wakesurf surface -o FILE`, **Export** in the page and `Surface.export` in Python write the same files. The "
            "extension chooses the format.\n\n" + written()
            + "\n\nParaView opens `.vtp` with every array. For its `.glb` reader, and any other without Draco, ask for a plain one: `--no-draco`.\n"
            + "\n## The store\n\nImported data lie in a folder of raw time-steps with a manifest, which numpy reads too: "
            f"[store]({UP}store/README.md). Time-steps whose velocity is\nlarger than 1 GiB lie in bricks (`--layout`). A store can always be made again from the simulation's results.\n")
