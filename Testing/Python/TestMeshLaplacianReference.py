# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""The arrays of vtkMeshLaplacian and vtkTriangleRadiusRatio agree with dense matrices."""
import unittest

import numpy as np
from laplacianmesh import vtkMeshLaplacian, vtkTriangleRadiusRatio

import lmo_reference as reference
import lmo_testing as testing

MESHES = {
    "closed": testing.with_isolated_point(testing.torus(10, 10)),
    "open": testing.with_isolated_point(testing.patch(10, 10)),
}


class MeshLaplacianReference(unittest.TestCase):
    def assert_agrees(self, name, expected):
        """The array has the values of expected(V, T), to round-off of the largest one."""
        for kind, mesh in MESHES.items():
            with self.subTest(kind):
                output = testing.updated(vtkMeshLaplacian, testing.to_polydata(mesh)).GetOutput()
                values = expected(*mesh)
                error = np.abs(testing.point_array(output, name) - values).max()
                self.assertLess(error / np.abs(values).max(), 1e-12)

    def test_uniform_laplacian(self):
        self.assert_agrees(
            "UniformLaplacian",
            lambda V, T: reference.normalised(reference.uniform_weights(V, T)) @ V,
        )

    def test_cotangent_laplacian(self):
        self.assert_agrees(
            "CotangentLaplacian",
            lambda V, T: reference.normalised(reference.cotangent_weights(V, T)) @ V,
        )

    def test_mean_curvature_normal(self):
        self.assert_agrees("MeanCurvatureNormal", reference.mean_curvature_normals)

    def test_mean_curvature(self):
        self.assert_agrees("MeanCurvature", reference.mean_curvatures)

    def test_gaussian_curvature(self):
        self.assert_agrees("GaussianCurvature", reference.gaussian_curvatures)

    def test_voronoi_area(self):
        self.assert_agrees("VoronoiArea", reference.voronoi_areas)


class RadiusRatioReference(unittest.TestCase):
    def test_radius_ratio_of_triangles(self):
        for V, T in MESHES.values():
            output = testing.updated(
                vtkTriangleRadiusRatio, testing.to_polydata((V, T))
            ).GetOutput()
            error = testing.cell_array(output, "RadiusRatio") - reference.radius_ratios(V, T)
            self.assertLess(np.abs(error).max(), 1e-12)

    def test_radius_ratio_of_points_is_the_minimum_at_the_point(self):
        for V, T in MESHES.values():
            output = testing.updated(
                vtkTriangleRadiusRatio, testing.to_polydata((V, T))
            ).GetOutput()
            used = reference.is_used(len(V), T)
            error = testing.point_array(output, "RadiusRatio") - reference.quality_weights(V, T)
            self.assertLess(np.abs(error[used]).max(), 1e-12)


if __name__ == "__main__":
    unittest.main()
