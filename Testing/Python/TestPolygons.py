# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Quads and larger polygons are smoothed along their edges, not along diagonals."""
import unittest

import numpy as np
from laplacianmesh import vtkLaplacianMeshOptimizer, vtkMeshLaplacian, vtkTriangleRadiusRatio
from vtkmodules.vtkFiltersCore import vtkWindowedSincPolyDataFilter
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality

import lmo_testing as testing
from lmo_testing import root_mean_square

OPTIMIZE_TRIANGLES, SMOOTH, WITHIN_DEVIATION, GUIDED = 0, 1, 3, 4
CONSTANT = 0


# --- Meshes: coordinates, and the point ids of each polygon ----------------------------------------
def grid_of_quads(cells, jitter, seed=3):
    """A flat square of unit quads, with inner points moved by up to jitter."""
    random = np.random.default_rng(seed)
    y, x = np.mgrid[: cells + 1, : cells + 1].astype(float)
    is_inside = (x > 0) & (x < cells) & (y > 0) & (y < cells)
    x, y = (c + is_inside * random.uniform(-jitter, jitter, c.shape) for c in (x, y))
    ids = np.arange(x.size).reshape(x.shape)
    quads = np.stack([ids[:-1, :-1], ids[:-1, 1:], ids[1:, 1:], ids[1:, :-1]], axis=-1)
    return np.c_[x.ravel(), y.ravel(), 0 * x.ravel()], quads.reshape(-1, 4)


def torus_of_quads(columns=80, rows=32, noise=0.0, seed=1):
    """Radii 2 and 0.8; noise in the distance from the ring."""
    u, v = np.meshgrid(*(2 * np.pi * np.arange(n) / n for n in (columns, rows)), indexing="ij")
    r = 0.8 + noise * np.random.default_rng(seed).standard_normal(u.shape)
    x, y, z = (2 + r * np.cos(v)) * np.cos(u), (2 + r * np.cos(v)) * np.sin(u), r * np.sin(v)
    ids = np.arange(u.size).reshape(u.shape)
    right = np.roll(ids, -1, axis=0)
    quads = np.stack([ids, right, np.roll(right, -1, axis=1), np.roll(ids, -1, axis=1)], axis=-1)
    return np.c_[x.ravel(), y.ravel(), z.ravel()], quads.reshape(-1, 4)


def honeycomb_torus(columns=60, rows=24, noise=0.0, seed=1):
    """Hexagons between the centres of a torus of triangles."""
    V, _ = torus_of_quads(columns, rows, noise, seed)
    ids = np.arange(len(V)).reshape(columns, rows)
    at = lambda i, j: np.roll(ids, (-i, -j), axis=(0, 1))
    lower = np.stack([at(0, 0), at(1, 0), at(1, 1)], axis=-1).reshape(-1, 3)
    upper = np.stack([at(0, 0), at(1, 1), at(0, 1)], axis=-1).reshape(-1, 3)
    centres = V[np.concatenate([lower, upper])].mean(axis=1)
    low, up = ids, ids + len(V)
    shift = lambda a, i, j: np.roll(a, (i, j), axis=(0, 1))
    hexagons = np.stack(
        [low, up, shift(low, 1, 0), shift(up, 1, 1), shift(low, 1, 1), shift(up, 0, 1)], axis=-1
    )
    return centres, hexagons.reshape(-1, 6)


# --- Measures -------------------------------------------------------------------------------------
def shapes(V, polygons):
    """The quality of polygons from its definition."""
    size = polygons.shape[1]
    corners = V[polygons]
    a = np.roll(corners, 1, axis=1) - corners
    b = np.roll(corners, -1, axis=1) - corners
    sine = np.sin(np.pi * (size - 2) / size)
    areas = np.linalg.norm(np.cross(a, b), axis=-1)
    squares = (a**2).sum(axis=-1) + (b**2).sum(axis=-1)
    return np.minimum(2 * areas / (squares * sine), 1).min(axis=1)


def verdict(polydata, measure):
    quality = vtkMeshQuality()
    quality.SetInputData(polydata)
    getattr(quality, "SetQuadQualityMeasureTo" + measure)()
    quality.Update()
    return testing.cell_array(quality.GetOutput(), "Quality")


