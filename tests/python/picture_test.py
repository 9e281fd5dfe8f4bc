"""Pictures and films from a script: the server's page in a Chromium without a window, and nothing of it left in the session."""
import importlib.util
import io
import os
import re
import shutil
import tempfile
import typing
import unittest
import warnings
from unittest import mock

import numpy as np

from real_server import ROOT, RealServer
import wakesurf
from wakesurf.chrome import find_browser

LINE = [(0.4, 0.4, 0.1), (0.6, 0.6, 0.1)]
BROWSER = shutil.which("chromium") or shutil.which("chromium-headless-shell")
PAGE = os.path.join(ROOT, "web-client/dist/index.html")


def pixels(data):
    from PIL import Image
    return np.asarray(Image.open(io.BytesIO(data)).convert("RGBA"), dtype=int)


def coloured(image):
    """How many pixels have a colour, and are no text or line."""
    return int(((image[..., :3].max(axis=-1) - image[..., :3].min(axis=-1) > 60) & (image[..., 3] > 0)).sum())


@unittest.skipUnless(BROWSER, "Chromium is not installed (Debian: chromium)")
@unittest.skipUnless(os.path.exists(PAGE), "the page is not built (npm run build in web-client)")
@unittest.skipUnless(importlib.util.find_spec("PIL"), "Pillow is not installed (Debian: python3-pil)")
class PictureTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        server = RealServer("flow:tornado")
        cls.addClassCleanup(server.stop)
        cls.session = wakesurf.Client(server.url).session()
        rake = cls.session.rake(line=LINE, seeds=16)
        cls.surface = cls.session.surface(rake, "streak", dataset="tornado", from_=0, to=4, separation=0.05)
        cls.surface.wait()
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)

    def everything(self):
        state = self.session.state()
        client = self.session.client
        return {name: state[name] for name in ("rakes", "surfaces", "bookmarks", "annotations", "clock")}, self.session.api.session.shares(), \
            [each.id for each in client.sessions()], [each.id for each in client.sessions(trash=True)]

    def test_of_another_time_may_be_drawn_by_who_may_only_look_and_no_copy_stays(self):
        before, link = self.everything(), self.session.share("viewer")
        early, late = (wakesurf.Client(link).session().picture(size=(400, 300), time=time, bar=False, axes=False) for time in (1, 4))
        self.assertGreater(coloured(pixels(late.data)), 1.2 * coloured(pixels(early.data)))
        for share in self.session.api.session.shares()["shares"]:
            self.session.api.session.unshare(grant=share["grant"])
        self.assertEqual(self.everything(), before)

    def test_of_what_a_surface_does_not_carry_are_refused_to_who_may_only_look_and_no_copy_stays(self):
        sessions, link = self.everything()[2:], self.session.share("viewer")
        with self.assertRaisesRegex(wakesurf.PictureFailed, "does not carry vorticity.*an editor can"):
            wakesurf.Client(link).session().picture(view={"look": {"colour_by": "vorticity"}})
        self.assertEqual(self.everything()[2:], sessions)
        for share in self.session.api.session.shares()["shares"]:
            self.session.api.session.unshare(grant=share["grant"])

    def test_has_the_size_the_looks_and_the_ground_that_were_asked_for(self):
        before, path = self.everything(), os.path.join(self.folder.name, "a.png")
        with self.session.painter((640, 400), view={"look": {"colour_by": "constant", "colour": "#ff0000"}}) as painter:
            picture = painter.picture(path, (900, 600), background="clear", bar=False, axes=False)
            plain = painter.picture(None, (900, 600), background="white", bar=True, axes=True, caption="t = 4")
        with open(path, "rb") as file:
            self.assertEqual(file.read(), picture.data)
        image = pixels(picture.data)
        self.assertEqual(image.shape, (600, 900, 4))
        self.assertEqual(image[5, 5].tolist(), [0, 0, 0, 0])
        shown = image[image[..., 3] == 255]
        self.assertGreater(len(shown), 1000)
        self.assertTrue((shown[:, 0] > 2 * shown[:, 1]).mean() > 0.95, "the surface is not red")
        ground = pixels(plain.data)
        self.assertEqual(ground[-5, 5].tolist(), [255, 255, 255, 255])
        # Bar, axes and caption are dark on it, beside what is dark of the surface.
        surface = (image[..., 3] == 255) & (image[..., :3].max(axis=-1) < 200)
        self.assertGreater((ground[..., :3].max(axis=-1) < 200).sum(), surface.sum() + 1000)
        self.assertEqual(self.everything(), before)

    def test_of_points_covers_what_that_of_cells_does(self):
        shown = []
        for points in (False, True):
            look = {"colour_by": "constant", "colour": "#ff0000", "back_side": "same", "points": points}
            drawn = self.session.picture(None, (640, 400), view={"look": look}, background="clear", bar=False, axes=False)
            shown.append(pixels(drawn.data)[..., 3] == 255)
        cells, points = shown
        self.assertGreater(cells.sum(), 1000)
        self.assertLess((cells ^ points).sum() / cells.sum(), 0.06)  # outlines of a rolled sheet
        self.assertGreater((cells ^ points).sum(), 0, "the same picture")

    def test_a_film_has_a_picture_for_each_time_while_the_clock_of_the_session_stands(self):
        before, reported = self.everything(), []
        folder = os.path.join(self.folder.name, "film")
        files = self.session.film(folder, [1, 2.5, 4], (320, 200), bar=False, axes=False, progress=reported.append)
        self.assertEqual([os.path.basename(each) for each in files], ["frame_0000.png", "frame_0001.png", "frame_0002.png"])
        sizes = []
        for file in files:
            with open(file, "rb") as opened:
                sizes.append(coloured(pixels(opened.read())))
        self.assertTrue(0 < sizes[0] < sizes[1] < sizes[2], f"a streak surface grows: {sizes}")
        self.assertEqual(reported[-1].share, 1.0)
        self.assertEqual(self.everything(), before)

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_a_film_is_one_file_where_ffmpeg_is_there(self):
        path = os.path.join(self.folder.name, "film.mp4")
        self.assertEqual(self.session.film(path, [3, 4], (321, 201)), [path])
        with open(path, "rb") as file:
            self.assertEqual(file.read(12)[4:8], b"ftyp")

    def test_says_what_is_missing_before_anything_is_begun(self):
        before = self.everything()
        os.environ["WAKESURF_CHROMIUM"] = "/nowhere/chromium"
        try:
            with self.assertRaisesRegex(wakesurf.BrowserMissing, "/nowhere/chromium.*Debian: chromium"):
                self.session.picture()
        finally:
            del os.environ["WAKESURF_CHROMIUM"]
        self.assertTrue(os.path.exists(find_browser()))
        with self.assertRaisesRegex(wakesurf.UnknownParameter, "did you mean `colour_by`"):
            self.session.picture(view={"look": {"color_by": "speed"}})
        with self.assertRaisesRegex(ValueError, "neither a folder"):
            self.session.film("film.avi", [1])
        self.assertEqual(self.everything(), before)

    def refused(self, words, call, kind=wakesurf.WakesurfError):
        """Before a browser starts."""
        with mock.patch("wakesurf.picture.Chrome", side_effect=AssertionError("a browser was started")):
            with self.assertRaisesRegex(kind, words):
                call()

    def test_refuses_a_look_or_a_camera_that_there_is_not_and_names_what_there_is(self):
        before = self.everything()
        for look, words in (({"colour_by": "jet"}, "`colour_by` is 'jet'.*there are speed, age, s, constant, vorticity"),
                            ({"colour_by": "vortcity"}, "did you mean vorticity"), ({"colour_by": "field:pressure"}, "there are speed"),
                            ({"colour_by": "field:velocity"}, "there are speed"), ({"colour_by": 3}, "there are speed"),
                            ({"map": "jet"}, "`map` is 'jet'.*viridis.*turbo"), ({"map": "Turbo"}, "did you mean turbo"),
                            ({"lines": "dots"}, "none, timelines"), ({"back_side": "no"}, "shaded, same, tinted"),
                            ({"range_of": "time"}, "surface, data"), ({"opacity": 2}, "from 0 to 1"), ({"density": 0}, "from 0.125 to 8"),
                            ({"opacity": "half"}, "from 0 to 1"), ({"invert": "yes"}, "True and False"), ({"centre": float("nan")}, "a number"),
                            ({"range": [2, 1]}, "the lower one first"), ({"range": 1}, "two numbers"), ({"colour": "red"}, "#rrggbb")):
            with self.subTest(look):
                self.refused(words, lambda look=look: self.session.picture(view={"look": look}), wakesurf.InvalidParameters)
                self.refused(words, lambda look=look: self.session.film("film", [1], view={"look": look}), wakesurf.InvalidParameters)
        for view, words in (({"looks": {"s9": {}}}, "`looks` has no `s9`.*" + self.surface.id),
                            ({"looks": {self.surface.id: {"map": "jet"}}}, "`map` is 'jet'"), ({"camera": {"position": (1, 1, 1)}}, "needs `target`"),
                            ({"camera": {"position": (1, 1), "target": (0, 0, 0)}}, "needs `position`.*three numbers"),
                            ({"camera": {"position": (1, 1, 1), "target": (1, 1, 1)}}, "the same point")):
            with self.subTest(view):
                self.refused(words, lambda view=view: self.session.picture(view=view), wakesurf.InvalidParameters)
        self.assertEqual(self.everything(), before)

    def test_refuses_a_time_outside_of_the_data_a_size_a_ground_and_a_file_that_cannot_be(self):
        before = self.everything()
        for time in (-0.5, 99, 1e9):
            self.refused("outside of the data.*0 to 10", lambda time=time: self.session.picture(time=time), wakesurf.OutsideTimeRange)
            self.refused("outside of the data.*0 to 10", lambda time=time: self.session.film("film", [1, time]), wakesurf.OutsideTimeRange)
        for time in (float("nan"), "end"):
            self.refused("the time is", lambda time=time: self.session.picture(time=time), wakesurf.InvalidParameters)
        self.refused("one or more", lambda: self.session.film("film", []), wakesurf.InvalidParameters)
        for size, words in (((0, 300), "from 16 to 16384"), ((300, -1), "16"), ((300,), "width and height"), ((300.5, 200), "whole pixels"), (300, "width"),
                            (("300", "200"), "whole pixels"), ((20000, 20), "16384"), ((16000, 16000), "128 million")):
            self.refused("`size` is .*" + words, lambda size=size: self.session.picture(size=size), wakesurf.InvalidParameters)
            self.refused("`size` is .*" + words, lambda size=size: self.session.film("film", [1], size), wakesurf.InvalidParameters)
        for call in (lambda: self.session.picture(background="black"), lambda: self.session.film("film", [1], background="black")):
            self.refused("`background` is 'black'.*shown, white, clear", call, wakesurf.InvalidParameters)
        for path in ("p.jpg", "p", b"p.tiff", os.path.join(self.folder.name, "a.pdf")):
            self.refused("pictures are written as .png", lambda path=path: self.session.picture(path), wakesurf.InvalidParameters)
        path = os.path.join(self.folder.name, "nowhere", "a.png")
        self.refused("nowhere/a.png'$", lambda: self.session.picture(path), FileNotFoundError)
        self.refused("nowhere/a.mp4'$", lambda: self.session.film(path.replace("png", "mp4"), [1]), FileNotFoundError)
        self.refused("cannot be filled in.*time", lambda: self.session.film("film", [1], caption="{tme}"), wakesurf.InvalidParameters)
        self.refused("`fps` is 0", lambda: self.session.film("film", [1], fps=0), wakesurf.InvalidParameters)
        self.assertFalse(os.path.exists("film"))
        self.assertEqual(self.everything(), before)

    def test_has_colours_that_the_surface_does_not_carry_in_a_copy_that_does(self):
        before = self.everything()
        ground, speed = (self.session.picture(size=(320, 240), view={"look": {"colour_by": by}}, bar=False, axes=False)
                         for by in ("vorticity", "speed"))
        self.assertEqual(self.everything(), before)
        self.surface.set(fields=["vorticity"])
        self.addCleanup(self.surface.set, fields=[])
        carried = self.session.picture(size=(320, 240), view={"look": {"colour_by": "vorticity"}}, bar=False, axes=False)
        self.assertLess(np.abs(pixels(ground.data) - pixels(carried.data)).mean(), 0.1)
        self.assertGreater(np.abs(pixels(ground.data) - pixels(speed.data)).mean(), 1)

    def test_small_ones_have_a_bar_and_letters_that_can_be_read_and_are_no_giants(self):
        def drawn(size, bar=False, **more):
            return pixels(painter.picture(None, size, bar=bar, axes=False, background="white", **more).data)[..., :3]

        def changed(one, other):
            """The box of what differs: left, top, right, bottom."""
            rows, columns = np.nonzero(np.abs(one - other).max(axis=-1) > 40)
            return columns.min(), rows.min(), columns.max() + 1, rows.max() + 1

        with self.session.painter((640, 400)) as painter:
            for size in ((300, 200), (640, 400)):
                with self.subTest(size):
                    plain = drawn(size)
                    left, top, right, bottom = changed(plain, drawn(size, bar=True))
                    self.assertTrue(180 < right - left <= 280 and 30 < bottom - top < 70, (left, top, right, bottom))
                    self.assertTrue(left > 0 and top > size[1] / 2 and right < size[0] and bottom < size[1], (left, top, right, bottom))
                    left, top, right, bottom = changed(plain, drawn(size, caption="H"))  # 16 pixels where a number has 12
                    self.assertTrue(7 <= bottom - top <= 13, f"a letter is {bottom - top} pixels high")

    def test_say_where_there_is_no_room_for_the_bar(self):
        with self.assertWarnsRegex(UserWarning, "200 x 200 pixels are too small for the scalar bar"):
            self.assertTrue(self.session.picture(size=(200, 200)).bar_left_out)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertFalse(self.session.picture(size=(200, 200), bar=False).bar_left_out)

    def test_the_looks_that_are_refused_are_those_that_the_page_does_not_know(self):
        with open(os.path.join(ROOT, "web-client/src/state/surfaceLook.ts"), encoding="utf-8") as file:
            page = dict(re.findall(r"^(?:export )?const (\w+) = \[(.*)\] as const;", file.read(), re.M))
        hints = typing.get_type_hints(wakesurf.SurfaceLook)
        for name, there in (("map", "colourMaps"), ("lines", "lineKinds"), ("back_side", "backSides"), ("range_of", "rangesOf")):
            self.assertEqual(list(typing.get_args(hints[name])), re.findall(r"'(\w+)'", page[there]))

    def test_one_that_is_not_whole_in_time_is_an_error_that_says_what_is_missing(self):
        with self.session.client.scratch() as other:
            rake = other.rake(line=LINE, seeds=16)
            other.surface(rake, "stream", dataset="tornado", to=400, separation=0.0005, max_quads=4_000_000)
            with self.assertRaisesRegex(wakesurf.WakesurfError, "not whole after 4 s"):
                other.picture(size=(320, 200), timeout=4)


if __name__ == "__main__":
    unittest.main()
