"""./run once everything is built: which options it adds to those it was given. The set-up and the server are of paper."""
import fcntl
import os
import re
import shutil
import stat
import subprocess
import tempfile
import unittest

from real_server import BINARY, write_program

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
STEPS = ("begin_setup", "announce", "setup_packages", "setup_npm", "configure", "stage", "setup_web", "end_setup")


class RunScriptTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.clone = os.path.join(self.folder.name, "clone")
        self.state = os.path.join(self.folder.name, "home/state/wakesurf")
        write_program(self.clone, "packaging/setup.sh", "release=$root/build/release\nsay() { echo \"$*\" >&2; }\n" +
                      "".join(f"{step}() {{ :; }}\n" for step in STEPS))
        write_program(self.clone, "build/release/bin/wakesurf", "#!/bin/sh\n[ \"$2\" != --help ] || exec cat \"$0.help\"\nprintf '%s\\n' \"$@\"\n")
        self.help = subprocess.run([BINARY, "serve", "--help"], text=True, check=True, stdout=subprocess.PIPE).stdout
        write_program(self.clone, "build/release/bin/wakesurf.help", self.help)
        shutil.copy(os.path.join(ROOT, "run"), self.clone)

    def given(self, *arguments, **environment):
        """What the server is given."""
        ran = subprocess.run([os.path.join(self.clone, "run"), *arguments], text=True, timeout=60, check=True, stdout=subprocess.PIPE,
                             cwd=self.folder.name,  # `--state 8` is a folder there
                             env={"PATH": os.environ["PATH"], "HOME": self.folder.name,
                                  "XDG_STATE_HOME": os.path.join(self.folder.name, "home/state"), **environment})
        return ran.stdout.split("\n")[:-1]

    def value(self, given, option):
        return given[given.index(option) + 1] if option in given else None

    def test_keeps_its_token_beside_the_sessions_in_a_folder_that_only_the_user_can_read(self):
        given = self.given()
        self.assertEqual(self.value(given, "--state"), self.state)
        self.assertEqual(self.value(given, "--token-file"), self.state + "/token")
        self.assertEqual(stat.S_IMODE(os.stat(self.state).st_mode), 0o700)
        self.assertNotIn("--new-token", given)

    def test_keeps_it_in_the_folder_that_was_named(self):
        other = os.path.join(self.folder.name, "other")
        self.assertEqual(self.value(self.given("--state", other), "--token-file"), other + "/token")
        self.assertEqual(self.value(self.given("--state=" + other), "--token-file"), other + "/token")
        self.assertEqual(self.value(self.given(WAKESURF_STATE=other), "--token-file"), other + "/token")

    def test_changes_the_token_where_it_is_asked_to(self):
        given = self.given("flow:abc", "--new-token")
        self.assertEqual(given.count("--new-token"), 1)
        self.assertEqual(self.value(given, "--token-file"), self.state + "/token")

    def test_leaves_the_token_to_whoever_says_where_it_is_or_wants_none(self):
        self.assertEqual(self.given("--token-file", "/mine").count("--token-file"), 1)
        self.assertNotIn("--token-file", self.given("--no-auth"))
        self.assertNotIn("--token-file", self.given(WAKESURF_TOKEN_FILE="/mine"))

    def test_never_changes_the_token_of_a_server_that_runs(self):
        os.makedirs(self.state)
        descriptor = os.open(self.state, os.O_RDONLY)
        self.addCleanup(os.close, descriptor)
        fcntl.flock(descriptor, fcntl.LOCK_EX)
        for arguments in ((), ("--state", self.state)):
            given = self.given(*arguments, "--new-token")
            self.assertNotIn("--token-file", given)
            self.assertNotIn("--new-token", given)

    def test_takes_the_values_of_options_for_values(self):
        given = self.given("case", "--url-file", "link", "--frame-origin", "https://wiki.example")
        self.assertEqual(given[:2], ["serve", "case"])
        self.assertEqual(self.value(given, "--url-file"), "link")
        self.assertEqual(self.value(given, "--frame-origin"), "https://wiki.example")
        given = self.given("case", "--dt", "0.01", "--start", "5", "other")
        self.assertEqual(given[:3], ["serve", "case", "other"])
        self.assertEqual((self.value(given, "--dt"), self.value(given, "--start")), ("0.01", "5"))

    def test_knows_each_option_that_the_program_has(self):
        options = re.findall(r"^ +(?:-\w,)?(--[\w-]+)( [A-Z]{2,})?", self.help, re.MULTILINE)
        self.assertGreater(len(options), 15)
        for option, value in options:
            if option in ("--help", "--new-token"):
                continue
            with self.subTest(option=option):
                given = self.given(option, *(["8"] if value else []), "case")
                self.assertEqual(given[:2], ["serve", "case"])
                self.assertIn(option, given)
                if value:
                    self.assertEqual(self.value(given, option), "8")

    def test_says_of_the_commonest_options_nothing_that_the_program_does_not(self):
        said = subprocess.run([os.path.join(self.clone, "run"), "--help"], text=True, check=True, stdout=subprocess.PIPE).stdout
        for option in re.findall(r"^  (--[\w-]+)", said, re.MULTILINE):
            self.assertIn(f"  {option} ", self.help)


if __name__ == "__main__":
    unittest.main()
