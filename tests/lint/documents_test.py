#!/usr/bin/env python3
"""No document and no comment cites a document that is not here, and no document a source file that is not.

Standard library only. Run it alone with: python3 tests/lint/documents_test.py
"""
import os
import re
import subprocess
import sys
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SOURCE = (".cpp", ".hpp", ".ts", ".py", ".sh", ".md", ".css", ".txt", ".cff")

LINK = re.compile(r"\[[^\]]*\]\((?!https?:)([^)#\s]+)(?:#[^)]*)?\)")
CITED = re.compile(r"(?<![\w/.-])((?:[\w.-]+/)*[\w-]+\.md)\b")
NAMED = re.compile(r"(?<![\w/.*>-])((?:[\w-]+/)*[a-z][\w.-]*\.(?:hpp|cpp|ts))\b")  # NOUN_methods.cpp and *_test.cpp stand for many


def files():
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "--cached", "--others", "--exclude-standard"],
                            capture_output=True, text=True, check=True).stdout.split("\n")
    return [path for path in listed if path and os.path.isfile(os.path.join(ROOT, path))]


def text_of(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


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


def missing_sources(path, text, all_files):
    """Source files are named from the root, from a folder on the way to the document, or by their ends."""
    if path.endswith(".md"):
        known = {each[i:] for each in all_files for i in (0, *(found.end() for found in re.finditer("/", each)))}
        for match in NAMED.finditer(text):
            if match.group(1) not in known and not re.search("[A-Z]{3}", match.group(1)):
                yield f"{path}:{text.count(chr(10), 0, match.start()) + 1}: names {match.group(1)}, which is not in the repository"


class Documents(unittest.TestCase):
    maxDiff = None

    def test_that_are_cited_are_in_the_repository(self):
        self.assertEqual([each for path in files() if path.endswith(SOURCE) for each in missing_documents(path, text_of(path))], [])

    def test_name_source_files_that_are_in_the_repository(self):
        there = files()
        self.assertEqual([each for path in there if path.endswith(".md") for each in missing_sources(path, text_of(path), there)], [])


class TheLinter(unittest.TestCase):
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

    def test_finds_source_files_that_are_not_there(self):
        there = ["core/base/result.hpp", "web-client/src/ui/app.ts"]
        self.assertEqual(list(missing_sources("a.md", "see base/result.hpp, `app.ts` and *_test.cpp; NOUN_methods.cpp", there)), [])
        self.assertEqual(len(list(missing_sources("a.md", "see `core/result.hpp`\nand told_words.hpp", there))), 2)

    def test_sees_the_project(self):
        self.assertIn("README.md", files())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]] + sys.argv[1:])
