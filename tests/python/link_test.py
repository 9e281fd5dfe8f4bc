"""A surface held by another program, as the plugin for ParaView holds it: beside people who work in the same session."""
import unittest

import numpy as np

from real_server import ServerTest
import wakesurf
from wakesurf.link import Link

LINE = ((0.4, 0.4, 0.1), (0.6, 0.6, 0.1))
OTHER = ((0.3, 0.5, 0.2), (0.7, 0.5, 0.2))


class LinkTest(ServerTest):
    def setUp(self):
        self.session = self.client.create_session("linked")
        self.link = Link(self.server.url, self.session.id, kind="path")
        self.link.change({"from_": 0.0, "to": 2.0, "separation": 0.1})

    def test_moves_the_rake_of_the_session_and_has_the_surface_on_it(self):
        self.link.move(LINE)
        (rake,) = self.session.rakes()
        self.assertEqual(rake.points.tolist(), [list(each) for each in LINE])
        mesh = self.link.mesh(1.0)
        self.assertEqual(mesh.about["time"], 1.0)
        at_rake = mesh.points[mesh["t"] == 0]
        np.testing.assert_allclose(at_rake[np.argsort(at_rake[:, 0])][[0, -1]], LINE, atol=1e-9)

    def test_asks_once_so_that_what_others_change_stays(self):
        self.link.move(LINE)
        (rake,), (surface,) = self.session.rakes(), self.session.surfaces()
        rake.set(line=OTHER)
        surface.set(separation=0.2)
        self.link.move(LINE)
        self.link.change({"to": 2.0, "separation": 0.1})
        self.assertEqual(self.link.line(), OTHER)
        self.assertEqual(surface.record()["separation"], 0.2)
        self.link.change({"separation": 0.05})
        self.assertEqual(surface.record()["separation"], 0.05)

    def test_notices_what_others_change_and_nothing_else(self):
        self.link.mesh(1.0)
        self.assertFalse(self.link.changed())
        (rake,) = self.session.rakes()
        rake.set(line=OTHER)
        self.assertTrue(self.link.changed())
        self.link.mesh(1.0)
        self.assertFalse(self.link.changed())
        self.session.set_time(1.5)  # of the page; a link asks for times of its own
        self.assertFalse(self.link.changed())

    def test_takes_a_surface_that_is_there_and_makes_none(self):
        (surface,) = self.session.surfaces()
        other = Link(self.server.url, self.session.id, surface=surface.id)
        self.assertEqual(len(self.session.surfaces()), 1)
        self.assertEqual(other.rake.id, self.link.rake.id)
        with self.assertRaises(wakesurf.NotFound):
            Link(self.server.url, self.session.id, surface="s99")

    def test_has_the_times_of_the_data_while_there_is_a_surface(self):
        self.assertEqual(self.link.steps(), [0.0, 0.5, 1.0, 1.5, 2.0])
        self.assertEqual(self.link.mesh(99.0).about.get("time", 2.0), 2.0)  # the nearest
        self.link.change({"kind": "stream"})
        self.assertEqual(self.link.steps(), [])
        self.assertGreater(len(self.link.mesh(1.0).points), 10)

    def test_refuses_a_rake_without_length_before_anyone_sees_it(self):
        with self.assertRaises(wakesurf.InvalidParameters):
            self.link.move((LINE[0], LINE[0]))


if __name__ == "__main__":
    unittest.main()