def non_planarity(V, polygons):
    """Least singular value of each polygon's points over the largest."""
    corners = V[polygons] - V[polygons].mean(axis=1, keepdims=True)
    singular = np.linalg.svd(corners, compute_uv=False)
    return singular[:, 2] / singular[:, 0]


def roughness(V, polygons):
    """Root mean square distance from the torus of the radii 2 and 0.8, without its mean."""
    distance = np.hypot(np.hypot(V[:, 0], V[:, 1]) - 2, V[:, 2])
    return distance.std()


def run(mesh, mode, **properties):
    return testing.updated(
        vtkLaplacianMeshOptimizer, testing.to_polydata(mesh), Mode=mode, **properties
    ).GetOutput()


class Quality(unittest.TestCase):
    def assert_equal(self, values, expected, bound):
        self.assertLess(np.abs(values - expected).max(), bound)

    def test_convex_flat_quads_have_verdict_s_shape(self):
        polydata = testing.to_polydata(grid_of_quads(12, 0.24))
        output = testing.updated(vtkTriangleRadiusRatio, polydata).GetOutput()
        expected = verdict(polydata, "Shape")
        self.assertLess(expected.min(), 0.8)
        self.assert_equal(testing.cell_array(output, "RadiusRatio"), expected, 1e-12)

    def test_polygons_have_the_quality_of_the_definition(self):
        for mesh in (torus_of_quads(noise=0.02), honeycomb_torus(noise=0.01)):
            vtk_filter = testing.updated(vtkTriangleRadiusRatio, testing.to_polydata(mesh))
            expected = shapes(*mesh)
            values = testing.cell_array(vtk_filter.GetOutput(), "RadiusRatio")
            self.assert_equal(values, expected, 1e-12)
            self.assert_equal(vtk_filter.GetMeanRadiusRatio(), expected.mean(), 1e-12)
            self.assert_equal(vtk_filter.GetMinimumRadiusRatio(), expected.min(), 1e-12)

    def test_the_optimizer_reports_the_same(self):
        for mesh in (torus_of_quads(noise=0.02), honeycomb_torus(noise=0.01)):
            output = run(mesh, SMOOTH)
            moved = testing.points_of(output)
            for name, V in (("InputRadiusRatio", mesh[0]), ("RadiusRatio", moved)):
                self.assert_equal(testing.cell_array(output, name), shapes(V, mesh[1]), 1e-12)


class FlatQuads(unittest.TestCase):
    SETTINGS = (
        (OPTIMIZE_TRIANGLES, {}),
        (SMOOTH, dict(PositionWeighting=CONSTANT, ScaleFactor=0.3, Twicing=1)),
        (SMOOTH, dict(PositionWeighting=CONSTANT, ScaleFactor=0.3, LaplacianType=1)),
        (WITHIN_DEVIATION, {}),
    )

    def test_nearly_square_quads_stay_square(self):
        mesh = grid_of_quads(39, 0.01)
        for mode, properties in self.SETTINGS:
            with self.subTest(mode=mode, **properties):
                output = run(mesh, mode, **properties)
                self.assertGreater(verdict(output, "ScaledJacobian").mean(), 0.999)

    def test_bad_quads_become_better(self):
        mesh = grid_of_quads(20, 0.3)
        before = shapes(*mesh)
        for mode in (OPTIMIZE_TRIANGLES, WITHIN_DEVIATION):
            with self.subTest(mode=mode):
                after = shapes(testing.points_of(run(mesh, mode)), mesh[1])
                self.assertGreater(after.mean(), before.mean() + 0.1)
                self.assertGreater(after.min(), before.min() + 0.1)

    def test_the_neighbours_are_those_along_edges(self):
        mesh = grid_of_quads(6, 0.2)
        output = testing.updated(vtkMeshLaplacian, testing.to_polydata(mesh)).GetOutput()
        V = mesh[0].reshape(7, 7, 3)
        expected = (V[:-2, 1:-1] + V[2:, 1:-1] + V[1:-1, :-2] + V[1:-1, 2:]) / 4 - V[1:-1, 1:-1]
        values = testing.point_array(output, "UniformLaplacian").reshape(7, 7, 3)
        self.assertLess(np.abs(values[1:-1, 1:-1] - expected).max(), 1e-14)

    def test_a_plane_has_no_cotangent_laplacian(self):
        for robust in (0, 1):
            polydata = testing.to_polydata(grid_of_quads(10, 0.24))
            output = testing.updated(
                vtkMeshLaplacian, polydata, RobustLaplacian=robust
            ).GetOutput()
            laplacian = testing.point_array(output, "CotangentLaplacian").reshape(11, 11, 3)
            self.assertLess(np.abs(laplacian[1:-1, 1:-1]).max(), 1e-12)


