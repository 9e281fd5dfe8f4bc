"""Studies: each rake in each case with each setting once, on executors of every sort, the same bytes whoever does it, and only what is missing."""
import contextlib
import csv
import importlib.util
import os
import re
import signal
import subprocess
import threading
import unittest
import unittest.mock
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np

from document_blocks import blocks
from importers_end_test import parent_of
from real_server import BINARY, ROOT, FolderTest, RealServer, until
from stop_test import below
import wakesurf
from wakesurf import kept_server
from wakesurf.executing import answers
from wakesurf.safe_names import safe_names
from wakesurf.study import _Tasks
from wakesurf.study_task import Answer, Task, Work

SQCYL = os.path.join(ROOT, "data/sqcyl/sqcyl.pvd")
STREAM = {"kind": "stream", "to": 2, "separation": 0.2, "accuracy": "fast"}
RAKES = {f"{x:g}": [(x, 0.4, 0.1), (x, 0.6, 0.1)] for x in (0.4, 0.5, 0.6)}
BESIDE = [(9, 0.4, 0.1), (9, 0.6, 0.1)]


def bytes_below(folder):
    """The bytes of all files, by their paths."""
    found = {}
    for at, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(at, name)
            with open(path, "rb") as file:
                found[os.path.relpath(path, folder)] = file.read()
    return found


def servers_of(process):
    """Servers that a process, or one below it, keeps."""
    return below(process, "wakesurf\0serve")


def numbered(count):
    return ((i, Task({}, str(i), "", None, {})) for i in range(count))


def answered(task):
    return Answer(numbers=task.place)


def killed_by_the_fourth(task):
    if task.place == "3":
        os.kill(os.getpid(), signal.SIGKILL)
    return answered(task)


def always_lost(task):
    if task.place == "1":
        raise wakesurf.Unreachable("no answer")
    return answered(task)


