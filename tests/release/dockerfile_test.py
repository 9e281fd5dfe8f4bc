#!/usr/bin/env python3
"""What docker/Dockerfile copies is there, and .dockerignore lets it through; every room the build names is copied."""
import os
import re
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def lines_of(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read().split("\n")


def copied():
    """Sources of each COPY from the build's context."""
    for line in lines_of("docker/Dockerfile"):
        words = line.split()
        if words[:1] == ["COPY"] and not any(word.startswith("--from=") for word in words):
            yield from (word for word in words[1:-1] if not word.startswith("--"))


def let_through():
    return {line[1:] for line in lines_of(".dockerignore") if line.startswith("!")}


class Image(unittest.TestCase):
    def test_what_is_copied_is_let_through_and_there(self):
        for source in copied():
            with self.subTest(source):
                self.assertIn(source.split("/")[0], let_through())
                self.assertTrue(os.path.exists(os.path.join(ROOT, source)))

    def test_every_room_that_the_build_adds_without_tests_is_copied(self):
        text = "\n".join(lines_of("CMakeLists.txt"))
        rooms = re.findall(r"^add_subdirectory\((\w[\w/]*)\)", text, re.MULTILINE)
        self.assertGreaterEqual(len(rooms), 4)
        for room in rooms:
            with self.subTest(room):
                self.assertIn(room.split("/")[0], set(copied()))


if __name__ == "__main__":
    unittest.main()
