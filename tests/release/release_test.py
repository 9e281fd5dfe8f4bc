"""packaging/release with a check of paper: what it changes when all is green, and that it changes nothing otherwise. And packaging/version,
built_commit.cmake: what they say of a tagged commit, of another, of changed files and of an archive."""
import os
import shutil
import subprocess
import tempfile
import unittest

from real_server import ROOT

FILES = ("CMakeLists.txt", "CITATION.cff", "CHANGELOG.md", "docs/versions.md", "web-client/package.json",
         "web-client/package-lock.json", "packaging/release", "packaging/version", "packaging/commit.txt", ".gitattributes",
         "server/app/built_commit.cmake")
CHECK = '#!/bin/sh\necho "$*" >>"$0.calls"\n[ "$*" != "$RED" ]\n'


class Repository(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = os.path.join(folder.name, "sources")
        self.outside = folder.name
        for path in FILES:
            os.makedirs(os.path.dirname(os.path.join(self.root, path)), exist_ok=True)
            shutil.copy(os.path.join(ROOT, path), os.path.join(self.root, path))
        self.write("check", CHECK)
        os.chmod(os.path.join(self.root, "check"), 0o755)
        self.write(".gitignore", "*.calls\n")
        self.write("CHANGELOG.md", "# Changes\n\n## Not released yet\n- **New**: # it can fly.\n\n## 0.1.0\n- old\n")
        self.old = self.said("packaging/version").split("\n")[0].split("=")[1]
        self.git("init", "--quiet")
        self.git("add", "--all")
        self.git("commit", "--quiet", "-m", "all")

    def write(self, path, text):
        with open(os.path.join(self.root, path), "w", encoding="utf-8") as file:
            file.write(text)

    def text_of(self, path):
        with open(os.path.join(self.root, path), encoding="utf-8") as file:
            return file.read()

    def git(self, *words):
        who = ["-c", "user.name=a", "-c", "user.email=a@b.org"]
        return subprocess.run(["git", "-C", self.root, *who, *words], check=True, capture_output=True, text=True).stdout.strip()

    def run_script(self, *words, red="nothing"):
        environment = {**os.environ, "RED": red, "GIT_AUTHOR_NAME": "a", "GIT_AUTHOR_EMAIL": "a@b.org",
                       "GIT_COMMITTER_NAME": "a", "GIT_COMMITTER_EMAIL": "a@b.org"}
        return subprocess.run([os.path.join(self.root, words[0]), *words[1:]], env=environment, capture_output=True, text=True)

    def said(self, *words):
        ran = self.run_script(*words)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        return ran.stdout


class ReleaseTest(Repository):
    def assert_refused(self, *words, because, red="nothing"):
        before = self.git("rev-parse", "HEAD"), self.git("status", "--porcelain"), self.git("tag")
        ran = self.run_script("packaging/release", *words, red=red)
        self.assertNotEqual(ran.returncode, 0)
        self.assertIn(because, ran.stderr)
        self.assertEqual((self.git("rev-parse", "HEAD"), self.git("status", "--porcelain"), self.git("tag")), before)

    def test_a_green_release_is_one_commit_with_the_version_everywhere_and_a_tag_with_its_notes(self):
        self.said("packaging/release", "7.8.9")
        self.assertEqual(self.git("log", "-1", "--format=%s"), "release: 7.8.9")
        self.assertEqual(self.git("status", "--porcelain"), "")
        self.assertIn("**New**: # it can fly.", self.git("tag", "-l", "--format=%(contents)", "v7.8.9"))
        self.assertNotIn("- old", self.git("tag", "-l", "--format=%(contents)", "v7.8.9"))
        for path in FILES[:6]:
            self.assertIn("7.8.9", self.text_of(path), path)
        self.assertEqual(self.text_of("web-client/package-lock.json").count("7.8.9"), 2)
        self.assertEqual(self.text_of("check.calls"), "full\n")
        self.assertIn("\nVERSION=7.8.9\n", self.said("packaging/version"))

    def test_a_red_check_releases_nothing_and_puts_everything_back(self):
        self.assert_refused("7.8.9", because="./check full is red", red="full")

    def test_a_version_that_is_not_newer_is_refused(self):
        self.assert_refused(self.old, because="is not newer than")
        self.assert_refused("0.0.9", because="is not newer than")
        self.assert_refused("v7.8.9", because="usage:")
        self.assertFalse(os.path.exists(os.path.join(self.root, "check.calls")), "the checks take long: refused before")

    def test_a_tag_that_is_there_is_refused(self):
        self.git("tag", "v7.8.9")
        self.assert_refused("7.8.9", because="is there already")

    def test_changes_that_are_not_committed_are_refused_and_kept(self):
        self.write("CITATION.cff", "mine")
        self.assert_refused("7.8.9", because="not committed")
        self.assertEqual(self.text_of("CITATION.cff"), "mine")

    def test_no_notes_are_refused(self):
        self.write("CHANGELOG.md", "# Changes\n\n## Not released yet\n\n## 0.1.0\n- old\n")
        self.git("commit", "--quiet", "-am", "no notes")
        self.assert_refused("7.8.9", because="CHANGELOG.md says nothing")


class VersionTest(Repository):
    def version(self):
        return dict(line.split("=", 1) for line in self.said("packaging/version").split("\n") if line)

    def built_commit(self, root=None):
        made = os.path.join(self.outside, "commit.cpp")
        root = root or self.root
        subprocess.run(["cmake", "-DSOURCES=" + root, "-DOUTPUT=" + made, "-P", os.path.join(root, "server/app/built_commit.cmake")],
                       check=True)
        with open(made, encoding="utf-8") as file:
            return file.read().split('return "')[1].split('"')[0]

    def test_a_commit_without_its_tag_comes_after_the_number_and_is_named(self):
        version, head = self.version(), self.git("rev-parse", "HEAD")
        self.assertRegex(version["VERSION"], rf"^{version['NUMBER']}\+git\d{{12}}\.g{head[:7]}$")
        self.assertEqual(version["COMMIT"], head[:12])
        self.assertEqual(self.built_commit(), head[:12])
        subprocess.run(["dpkg", "--compare-versions", version["VERSION"], "gt", version["NUMBER"]], check=True)

    def test_changed_files_are_told(self):
        self.write("CITATION.cff", "other")
        self.assertTrue(self.version()["VERSION"].endswith(".changed"))
        self.assertEqual(self.built_commit(), self.git("rev-parse", "HEAD")[:12] + " with changes")

    def test_a_tagged_commit_is_the_number_alone(self):
        self.git("tag", "v" + self.old)
        self.assertEqual(self.version()["VERSION"], self.old)

    def test_an_archive_knows_its_commit_without_git(self):
        archive = os.path.join(self.outside, "archive")
        os.mkdir(archive)
        self.git("archive", "--format=tar", "-o", archive + ".tar", "HEAD")
        subprocess.run(["tar", "-xf", archive + ".tar", "-C", archive], check=True)
        self.assertEqual(self.built_commit(archive), self.git("rev-parse", "HEAD")[:12])

    def test_sources_that_nothing_is_known_of_say_so(self):
        shutil.rmtree(os.path.join(self.root, ".git"))
        self.assertEqual(self.built_commit(), "unknown")


if __name__ == "__main__":
    unittest.main()
