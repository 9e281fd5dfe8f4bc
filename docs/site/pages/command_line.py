"""What every command says with --help."""
import re

from .base import said


def commands(help_text):
    """Names of subcommands."""
    section = re.search(r"^Subcommands:\n((?:  .*\n?)+)", help_text, re.M)
    return re.findall(r"^  (\w[\w-]*) ", section.group(1), re.M) if section else []


def help_sections(*command):
    shown = said(*command, "--help").strip("\n")
    parts = [f"{'#' * (2 + max(0, len(command) - 1))} {' '.join(('wakesurf', *command))}\n\n```text\n{shown}\n```\n"]
    for each in commands(shown):
        parts += help_sections(*command, each)
    return parts


def text():
    return "\n".join(help_sections())


def options(help_text):
    """Every option that a help text names."""
    return set(re.findall(r"(?<![\w-])(--?[A-Za-z][\w-]*)", help_text))
