# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the paper says of its results holds on meshes made in code."""
import unittest

import numpy as np
from laplacianmesh import vtkLaplacianMeshOptimizer as Optimizer
from laplacianmesh import vtkSurfaceDeviation
from vtkmodules.vtkFiltersCore import vtkContourFilter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

import lmo_testing as testing


def wavelet_contour():
    """What a contour filter makes: triangles of every shape, slivers among them."""
    wavelet = vtkRTAnalyticSource()
    contour = vtkContourFilter()
    contour.SetInputConnection(wavelet.GetOutputPort())
    contour.SetValue(0, 157.09)
    contour.Update()
    return contour.GetOutput()


def deviation(surface, reference):
    measure = vtkSurfaceDeviation()
    measure.SetInputData(surface)
    measure.SetReferenceData(reference)
    measure.SetNumberOfSamples(20000)
    measure.Update()
    return measure


def mean_distance(optimizer):
    return deviation(optimizer.GetOutput(), optimizer.GetInput()).GetMeanDistance()


def relative_hausdorff_distance(optimizer):
    return deviation(optimizer.GetOutput(), optimizer.GetInput()).GetRelativeHausdorffDistance()


class OptimizedTriangles(unittest.TestCase):
    """Section 5."""

    @classmethod
    def setUpClass(cls):
        cls.meshes = {
            "torus": testing.to_polydata(testing.torus(60, 40)),
            "contour": wavelet_contour(),
        }

    def assert_ascending(self, measure):
        """const < cdf < linear, as in Fig. 5."""
        for name, mesh in self.meshes.items():
            with self.subTest(name):
                const, cdf, linear = (
                    measure(testing.updated(Optimizer, mesh, PositionWeighting=weighting))
                    for weighting in (Optimizer.CONSTANT, Optimizer.CDF, Optimizer.LINEAR)
                )
                self.assertLess(const, cdf)
                self.assertLess(cdf, linear)

    def test_triangles_get_better_with_every_weighting(self):
        for name, mesh in self.meshes.items():
            with self.subTest(name):
                optimizer = testing.updated(Optimizer, mesh, PositionWeighting=Optimizer.CONSTANT)
                self.assertGreater(
                    optimizer.GetMeanRadiusRatio(), optimizer.GetInputMeanRadiusRatio() + 0.1
                )

    def test_order_of_mean_triangle_quality(self):
        self.assert_ascending(lambda optimizer: optimizer.GetMeanRadiusRatio())

    def test_order_of_mean_distance(self):
        self.assert_ascending(mean_distance)

    def test_modulation_by_triangle_quality_raises_the_minimum(self):
        for name, mesh in self.meshes.items():
            with self.subTest(name):
                plain = testing.updated(Optimizer, mesh)
                modulated = testing.updated(Optimizer, mesh, ModulateByTriangleQuality=True)
                self.assertGreater(
                    modulated.GetMinimumRadiusRatio(), plain.GetMinimumRadiusRatio()
                )

    def test_tangent_planes_reduce_the_error_at_nearly_the_same_quality(self):
        for name, mesh in self.meshes.items():
            with self.subTest(name):
                plain = testing.updated(Optimizer, mesh)
                constrained = testing.updated(Optimizer, mesh, TangentPlaneConstraints=True)
                self.assertLess(mean_distance(constrained), mean_distance(plain))
                loss = plain.GetMeanRadiusRatio() - constrained.GetMeanRadiusRatio()
                self.assertLess(loss, 0.02)


class SharpFeatures(unittest.TestCase):
    """Section 5.3: W_p = W_linear and W_L = (s - W_linear) / s keep edges and corners in place."""

    def optimized(self, mesh, laplacian_weighting):
        return testing.updated(
            Optimizer,
            testing.to_polydata(mesh),
            PositionWeighting=Optimizer.LINEAR,
            LaplacianWeighting=laplacian_weighting,
        )

    def assert_features_stay(self, mesh, is_feature):
        optimizer = self.optimized(mesh, Optimizer.LINEAR_COMPLEMENT)
        displacement = testing.point_array(optimizer.GetOutput(), "Displacement")[is_feature]
        size = testing.diagonal(mesh[0])
        self.assertLess(testing.root_mean_square(displacement) / size, 3e-4)
        self.assertLess(relative_hausdorff_distance(optimizer), 3e-4)
        self.assertGreater(
            optimizer.GetMeanRadiusRatio(), optimizer.GetInputMeanRadiusRatio() + 0.05
        )

    def test_edges_between_slightly_curved_faces_stay(self):
        self.assert_features_stay(*testing.box(36, bulge=0.02))

    def test_edges_between_flat_faces_stay(self):
        self.assert_features_stay(*testing.box(20))

    def test_edges_break_without_laplacian_weights(self):
        for bulge in [0, 0.02]:
            mesh, _ = testing.box(36, bulge)
            optimizer = self.optimized(mesh, Optimizer.CONSTANT)
            self.assertGreater(relative_hausdorff_distance(optimizer), 1e-3)


