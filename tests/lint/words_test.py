#!/usr/bin/env python3
"""Keeps the words of docs/glossary.md to their meanings.

A rule is a function of (path, text) that yields messages; BAD and GOOD hold for each rule what it must and must not flag.
Standard library only. Run it alone with: python3 tests/lint/words_test.py
"""
import os
import re
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from documents_test import files, text_of  # noqa: E402

# `color` where others' interfaces have it: names of three.js and of the DOM, and contexts in which they are used.
THEIR_NAMES = {"Color", "SrcColorFactor", "setClearColor", "getClearColor", "SRGBColorSpace", "colorSpace", "vertexColors", "colorScheme",
               "backgroundColor", "borderColor", "borderTopColor", "borderLeftColor", "currentColor", "gl_FragColor",
               "colorspace_fragment", "colorspace"}
THEIR_CONTEXT = re.compile(
    r"type=.color|\[type=.color|\bmaterial\.color\b|Lights\[i\]\.color\b|\bstyle\.color\b|state\.buffers|\bcolor\.set(Mask|Locked)\b|setAttribute\('color'|"
    r"[\w-]+-color\b|\bcolor-|\bcolor: (0x|colour\b|var\(|light-dark|rgb|#|inherit|transparent)|color: rgb")
COLOR = re.compile(r"\b\w*[cC]olor\w*\b")

# Types named by a word with a home: the word, and the product's files that may declare one.
HOMES = {
    "Turn": ("server/service/compute/fair_queue.hpp",),
    "Lane": (),
    "Place": ("server/net/downloads.hpp", "server/service/session/records/change_log.hpp", "core/field/cells/box_tree.hpp"),
    "Places": ("protocol/wire/wire_match.hpp",),
    "History": ("server/service/session/records/history.hpp",),
    "Cell": ("core/surface/quad_complex.hpp",),
}
DECLARED = re.compile(r"^[ \t]*(?:struct|class|enum class|enum|using)[ \t]+(\w+)(?=[ \t]*(?:\{|;|:|=|final\b|$))", re.MULTILINE)

# Rooms whose comments in front of declarations are sentences. The list grows.
ROOMS_OF_SENTENCES = re.compile(r"(core|store|importer|command|protocol/(api(?!/generated)|wire|files)|tests/support|server)/.*\.(hpp|cpp)$")
WITHOUT_SUBJECT = re.compile(r"(Of|As|The same|What|Whether|Who|How|So many|That)\b(?! is why)")
LONGEST_COMMENT = 110
# The page's comments: those that stand alone or behind code; one in front of a declaration may begin on the line below its `/**`.
PAGE_OF_SENTENCES = re.compile(r"web-client/src/(?!.*\bgenerated/).*\.ts$")
PAGE_COMMENT = re.compile(r"^\s*(//|/\*\*|\*) |[;,{}()] // ")


def line_of(text, offset):
    return text.count("\n", 0, offset) + 1


def spelt_color(path, text):
    """Our names say colour."""
    if not re.match(r"(web-client/(src|tools)|tests/(end_to_end|fuzz))/.*\.ts$", path):
        return
    for number, line in enumerate(text.split("\n"), 1):
        if THEIR_CONTEXT.search(line):
            continue
        for match in COLOR.finditer(re.sub(r"^\s*(//|\*|/\*\*).*", "", line)):
            if match.group() not in THEIR_NAMES:
                yield f"{path}:{number}: {match.group()}: our own names say colour"


def word_away_from_home(path, text):
    """A type with a word of the glossary for its name, where the word means something else."""
    if not re.match(r"(command|core|importer|protocol|server|store)/.*\.(hpp|cpp)$", path):
        return
    for match in DECLARED.finditer(text):
        homes = HOMES.get(match.group(1))
        if homes is not None and path not in homes:
            yield (f"{path}:{line_of(text, match.start())}: a type {match.group(1)}: docs/glossary.md has another meaning for "
                   "this word; choose one that says what this is")