class StudyTest(FolderTest):
    def study(self, rakes, cases="flow:tornado", settings=STREAM, folder="out", **more):
        return wakesurf.study(rakes, cases, settings, os.path.join(self.folder, folder), binary=BINARY, threads=1, **more)

    def test_has_each_rake_in_each_case_with_each_setting_once_and_in_order(self):
        reported = []
        settings = {"stream": STREAM, "a path": {"kind": "path", "from_": 0, "to": 1, "separation": 0.2, "max_quads": 500}}
        found = self.study(list(RAKES.values()), ["flow:tornado", "flow:abc"], settings, files=["vtp", "GLB"],
                           progress=reported.append)
        self.assertEqual([(row["case"], row["setting"], row["rake"]) for row in found.rows],
                         [(case, setting, rake) for case in ("tornado", "abc") for setting in settings for rake in "012"])
        files = bytes_below(found.folder)
        self.assertTrue(all(row["area"] > 0 and row["quads"] > 0 and row["error"] == "" for row in found.rows))
        for row in found.rows:
            self.assertEqual(wakesurf.Mesh.from_vtp(files[row["vtp"]]).about["kind"], row["setting"].split()[-1])
            self.assertEqual(files[row["glb"]][:4], b"glTF")
        self.assertEqual(len(reported), 13)
        self.assertEqual(reported[-1].share, 1)
        self.assertEqual(reported[-2].state, {"done": 12, "total": 12, "kept": 0, "failed": 0})
        self.assertEqual(found.frame().groupby("case").size().to_dict(), {"abc": 6, "tornado": 6})
        with open(found.csv, encoding="utf-8") as file:
            self.assertEqual([float(row["area"]) for row in csv.DictReader(file)], [row["area"] for row in found.rows])

    def test_has_a_row_for_each_time_and_numbers_of_what_was_asked_for(self):
        found = self.study({"one": {"line": RAKES["0.5"], "seeds": 4}, "suggested": None}, times=(0, 2, 1), fields="velocity_z",
                           through=wakesurf.numbers.box((0, 0, 0), (1, 1, 1)))
        self.assertEqual([(row["rake"], row["age"]) for row in found.rows], [(rake, age) for rake in ("one", "suggested") for age in (0, 1, 2)])
        self.assertTrue(all(row["inside_area"] >= 0 and "mean_velocity_z" in row for row in found.rows))

    def test_makes_only_what_is_missing_or_has_changed_when_it_is_run_again(self):
        first = self.study(RAKES, files="ply")
        self.assertEqual((first.surfaces, first.kept, first.failed), (3, 0, 0))
        before = bytes_below(first.folder)
        times = {path: os.stat(os.path.join(first.folder, path)).st_mtime_ns for path in before if path != "study.csv"}
        with self.subTest("all is there: no server is needed"):
            again = wakesurf.study(RAKES, "flow:tornado", STREAM, first.folder, files="ply", binary="/nowhere/wakesurf")
            self.assertEqual((again.kept, repr(again.rows), again.units), (3, repr(first.rows), first.units))  # with NaN
            self.assertIn("0 made, 3 there already, 0 failed", str(again))
            self.assertEqual(bytes_below(first.folder), before)
            self.assertEqual({path: os.stat(os.path.join(first.folder, path)).st_mtime_ns for path in times}, times)
        os.remove(os.path.join(first.folder, "tornado/stream/0.5.ply"))
        with open(os.path.join(first.folder, "tornado/stream/0.4.json"), "w", encoding="utf-8") as file:
            file.write("{")
        self.assertEqual(self.study(RAKES, files="ply").kept, 1)
        self.assertEqual(bytes_below(first.folder), before)
        changed = self.study(RAKES, settings={**STREAM, "to": 1}, files="ply")
        self.assertEqual(changed.kept, 0)
        self.assertLess(changed.rows[0]["area"], first.rows[0]["area"])
        self.assertEqual(self.study({**RAKES, "new": RAKES["0.4"]}, settings={**STREAM, "to": 1}, files="ply").kept, 3)

    def test_makes_again_all_of_a_case_whose_file_is_another_one_also_if_that_is_older(self):
        speeds = {name: wakesurf.write_series(os.path.join(self.folder, f"{name}.pvd"), [0, 1], [np.full((4, 4, 4, 3), speed)] * 2)[0]
                  for name, speed in (("mine", 1.0), ("half", 0.5))}
        rakes, setting, found = [[(0.5, 0.5, 1), (0.5, 1.5, 1)]], {"kind": "stream", "to": 1, "separation": 0.5}, []
        for other in (None, None, "half", None):
            if other:
                os.utime(speeds[other], (1e9, 1e9))
                os.replace(speeds[other], speeds["mine"])
            found.append(self.study(rakes, speeds["mine"], setting, store=os.path.join(self.folder, "store")))
        self.assertEqual([each.kept for each in found], [0, 1, 0, 1])
        self.assertAlmostEqual(found[2].rows[0]["area"], found[0].rows[0]["area"] / 2, delta=1e-6)

    def test_names_cases_of_a_list_by_their_files_and_folders_each_differently(self):
        folders = [os.path.join(self.folder, name) for name in ("run_0.5", "run_0.6")]
        for each in folders:
            os.mkdir(each)
        for cases, url, names in ((folders, None, ["run_0.5", "run_0.6"]), (["flow:abc", "x/wing.foam"], None, ["abc", "wing"]),
                                  (["a/case.foam", "b/case.foam", "case-2.foam"], None, ["case", "case-2", "case-2-2"]),
                                  (["run_0.5"], "http://server", ["run_0.5"])):
            tasks = _Tasks(Work("", url, {}, {}, (), {}, {}, None, ""), [None], cases, STREAM)
            self.assertEqual([task.names["case"] for task in tasks], names)

    def test_has_a_row_with_words_for_what_fails_and_goes_on(self):
        rakes = {"beside": BESIDE, "not a number": [(float("nan"), 0, 0), (1, 1, 1)], **RAKES}
        found = self.study(rakes, {"good": "flow:tornado", "none": "/nowhere/case.foam"}, executor=ThreadPoolExecutor(2))
        self.assertEqual((found.surfaces, found.failed), (10, 7))
        self.assertIn("3 made, 0 there already, 7 failed", str(found))
        words = {(row["case"], row["rake"]): row["error"] for row in found.failures}
        self.assertIn("outside the domain", words["good", "beside"])
        self.assertIn("not a finite number", words["good", "not a number"])
        self.assertIn("case.foam", words["none", "0.4"])
        self.assertEqual(len(found.frame()), 10)

    def test_refuses_what_makes_no_sense_before_anything_is_begun(self):
        for given, words in ((dict(settings={"kind": "stream", "seperation": 1}), "did you mean `separation`"), (dict(settings={"to": 1}), "no kind"),
                             (dict(rakes={}), "no rake"), (dict(rakes={"a": (0, 0, 0)}), "rake 'a'"), (dict(rakes={1: None, "1": None}), "same name"),
                             (dict(files="stl"), "'stl'"), (dict(picture={"colour": 1}), "`picture` has no `colour`"),
                             (dict(settings=["stream"]), "no dictionary"), (dict(ahead=0), "at least 1"), (dict(rakes=[{"lines": []}]), "did you mean `line`"), (dict(exe=1), "no parameter `exe`")):
            with self.subTest(words):
                with self.assertRaisesRegex(wakesurf.InvalidParameters, words):
                    self.study(**{"rakes": RAKES, **given})
        self.assertEqual(os.listdir(self.folder), [])
        with self.assertRaisesRegex(wakesurf.ServerMissing, "nowhere"):
            wakesurf.study(RAKES, "flow:abc", STREAM, self.folder, binary="/nowhere/wakesurf")

    def test_removes_what_a_worker_that_was_killed_had_begun_to_write(self):
        os.makedirs(os.path.join(self.folder, "out/tornado/stream"))
        with open(os.path.join(self.folder, "out/tornado/stream/0.4.ply.012345.part"), "wb"):
            pass
        self.assertFalse([path for path in bytes_below(self.study(RAKES).folder) if path.endswith(".part")])

    def test_says_that_files_are_elsewhere_where_workers_have_another_disk(self):
        elsewhere = unittest.mock.patch("wakesurf.study_task.write_whole")
        with elsewhere, self.assertWarnsRegex(UserWarning, "not the files"):
            self.assertEqual(self.study(RAKES).failed, 0)

    def test_writes_nowhere_else_whatever_names_it_is_given(self):
        names = {"../../escaped": RAKES["0.4"], "/tmp/escaped": RAKES["0.5"], "a\0b\n\ud800": RAKES["0.6"], "": BESIDE}
        found = self.study(names, {"..": "flow:tornado", "study.csv": "flow:abc"}, {".hidden/x": STREAM})
        self.assertEqual([row["rake"] for row in found.rows[:4]], list(names))
        self.assertEqual(len(bytes_below(self.folder)), 2 * found.surfaces - 2 * found.failed + 1)
        self.assertEqual(len(bytes_below(found.folder)), len(bytes_below(self.folder)))
        self.assertFalse([each for each in bytes_below(found.folder) if each.startswith(".") or "/." in each])

    def test_uses_a_server_that_runs_and_leaves_nothing_in_it(self):
        server = RealServer("flow:tornado")
        self.addCleanup(server.stop)
        found = self.study(RAKES, ["tornado", "none"], url=server.url, executor=ThreadPoolExecutor(12))
        self.assertEqual([row["area"] for row in found.rows[:3]], [row["area"] for row in self.study(RAKES, folder="own").rows])
        self.assertIn("there is no dataset of this name", found.failures[0]["error"])
        client = wakesurf.Client(server.url)
        self.assertEqual([each.id for each in client.sessions()], ["main"])
        self.assertEqual(client.sessions(trash=True), [])

    def test_makes_of_the_lines_of_a_slurm_array_the_same_numbers(self):
        (job,) = [each.code for each in blocks("docs/how-to/study.md") if "#SBATCH" in each.code]
        rakes = self.lines_of_the_page()
        self.assertEqual(len(rakes), 200)
        os.symlink(os.path.join(ROOT, "data"), os.path.join(self.folder, "data"))
        environment = {**os.environ, "PATH": os.path.dirname(BINARY) + os.pathsep + os.environ["PATH"], "SLURM_CPUS_PER_TASK": "1",
                       "WAKESURF_STORE": os.path.join(self.folder, "store")}
        for i in range(3):
            subprocess.run(["bash", "-euo", "pipefail", "-c", job], cwd=self.folder, env={**environment, "SLURM_ARRAY_TASK_ID": str(i)}, check=True,
                           capture_output=True, timeout=120)
        failed = subprocess.run(["bash", "-c", job], cwd=self.folder, env={**environment, "SLURM_ARRAY_TASK_ID": "200"}, capture_output=True, text=True,
                                timeout=120, check=False)
        self.assertIn("no such line", failed.stderr)
        setting = {"kind": "path", "separation": 0.4}
        points = [[[float(x) for x in point.split(",")] for point in line.split()] for line in rakes[:3]]
        self.study(points, SQCYL, setting, store=environment["WAKESURF_STORE"], through=re.search(r"--through (\S+)", job)[1])
        made, found = bytes_below(os.path.join(self.folder, "array")), bytes_below(os.path.join(self.folder, "out/sqcyl/path"))
        self.assertEqual(made, {path: data for path, data in found.items() if path.endswith(".csv")})

    def lines_of_the_page(self):
        (made,) = [each.code for each in blocks("docs/how-to/study.md") if "rakes.txt" in each.code and each.mark == "sh run"]
        subprocess.run(["bash", "-c", made], cwd=self.folder, check=True)
        with open(os.path.join(self.folder, "rakes.txt"), encoding="utf-8") as file:
            return list(file)


