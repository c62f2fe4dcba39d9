# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""The examples do what they say, on small meshes.

LMO_EXAMPLES: the folder of the examples. LMO_PICTURES: set if pictures can be made.
"""
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np

EXAMPLES = os.environ["LMO_EXAMPLES"]
sys.path.insert(0, EXAMPLES)

import common  # noqa: E402
import shapes  # noqa: E402

import lmo_testing as testing  # noqa: E402


def relative_hausdorff_distance(mesh, reference):
    return common.deviation(mesh, reference).GetRelativeHausdorffDistance()


def mean_distance(mesh, reference):
    return common.deviation(mesh, reference).GetRelativeMeanDistance()


def mean_curvature(mesh):
    return testing.point_array(mesh, "MeanCurvature").mean()


class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.animal = shapes.animal(samples=24)
        cls.part = shapes.machine_part(edge=0.09)

    def run_example(self, name, mesh, **options):
        """The mesh that the example writes."""
        with tempfile.TemporaryDirectory() as folder:
            files = [os.path.join(folder, file) for file in ("in.vtp", "out.vtp", "picture.png")]
            common.write_mesh(files[0], mesh)
            command = [sys.executable, os.path.join(EXAMPLES, name + ".py"), *files[:1]]
            command += ["--output", files[1]]
            if os.environ.get("LMO_PICTURES"):
                command += ["--picture", files[2]]
            for option, value in options.items():
                command += ["--" + option.replace("_", "-"), str(value)]
            subprocess.run(command, check=True, capture_output=True)
            if os.environ.get("LMO_PICTURES"):
                self.assertGreater(os.path.getsize(files[2]), 10000)
            return common.read_mesh(files[1])

    def assert_better_triangles(self, output):
        gain = testing.metric(output, "MeanRadiusRatio") - testing.metric(
            output, "InputMeanRadiusRatio"
        )
        self.assertGreater(gain, 0.1)

    def test_triangles_within_error(self):
        output = self.run_example("triangles_within_error", self.animal, max_deviation=0.003)
        self.assert_better_triangles(output)
        self.assertLess(relative_hausdorff_distance(output, self.animal), 0.003)

    def test_cad_triangles(self):
        output = self.run_example("cad_triangles", self.part)
        self.assert_better_triangles(output)
        is_corner = testing.point_array(output, "FeatureClass") == 2
        self.assertEqual(is_corner.sum(), 10)  # 7 corners of the outline, 2 of them rounded, twice
        displacement = testing.point_array(output, "Displacement")
        self.assertEqual(np.abs(displacement[is_corner]).max(), 0)

    def test_denoise(self):
        clean = shapes.animal(samples=40)
        noisy = shapes.with_noise(clean, 0.0015)
        output = self.run_example("denoise", noisy)
        self.assertLess(mean_distance(output, clean), 0.75 * mean_distance(noisy, clean))
        self.assertLess(abs(testing.metric(output, "RelativeVolumeChange")), 1e-6)

    def test_denoise_cad(self):
        clean = shapes.machine_part(edge=0.05)
        noisy = shapes.with_noise(clean, 0.002)
        output = self.run_example("denoise_cad", noisy)
        self.assertLess(mean_distance(output, clean), 0.7 * mean_distance(noisy, clean))

    def test_least_squares_mesh_is_closer_with_more_anchors(self):
        few, many = (
            self.run_example("least_squares_mesh", self.animal, anchors=count)
            for count in (100, 1000)
        )
        self.assertLess(
            mean_distance(many, self.animal), 0.5 * mean_distance(few, self.animal)
        )

    def test_detail_preserving_keeps_more_than_a_least_squares_mesh(self):
        smooth, detailed = (
            self.run_example(name, self.animal, anchors=500)
            for name in ("least_squares_mesh", "detail_preserving")
        )
        self.assert_better_triangles(detailed)
        self.assertLess(
            mean_distance(detailed, self.animal), 0.7 * mean_distance(smooth, self.animal)
        )

    def test_exaggerate_detail_by_1_changes_nothing(self):
        output = self.run_example("exaggerate_detail", self.animal, factor=1)
        self.assertLess(testing.metric(output, "RelativeMaximumDisplacement"), 1e-6)

    def test_exaggerate_detail_raises_curvature(self):
        same, more = (
            self.run_example("exaggerate_detail", self.animal, factor=factor) for factor in (1, 2)
        )
        curvatures = []
        for mesh in (same, more):
            curvatures.append(mean_curvature(self.run_example("curvature_plot", bare(mesh))))
        self.assertGreater(curvatures[1], 1.2 * curvatures[0])

    def test_curvature_plot_obeys_gauss_and_bonnet(self):
        output = self.run_example("curvature_plot", self.animal)
        curvature = testing.point_array(output, "GaussianCurvature")
        area = testing.point_array(output, "VoronoiArea")
        euler_characteristic = output.GetNumberOfPoints() - output.GetNumberOfPolys() / 2
        self.assertAlmostEqual((curvature * area).sum(), 2 * np.pi * euler_characteristic, 6)


def bare(mesh):
    return shapes.polydata(shapes.points_of(mesh), shapes.triangles_of(mesh))


if __name__ == "__main__":
    unittest.main()
