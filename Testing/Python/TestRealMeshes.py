# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Metrics and claims on real meshes, in the folder that LMO_REAL_MESHES names."""
import os
import unittest
from functools import lru_cache

from laplacianmesh import vtkLaplacianMeshOptimizer as Optimizer
from laplacianmesh import vtkSurfaceDeviation
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkIOPLY import vtkPLYReader

import lmo_testing as testing

FOLDER = os.environ.get("LMO_REAL_MESHES", "")
FILES = [
    "horse.ply",
    "fandisk.obj",
    "rocker-arm.obj",
    "bunny.obj",
    "armadillo-15k.obj",
    "armadillo-43k.obj",
]

# Mean and minimum radius ratio of the input.
INPUT_QUALITY = {
    "horse.ply": (0.807602, 0.001519),
    "fandisk.obj": (0.850561, 0.323530),
    "rocker-arm.obj": (0.777631, 0.035402),
    "bunny.obj": (0.814449, 0.000571),
    "armadillo-15k.obj": (0.775796, 0.033477),
    "armadillo-43k.obj": (0.849292, 0.006027),
}

# Mean and minimum radius ratio after OPTIMIZE_TRIANGLES with s = 1 and a free boundary, for each
# weighting without and with W_t. From an independent direct solution of Eqn. 11.
QUALITY = {
    "horse.ply": {
        ("CONSTANT", False): (0.863092, 0.005462),
        ("CDF", False): (0.880454, 0.010289),
        ("LINEAR", False): (0.888016, 0.015253),
        ("CONSTANT", True): (0.876795, 0.111542),
        ("CDF", True): (0.889174, 0.064902),
        ("LINEAR", True): (0.895293, 0.045681),
    },
    "fandisk.obj": {
        ("CONSTANT", False): (0.882209, 0.471932),
        ("CDF", False): (0.896017, 0.474167),
        ("LINEAR", False): (0.910064, 0.281112),
        ("CONSTANT", True): (0.888558, 0.519986),
        ("CDF", True): (0.900986, 0.512626),
        ("LINEAR", True): (0.912830, 0.303502),
    },
    "rocker-arm.obj": {
        ("CONSTANT", False): (0.860029, 0.215129),
        ("CDF", False): (0.885521, 0.195741),
        ("LINEAR", False): (0.894470, 0.129609),
        ("CONSTANT", True): (0.881745, 0.141782),
        ("CDF", True): (0.895114, 0.196283),
        ("LINEAR", True): (0.900463, 0.212384),
    },
    "bunny.obj": {
        ("CONSTANT", False): (0.845685, 0.095187),
        ("CDF", False): (0.855919, 0.114178),
        ("LINEAR", False): (0.862548, 0.126481),
        ("CONSTANT", True): (0.853325, 0.192644),
        ("CDF", True): (0.862516, 0.197407),
        ("LINEAR", True): (0.868968, 0.167476),
    },
    "armadillo-15k.obj": {
        ("CONSTANT", False): (0.853885, 0.140742),
        ("CDF", False): (0.881847, 0.158057),
        ("LINEAR", False): (0.892433, 0.154858),
        ("CONSTANT", True): (0.883990, 0.187593),
        ("CDF", True): (0.900530, 0.196624),
        ("LINEAR", True): (0.906936, 0.204545),
    },
    "armadillo-43k.obj": {
        ("CONSTANT", False): (0.856591, 0.022656),
        ("CDF", False): (0.861445, 0.015817),
        ("LINEAR", False): (0.865446, 0.009639),
        ("CONSTANT", True): (0.860710, 0.043950),
        ("CDF", True): (0.867015, 0.064156),
        ("LINEAR", True): (0.871635, 0.072476),
    },
}

# Root-mean-square displacement divided by the diagonal, armadillo-15k, SMOOTH, CDF, s = 0.1.
SMOOTHING_DISPLACEMENT = {
    "UNIFORM": 4.834553e-03,
    "COTANGENT": 3.029194e-03,
    "MEAN_CURVATURE": 3.005568e-03,
}


