"""Every command of README.md and docs/ runs, or is checked as far as it can be here; pages that tell what the program says are true."""
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import document_blocks
from document_blocks import ADDRESS, MARKS, blocks, inline_calls, logical_lines, pages, parts, text_of, wakesurf_calls
from real_server import BINARY, ROOT, RealServer

sys.path.insert(0, os.path.join(ROOT, "docs", "site"))
from pages import command_line, outputs  # noqa: E402
import wakesurf  # noqa: E402

HELP = {}


def help_of(*command):
    if command not in HELP:
        done = subprocess.run([BINARY, *command, "--help"], capture_output=True, text=True, timeout=60, check=False)
        HELP[command] = done.stdout if done.returncode == 0 else ""
    return HELP[command]


def unknown_options(arguments):
    """Options that the command's own --help does not name; or that there is no such command."""
    command = []
    while arguments[len(command):] and arguments[len(command)] in command_line.commands(help_of(*command)):
        command.append(arguments[len(command)])
    given = [word.split("=")[0] for word in arguments[len(command):] if re.match(r"--?[A-Za-z]", word)]
    known = set().union(*(command_line.options(help_of(*command[:n])) for n in range(len(command) + 1)))
    wrong = [word for word in given if word not in known]
    first = arguments[0] if arguments else ""
    return wrong + ([first] if not command and re.fullmatch(r"[a-z]+", first) else [])