def distance_to_double_pyramid(V):
    """Distance to |x| + |y| + |z| = 1: to its triangle in the octant of each point."""
    V = np.abs(V)
    corners = np.eye(3)
    normal = np.ones(3) / np.sqrt(3)
    height = (V - corners[0]) @ normal
    projected = V - np.outer(height, normal)
    to_edges = []
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        along = np.clip((V - a) @ (b - a) / 2, 0, 1)
        to_edges.append(np.linalg.norm(V - a - np.outer(along, b - a), axis=1))
    is_above = (projected >= 0).all(axis=1)
    return np.where(is_above, np.abs(height), np.min(to_edges, axis=0))


class SmoothedDoublePyramid(unittest.TestCase):
    """Fig. 8."""

    @classmethod
    def setUpClass(cls):
        (V, T), cls.is_edge = testing.double_pyramid(32)
        cls.size = testing.diagonal(V)
        noise = np.random.default_rng(1).normal(0, 1e-3 * cls.size, V.shape)
        cls.plain, cls.weighted = (
            cls.errors_after_smoothing((V + noise, T), laplacian_weighting)
            for laplacian_weighting in (Optimizer.CONSTANT, Optimizer.LINEAR_COMPLEMENT)
        )
        cls.noisy = distance_to_double_pyramid(V + noise) / cls.size

    @classmethod
    def errors_after_smoothing(cls, mesh, laplacian_weighting):
        optimizer = testing.updated(
            Optimizer,
            testing.to_polydata(mesh),
            Mode=Optimizer.SMOOTH,
            PositionWeighting=Optimizer.LINEAR,
            LaplacianWeighting=laplacian_weighting,
            ScaleFactor=0.1,
        )
        return distance_to_double_pyramid(testing.points_of(optimizer.GetOutput())) / cls.size

    def test_has_about_4000_points(self):
        self.assertEqual(len(self.is_edge), 4098)

    def test_laplacian_weights_recover_the_shape(self):
        self.assertLess(
            testing.root_mean_square(self.weighted), testing.root_mean_square(self.plain) / 4
        )

    def test_laplacian_weights_recover_the_edges(self):
        self.assertLess(
            testing.root_mean_square(self.weighted[self.is_edge]),
            testing.root_mean_square(self.plain[self.is_edge]) / 4,
        )

    def test_laplacian_weights_remove_noise(self):
        self.assertLess(
            testing.root_mean_square(self.weighted), 0.6 * testing.root_mean_square(self.noisy)
        )


class InnerFairness(unittest.TestCase):
    """Fig. 9."""

    def test_cotangent_laplacians_keep_the_shapes_of_triangles(self):
        V, T = testing.torus(60, 40)
        noise = np.random.default_rng(1).normal(0, 0.01, V.shape)
        mesh = testing.to_polydata((V + noise, T))
        change = {}
        for laplacian in (Optimizer.UNIFORM, Optimizer.COTANGENT, Optimizer.MEAN_CURVATURE):
            optimizer = testing.updated(
                Optimizer, mesh, Mode=Optimizer.SMOOTH, LaplacianType=laplacian
            )
            before, after = (
                testing.cell_array(optimizer.GetOutput(), name)
                for name in ("InputRadiusRatio", "RadiusRatio")
            )
            change[laplacian] = np.abs(after - before).mean()
        self.assertLess(change[Optimizer.COTANGENT], change[Optimizer.UNIFORM] / 2)
        self.assertLess(change[Optimizer.MEAN_CURVATURE], change[Optimizer.UNIFORM] / 2)


if __name__ == "__main__":
    unittest.main()
