"""python/wakesurf against the real server."""
import os
import tempfile
import threading
import unittest

import numpy as np

from real_server import BINARY, ServerTest
import wakesurf

os.environ.setdefault("WAKESURF_FRAMES_LIBRARY", os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(BINARY))),
                                                             "lib/libwakesurf_frames.so"))

LINE = [(0.2, 0, -1), (1, 0, -1)]


class ClientTest(ServerTest):
    datasets = ("flow:lamb-oseen", "flow:abc")

    def setUp(self):
        self.session = self.client.create_session("test")

    def surface(self, **more):
        rake = self.session.rake(line=LINE, seeds=9)
        return self.session.surface(rake, "stream", dataset="lamb-oseen", **{"to": 2, "separation": 0.1, **more})

    def long_surface(self):
        rake = self.session.rake(line=[(-9, 0, 0), (9, 0.1, 0)], seeds=256)
        return self.session.surface(rake, "stream", dataset="abc", to=200, separation=0.01, max_quads=4_000_000)

    # Finding the server.

    def test_takes_address_and_token_from_the_printed_line_the_environment_or_the_arguments(self):
        address, token = self.server.url.split("/#token=")
        self.assertEqual(wakesurf.Client(address, token=token).info()["name"], "wakesurf")
        self.assertEqual(wakesurf.Client(address.replace("http://", ""), token=token).info()["name"], "wakesurf")
        os.environ.update(WAKESURF_URL=address, WAKESURF_TOKEN=token)
        try:
            with wakesurf.Client() as client:
                self.assertEqual(client.info()["name"], "wakesurf")
        finally:
            del os.environ["WAKESURF_URL"], os.environ["WAKESURF_TOKEN"]

    def test_says_what_is_wrong_with_token_and_address(self):
        address = self.server.url.split("/#")[0]
        with self.assertRaises(wakesurf.Unauthenticated):
            wakesurf.Client(address, token="wrong").info()
        with self.assertRaises(wakesurf.Unreachable) as raised:
            wakesurf.Client("http://127.0.0.1:9", token="s3cret", timeout=5).info()
        self.assertIsInstance(raised.exception, ConnectionError)
        self.assertNotIn("s3cret", str(raised.exception))

    def test_isosurface_asks_for_no_rake_and_makes_none(self):
        with self.assertRaises(wakesurf.WakesurfError) as raised:
            self.session.isosurface("velocity", 0.5, dataset="abc")
        self.assertEqual(raised.exception.kind, "unsupported")
        self.assertEqual(self.session.rakes(), [])

    # Data.

    def test_lists_and_describes_datasets(self):
        self.assertEqual([each["dataset"] for each in self.client.datasets()], ["lamb-oseen", "abc"])
        self.assertEqual(self.client.describe("abc")["grid"], "analytic")
        self.assertEqual(self.client.cache("abc")["steps"], [])
        with self.assertRaises(wakesurf.NotFound) as raised:
            self.client.describe("nothing")
        self.assertEqual((raised.exception.code, raised.exception.kind), (-32004, "notFound"))
        self.assertTrue(raised.exception.hint)

    def test_probes_give_arrays_with_nan_outside(self):
        answer = self.client.probe("abc", np.array([[0, 0, 0], [50, 0, 0]]), time=0)
        np.testing.assert_array_equal(answer["inside"], [True, False])
        velocity = answer[self.client.describe("abc")["velocity"]]
        np.testing.assert_allclose(velocity[0], [0, 1, 1])
        self.assertTrue(np.isnan(velocity[1]).all())

    def test_many_points_are_asked_for_in_several_calls(self):
        grid = np.stack(np.meshgrid(np.linspace(-24, 24, 60), np.linspace(-24, 24, 60), [0.1]), axis=-1).reshape(-1, 3)
        calls = []
        send = self.client._request
        self.client._request = lambda path, body=None, *more, **named: calls.append(len(body)) or send(path, body, *more,
                                                                                                       **named)
        try:
            answer = self.client.probe("abc", grid, time=0)
        finally:
            del self.client._request
        self.assertGreater(len(calls), 2)
        self.assertLessEqual(max(calls), 65536)
        velocity = answer[self.client.describe("abc")["velocity"]]
        np.testing.assert_array_equal(answer["inside"], (np.abs(grid) <= 20).all(axis=1))
        inside = grid[answer["inside"]]
        x, _, z = inside.T
        np.testing.assert_allclose(velocity[answer["inside"]], np.stack([np.sin(z), np.sin(x) + np.cos(z), np.cos(x)], axis=1),
                                   atol=1e-6)
        self.assertEqual(velocity.shape, (3600, 3))
        self.assertTrue(np.isnan(velocity[~answer["inside"]]).all())

    def test_points_that_all_lie_outside_are_vectors_all_the_same(self):
        answer = self.client.probe("abc", [(50, 0, 0)] * 3, time=0)
        self.assertEqual(answer[self.client.describe("abc")["velocity"]].shape, (3, 3))

    def test_numbers_that_json_has_not_are_named_before_anything_is_sent(self):
        with self.assertRaisesRegex(wakesurf.InvalidParameters, r"`points\[1\]\[2\]` is nan"):
            self.client.probe("abc", np.array([[0, 0, 0], [1, 2, np.nan]]), time=0)
        with self.assertRaisesRegex(wakesurf.InvalidParameters, r"`points\[0\]\[0\]` is inf"):
            self.session.rake(line=[(float("inf"), 0, 0), (1, 0, 0)])
        with self.assertRaisesRegex(wakesurf.InvalidParameters, "`to` is nan"):
            self.surface(to=float("nan"))
        with self.assertRaisesRegex(wakesurf.InvalidParameters, "`time` is -inf"):
            self.session.set_time(-np.inf)
        with self.assertRaisesRegex(wakesurf.InvalidParameters, "`view.camera"):
            self.session.call("bookmark.set", name="x", view={"camera": np.array([1, np.nan])})

    # Rakes and surfaces.

    def test_a_surface_begins_at_the_datasets_first_time_unless_it_is_said(self):
        surface = self.surface()
        self.assertEqual(surface.record()["from"], self.client.describe("lamb-oseen")["times"][0])
        self.assertEqual(self.surface(from_=0.5).record()["from"], 0.5)

    def test_parameters_have_the_spelling_of_python_and_that_of_the_api(self):
        self.assertEqual(self.surface(max_quads=5000).record()["maxQuads"], 5000)
        surface = self.surface(max_quads=6000)
        surface.set(max_quads=7000)
        self.assertEqual(surface.record()["maxQuads"], 7000)
        with self.assertRaises(wakesurf.InvalidParameters):
            self.surface(max_quads=5000, maxQuads=6000)
        with self.assertRaisesRegex(wakesurf.InvalidParameters, "did you mean `separation`"):
            self.surface(seperation=1)
        with self.assertRaisesRegex(wakesurf.MethodNotFound, r"did you mean `session\.api\.surface\.list\(\)`"):
            self.session.call("surfaces.list")

    def test_a_mesh_is_the_one_the_session_shows(self):
        rake = self.session.rake(line=LINE, seeds=9)
        surface = self.session.surface(rake, "path", dataset="lamb-oseen", to=2, separation=0.1)
        end = surface.mesh()
        self.assertNotIn("time", end.about)
        self.session.set_time(0.5)
        then = surface.mesh()
        self.assertEqual(len(then.points), surface.wait()["vertices"])
        self.assertEqual(then.about["time"], 0.5)
        self.assertLess(then["t"].max(), 0.5 + 1e-9)
        self.assertIs(surface.mesh(), then)
        np.testing.assert_array_equal(surface.mesh(time="end").points, end.points)
        self.assertLess(len(surface.mesh(time=0.25).points), len(then.points))
        self.assertEqual(self.session.state()["clock"]["time"], 0.5, "no one else's time has changed")
        with self.assertRaises(wakesurf.OutsideTimeRange):
            surface.mesh(time=3)
        with self.assertRaises(wakesurf.InvalidParameters):
            surface.mesh(time=float("nan"))

    def test_lines_on_a_surface_are_those_its_kind_consists_of(self):
        rake = self.session.rake(line=[(0.5, 0, 0), (1.5, 0, 0)], seeds=33)
        surface = self.session.surface(rake, "path", dataset="lamb-oseen", to=2, separation=0.05)
        for value, points in surface.lines("pathlines", 4):  # round the vortex, each in its own circle
            np.testing.assert_allclose(np.hypot(points[:, 0], points[:, 1]), 0.5 + value, atol=5e-3)
        ages = [age for age, _ in surface.lines("timelines", 3)]
        np.testing.assert_allclose(ages, [0.5, 1.0, 1.5])
        for format, start in (("ply", b"ply"), ("glb", b"glTF"), ("obj", b"# "), ("vtp", b"<?xml")):
            self.assertTrue(surface.download(format, lines="arrows:every=0.3,width=0.05").startswith(start), format)
        with self.assertRaisesRegex(wakesurf.InvalidParameters, "lines cannot be written as .drc"):
            surface.download("drc", lines="timelines:3")
        points = surface.download("ply", lines="points")
        self.assertIn(b"property float radius\nend_header\n", points)
        self.assertNotIn(b"element face", points)
        with self.assertRaisesRegex(wakesurf.InvalidParameters, "points cannot be written as .vtp"):
            surface.download("vtp", lines="points")
        with self.assertRaisesRegex(wakesurf.InvalidParameters, "no lines called 'streaklines'"):
            surface.lines("streaklines")

    def test_cells_can_be_cut_on_curved_patches(self):
        rake = self.session.rake(line=[(0.5, 0, 0), (1.5, 0, 0)], seeds=5)
        surface = self.session.surface(rake, "path", dataset="lamb-oseen", to=1, separation=0.2)
        flat, cut = surface.mesh(), surface.mesh(tessellate=3)
        self.assertEqual(len(cut.polygons), 9 * len(flat.polygons))
        np.testing.assert_array_equal(cut.points[:len(flat.points)], flat.points)
        self.assertEqual(len(surface.mesh().polygons), len(flat.polygons))
        with self.assertRaisesRegex(wakesurf.InvalidParameters, "`tessellate` is not a whole number from 1 to 64"):
            surface.download("vtp", tessellate=65)

    def test_makes_a_surface_and_gives_its_mesh_as_arrays(self):
        stats = self.surface().wait(60)
        self.assertTrue(stats["complete"])
        mesh = self.session.surfaces()[0].mesh()
        self.assertEqual(mesh.points.shape, (stats["vertices"], 3))
        self.assertEqual(mesh.points.dtype, np.float64)
        self.assertEqual(len(mesh.polygons), stats["quads"])
        self.assertEqual(mesh["velocity"].shape, (stats["vertices"], 3))
        np.testing.assert_allclose(np.linalg.norm(mesh["velocity"], axis=1), mesh["speed"], rtol=1e-5)
        np.testing.assert_allclose(mesh.points[mesh["t"] == 0][:, 1:], [[0, -1]] * (mesh["t"] == 0).sum(), atol=1e-12)
        self.assertEqual(mesh.about["kind"], "stream")
        self.assertEqual(mesh.about["rake"].shape, (2, 3))
        for cell in mesh.polygons:
            self.assertTrue(4 <= len(cell) <= 8)

    def test_triangles_cover_the_polygons_without_gaps(self):
        rake = self.session.rake(line=[(0.5, 0, 0), (2.5, 0.3, 1)], seeds=8)
        surface = self.session.surface(rake, "stream", dataset="abc", to=6, separation=0.2)
        mesh = surface.mesh()
        self.assertLess(len(mesh.quads), len(mesh.polygons), "nothing hangs here")
        triangles = mesh.triangles()
        self.assertEqual(len(triangles), sum(len(cell) - 2 for cell in mesh.polygons))

        def border(faces):
            edges = {}
            for face in faces:
                for a, b in zip(face, np.roll(face, -1)):
                    key = (min(a, b), max(a, b))
                    edges[key] = edges.get(key, 0) + 1
            self.assertLessEqual(max(edges.values()), 2)
            return {edge for edge, uses in edges.items() if uses == 1}

        self.assertEqual(border(triangles), border(mesh.polygons))

    def test_a_mesh_is_fetched_again_only_when_the_surface_has_changed(self):
        surface = self.surface()
        first = surface.mesh()
        self.assertIs(surface.mesh(), first)
        surface.set(to=3)
        self.assertGreater(surface.mesh()["t"].max(), first["t"].max())

    def test_setters_change_what_is_given_and_keep_the_rest(self):
        surface = self.surface(accuracy="exact")
        rake = self.session.rakes()[0]
        rake.set(seeds=12)
        rake.set(line=[(0.3, 0, -1), (1, 0, -1)])
        np.testing.assert_allclose(rake.points, [(0.3, 0, -1), (1, 0, -1)])
        self.assertEqual(rake.record()["seeds"], 12)
        surface.set(from_=0.5)
        self.assertEqual((surface.record()["from"], surface.record()["accuracy"]), (0.5, "exact"))
        with self.assertWarnsRegex(UserWarning, "outside of the domain in part, which is cut away, 20 % of it is left"):
            rake.set(polyline=[(9, 0, 0), (14, 0, 0)])
        self.assertTrue(rake.clipped)

    def test_goes_back_in_time_where_to_is_earlier_and_refuses_a_direction_that_says_otherwise(self):
        rake = self.session.rake(line=LINE, seeds=9)
        surface = self.session.surface(rake, "path", dataset="lamb-oseen", from_=1.5, to=0.5, separation=0.1)
        self.assertEqual(surface.record()["direction"], "backward")
        self.assertAlmostEqual(surface.mesh()["t"].min(), -1, places=5)
        surface.set(to=2)
        self.assertEqual((surface.record()["direction"], surface.record()["to"]), ("forward", 2))
        with self.assertRaises(wakesurf.InvalidParameters) as refused:
            surface.set(direction="backward")
        self.assertIn("`from_` 1.5 and `to` 1", refused.exception.hint)
        for kind, more in (("streak", {}), ("time", {"sweep": (0, 0, 0.5)})):
            with self.assertRaises(wakesurf.InvalidParameters) as refused:
                surface.set(kind=kind, direction="both", **more)
            self.assertIn("stream and path surfaces", str(refused.exception))
        surface.set(direction="both")
        surface.set(to=2.5)
        self.assertEqual(surface.record()["direction"], "both")

    def test_rakes_have_a_colour_which_changes_nothing_that_hangs_on_them(self):
        surface = self.surface()
        rake = self.session.rakes()[0]
        self.assertRegex(rake.colour, "^#[0-9a-f]{6}$")
        before = surface.record()["epoch"]
        self.assertEqual(rake.set(colour="#123456")["surfaces"], [])
        self.assertEqual((rake.colour, surface.record()["epoch"]), ("#123456", before))
        rake.set(seeds=12)
        self.assertEqual(rake.colour, "#123456")
        self.assertEqual(self.session.rake(line=LINE, colour="#abcdef").colour, "#abcdef")
        with self.assertRaises(wakesurf.InvalidParameters):
            rake.set(colour="red")

    def test_fields_are_in_the_mesh_by_name(self):
        surface = self.surface(fields=["deformation", "approximated"])
        mesh = surface.mesh()
        self.assertEqual(mesh["deformation"].shape, (len(mesh.points),))
        self.assertGreater(np.abs(mesh["deformation"]).max(), 0)
        surface.set(fields=["velocity_x", "velocity_z", "normal_y", "vorticity"])  # what the page's texture and curved cells ask for
        mesh = surface.mesh()
        self.assertTrue(np.array_equal(mesh["velocity_x"], mesh["velocity"][:, 0].astype("f4")))
        self.assertTrue(np.array_equal(mesh["velocity_z"], mesh["velocity"][:, 2].astype("f4")))
        self.assertLessEqual(np.nanmax(np.abs(mesh["normal_y"])), 1 + 1e-6)
        self.assertGreater(np.isfinite(mesh["normal_y"]).mean(), 0.9)
        for format in ("ply", "glb", "obj", "drc"):
            self.assertGreater(len(surface.download(format)), 1000)
        self.assertEqual(surface.stats()["pass"].keys(), {"queue", "load", "compute", "encode"})
        with self.assertRaises(wakesurf.InvalidParameters):
            surface.set(fields=["nothing"])
        with self.assertRaisesRegex(wakesurf.InvalidParameters, "at most 5"):
            surface.set(fields=["a", "b", "c", "d", "e", "f"])

    def test_refusals_are_exceptions_of_their_own(self):
        rake = self.session.rake(line=LINE)
        with self.assertRaises(wakesurf.OutsideDomain):
            self.session.rake(line=[(0, 0, 99), (1, 0, 99)])
        with self.assertRaises(wakesurf.InvalidParameters):
            self.session.rake(line=LINE, seeds=1)
        with self.assertRaises(wakesurf.InvalidParameters) as raised:
            self.session.call("rake.set", shade="red")
        self.assertIn("shade", str(raised.exception))
        with self.assertRaises(wakesurf.MethodNotFound):
            self.client.call("no.such")
        with self.assertRaises(wakesurf.InvalidRequest):
            self.session.call("session.join")
        revision = rake.record()["rev"]
        rake.set(seeds=5)
        with self.assertRaises(wakesurf.Stale) as stale:
            rake.set(seeds=6, if_rev=revision)
        self.assertEqual(stale.exception.current["seeds"], 5)
        with self.assertRaises(ValueError):
            self.session.rake(line=LINE, points=LINE)
        rake.delete()
        with self.assertRaises(wakesurf.NotFound):
            rake.record()
        with self.assertRaises(wakesurf.NotFound):
            self.client.session("nowhere")

    def test_a_batch_answers_in_order_with_errors_as_values(self):
        answers = self.client.batch([("server.ping", {}), ("no.such", {}), ("dataset.describe", {"dataset": "abc"})])
        self.assertEqual(answers[0], {})
        self.assertIsInstance(answers[1], wakesurf.MethodNotFound)
        self.assertEqual(answers[2]["dataset"], "abc")
        self.assertEqual(self.client.batch([]), [])

    def test_waiting_ends_in_time_and_tells_how_far_it_is(self):
        surface = self.long_surface()
        reported = []
        with self.assertRaises(wakesurf.WaitTimeout) as raised:  # of a surface that takes minutes
            surface.wait(1.5, progress=reported.append)
        self.assertGreaterEqual(len(reported), 1)
        self.assertTrue(all(each.share is None or 0 <= each.share < 1 for each in reported))
        self.assertFalse([each.state for each in reported if each.state][0]["complete"])
        self.assertIsInstance(raised.exception, TimeoutError)
        surface.delete()

    def test_a_bar_of_tqdm_is_moved_to_its_end(self):
        class Bar:
            n, total, moves = 0, 50, []

            def refresh(self):
                self.moves.append(self.n)

        bar = Bar()
        self.surface(separation=0.01).wait(progress=bar)
        self.assertEqual(bar.n, 50)
        self.assertEqual(bar.moves, sorted(bar.moves))

    def test_what_is_used_in_a_with_is_gone_afterwards(self):
        with self.session.rake(line=LINE, seeds=9) as rake:
            with self.session.surface(rake, "stream", dataset="lamb-oseen", to=2) as surface:
                surface.wait()
        self.assertEqual((self.session.rakes(), self.session.surfaces()), ([], []))
        rake = self.session.rake(line=LINE)
        with rake:
            rake.delete()

    def test_undo_and_redo(self):
        rake = self.session.rake(line=LINE, seeds=9)
        rake.set(seeds=30)
        self.assertTrue(self.session.undo()["undone"])
        self.assertEqual(rake.record()["seeds"], 9)
        self.assertTrue(self.session.redo()["redone"])
        self.assertEqual(rake.record()["seeds"], 30)

    def test_a_share_link_opens_its_session_in_its_role(self):
        surface = self.surface()
        link = self.session.share("viewer", expires_in=60)
        guest = wakesurf.Client(link)
        self.assertEqual(guest.session().id, self.session.id)
        self.assertEqual([each.id for each in guest.sessions()], [self.session.id])
        self.assertEqual(guest.session().surfaces()[0].id, surface.id)
        with self.assertRaises(wakesurf.NotPermitted):
            guest.session().rake(line=LINE)

    # Files.

    def test_exports_in_every_format_and_leaves_nothing_half_written(self):
        surface = self.surface()
        with tempfile.TemporaryDirectory() as folder:
            for extension, start in ((".vtp", b"<?xml"), (".glb", b"glTF"), (".ply", b"ply\n"), (".obj", b"# wak"),
                                     (".drc", b"DRACO")):
                path = os.path.join(folder, "mesh" + extension)
                surface.export(path)
                with open(path, "rb") as file:
                    self.assertTrue(file.read(8).startswith(start), extension)
            plain = os.path.join(folder, "mesh.GLB")
            surface.export(plain, draco=False)
            with open(plain, "rb") as file:
                self.assertNotIn(b"KHR_draco", file.read())
            os.remove(plain)
            with self.assertRaises(ValueError):
                surface.export(os.path.join(folder, "mesh.stl"))
            nowhere = os.path.join(folder, "nowhere", "mesh.ply")
            with self.assertRaises(FileNotFoundError) as raised:
                surface.export(nowhere)
            self.assertEqual(raised.exception.filename, nowhere)
            surface.export(os.fsencode(os.path.join(folder, "mesh.ply")))
            surface.delete()
            with self.assertRaises(wakesurf.NotFound):
                surface.export(os.path.join(folder, "gone.ply"))
            self.assertEqual(len(os.listdir(folder)), 5)

    def test_shows_itself_in_a_notebook(self):
        surface = self.surface()
        surface.wait()
        self.assertIn("<th>quads</th>", surface._repr_html_())
        self.assertNotIn("token", repr(self.client))

    # Live.

    def test_watching_gives_every_state_coarse_before_final_and_the_checksum_of_the_server(self):
        surface = self.surface()
        surface.wait()
        updates = surface.watch(timeout=30)
        first = next(update for update in updates if update.phase == "final")
        stats = surface.stats()
        self.assertEqual((first.vertices, first.cells, first.state_sum), (stats["vertices"], stats["quads"], stats["stateSum"]))
        self.assertGreater(first.bytes, 100)

        def edit():
            wakesurf.Client(self.server.url).session(self.session.id).surfaces()[0].set(to=4)

        threading.Thread(target=edit).start()
        later = next(update for update in updates if update.epoch > first.epoch and update.phase == "final")
        updates.close()
        self.assertGreater(later.vertices, first.vertices)
        self.assertEqual(len(later.mesh().points), later.vertices)

    def test_a_mesh_says_which_arrays_it_has_and_how_to_ask_for_others(self):
        mesh = self.surface().mesh()
        for name, said in (("vorticity", 'fields=["vorticity"]'), ("sped", "did you mean `speed`")):
            with self.assertRaises(KeyError) as raised:
                mesh[name]
            self.assertIsInstance(raised.exception, wakesurf.NoSuchArray)
            self.assertIn(said, str(raised.exception))
            self.assertIn("s, t, speed", str(raised.exception))

    def test_points_that_are_none_are_refused_with_an_example(self):
        for points, said in (((-1.5, -1.2, 1), "a single point"), ([(1, 2), (3, 4)], "three numbers"), ("ab", "three numbers"),
                             ([(1, 2, 3), (4, 5)], "three numbers"), (5, "three numbers")):
            with self.subTest(points), self.assertRaises(wakesurf.InvalidPoints) as raised:
                self.session.rake(line=points)
            self.assertIsInstance(raised.exception, TypeError)
            self.assertIn(said, str(raised.exception))
            self.assertIn("write line=[(", str(raised.exception))
        rake = self.session.rake(line=np.array([(0, 0, 0), (0, 1, 0)]))
        with self.assertRaises(wakesurf.InvalidPoints):
            rake.set(circle=(0, 0, 1))

    def test_hints_speak_python(self):
        with self.assertRaises(wakesurf.InvalidParameters) as raised:
            self.session.call("surface.set", rake="r1", dataset="abc", kind="stream", to=1, nonsenseWord=1)
        self.assertIn("`max_quads`", raised.exception.hint)
        self.assertNotIn("`maxQuads`", str(raised.exception))
        with self.assertRaises(wakesurf.InvalidParameters) as raised:
            self.session.call("rake.set", kind="line", points=[[0, 0, 0], [0, 1, 0]], seeds=1)
        self.assertIn("`seeds` must be", raised.exception.message)
        self.assertEqual(raised.exception.hint, "", "the message says it all: nothing that holds for every parameter")
        with self.assertRaises(wakesurf.NotFound) as raised:
            self.client.describe("nothing")
        self.assertEqual(raised.exception.hint, "`session.api.dataset.list()` lists them")

    def test_live_meshes_are_the_servers_on_its_lattice_through_edits(self):
        surface = self.surface(fields=["vorticity"])
        surface.wait()
        live = surface.live(timeout=30)
        first = next(mesh for mesh in live if mesh.about["phase"] == "final")
        self.same_surface(first, surface)

        def edit():
            wakesurf.Client(self.server.url).session(self.session.id).surfaces()[0].set(to=4)

        threading.Thread(target=edit).start()
        later = next(mesh for mesh in live if mesh.about["epoch"] > first.about["epoch"] and mesh.about["phase"] == "final")
        live.close()
        self.assertGreater(len(later.points), len(first.points))
        self.same_surface(later, surface)

    def same_surface(self, live, surface):
        """In any order: the wire has its own."""
        exact = surface.mesh()
        self.assertTrue(live.about["lossless"])
        self.assertEqual((len(live.points), len(live.polygons)), (len(exact.points), len(exact.polygons)))
        step = self.client.describe("lamb-oseen")["lattice"]["step"]
        np.testing.assert_allclose(live.points.min(axis=0), exact.points.min(axis=0), atol=step)
        np.testing.assert_allclose(live.points.max(axis=0), exact.points.max(axis=0), atol=step)
        np.testing.assert_allclose(live.points.mean(axis=0), exact.points.mean(axis=0), atol=step)
        for name in ("speed", "s", "t", "vorticity"):
            width = np.ptp(exact[name]) / 65535 + 1e-5
            np.testing.assert_allclose(np.sort(live[name]), np.sort(exact[name]), atol=width, err_msg=name)
        sizes = np.bincount(np.diff(live.offsets))
        np.testing.assert_array_equal(sizes, np.bincount(np.diff(exact.offsets)))

    def test_watching_says_when_nothing_comes(self):
        updates = self.long_surface().watch(timeout=0.5)
        with self.assertRaises(wakesurf.WaitTimeout):
            for _ in updates:
                pass


if __name__ == "__main__":
    unittest.main()
