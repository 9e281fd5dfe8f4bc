"""What the makers of pages share: where things are, the description of the API, the program, tables."""
import json
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
sys.path.insert(0, os.path.join(ROOT, "protocol", "api"))
MADE = "<!-- Made by docs/site/generate from {source}: do not edit. -->\n"


def binary():
    return os.environ.get("WAKESURF_BINARY", os.path.join(ROOT, "build/release/bin/wakesurf"))


def said(*arguments, check=True):
    """What the program prints, in an environment that changes no default."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("WAKESURF_")}
    done = subprocess.run([binary(), *arguments], capture_output=True, text=True, timeout=60, check=False, env=environment)
    if check and done.returncode != 0:
        raise RuntimeError(done.stderr)
    return done.stdout if check else done.stdout + done.stderr


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def read_json(path):
    return json.loads(read(path))


def api():
    """The description of the API, as its own generator reads it."""
    from generator import schema
    return schema.load()


def cell(text):
    return str(text).replace("|", "\\|").replace("\n", " ")


def table(titles, rows):
    lines = ["| " + " | ".join(titles) + " |", "|" + "---|" * len(titles)]
    return "\n".join(lines + ["| " + " | ".join(cell(each) for each in row) + " |" for row in rows]) + "\n"


def number(value):
    return f"{value:,}" if isinstance(value, int) and abs(value) >= 10000 else f"{value:g}" if isinstance(value, float) else str(value)