@unittest.skipUnless(importlib.util.find_spec("distributed"), "Dask is not installed (Debian: python3-distributed)")
class DaskTest(FolderTest):
    """Two workers that convert the same case into one store at once, of whom one is killed."""

    def test_a_worker_that_is_killed_loses_nothing_and_the_bytes_are_those_of_threads(self):
        from distributed import Client, LocalCluster
        rakes = {f"y={y:g}": [(-1.5, y, 1), (-1.5, y, 5)] for y in (-1, -0.5, 0.5, 1)}
        settings = [{"kind": kind, "separation": 0.5, "fields": ["interval_error"]} for kind in ("path", "streak")]

        def study(name, executor, progress=None):
            folder = os.path.join(self.folder, name)
            return wakesurf.study(rakes, SQCYL, settings, folder, executor=executor, files=["vtp", "glb"], binary=BINARY, threads=1,
                                  store=os.path.join(self.folder, name + "-store"), progress=progress)

        killed = []

        def kill(progress):
            if progress.state["done"] >= 1 and not killed:
                worker = next(each for each in client.run(os.getpid).values() if servers_of(each))
                killed.extend([worker, *servers_of(worker)])
                os.kill(worker, signal.SIGKILL)

        with LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None, silence_logs=50) as cluster, Client(cluster) as client:
            found = study("dask", client.get_executor(), kill)
            alone = study("threads", None)
            self.assertEqual(study("dask", client).kept, 8)
        self.assertEqual((found.surfaces, found.kept, found.failed), (8, 0, 0))
        self.assertEqual(repr(found.rows), repr(alone.rows))  # with NaN
        ours = bytes_below(found.folder)
        self.assertEqual(len(ours), 8 * 4 + 1)
        self.assertEqual(ours, bytes_below(alone.folder))
        self.assertGreater(len(killed), 1)
        until(lambda: not any(parent_of(each) for each in killed))  # the server ends with its worker