class Runner:
    """One page: a folder like a clone, a home, and the server that a block has started."""

    def __init__(self, folder, store):
        self.folder, self.server, self.url = folder, None, ""
        for name in ("data", "build"):
            os.symlink(os.path.join(ROOT, name), os.path.join(folder, name))
        home = os.path.join(folder, "home")
        os.mkdir(home)
        self.environment = {name: value for name, value in os.environ.items() if not name.startswith("WAKESURF_")}
        self.environment.update(HOME=home, WAKESURF_STORE=store, WAKESURF_LISTEN="127.0.0.1:0",
                                PATH=os.path.dirname(BINARY) + os.pathsep + os.environ["PATH"],
                                PYTHONPATH=os.path.join(ROOT, "python"), PYTHONDONTWRITEBYTECODE="1")

    def placed(self, code):
        return code.replace(ADDRESS + "/#token=...", self.url).replace(ADDRESS, self.url.split("/#")[0]) if self.url else code

    def serve(self, code):
        """Error: AssertionError, where it prints no address."""
        self.server = subprocess.Popen(["bash", "-c", "exec " + code.replace("127.0.0.1:8080", "127.0.0.1:0")], cwd=self.folder,
                                       env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        words = self.server.stdout.readline().split()
        assert len(words) == 2 and "/#token=" in words[1], f"{code} printed {words}"
        self.url = self.environment["WAKESURF_URL"] = words[1]
        client = wakesurf.Client(self.url)
        for each in client.datasets():
            client.call("dataset.open", 120, dataset=each["dataset"])  # a person is slower than the import

    def run(self, block):
        """What went wrong, as text; empty for nothing."""
        code = self.placed(block.code)
        command = ["bash", "-euo", "pipefail", "-c", code] if block.mark.startswith("sh") else ["/usr/bin/python3", "-c", code]
        done = subprocess.run(command, cwd=self.folder, env=self.environment, capture_output=True, text=True, timeout=120, check=False)
        return "" if done.returncode == 0 else f"{block.page}:{block.line}: status {done.returncode}\n{code}\n{done.stdout}{done.stderr}"

    def stop(self):
        if self.server is not None:
            self.server.send_signal(signal.SIGTERM)
            self.server.wait(timeout=20)
            self.server.stdout.close()


class Commands(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.store = tempfile.TemporaryDirectory()

    @classmethod
    def tearDownClass(cls):
        cls.store.cleanup()

    def run_page(self, page):
        with tempfile.TemporaryDirectory() as folder:
            runner = Runner(folder, self.store.name)
            try:
                for block in blocks(page):
                    if block.mark == "sh run serve":
                        runner.serve(block.code.strip())
                    elif block.mark in ("sh run", "python run"):
                        self.assertEqual(runner.run(block), "")
            finally:
                runner.stop()

    def test_that_cannot_run_here_are_right_as_far_as_can_be_seen(self):
        for page in pages():
            for block in blocks(page):
                if block.mark == "python elsewhere":
                    compile(block.code, page, "exec")
                if block.mark != "sh elsewhere":
                    continue
                with self.subTest(page=page, line=block.line):
                    done = subprocess.run(["bash", "-n"], input=block.code, capture_output=True, text=True, check=False)
                    self.assertEqual(done.stderr, "")
                    for words in logical_lines(block.code):
                        for part in parts(words):
                            self.check_others(part)

    def check_others(self, words):
        """What the other programs of a block can say of it without doing it."""
        if words[0] == "ssh" and shutil.which("ssh"):
            done = subprocess.run(["ssh", "-G", *words[1:]], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
        for word in words:
            if word.endswith(".deb"):  # what ./package makes
                self.assertIn(os.path.basename(word), ("wakesurf_*.deb", "wakesurf-bricks_*.deb"))
            elif word.startswith(("./", "tests/")) or (word.startswith(("docker/", "data/")) and "." in word):
                self.assertTrue(os.path.exists(os.path.join(ROOT, word)), word)
        if words[0] == "tests/some" and "/" in words[1]:
            self.assertTrue(os.path.exists(os.path.join(ROOT, "tests", words[1] + ".cpp")), words[1])
        if words[:2] == ["wakesurf", "bench"]:
            for name in (word for word in words[2:] if re.match(r"[a-z]", word)):
                self.assertRegex(text_of("tests/bench/README.md"), rf"(?m)^\| `{name}")
        if words[0] == "npm":
            with open(os.path.join(ROOT, "web-client", "package.json"), encoding="utf-8") as file:
                self.assertIn(words[words.index("run") + 1], json.load(file)["scripts"])

    def test_name_only_options_that_help_knows(self):
        for page in pages():
            text = text_of(page)
            calls = [(block.line, call) for block in blocks(page) if block.mark.startswith("sh") for call in wakesurf_calls(block.code)]
            calls += [(0, call) for call in inline_calls(text)]
            for line, call in calls:
                with self.subTest(page=page, line=line, call=call):
                    self.assertEqual(unknown_options(call), [])

    def test_say_what_is_done_with_them(self):
        for page in pages():
            for block in blocks(page):
                if block.mark.split(" ")[0] in ("sh", "bash", "python", "console", ""):
                    with self.subTest(page=page, line=block.line):
                        self.assertIn(block.mark, MARKS)


def page_test(page):
    return lambda self: self.run_page(page)


for each in pages():
    if any("run" in block.mark.split() for block in blocks(each)):
        setattr(Commands, "test_of_" + re.sub(r"\W", "_", each.removeprefix("docs/").removesuffix(".md")), page_test(each))


class TheChecker(unittest.TestCase):
    def test_finds_what_help_does_not_know(self):
        for call in (["serve", "--colour", "red"], ["surface", "flow:abc", "--kin", "stream"], ["nothing"],
                     ["sessions", "export", "main", "--outputs", "a"]):
            with self.subTest(call=call):
                self.assertEqual(len(unknown_options(call)), 1)
        for call in (["serve", "a.foam", "--listen", "127.0.0.1:0"], ["--version"], ["sessions", "export", "main", "-o", "a"],
                     ["sessions", "list", "--url", "http://a"], ["surface", "flow:abc", "--rake", "-1,0,0 1,0,0"]):
            with self.subTest(call=call):
                self.assertEqual(unknown_options(call), [])

    def test_sees_calls_wherever_they_stand(self):
        code = "nohup wakesurf serve A --state b > log 2>&1 &\ndocker run -v x:/y wakesurf /data/a\nbuild/release/bin/wakesurf info B | cat\n"
        self.assertEqual(list(wakesurf_calls(code)), [["serve", "A", "--state", "b"], ["serve", "/data/a"], ["info", "B"]])
        self.assertEqual(list(inline_calls("see `wakesurf info FILE`, and\n```sh run\nwakesurf no\n```\n")), [["info", "FILE"]])

    def test_runs_what_is_marked_and_sees_it_fail(self):
        with tempfile.TemporaryDirectory() as folder:
            runner = Runner(folder, folder)
            (good, bad) = blocks("a page", "```sh run\nwakesurf --version > v\n```\n\n```sh run\nwakesurf surface nowhere | cat\n```\n")
            self.assertEqual(runner.run(good), "")
            self.assertIn("a page:5", runner.run(bad))
            self.assertTrue(os.path.exists(os.path.join(folder, "v")))

    def test_sees_the_documents(self):
        self.assertIn("README.md", pages())
        self.assertGreater(sum(block.mark == "sh run" for page in pages() for block in document_blocks.blocks(page)), 30)


class ReferencePages(unittest.TestCase):
    maxDiff = None

    def test_get_what_the_program_says_on_the_site(self):
        added = outputs.from_program()
        self.assertIn("### wakesurf state aside", added["docs/reference/command-line.md"])
        self.assertIn("| `wakesurf_build_info` | gauge | `version` |", added["docs/reference/metrics.md"])

    def test_name_every_command(self):
        page = text_of("docs/reference/command-line.md")
        self.assertEqual(sorted(re.findall(r"(?m)^\| `wakesurf (\w+)`", page)), sorted(command_line.commands(help_of())))

    def test_name_every_built_in_flow_with_its_parameters(self):
        rows = dict(re.findall(r"(?m)^\| `flow:([\w-]+)` \|[^|]*\|([^|]*)\|", text_of("docs/reference/flows.md")))
        done = subprocess.run([BINARY, "info", "flow:there-is-none"], capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(sorted(rows), sorted(re.findall(r"choose one of ([^)]*)\)", done.stdout + done.stderr)[0].split(", ")))
        for name, parameters in rows.items():
            with self.subTest(name):
                given = ",".join(re.findall(r"\w+ = -?[\d.]+", parameters)).replace(" ", "")
                subprocess.run([BINARY, "info", f"flow:{name}?{given}" if given else f"flow:{name}"], capture_output=True, timeout=60, check=True)

    def test_name_every_format_that_is_written(self):
        offered = re.search(r"File to write: (.*)", help_of("surface")).group(1)
        page = text_of("docs/reference/formats.md")
        formats = re.findall(r"\.\w+", offered)
        self.assertGreaterEqual(len(formats), 5)
        for each in formats:
            self.assertIn(f"| `{each}` |", page)


@unittest.skipUnless(shutil.which("haproxy", path=os.environ.get("PATH", "") + ":/usr/sbin"), "haproxy is not installed")
class BehindHaproxy(unittest.TestCase):
    def test_it_takes_the_lines_of_the_document(self):
        (block,) = [each for each in blocks("docs/how-to/proxy.md") if each.mark == "haproxy"]
        for wrong in ("", "    replace-path\n"):
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "haproxy.cfg")
                times = "".join(f"    timeout {each} 1m\n" for each in ("connect", "client", "server"))
                with open(path, "w", encoding="utf-8") as file:
                    lines = re.sub(r"(?m)^    bind .*$", f"    bind unix@{folder}/haproxy.sock", block.code)  # there is no certificate here
                    file.write(f"defaults\n    mode http\n{times}{lines}{wrong}")
                binary = shutil.which("haproxy", path=os.environ["PATH"] + ":/usr/sbin")
                done = subprocess.run([binary, "-c", "-f", path], capture_output=True, text=True, timeout=60, check=False)
            self.assertEqual(done.returncode == 0, wrong == "", done.stdout + done.stderr)


@unittest.skipUnless(shutil.which("nginx", path=os.environ.get("PATH", "") + ":/usr/sbin"), "nginx is not installed")
class BehindNginx(unittest.TestCase):
    def test_the_page_answers_below_its_prefix_with_the_lines_of_the_document(self):
        (block,) = [each for each in blocks("docs/how-to/proxy.md") if each.mark == "nginx"]
        with tempfile.TemporaryDirectory() as folder:
            server = RealServer("flow:tornado", "--store", folder)
            nginx = None
            try:
                place = os.path.join(folder, "nginx.sock")
                lines = block.code.replace("127.0.0.1:8080", server.url.split("//")[1].split("/")[0])
                kept = "".join(f"{each}_temp_path {folder}/{each};" for each in ("client_body", "proxy", "fastcgi", "uwsgi", "scgi"))
                with open(os.path.join(folder, "nginx.conf"), "w", encoding="utf-8") as file:
                    file.write(f"daemon off; master_process off; pid {folder}/pid; error_log stderr; events {{}}\n"
                               f"http {{ access_log off; {kept} server {{ listen unix:{place};\n{lines}\n}} }}\n")
                binary = shutil.which("nginx", path=os.environ["PATH"] + ":/usr/sbin")
                nginx = subprocess.Popen([binary, "-c", os.path.join(folder, "nginx.conf"), "-p", folder], stderr=subprocess.PIPE, text=True)
                asked = subprocess.run(["curl", "-sS", "--retry", "20", "--retry-connrefused", "--retry-all-errors", "--retry-delay", "1",
                                        "--unix-socket", place, "http://localhost/flow/healthz", "-o", os.devnull, "-w", "%{http_code}"],
                                       capture_output=True, text=True, timeout=60, check=False)
                self.assertEqual(asked.stdout[-3:], "200", asked.stderr)
            finally:
                if nginx is not None:
                    nginx.terminate()
                    nginx.wait(timeout=20)
                    nginx.stderr.close()
                server.stop()


if __name__ == "__main__":
    unittest.main()
