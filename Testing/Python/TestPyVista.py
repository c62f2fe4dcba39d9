# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""laplacianmesh.pyvista: with PyVista, and what it says without it."""
import sys
import unittest
from unittest import mock

import numpy as np

try:
    import pyvista
except ImportError:
    pyvista = None


class WithoutPyVista(unittest.TestCase):
    def test_the_import_says_what_to_install(self):
        sys.modules.pop("laplacianmesh.pyvista", None)
        with mock.patch.dict(sys.modules, {"pyvista": None}):
            with self.assertRaisesRegex(ImportError, "python3-pyvista"):
                import laplacianmesh.pyvista


@unittest.skipUnless(pyvista, "PyVista is not installed")
class WithPyVista(unittest.TestCase):
    def setUp(self):
        import laplacianmesh.pyvista as functions

        self.functions = functions
        sphere = pyvista.Icosphere(radius=2, nsub=4)
        points = sphere.points * np.random.default_rng(1).normal(1, 0.01, (sphere.n_points, 1))
        self.sphere = sphere
        self.noisy = pyvista.PolyData(points, sphere.faces)

    def roughness(self, mesh):
        return np.linalg.norm(mesh.points, axis=1).std()

    def test_triangles_improve_within_the_error(self):
        better = self.functions.improve_triangles(self.noisy, max_deviation=0.001)
        self.assertIsInstance(better, pyvista.PolyData)
        self.assertGreater(better["MeanRadiusRatio"][0], better["InputMeanRadiusRatio"][0])
        self.assertLessEqual(better["RelativeHausdorffBound"][0], 0.001)
        measured = self.functions.deviation(better, self.noisy)
        self.assertLessEqual(measured["RelativeHausdorffDistance"][0], 0.001)
        self.assertGreater(measured["RelativeHausdorffDistance"][0], 0)

    def test_noise_becomes_less_and_the_volume_stays(self):
        smooth = self.functions.denoise(self.noisy)
        self.assertLess(self.roughness(smooth), 0.3 * self.roughness(self.noisy))
        self.assertAlmostEqual(smooth.volume / self.noisy.volume, 1, 6)

    def test_smaller_scale_factors_smooth_more(self):
        smooth, smoother = (self.functions.denoise(self.noisy, s) for s in (1, 0.1))
        self.assertLess(self.roughness(smoother), self.roughness(smooth))

    def test_the_faces_of_a_noisy_cube_become_flat(self):
        cube = pyvista.Box(level=15).triangulate().clean()
        noise = np.random.default_rng(1).normal(0, 0.02, (cube.n_points, 3))
        noisy = pyvista.PolyData(cube.points + noise, cube.faces)
        flat = self.functions.denoise(noisy, flat_faces=True)
        distance = [self.functions.deviation(mesh, cube)["MeanDistance"][0] for mesh in (noisy, flat)]
        self.assertLess(distance[1], 0.5 * distance[0])

    def test_the_mean_curvature_of_a_sphere(self):
        curvature = self.functions.mean_curvature(self.sphere)["MeanCurvature"]
        self.assertLess(np.abs(curvature - 1 / 2).max(), 0.02)

    def test_concentric_spheres_are_the_difference_of_their_radii_apart(self):
        result = self.functions.deviation(self.sphere, pyvista.Icosphere(radius=3, nsub=4))
        self.assertLess(np.abs(result["Distance"] - 1).max(), 0.02)
        self.assertAlmostEqual(result["HausdorffDistance"][0], 1, 1)

    def test_the_input_is_left_as_it_is(self):
        points = self.noisy.points.copy()
        self.functions.denoise(self.noisy)
        self.assertTrue(np.array_equal(self.noisy.points, points))
        self.assertEqual(self.noisy.array_names, [])

    def test_other_meshes_give_their_surface(self):
        block = pyvista.ImageData(dimensions=(4, 4, 4)) if hasattr(pyvista, "ImageData") else None
        block = block or pyvista.UniformGrid(dimensions=(4, 4, 4))
        self.assertEqual(self.functions.mean_curvature(block).n_points, 56)

    def test_properties_of_the_filter_are_keywords(self):
        one = self.functions.improve_triangles(self.noisy, NumberOfPasses=1)
        self.assertEqual(one["Passes"][0], 1)

    def test_errors_are_exceptions(self):
        with self.assertRaisesRegex(RuntimeError, "MaximumDeviation"):
            self.functions.improve_triangles(self.noisy, max_deviation=-1)


if __name__ == "__main__":
    unittest.main()