def comment_that_is_no_sentence(path, text):
    """A comment in front of a declaration, or at the head of a file, begins with a word that leaves out its subject or its verb."""
    page = PAGE_OF_SENTENCES.match(path)
    if not page and not ROOMS_OF_SENTENCES.match(path):
        return
    document = r"\s*/\*\* ?(.*)" if page else r"\s*///(?!<) ?(.*)"
    before = ""
    # What stands on the line below a lone `/**` begins that comment.
    for number, line in enumerate(re.sub(r"/\*\*\n\s*\* ", "\n/** ", text).split("\n") if page else text.split("\n"), 1):
        comment = re.match(document if number > 1 else r"//+ (.*)", line)
        begins = comment is not None and WITHOUT_SUBJECT.match(comment.group(1))
        if begins and not before.startswith("//"):
            yield (f"{path}:{number}: {begins.group(1)}: say it in a sentence with subject and verb: `Returns ...`, `Holds ...`, "
                   "`The ... is ...`")
        before = line.strip()


def comment_out_of_its_place(path, text):
    """A comment that goes beyond a column, or stands behind a declaration that it breaks into lines."""
    if PAGE_OF_SENTENCES.match(path):
        for number, line in enumerate(text.split("\n"), 1):
            if len(line) > LONGEST_COMMENT and PAGE_COMMENT.search(line):
                yield f"{path}:{number}: a comment ends before column {LONGEST_COMMENT}"
        return
    if not ROOMS_OF_SENTENCES.match(path):
        return
    before = ""
    for number, line in enumerate(text.split("\n"), 1):
        code, mark, _ = line.partition("//")
        if mark and len(line) > LONGEST_COMMENT:
            yield f"{path}:{number}: a comment ends before column {LONGEST_COMMENT}"
        if "///<" in line and (not code.strip() or not re.search(r"(^|[;{},:])$", before)):
            yield f"{path}:{number}: a comment of a declaration of several lines stands above it"
        before = code.strip()


RULES = [spelt_color, word_away_from_home, comment_that_is_no_sentence, comment_out_of_its_place]

