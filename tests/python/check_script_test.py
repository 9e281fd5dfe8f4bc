"""./check where everything is built: a test of cpp, browser or timing that fails is named, and run once more. The set-up and the tests are of paper."""
import json
import os
import shutil
import subprocess
import tempfile
import unittest

from real_server import ROOT, write_program

STEPS = ("begin_setup", "announce", "setup_packages", "setup_npm", "build", "setup_web", "end_setup")

# Says what the tests in suites.json do at their first and at their second run: `fails` or `passes`. Writes as npm with vitest, as ctest, or as
# the program of the timing tests does.
RUNNER = '''#!/usr/bin/env python3
import json, os, re, sys

here = os.path.dirname(os.path.realpath(__file__))
name, arguments = os.path.basename(sys.argv[0]), sys.argv[1:]
with open(os.path.join(here, "suites.json"), encoding="utf-8") as file:
    suites = json.load(file)
with open(os.path.join(here, "ran.txt"), "a", encoding="utf-8") as file:
    print(name, *arguments, file=file)


def value(option):
    found = [each.removeprefix(option + "=") for each in arguments if each.startswith(option + "=")]
    return found[0] if found else None


def written(path, result):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        json.dump(result, file)
    sys.exit(0 if "fails" not in json.dumps(result) else 1)


def failed_programs(*programs):
    """As ctest ends."""
    print("The following tests FAILED:", *(f"\\t  {i} - {each}" for i, each in enumerate(programs, 1)), "Errors while running CTest", sep="\\n")


def google(tests, turn):
    return {"testsuites": [{"name": "Clock", "testsuite": [
        {"name": test, "result": "COMPLETED", **({"failures": [{"failure": f"{test} fails, turn {turn}"}]} if runs[turn] == "fails" else {})}
        for test, runs in tests.items()]}]}


part = "timing" if "timing_test" in "".join([name, *arguments]) else "cpp"
if name == "ctest":
    print("[ RUN      ] Clock.Strikes\\n[       OK ] Clock.Strikes (0 ms)\\nThe end of the output")
    crashes = suites[part].pop("crashes", None)
    if crashes:
        print(f"[ RUN      ] Clock.{crashes}")
        failed_programs("core_test.1 (SEGFAULT)", *(["core_test.0 (Failed)"] if suites[part] else []))
        if not suites[part]:
            sys.exit(8)
    written(os.path.join(here, f"../build/release/results/{'core' if part == 'cpp' else part}_test.0.json"), google(suites[part], 0))
if name in ("core_test", "timing_test"):
    test = value("--gtest_filter").removeprefix("Clock.")
    written(value("--gtest_output").removeprefix("json:"), google({test: suites[part][test]}, 1))
project = arguments[arguments.index("run") + 1].removeprefix("test:")
tests = suites[project if project == "browser" else "page"]
turn, pattern = 0, None
if "-t" in arguments:
    turn, pattern = 1, re.compile(arguments[arguments.index("-t") + 1])
ran = {test: runs[turn] for test, runs in tests.items() if pattern is None or pattern.search(test)}
if "an error beside the tests" in ran:
    print("Vitest caught 1 unhandled error during the test run.")
written(value("--outputFile.json"), {"testResults": [{
    "name": "/tests/end_to_end/picture.spec.ts", "status": "failed" if "fails" in ran.values() else "passed",
    "assertionResults": [{"fullName": test, "status": "failed" if what == "fails" else "passed",
                          "failureMessages": [f"{test} fails, turn {turn}"] if what == "fails" else []} for test, what in ran.items()]}]})
'''


class CheckScriptTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.clone = os.path.join(self.folder.name, "clone")
        write_program(self.clone, "docker/setup.sh",
                      "log=$root/build/check.log; web=$root/web-client\nsay() { echo \"$*\" >&2; }\nstage() { shift; \"$@\"; }\n" +
                      "".join(f"{step}() {{ mkdir -p $root/build; }}\n" for step in STEPS))
        for program in ("bin/npm", "bin/ctest"):
            write_program(self.clone, program, RUNNER)
        os.makedirs(os.path.join(self.clone, "build/release/bin"))
        for name in ("core_test", "timing_test"):
            write_program(self.clone, "bin/" + name, RUNNER)
            os.symlink(os.path.join(self.clone, "bin", name), os.path.join(self.clone, "build/release/bin", name))
        for name in ("check", "tests/read_results"):
            os.makedirs(os.path.dirname(os.path.join(self.clone, name)), exist_ok=True)
            shutil.copy(os.path.join(ROOT, name), os.path.join(self.clone, name))

    def checked(self, part, **suites):
        """Status and last lines of a check of one part, and all that it showed beside them."""
        write_program(self.clone, "bin/suites.json", json.dumps({"timing": {"Ticks": ["passes"]}, "page": {"a page": ["passes"]}, **suites}))
        ran = subprocess.run([os.path.join(self.clone, "check"), "--only", part], text=True, timeout=60, check=False, capture_output=True,
                             env={"PATH": os.path.join(self.clone, "bin") + ":" + os.environ["PATH"]})
        return ran.returncode, ran.stdout.splitlines(), ran.stderr

    def runs(self):
        with open(os.path.join(self.clone, "bin/ran.txt"), encoding="utf-8") as file:
            return file.read().splitlines()

    def test_says_no_word_of_unstable_tests_where_all_pass(self):
        self.assertEqual(self.checked("browser", browser={"a": ["passes"], "b": ["passes"]})[:2], (0, ["2 passed, 0 failed"]))
        self.assertEqual(len(self.runs()), 1)

    def test_counts_a_browser_test_that_passes_alone_as_passed_and_names_it(self):
        name = "a picture (of 2.5 \"m\") is whole [again]"
        status, last, shown = self.checked("browser", browser={name: ["fails", "passes"], "another": ["passes", "fails"]})
        self.assertEqual((status, last), (0, ["unstable: " + name, "1 unstable", "2 passed, 0 failed"]))
        self.assertIn(name + " fails, turn 0", shown)
        with open(os.path.join(self.clone, "build/check.log"), encoding="utf-8") as log:
            self.assertIn(name + " fails, turn 0", log.read())
        self.assertEqual(len(self.runs()), 2)
        self.assertIn(" picture.spec.ts -t ", self.runs()[1])

    def test_counts_a_browser_test_that_fails_twice_as_failed(self):
        status, last, shown = self.checked("browser", browser={"a": ["fails", "fails"], "b": ["passes"], "c": ["fails", "passes"]})
        self.assertEqual((status, last), (1, ["unstable: c", "1 unstable", "2 passed, 1 failed"]))
        self.assertIn("once more, alone, it failed as well: a", shown)

    def test_runs_a_test_alone_whose_name_is_the_beginning_of_another(self):
        self.assertEqual(self.checked("browser", browser={"a": ["fails", "passes"], "a, then b": ["passes", "fails"]})[1][-1],
                         "2 passed, 0 failed")

    def test_runs_nothing_again_where_many_fail(self):
        status, last, _ = self.checked("browser", browser={f"test {i}": ["fails", "passes"] for i in range(9)})
        self.assertEqual((status, last), (1, ["0 passed, 9 failed"]))
        self.assertEqual(len(self.runs()), 1)

    def test_excuses_no_error_beside_the_tests(self):
        tests = {"a": ["fails", "passes"], "an error beside the tests": ["passes"]}
        self.assertEqual(self.checked("browser", browser=tests)[:2], (1, ["1 passed, 1 failed"]))

    def test_runs_timing_tests_of_both_kinds_once_more(self):
        status, last, shown = self.checked("timing", timing={"Ticks": ["fails", "passes"], "Tocks": ["passes", "passes"]},
                                           page={"is quick": ["fails", "passes"], "is quicker": ["fails", "fails"]})
        self.assertEqual((status, last), (1, ["unstable: Clock.Ticks", "unstable: is quick", "2 unstable", "3 passed, 1 failed"]))
        self.assertIn("Ticks fails, turn 0", shown)

    def test_counts_a_crash_as_a_failure_that_is_not_run_again(self):
        status, last, shown = self.checked("timing", timing={"crashes": "Ticks"})
        self.assertEqual((status, last), (1, ["1 passed, 1 failed"]))
        self.assertEqual([each.split()[0] for each in self.runs()], ["ctest", "npm"])
        self.assertIn("\nfailed: Clock.Ticks: it did not end\n", shown)
        self.assertNotIn("failed: Clock.Strikes", shown)

    def test_runs_a_test_in_cpp_once_more_by_its_program(self):
        status, last, shown = self.checked("cpp", cpp={"Ticks": ["fails", "passes"], "Tocks": ["passes"]})
        self.assertEqual((status, last), (0, ["unstable: Clock.Ticks", "1 unstable", "2 passed, 0 failed"]))
        self.assertIn("failed: Clock.Ticks\n", shown)
        self.assertEqual(self.runs()[1].split()[0], "core_test")

    def test_names_last_the_tests_that_failed_and_what_they_said(self):
        status, last, shown = self.checked("cpp", cpp={"Ticks": ["fails", "fails"], "Tocks": ["passes"]})
        self.assertEqual((status, last), (1, ["1 passed, 1 failed"]))
        self.assertLess(shown.index("The end of the output"), shown.index("failed: Clock.Ticks\n    Ticks fails, turn 0\n"))

    def test_excuses_no_crash_beside_a_test_that_failed(self):
        status, last, shown = self.checked("cpp", cpp={"Ticks": ["fails", "passes"], "crashes": "Strays"})
        self.assertEqual((status, last), (1, ["0 passed, 1 failed"]))
        self.assertEqual(len(self.runs()), 1)
        self.assertIn("failed: Clock.Strays: it did not end\n", shown)


if __name__ == "__main__":
    unittest.main()
