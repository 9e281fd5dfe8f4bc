"""Bodies and patches of the boundary as files."""
import unittest
import xml.etree.ElementTree as ElementTree

from real_server import ServerTest
import wakesurf


class BodyTest(ServerTest):
    datasets = ("flow:sphere",)

    def test_is_a_file_with_the_field_at_its_points(self):
        piece = ElementTree.fromstring(self.client.body("sphere", field="vorticity")).find("PolyData/Piece")
        self.assertGreater(int(piece.get("NumberOfPolys")), 1000)
        self.assertEqual([each.get("Name") for each in piece.find("PointData")], ["vorticity"])
        shape = ElementTree.fromstring(self.client.body("sphere", all_patches=True))
        self.assertEqual(len(shape.find("PolyData/Piece/PointData")), 0)

    def test_a_patch_and_a_field_that_are_not_there_are_refused_in_words(self):
        for given in ({"patch": "hull"}, {"field": "nothing"}):
            with self.assertRaisesRegex(wakesurf.WakesurfError, "hull|nothing"):
                self.client.body("sphere", **given)
        with self.assertRaisesRegex(wakesurf.NotFound, "there is no patch hull"):
            self.client.streamlines("sphere", walls=0.1, patches="hull")


    def test_lines_along_it_lie_on_it(self):
        lines = self.client.streamlines("sphere", along_walls=True, seeds=20)
        self.assertEqual(len(lines), 20)
        radii = (lines.points ** 2).sum(axis=1) ** 0.5
        self.assertLess(radii.max() - radii.min(), 0.01 * radii.max())


if __name__ == "__main__":
    unittest.main()
