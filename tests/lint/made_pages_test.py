#!/usr/bin/env python3
"""Made documents are what docs/site/generate makes of them today, and the pictures of the documents are there."""
import os
import re
import sys
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "docs", "site"))
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from documents_test import files, text_of  # noqa: E402
from pages import errors, gallery, outputs  # noqa: E402

PICTURES = os.path.join(ROOT, "docs", "pictures")
BY_OTHERS = ["paraview.webp"]  # not of the gallery: docs/how-to/paraview.md says how it was made
PICTURE_BYTES, FILM_BYTES = 60_000, 3_000_000


class MadePages(unittest.TestCase):
    maxDiff = None

    def test_are_what_generate_makes(self):
        for path, text in outputs.from_files().items():
            with self.subTest(path):
                self.assertEqual(outputs.kept(path), text, "run docs/site/generate")

    def test_have_an_entry_for_every_kind_of_error(self):
        page, api = text_of("docs/troubleshooting.md"), errors.api()
        answers = errors.error_kinds(api)
        kinds = [*answers, *errors.notice_kinds(api), *errors.empty_kinds(), *errors.client_kinds(answers)]
        self.assertGreater(len(kinds), 35)
        for kind in kinds:
            with self.subTest(kind):
                self.assertRegex(page, rf"(?m)^### {kind}$")

    def test_refuse_a_kind_without_words_and_words_without_a_kind(self):
        for there, words in ((["a", "b"], ["a"]), (["a"], ["a", "b"])):
            with self.assertRaises(ValueError):
                errors.differences(there, words, "errors")
        self.assertIn("unsupported", errors.kinds_in_code())
        self.assertIn("carefulStart", errors.notice_kinds(errors.api()))


class Pictures(unittest.TestCase):
    def test_of_the_gallery_are_there_and_no_others(self):
        scenes = gallery.scenes()
        self.assertGreaterEqual(len(scenes), 16)
        film = gallery.read_json(gallery.SCENES)["film"]["name"] + ".png"
        self.assertEqual(sorted(os.listdir(PICTURES)), sorted([*(f"{each['name']}.webp" for each in scenes), film, *BY_OTHERS]))

    def test_are_small(self):
        for name in os.listdir(PICTURES):
            with self.subTest(name):
                self.assertLessEqual(os.path.getsize(os.path.join(PICTURES, name)), PICTURE_BYTES if name.endswith(".webp") else FILM_BYTES)

    def test_of_documents_have_words_for_those_who_cannot_see_them(self):
        for path in files():
            if path.endswith(".md"):
                for words, target in re.findall(r"!\[([^\]]*)\]\(([^)]*)\)", text_of(path)):
                    with self.subTest(path=path, target=target):
                        self.assertGreater(len(words), 5)


if __name__ == "__main__":
    unittest.main()