class CurvedPolygons(unittest.TestCase):
    def assert_smooths(self, make_mesh, noise, share):
        """The difference between noisy and clean meshes falls to a share of what it was."""
        noisy, clean = make_mesh(noise=noise), make_mesh()
        before = root_mean_square(noisy[0] - clean[0])
        outputs = []
        for laplacian_type in (0, 1, 2):
            with self.subTest(LaplacianType=laplacian_type):
                settings = dict(
                    PositionWeighting=CONSTANT, ScaleFactor=0.1, LaplacianType=laplacian_type
                )
                output, smooth = (run(mesh, SMOOTH, **settings) for mesh in (noisy, clean))
                difference = testing.points_of(output) - testing.points_of(smooth)
                self.assertLess(root_mean_square(difference), share * before)
                outputs.append(output)
        return outputs

    def test_a_noisy_torus_of_quads_ends_as_good_as_by_a_windowed_sinc(self):
        sinc = vtkWindowedSincPolyDataFilter()
        sinc.SetInputData(testing.to_polydata(torus_of_quads(noise=0.02)))
        sinc.Update()
        expected = verdict(sinc.GetOutput(), "ScaledJacobian").mean()
        self.assertGreater(expected, 0.998)
        for output in self.assert_smooths(torus_of_quads, 0.02, 0.25):
            self.assertGreater(verdict(output, "ScaledJacobian").mean(), expected - 1e-3)

    def test_hexagons_become_smoother_and_no_less_planar(self):
        before = non_planarity(*honeycomb_torus(noise=0.02)).mean()
        for output in self.assert_smooths(honeycomb_torus, 0.02, 0.5):
            V = testing.points_of(output)
            hexagons = honeycomb_torus()[1]
            self.assertLess(non_planarity(V, hexagons).mean(), before)

    def test_curvatures_of_a_torus(self):
        V, quads = torus_of_quads(160, 64)
        output = testing.updated(vtkMeshLaplacian, testing.to_polydata((V, quads))).GetOutput()
        cosine = (np.hypot(V[:, 0], V[:, 1]) - 2) / 0.8
        mean = (2 + 2 * 0.8 * cosine) / (2 * 0.8 * (2 + 0.8 * cosine))
        gaussian = cosine / (0.8 * (2 + 0.8 * cosine))
        for name, expected in (("MeanCurvature", np.abs(mean)), ("GaussianCurvature", gaussian)):
            error = testing.point_array(output, name) - expected
            self.assertLess(np.abs(error).max(), 0.01 * np.abs(expected).max())

    def test_polygons_within_a_deviation_become_better_and_stay_valid(self):
        for mesh in (torus_of_quads(noise=0.01), honeycomb_torus(noise=0.005)):
            output = run(mesh, WITHIN_DEVIATION, MaximumDeviation=0.005)
            before = shapes(*mesh)
            after = shapes(testing.points_of(output), mesh[1])
            self.assertGreater(after.mean(), before.mean())
            self.assertGreaterEqual(after.min(), before.min())
            self.assertLessEqual(testing.metric(output, "RelativeHausdorffBound"), 0.005)

    def test_scattered_numbers_change_nothing(self):
        V, quads = torus_of_quads(400, 160, noise=0.01)
        order = np.random.default_rng(5).permutation(len(V))
        number = np.argsort(order)
        plain = run((V, quads), SMOOTH)
        scattered = run((V[order], number[quads]), SMOOTH)
        difference = testing.points_of(scattered) - testing.points_of(plain)[order]
        self.assertLess(np.abs(difference).max(), 1e-5)
        ratios = [testing.cell_array(output, "RadiusRatio") for output in (plain, scattered)]
        self.assertLess(np.abs(ratios[0] - ratios[1]).max(), 1e-4)

    def test_guided_smoothing_takes_polygons(self):
        mesh = torus_of_quads(noise=0.02)
        V = testing.points_of(run(mesh, GUIDED))
        self.assertLess(roughness(V, mesh[1]), roughness(*mesh))


if __name__ == "__main__":
    unittest.main()