class LostWorkersTest(FolderTest):
    def test_a_pool_that_breaks_is_left_with_what_is_done_and_another_one_does_the_rest(self):
        with ProcessPoolExecutor(2) as pool:
            with self.assertRaisesRegex(wakesurf.WorkersLost, "again in the same folder with a new executor"):
                list(answers(numbered(40), killed_by_the_fourth, pool, 3, None))

    def test_a_task_that_kills_workers_costs_no_other_its_result(self):
        made = []

        def make():
            made.append(ProcessPoolExecutor(2))
            return made[-1]

        found = dict((number, answer) for number, _, answer in answers(numbered(40), killed_by_the_fourth, make, 3, None))
        self.assertEqual(sorted(found), list(range(40)))
        self.assertEqual([number for number, answer in found.items() if answer.error], [3])
        self.assertIn("given up after 3 tries", found[3].error)
        self.assertEqual(len(made), 4)

    def test_a_task_whose_server_dies_each_time_is_given_up(self):
        with ThreadPoolExecutor(2) as pool:
            found = {number: answer for number, _, answer in answers(numbered(5), always_lost, pool, 2, None)}
        self.assertEqual([found[i].error for i in range(5)], ["", "given up after 2 tries: no answer", "", "", ""])

    def test_what_every_task_would_fail_with_ends_it(self):
        def fails(_):
            raise wakesurf.ServerMissing("there is no program")
        with self.assertRaises(wakesurf.ServerMissing):
            list(answers(numbered(5), fails, None, 3, None))

    def test_an_executor_that_takes_nothing_ends_it(self):
        class Closed(Executor):
            def submit(self, *_):
                raise RuntimeError("cannot schedule new futures after shutdown")
        for given in (Closed(), Closed):
            with self.assertRaisesRegex(wakesurf.WorkersLost, "after shutdown"):
                list(answers(numbered(5), answered, given, 3, None))

    def test_a_million_tasks_are_never_in_memory_together(self):
        most, inside, lock = [0], [0], threading.Lock()

        class Counting(ThreadPoolExecutor):
            def submit(self, *arguments):
                with lock:
                    inside[0] += 1
                    most[0] = max(most[0], inside[0])
                future = super().submit(*arguments)
                future.add_done_callback(lambda _: left())
                return future

        def left():
            with lock:
                inside[0] -= 1

        with Counting(2) as pool:
            tasks = numbered(10 ** 6)
            found = answers(tasks, answered, pool, 3, None)
            for _ in range(500):
                next(found)
            found.close()
        self.assertLessEqual(most[0], 4)
        self.assertLess(next(tasks)[0], 1000)


