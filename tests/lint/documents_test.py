#!/usr/bin/env python3
"""What keeps documents readable and true: paragraphs of at most 80 words, READMEs of rooms of at most 120 lines, and no citation of
a document that is not here.

Standard library only. Run it alone with: python3 tests/lint/documents_test.py
"""
import os
import re
import subprocess
import sys
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MOST_WORDS = 80
MOST_LINES = 120
SOURCE = (".cpp", ".hpp", ".ts", ".py", ".sh", ".md", ".css", ".txt", ".cff")

LINK = re.compile(r"\[[^\]]*\]\((?!https?:)([^)#\s]+)(?:#[^)]*)?\)")
CITED = re.compile(r"(?<![\w/.-])((?:[\w.-]+/)*[\w-]+\.md)\b")


def files():
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "--cached", "--others", "--exclude-standard"],
                            capture_output=True, text=True, check=True).stdout.split("\n")
    return [path for path in listed if path and os.path.isfile(os.path.join(ROOT, path))]


def text_of(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def paragraphs(text):
    """(line, words) of each block of prose: a paragraph, an item of a list, a cell of a table. Code is none."""
    block, start, in_code = [], 0, False
    for number, line in enumerate(text.split("\n") + [""], 1):
        stripped = line.strip()
        fence = stripped.startswith("```")
        in_code ^= fence
        apart = fence or in_code or stripped == "" or stripped.startswith(("#", "|"))
        if block and (apart or re.match(r"([-*+]|\d+\.)\s", stripped)):
            yield start, " ".join(block)
            block = []
        if stripped.startswith("|") and not in_code:
            for cell in stripped.strip("|").split("|"):
                yield number, cell
        if not apart:
            start = start if block else number
            block.append(stripped)


def long_paragraphs(path, text):
    if path.endswith(".md"):
        for line, words in paragraphs(text):
            count = len(words.split())
            if count > MOST_WORDS:
                yield f"{path}:{line}: a paragraph of {count} words, at most {MOST_WORDS}: split it, or make a list of it"


def long_readme(path, text):
    """A README of a room says what it holds, what it may touch and who waits for whom; docs/ has longer things."""
    lines = len(text.splitlines())
    if os.path.basename(path) == "README.md" and not path.startswith("docs/") and lines > MOST_LINES:
        yield f"{path}: {lines} lines, at most {MOST_LINES}: give a folder of the room a README of its own, or docs/ a page"


def missing_documents(path, text, there=None):
    """Links of documents, and names of documents in comments, must lead to files of this repository."""
    there = there or (lambda target: os.path.exists(os.path.join(ROOT, target)))
    if path.endswith((".spec.ts", "documents_test.py", "THIRD_PARTY.txt")) or not path.endswith(SOURCE):
        return
    pattern = LINK if path.endswith(".md") else CITED
    for match in pattern.finditer(text):
        target = match.group(1)
        beside = os.path.normpath(os.path.join(os.path.dirname(path), target))
        if not there(beside) and not there(target):
            line = text.count("\n", 0, match.start()) + 1
            yield f"{path}:{line}: names {target}, which is not in the repository"


def found(rule):
    return [each for path in files() if path.endswith(SOURCE) for each in rule(path, text_of(path))]


class Documents(unittest.TestCase):
    maxDiff = None

    def test_have_no_paragraph_of_more_than_80_words(self):
        self.assertEqual(found(long_paragraphs), [])

    def test_of_a_room_have_at_most_120_lines(self):
        self.assertEqual(found(long_readme), [])

    def test_that_are_cited_are_in_the_repository(self):
        self.assertEqual(found(missing_documents), [])


class TheLinter(unittest.TestCase):
    def test_counts_the_words_of_each_block_by_itself(self):
        long = "word " * 81
        for text in (long, "- " + long, "| a | " + long + " |", "# head\n" + long + "\n\nmore"):
            with self.subTest(text=text[:20]):
                self.assertEqual(len(list(long_paragraphs("a.md", text))), 1)
        short = "word " * 50
        for text in (short + "\n\n" + short, "- " + short + "\n- " + short, "```\n" + long + "\n```",
                     "| " + short + " | " + short + " |", "1. " + short + "\n2. " + short):
            with self.subTest(text=text[:20]):
                self.assertEqual(list(long_paragraphs("a.md", text)), [])
        self.assertEqual(list(long_paragraphs("a.cpp", long)), [])

    def test_counts_the_lines_of_a_readme_of_a_room(self):
        for path, lines in [("server/net/README.md", MOST_LINES + 1), ("README.md", MOST_LINES + 1)]:
            with self.subTest(path=path, lines=lines):
                self.assertEqual(len(list(long_readme(path, "a\n" * lines))), 1)
        for path, lines in [("server/net/README.md", MOST_LINES), ("docs/notebooks/README.md", MOST_LINES + 1),
                            ("protocol/wire/FORMAT.md", MOST_LINES + 1)]:
            with self.subTest(path=path, lines=lines):
                self.assertEqual(list(long_readme(path, "a\n" * lines)), [])

    def test_finds_documents_that_are_not_there(self):
        there = {"docs/a.md", "core/README.md"}.__contains__
        bad = [("core/a.hpp", "// measured (performance.md 3.1)\n"), ("core/a.cpp", "// docs/b.md, Pages\n"),
               ("README.md", "see [a](docs/none.md)\n"), ("docs/a.md", "[b](b.md#part)\n")]
        good = [("core/a.hpp", "// docs/a.md, Pages\n"), ("core/a.hpp", "// README.md has it\n"),
                ("README.md", "see [a](docs/a.md#part), [b](https://x.org/c.md), and none.md in words\n")]
        for path, text in bad:
            with self.subTest(path=path, text=text):
                self.assertEqual(len(list(missing_documents(path, text, there))), 1)
        for path, text in good:
            with self.subTest(path=path, text=text):
                self.assertEqual(list(missing_documents(path, text, there)), [])

    def test_sees_the_project(self):
        self.assertIn("README.md", files())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]] + sys.argv[1:])