BAD = [
    (spelt_color, "web-client/src/a.ts", "const rakeColor = 1;\n"),
    (spelt_color, "web-client/src/a.ts", "interface A {\n    color: string;\n}\n"),
    (spelt_color, "tests/end_to_end/a.spec.ts", "expectColor(a);\n"),
    (word_away_from_home, "server/net/a.hpp", "    struct Place {\n"),
    (word_away_from_home, "core/a.cpp", "using Turn = std::function<void()>;\n"),
    (word_away_from_home, "server/service/session/a.hpp", "enum class Lane { A, B };\n"),
    (comment_that_is_no_sentence, "core/a.hpp", "// How far it is.\n#pragma once\n"),
    (comment_that_is_no_sentence, "core/a.hpp", "struct A {\n    /// Of the budget.\n    double part;\n"),
    (comment_that_is_no_sentence, "core/a.cpp", "/// The same of a text.\nvoid f();\n"),
    (comment_that_is_no_sentence, "store/a.cpp", "/// What it takes.\nint bytes();\n"),
    (comment_that_is_no_sentence, "store/a.hpp", "int a;\n/// Whether it is there, in a\n/// sentence of two lines.\nbool b;\n"),
    (comment_that_is_no_sentence, "web-client/src/a.ts", "// How far it is.\nconst far = 1;\n"),
    (comment_that_is_no_sentence, "web-client/src/a.ts", "const a = 1;\n/** Of the budget. */\nconst part = 2;\n"),
    (comment_that_is_no_sentence, "web-client/src/a.ts", "const a = 1;\n/**\n * Whether it is there.\n */\nfunction is() {}\n"),
    (comment_out_of_its_place, "web-client/src/a.ts", "/** " + "word " * 22 + "*/\n"),
    (comment_out_of_its_place, "web-client/src/a.ts", "const a = 1; // " + "word " * 20 + "\n"),
    (comment_out_of_its_place, "core/a.hpp", "    double from =\n        0.0; ///< where it starts\n"),
    (comment_out_of_its_place, "core/a.hpp", "    double to; ///< where it\n               ///< ends\n"),
    (comment_out_of_its_place, "core/a.cpp", "/// " + "word " * 22 + "\n"),
]
GOOD = [
    (spelt_color, "web-client/src/a.ts", "import { Color } from 'three';\nmesh.material.color.set(colour);\n"),
    (spelt_color, "web-client/src/a.ts", "    color: var(--quiet);\n    border-left-color: red;\n"),
    (spelt_color, "web-client/src/a.ts", "new LineBasicMaterial({ color: 0xb4bcc9 });\n// the color of it\n"),
    (spelt_color, "server/a.ts", "const color = 1;\n"),
    (word_away_from_home, "server/service/compute/fair_queue.hpp", "    struct Turn {\n"),
    (word_away_from_home, "server/net/a.cpp", "Admission::Place place;\nstruct PlaceOfMine {};\n"),
    (word_away_from_home, "tests/core/a.cpp", "struct Turn {\n"),
    (comment_that_is_no_sentence, "core/a.hpp", "/// Returns what it takes, in bytes.\nint bytes();\n"),
    (comment_that_is_no_sentence, "core/a.hpp", "/// Returns bytes.\n/// What is free is left out.\nint bytes();\n"),
    (comment_that_is_no_sentence, "core/a.cpp", "    // What fits is kept.\n    keep();\n"),
    (comment_that_is_no_sentence, "core/a.cpp", "/// Asks for more.\nvoid f();\n"),
    (comment_that_is_no_sentence, "tests/core/a.hpp", "/// What it takes.\nint bytes();\n"),
    (comment_that_is_no_sentence, "web-client/src/a.ts", "const a = 1;\n/** Returns what it takes. */\nfunction takes() {}\n"),
    (comment_that_is_no_sentence, "web-client/src/a.ts", "/** Returns bytes.\n *  What is free is left out. */\nfunction b() {}\n"),
    (comment_that_is_no_sentence, "web-client/src/protocol/generated/a.ts", "/** Of the budget. */\nconst part = 2;\n"),
    (comment_out_of_its_place, "web-client/src/a.ts", "const a = 'https://x.org'; const b = '" + "word " * 22 + "';\n"),
    (comment_out_of_its_place, "core/a.hpp", "    double to = 1.0; ///< where it ends\n    double from; ///< and begins\n"),
    (comment_out_of_its_place, "core/a.hpp", "  private:\n    double to; ///< where it ends\n"),
    (comment_out_of_its_place, "core/a.hpp", "enum A {\n    B, ///< one\n    C ///< the other\n};\n"),
    (comment_out_of_its_place, "tests/core/a.cpp", "/// " + "word " * 22 + "\n"),
]


class Words(unittest.TestCase):
    maxDiff = None


def rule_test(rule):
    def test(self):
        self.assertEqual([each for path in files() if path.endswith((".ts", ".hpp", ".cpp")) for each in rule(path, text_of(path))], [])
    return test


for each in RULES:
    setattr(Words, "test_" + each.__name__, rule_test(each))


class TheLinter(unittest.TestCase):
    def test_flags_every_bad_sample(self):
        for rule, path, text in BAD:
            with self.subTest(rule=rule.__name__, text=text):
                self.assertTrue(list(rule(path, text)))

    def test_leaves_every_good_sample_alone(self):
        for rule, path, text in GOOD:
            with self.subTest(rule=rule.__name__, text=text):
                self.assertEqual(list(rule(path, text)), [])

    def test_knows_only_homes_that_there_are(self):
        for word, homes in HOMES.items():
            for home in homes:
                with self.subTest(word=word, home=home):
                    self.assertIn(word, DECLARED.findall(text_of(home)))

    def test_finds_each_of_its_words_in_the_glossary(self):
        glossary = text_of("docs/glossary.md").lower()
        for word in HOMES:
            self.assertIn(f"**{word.lower().rstrip('s')}", glossary)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]] + sys.argv[1:])