class KeptServerTest(unittest.TestCase):
    OPTIONS = {"binary": BINARY, "threads": 1}

    def pid(self, case):
        with kept_server.kept_server(case, "", self.OPTIONS, "") as client:
            client.info()
            return next(each.begun.result().process.pid for each in kept_server._kept.values() if each.users)

    def test_is_one_for_all_threads_and_another_one_where_it_has_died(self):
        with ThreadPoolExecutor(8) as threads:
            pids = set(threads.map(self.pid, ["flow:abc"] * 16))
        self.assertEqual(len(pids), 1)
        (pid,) = pids
        os.kill(pid, signal.SIGKILL)
        with contextlib.suppress(wakesurf.Unreachable):  # by the one that notices it
            self.pid("flow:abc")
        self.assertNotEqual(self.pid("flow:abc"), pid)

    def test_there_are_two_at_most_and_none_when_it_has_long_been_idle(self):
        first = self.pid("flow:abc")
        second = self.pid("flow:hill")
        self.assertEqual(self.pid("flow:abc"), first)
        self.pid("flow:shear")
        until(lambda: not os.path.exists(f"/proc/{second}"))
        self.assertEqual(self.pid("flow:abc"), first)
        with unittest.mock.patch.object(kept_server, "_IDLE", 0):
            until(lambda: not os.path.exists(f"/proc/{first}"))


