"""`wakesurf case.foam`: what is served, and who is shown the page; with programs in place of browsers that note what they were told."""
import os
import pwd
import re
import shutil
import socket
import subprocess
import time
import unittest

from real_server import BINARY, ROOT, FolderTest, write_program
import wakesurf
from wakesurf.chrome import Chrome, find_browser

# Words that it was started with, what the page holds, and who may read it; the name under which it comes at the end is whole.
BROWSER = """#!/bin/sh
for word; do case $word in file://*) page=${word#file://} ;; esac; done
{ echo "$0 $*"; stat -c %a "$page"; stat -c %a "$(dirname "$page")"; cat "$page"; tr '\\0' ' ' </proc/$$/environ; } >NOTE.part
mv NOTE.part NOTE
"""


class OpenCase(FolderTest):
    def setUp(self):
        super().setUp()
        self.note = os.path.join(self.folder, "note")

    def browser(self, name):
        return write_program(self.folder, name, BROWSER.replace("NOTE", self.note))

    def environment(self, **more):
        kept = {name: value for name, value in os.environ.items()
                if name not in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER", "SSH_CONNECTION", "WAKESURF_LISTEN", "WAKESURF_DATASET", "container")}
        return {**kept, "PATH": self.folder + ":/usr/bin:/bin", "TMPDIR": self.folder, "XDG_RUNTIME_DIR": "", **more}

    def start(self, *arguments, program=BINARY, **environment):
        """The program while it runs, and what it prints until nothing more is said before it waits."""
        arguments = arguments if "--listen" in arguments else (*arguments, "--listen", "127.0.0.1:0")
        process = subprocess.Popen([program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=self.folder,
                                   env=self.environment(**environment))
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.stdout.close)
        self.addCleanup(self.end, process)
        return process, process.stdout.readline().split()[1]

    def end(self, process):
        if process.poll() is None:
            process.terminate()
            process.wait(timeout=30)

    def until(self, met, process):
        """Fails where that takes a minute, or the program ends."""
        end = time.monotonic() + 60
        while not met():
            self.assertIsNone(process.poll())
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)

    def noted(self, process):
        """What the browser noted. It is started before the server says so."""
        self.assertIn("opening the page", process.stdout.readline())
        self.until(lambda: os.path.exists(self.note), process)
        with open(self.note, encoding="utf-8") as file:
            return file.read()


class BrowserTest(OpenCase):
    def test_is_given_a_private_page_that_leads_to_the_link_and_never_the_token(self):
        self.browser("xdg-open")
        process, link = self.start("flow:tornado", DISPLAY=":0")
        words, mode, of_folder, page = self.noted(process).split("\n", 3)
        token = link.split("#token=")[1]
        self.assertRegex(words, r"/xdg-open file:///.*/open\.html$")
        self.assertNotIn(token, words)
        self.assertEqual((mode, of_folder), ("600", "700"))
        self.assertIn(f'<meta http-equiv="refresh" content="0; url={link}">', page)
        self.assertEqual(page.count(token), 2, "in the page, not in the environment")
        path = words.split("file://")[1]
        self.end(process)
        self.assertEqual((process.returncode, os.path.exists(os.path.dirname(path))), (0, False))

    def test_is_the_first_of_those_named_that_is_there(self):
        mine = self.browser("mine")
        process, _ = self.start("flow:tornado", WAYLAND_DISPLAY="wayland-0", BROWSER=f"nowhere:{mine} --new %s --last")
        self.assertRegex(self.noted(process).split("\n")[0], r"/mine --new file:///.*/open\.html --last$")

    def test_is_not_started_where_no_one_would_see_it(self):
        self.browser("xdg-open")
        for options, environment in ((("flow:tornado",), {}), (("flow:tornado", "--no-open"), {"DISPLAY": ":0"}),
                                     (("serve", "flow:tornado"), {"DISPLAY": ":0"}),
                                     (("flow:tornado",), {"DISPLAY": ":0", "SSH_CONNECTION": "192.0.2.7 5 192.0.2.9 22"}),
                                     (("flow:tornado",), {"DISPLAY": ":0", "container": "docker"}),
                                     (("flow:tornado",), {"DISPLAY": ":0", "BROWSER": "nowhere"})):
            with self.subTest(options=options, **environment):
                process, link = self.start(*options, **environment)
                wakesurf.Client(link).info()  # it answers after it would have opened a page
                self.end(process)
                self.assertNotIn("opening", process.stdout.read())
                self.assertFalse(os.path.exists(self.note))
                self.assertEqual([each for each in os.listdir(self.folder) if each.startswith("wakesurf-")], [])

    def test_is_not_started_where_the_program_has_no_page(self):
        self.browser("xdg-open")
        alone = shutil.copy(BINARY, self.folder)
        process, _ = self.start("flow:tornado", program=alone, DISPLAY=":0")
        self.assertTrue(any("the page was not found next to this program" in line for line in process.stderr), "it has ended without saying so")
        self.assertFalse(os.path.exists(self.note))

    def test_is_started_where_ssh_forwards_a_display_and_by_serve_where_it_is_asked_to(self):
        self.browser("xdg-open")
        process, _ = self.start("flow:tornado", DISPLAY="localhost:10.0", SSH_CONNECTION="192.0.2.7 5 192.0.2.9 22")
        self.assertIn("ssh -N -L", process.stdout.readline())
        self.noted(process)
        os.remove(self.note)
        process, _ = self.start("serve", "flow:tornado", "--open", DISPLAY=":0")
        self.noted(process)

    @unittest.skipUnless(find_browser(), "needs Chromium")
    def test_comes_from_the_private_page_into_the_session(self):
        self.browser("xdg-open")
        process, link = self.start("flow:tornado", DISPLAY=":0")
        page = self.noted(process).split("\n")[0].split()[-1]
        session = wakesurf.Client(link).session()
        chrome = Chrome(page, (800, 600))
        self.addCleanup(chrome.close)
        self.until(lambda: any(each["connected"] for each in session.state()["participants"]), process)
        self.assertTrue(chrome.value("location.href").startswith(link.split("#")[0]))
        self.assertNotIn("token", chrome.value("location.href"))


