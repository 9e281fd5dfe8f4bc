"""docs/reference/command-line.md: what every command says with --help."""
import re

from .base import MADE, said

INTRO = """# Command line

What each command prints with `--help`. A line of output is about one thing and goes to standard output; progress and errors go to standard error.
The exit status is 0, 1 where the work could not be done, or 2 where the command was misused.

"""


def commands(help_text):
    """Names of subcommands."""
    section = re.search(r"^Subcommands:\n((?:  .*\n?)+)", help_text, re.M)
    return re.findall(r"^  (\w[\w-]*) ", section.group(1), re.M) if section else []


def told(*command):
    shown = said(*command, "--help").strip("\n")
    parts = [f"{'#' * (2 + max(0, len(command) - 1))} {' '.join(('wakesurf', *command))}\n\n```text\n{shown}\n```\n"]
    for each in commands(shown):
        parts += told(*command, each)
    return parts


def text():
    return MADE.format(source="wakesurf --help") + INTRO + "\n".join(told())


def options(help_text):
    """Every option that a help text names."""
    return set(re.findall(r"(?<![\w-])(--?[A-Za-z][\w-]*)", help_text))