class StartsTest(unittest.TestCase):
    """Starts of servers that are none: `starts` are those that were begun, `problems` the errors of the next ones."""

    def setUp(self):
        self.starts, self.problems, self.stopped = [], [], []
        for patch in (unittest.mock.patch.object(kept_server, "serve", self.serve), unittest.mock.patch.object(kept_server, "Client", str),
                      unittest.mock.patch.object(kept_server, "_kept", {}), unittest.mock.patch.object(kept_server, "_failed", {})):
            patch.start()
            self.addCleanup(patch.stop)
        self.addCleanup(lambda: [each.unwanted.set() for each in kept_server._kept.values()])

    def serve(self, case, **_):
        self.starts.append(case)
        if self.problems:
            raise self.problems.pop(0)
        server = unittest.mock.Mock(url=f"{case} {len(self.starts)}", running=True)
        server.stop = lambda: self.stopped.append(case)
        return server

    def use(self, case="case", data="", study="first"):
        with kept_server.kept_server(case, data, {}, study) as url:
            return url

    def test_a_server_of_a_file_that_was_another_one_is_not_used(self):
        self.assertEqual([self.use(data="1"), self.use(data="1", study="second"), self.use(data="2")], ["case 1", "case 1", "case 2"])

    def test_what_is_wrong_with_a_case_is_found_once_in_a_study_and_again_in_the_next(self):
        for problem in (wakesurf.DatasetError("damaged"), wakesurf.ServerFailed("no such file", 1)):
            self.starts.clear()
            self.problems.append(problem)
            for _ in range(3):
                with self.assertRaises(type(problem)):
                    self.use(study=str(problem))
            self.assertEqual(len(self.starts), 1)
            self.assertFalse(kept_server.lost(problem))
            self.use("case", str(problem), study=str(problem) + " mended")
            self.assertEqual(len(self.starts), 2)

    def test_a_start_that_fails_for_another_reason_is_tried_again(self):
        for problem in (wakesurf.ServerMissing("none"), wakesurf.Unreachable("killed"), wakesurf.ServerFailed("killed", -9),
                        wakesurf.ServerFailed("not started in time"), wakesurf.OverLimit("memory"), OSError("no more processes")):
            self.problems.append(problem)
            with self.assertRaises(type(problem)):
                self.use(repr(problem))
            self.use(repr(problem))
            self.assertEqual(self.starts.count(repr(problem)), 2)

    def test_a_third_server_waits_until_one_of_two_has_no_users(self):
        waiting = threading.Event()

        class Watched(threading.Condition):
            def wait(self, timeout=None):
                waiting.set()
                return super().wait(timeout)

        with unittest.mock.patch.object(kept_server, "_changed", Watched()), ThreadPoolExecutor(1) as threads:
            with kept_server.kept_server("a", "", {}, ""):
                with kept_server.kept_server("b", "", {}, ""):
                    third = threads.submit(self.use, "c")
                    self.assertTrue(waiting.wait(60))
                    self.assertEqual(self.starts, ["a", "b"])
                self.assertEqual(third.result(), "c 3")
                until(lambda: self.stopped == ["b"])


class SafeNamesTest(unittest.TestCase):
    def test_are_different_for_different_names_and_stay_the_same_in_other_company(self):
        names = ["wing", "Wing", "WING", "a/b", "a:b", "a-b", "..", "", ".", "x" * 300, "x" * 301, "y=0.5", "\ud800", "流れ", "aux", "NUL.x", "falcon"]
        safe = safe_names(names)
        self.assertEqual(len({each.casefold() for each in safe}), len(names))
        for name, each in zip(names, safe):
            self.assertLess(len(each.encode()), 200)
            self.assertEqual(os.path.basename(each), each)
            self.assertNotIn(each[0], ".-")
        self.assertEqual([each for each in names if each in safe], ["wing", "a-b", "y=0.5", "流れ", "falcon"])
        self.assertTrue(safe[-3].startswith("aux_-") and safe[-2].startswith("NUL_.x-"))  # the others are devices to Windows
        self.assertEqual(safe_names(names[3:]), safe[3:])


if __name__ == "__main__":
    unittest.main()