class LinkTest(OpenCase):
    def test_comes_with_the_line_to_type_on_the_other_machine(self):
        user, host = pwd.getpwuid(os.geteuid()).pw_name, os.uname().nodename
        for connection, door in (("192.0.2.7 5 192.0.2.9 22", ""), ("192.0.2.7 5 192.0.2.9 2222", " -p 2222")):
            process, link = self.start("flow:tornado", SSH_CONNECTION=connection)
            port = re.search(r":(\d+)/", link)[1]
            self.assertIn(f"ssh -N -L {port}:localhost:{port}{door} {user}@{host}\n", process.stdout.readline())
            self.end(process)

    def test_has_another_port_where_the_usual_one_is_taken_unless_one_was_asked_for(self):
        with socket.socket() as other:
            other.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            try:
                other.bind(("127.0.0.1", 8080))
                other.listen()
            except OSError:
                pass  # another program has it: just as well
            process = subprocess.Popen([BINARY, "flow:tornado"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                                       env=self.environment())
            self.addCleanup(process.stdout.close)
            self.addCleanup(self.end, process)
            self.assertRegex(process.stdout.readline(), r"http://127\.0\.0\.1:(?!8080/)\d+/#token=")
            for arguments, environment in ((["--listen", "127.0.0.1:8080"], {}), ([], {"WAKESURF_LISTEN": "127.0.0.1:8080"})):
                ran = subprocess.run([BINARY, "flow:tornado", *arguments], capture_output=True, text=True, timeout=60,
                                     env=self.environment(**environment), check=False)
                self.assertEqual((ran.returncode, "8080" in ran.stderr), (1, True), ran.stderr)


class WordsTest(OpenCase):
    """What is taken for data, and what for a command that was mistyped."""

    def run_it(self, *words):
        ran = subprocess.run([BINARY, *words], capture_output=True, text=True, timeout=60, cwd=self.folder, env=self.environment(), check=False)
        return ran.returncode, ran.stderr

    def test_a_file_a_folder_a_flow_or_nothing_is_served(self):
        case = os.path.join(ROOT, "data/sqcyl/sqcyl.pvd")
        for words, dataset in (((case,), "sqcyl"), ((os.path.dirname(case),), "sqcyl"), (("flow:abc",), "abc"), ((), "sqcyl"),
                               (("--threads", "1", "flow:abc"), "abc")):
            with self.subTest(words):
                process, link = self.start(*words, "--store", self.folder + "/store")
                client = wakesurf.Client(link)
                self.assertEqual([each["dataset"] for each in client.datasets()], [dataset])
                self.end(process)

    def test_a_folder_named_like_no_command_is_served_and_one_named_like_a_command_is_not(self):
        os.mkdir(os.path.join(self.folder, "case"))
        self.assertNotIn("not a command", self.run_it("case", "--listen", "nonsense")[1])
        os.mkdir(os.path.join(self.folder, "info"))
        status, said = self.run_it("info")
        self.assertEqual((status, "DATASET" in said), (2, True), said)

    def test_a_mistyped_command_is_told_from_a_missing_file(self):
        for words, status, told in ((["srve"], 2, "did you mean `wakesurf serve`?"), (["srve", "case.foam"], 2, "did you mean `wakesurf serve`?"),
                                    (["surfaces", "flow:abc"], 2, "did you mean `wakesurf surface`?"), (["zzzzzz"], 2, "wakesurf --help lists"),
                                    (["case.foam"], 1, "cannot read case.foam: No such file"), (["a/case"], 1, "cannot read case: No such file"),
                                    (["flow:nonsense"], 1, "lamb-oseen"), (["--nonsense"], 2, "--nonsense"),
                                    (["flow:abc", "serve"], 1, "cannot read serve")):
            with self.subTest(words):
                code, said = self.run_it(*words)
                self.assertEqual((code, told in said, said.count("\n")), (status, True, 1), said)

    def test_help_and_version_are_the_programs(self):
        ran = subprocess.run([BINARY, "--help"], capture_output=True, text=True, check=True)
        self.assertIn("Without a subcommand, `wakesurf [DATASET ...]` serves the data", ran.stdout)
        self.assertEqual(self.run_it("--version"), (0, ""))
        page = subprocess.run([BINARY, "--man-page"], capture_output=True, text=True, check=True).stdout
        self.assertIn("Without a subcommand", page.split(".SH OPTIONS")[0])


if __name__ == "__main__":
    unittest.main()
