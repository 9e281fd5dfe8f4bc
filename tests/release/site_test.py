#!/usr/bin/env python3
"""The documents as a site, which builds without a dead link. Needs mkdocs-material."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "docs", "site"))
sys.path.insert(0, os.path.join(ROOT, "tests", "lint"))
from documents_test import files, text_of  # noqa: E402
from pages import links, staging  # noqa: E402


class Site(unittest.TestCase):
    maxDiff = None

    def test_has_every_document_of_the_repository(self):
        there = {path for path in files() if path.endswith(".md") and path != "AGENTS.md"}  # which only leads to another
        self.assertEqual(there - set(staging.settings_pages()), set())

    @unittest.skipUnless(shutil.which("mkdocs"), "mkdocs-material is not installed")
    def test_builds_without_warnings_dead_links_or_requests_to_other_servers(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, os.path.join(ROOT, "docs", "site", "build"), os.path.join(folder, "site")],
                                  capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)


class TheLinkCheck(unittest.TestCase):
    def faults(self, **pages):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in pages.items():
                with open(os.path.join(folder, name.replace("_", ".")), "w", encoding="utf-8") as file:
                    file.write(text)
            return links.faults(folder)

    def test_finds_dead_links_missing_headings_and_foreign_requests(self):
        bad = ['<a href="b.html">', '<a href="#no">', '<a href="c.html#no">', '<img src="https://x.org/a.png">', '<img src="no.png">',
               '<script src="//x.org/a.js">', '<link rel="stylesheet" href="https://x.org/a.css">']
        for text in bad:
            with self.subTest(text):
                self.assertEqual(len(self.faults(a_html=text, c_html='<p id="yes">')), 1)
        self.assertEqual(len(self.faults(a_html="", b_css="a { background: url(https://x.org/a.png) }")), 1)

    def test_lets_good_ones_pass(self):
        good = ['<a href="c.html#yes">', '<a href="https://x.org">', '<a href="#here"><p id="here">', '<img src="data:image/png;base64,a">',
                '<link rel="canonical" href="https://x.org/">']
        for text in good:
            with self.subTest(text):
                self.assertEqual(self.faults(a_html=text, c_html='<p id="yes">'), [])


class Staging(unittest.TestCase):
    def test_writes_lists_and_tables_as_mkdocs_reads_them(self):
        self.assertEqual(staging.rewritten("text:\n- a\n  more\n- b\n  - c\n"), "text:\n\n- a\n  more\n- b\n    - c\n")
        self.assertEqual(staging.rewritten("text\n| a |\n|---|"), "text\n\n| a |\n|---|")
        self.assertEqual(staging.rewritten("```sh run\n- a\n| b |\n```"), "```sh\n- a\n| b |\n```")


if __name__ == "__main__":
    unittest.main()
