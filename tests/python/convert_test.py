"""A mesh as the objects of other packages: nothing is lost on the way. Each is tried where that package is."""
import importlib.util
import os
import tempfile
import unittest

import numpy as np

from real_server import RealServer
import wakesurf


def there(name):
    return importlib.util.find_spec(name) is not None


class ConvertTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        server = RealServer("flow:abc")
        cls.addClassCleanup(server.stop)
        session = wakesurf.Client(server.url).session()
        rake = session.rake(line=[(0.5, 0, 0), (2.5, 0.3, 1)], seeds=8)
        cls.surface = session.surface(rake, "stream", dataset="abc", to=6, separation=0.2, fields=["vorticity"])
        cls.mesh = cls.surface.mesh()
        assert len(cls.mesh.quads) < len(cls.mesh.polygons), "nothing hangs here"

    def test_quads_and_triangles_are_all_of_it(self):
        quads, triangles = self.mesh.quads_and_triangles()
        self.assertEqual((quads.shape[1], triangles.shape[1]), (4, 3))
        cut = sum(len(cell) - 2 for cell in self.mesh.polygons if len(cell) != 4)
        self.assertEqual((len(quads), len(triangles)), (len(self.mesh.quads), cut))
        self.assertEqual(len(np.unique(np.concatenate([quads.ravel(), triangles.ravel()]))), len(self.mesh.points))

    def test_areas_and_normals_are_those_of_a_cylinder(self):
        angle, height = np.linspace(0, 2 * np.pi, 201)[:-1], np.linspace(0, 2, 21)
        points = np.array([(np.cos(a), np.sin(a), h) for h in height for a in angle])
        quads = np.array([[r * 200 + i, r * 200 + (i + 1) % 200, (r + 1) * 200 + (i + 1) % 200, (r + 1) * 200 + i]
                          for r in range(20) for i in range(200)])
        mesh = wakesurf.Mesh(points, quads.ravel(), np.arange(0, 4 * len(quads) + 1, 4), {}, {})
        self.assertAlmostEqual(mesh.areas(mesh.quads).sum(), 4 * np.pi, delta=0.002)
        np.testing.assert_allclose(mesh.normals(), points * [1, 1, 0], atol=0.02)

    @unittest.skipUnless(there("pandas"), "pandas is not installed (Debian: python3-pandas)")
    def test_a_dataframe_has_a_row_a_vertex_and_a_column_a_component(self):
        frame = self.surface.to_dataframe()
        self.assertEqual(len(frame), len(self.mesh.points))
        np.testing.assert_array_equal(frame[["x", "y", "z"]].to_numpy(), self.mesh.points)
        np.testing.assert_array_equal(frame[["velocity_x", "velocity_y", "velocity_z"]].to_numpy(), self.mesh["velocity"])
        self.assertAlmostEqual(frame["vorticity"].max(), self.mesh["vorticity"].max())

    @unittest.skipUnless(there("meshio"), "meshio is not installed (Debian: python3-meshio)")
    def test_meshio_writes_it_and_reads_the_same(self):
        import meshio
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "surface.vtu")
            self.surface.to_meshio().write(path)
            read = meshio.read(path)
        np.testing.assert_allclose(read.points, self.mesh.points)
        quads, triangles = self.mesh.quads_and_triangles()
        np.testing.assert_array_equal(read.cells_dict["quad"], quads)
        np.testing.assert_array_equal(read.cells_dict["triangle"], triangles)
        np.testing.assert_allclose(read.point_data["speed"], self.mesh["speed"])

    @unittest.skipUnless(there("vtkmodules"), "VTK's Python is not installed (Debian: python3-vtk9)")
    def test_vtk_has_the_same_polygons_and_arrays_also_when_ours_are_gone(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        data = self.surface.to_vtk()
        self.assertEqual((data.GetNumberOfPoints(), data.GetNumberOfPolys()), (len(self.mesh.points), len(self.mesh.polygons)))
        np.testing.assert_array_equal(vtk_to_numpy(data.GetPoints().GetData()), self.mesh.points)
        np.testing.assert_array_equal(vtk_to_numpy(data.GetPolys().GetConnectivityArray()), self.mesh.connectivity)
        for name, values in self.mesh.arrays.items():
            np.testing.assert_array_equal(vtk_to_numpy(data.GetPointData().GetArray(name)), values, err_msg=name)
        self.assertEqual(data.GetPointData().GetScalars().GetName(), "speed")

    @unittest.skipUnless(there("pyvista"), "pyvista is not installed")
    def test_pyvista_has_the_same(self):
        data = self.surface.to_pyvista()
        self.assertEqual((data.n_points, data.n_cells), (len(self.mesh.points), len(self.mesh.polygons)))

    def test_what_is_missing_is_named_with_where_it_comes_from(self):
        from wakesurf.mesh import needed
        with self.assertRaisesRegex(ImportError, r"the package nothing_of_the_kind"):
            needed("nothing_of_the_kind.at_all")
        if not there("pyvista"):
            with self.assertRaisesRegex(ImportError, r"pyvista \(pip: pyvista\)|vtkmodules \(Debian: python3-vtk9"):
                self.mesh.to_pyvista()


if __name__ == "__main__":
    unittest.main()