@lru_cache(maxsize=None)
def mesh(name):
    reader = vtkPLYReader() if name.endswith(".ply") else vtkOBJReader()
    reader.SetFileName(os.path.join(FOLDER, name))
    reader.Update()
    return reader.GetOutput()


@lru_cache(maxsize=None)
def optimized(name, weighting, modulate=False, boundary="FREE"):
    return testing.updated(
        Optimizer,
        mesh(name),
        PositionWeighting=getattr(Optimizer, weighting),
        ModulateByTriangleQuality=modulate,
        BoundaryCondition=getattr(Optimizer, boundary),
        Tolerance=1e-10,
    )


def deviation(optimizer):
    measure = vtkSurfaceDeviation()
    measure.SetInputData(optimizer.GetOutput())
    measure.SetReferenceData(optimizer.GetInput())
    measure.SetNumberOfSamples(20000)
    measure.Update()
    return measure


@unittest.skipUnless(FOLDER, "LMO_REAL_MESHES names no folder of real meshes")
class RealMeshes(unittest.TestCase):
    def assert_quality(self, optimizer, expected):
        self.assertAlmostEqual(optimizer.GetMeanRadiusRatio(), expected[0], delta=1e-4)
        self.assertAlmostEqual(optimizer.GetMinimumRadiusRatio(), expected[1], delta=1e-4)

    def test_triangle_quality_of_the_input(self):
        for name, expected in INPUT_QUALITY.items():
            with self.subTest(name):
                optimizer = optimized(name, "CONSTANT")
                ratios = (
                    optimizer.GetInputMeanRadiusRatio(),
                    optimizer.GetInputMinimumRadiusRatio(),
                )
                for ratio, value in zip(ratios, expected):
                    self.assertAlmostEqual(ratio, value, delta=1e-6)

    def test_triangle_quality_after_optimization(self):
        for name, metrics in QUALITY.items():
            for (weighting, modulate), expected in metrics.items():
                with self.subTest(name, weighting=weighting, modulate=modulate):
                    self.assert_quality(optimized(name, weighting, modulate), expected)

    def test_triangle_quality_with_a_fixed_boundary(self):
        optimizer = optimized("bunny.obj", "CDF", boundary="FIXED")
        self.assert_quality(optimizer, (0.855480, 0.091178))

    def test_displacement_by_smoothing(self):
        for laplacian, expected in SMOOTHING_DISPLACEMENT.items():
            with self.subTest(laplacian):
                surface = mesh("armadillo-15k.obj")
                optimizer = testing.updated(
                    Optimizer,
                    surface,
                    Mode=Optimizer.SMOOTH,
                    LaplacianType=getattr(Optimizer, laplacian),
                    ScaleFactor=0.1,
                    Tolerance=1e-10,
                )
                displacement = testing.point_array(optimizer.GetOutput(), "Displacement")
                size = testing.diagonal(testing.points_of(surface))
                error = testing.root_mean_square(displacement) / size - expected
                self.assertLess(abs(error), 1e-8)

    def assert_ascending(self, measure):
        """const < cdf < linear, as in Fig. 5."""
        for name in FILES:
            with self.subTest(name):
                const, cdf, linear = (
                    measure(optimized(name, weighting))
                    for weighting in ("CONSTANT", "CDF", "LINEAR")
                )
                self.assertLess(const, cdf)
                self.assertLess(cdf, linear)

    def test_order_of_mean_triangle_quality(self):
        self.assert_ascending(lambda optimizer: optimizer.GetMeanRadiusRatio())

    def test_order_of_mean_distance(self):
        self.assert_ascending(lambda optimizer: deviation(optimizer).GetMeanDistance())

    def test_sharp_features_stay(self):
        optimizer = testing.updated(
            Optimizer,
            mesh("fandisk.obj"),
            PositionWeighting=Optimizer.LINEAR,
            LaplacianWeighting=Optimizer.LINEAR_COMPLEMENT,
        )
        self.assertLessEqual(deviation(optimizer).GetRelativeHausdorffDistance(), 3e-4)


if __name__ == "__main__":
    unittest.main()
