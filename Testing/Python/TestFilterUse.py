# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""The filters do in VTK's Python what its users expect of a filter."""
import os
import subprocess
import sys
import unittest

import laplacianmesh
import numpy as np
from laplacianmesh import (
    vtkLaplacianMeshOptimizer,
    vtkMeshLaplacian,
    vtkSurfaceDeviation,
    vtkTriangleRadiusRatio,
)
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkSphereSource

import lmo_testing as testing

POINTS = vtkDataObject.FIELD_ASSOCIATION_POINTS

# Prints the bytes of the points that the optimizer computes on two threads, if there are threads.
PRINT_POINTS = """
from vtkmodules.vtkCommonCore import vtkSMPTools
import lmo_testing as testing
from laplacianmesh import vtkLaplacianMeshOptimizer
vtkSMPTools.Initialize(2)
mesh = testing.to_polydata(testing.torus(150, 100))
output = testing.updated(vtkLaplacianMeshOptimizer, mesh, ScaleFactor=0.5).GetOutput()
print(vtkSMPTools.GetBackend(), testing.points_of(output).tobytes().hex())
"""

# Runs each filter on a composite data set with a block that is no surface.
FILTER_AN_IMAGE = """
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
import laplacianmesh
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, vtkImageData())
for name in ("vtkLaplacianMeshOptimizer", "vtkMeshLaplacian", "vtkTriangleRadiusRatio"):
    vtk_filter = getattr(laplacianmesh, name)()
    vtk_filter.SetInputDataObject(blocks)
    vtk_filter.Update()
"""


def run_python(code, **environment):
    """Standard output of a new Python that runs the code in the folder of this file."""
    return subprocess.run(
        [sys.executable, "-c", code],
        cwd=os.path.dirname(os.path.abspath(__file__)),
        env=dict(os.environ, PYTHONDONTWRITEBYTECODE="1", **environment),
        check=True,
        capture_output=True,
        text=True,
    ).stdout


class Pipeline(unittest.TestCase):
    def test_setting_another_value_makes_the_output_out_of_date(self):
        optimizer = testing.updated(
            vtkLaplacianMeshOptimizer, testing.to_polydata(testing.torus(9, 8))
        )
        before = testing.points_of(optimizer.GetOutput())
        optimizer.SetScaleFactor(0.1)
        optimizer.Update()
        self.assertGreater(np.abs(testing.points_of(optimizer.GetOutput()) - before).max(), 0.01)

    def test_filters_connect(self):
        sphere = vtkSphereSource()
        optimizer, laplacian, quality = (
            vtkLaplacianMeshOptimizer(),
            vtkMeshLaplacian(),
            vtkTriangleRadiusRatio(),
        )
        deviation = vtkSurfaceDeviation()
        optimizer.SetInputConnection(sphere.GetOutputPort())
        laplacian.SetInputConnection(optimizer.GetOutputPort())
        quality.SetInputConnection(laplacian.GetOutputPort())
        deviation.SetInputConnection(quality.GetOutputPort())
        deviation.SetReferenceConnection(sphere.GetOutputPort())
        deviation.Update()
        point_data = deviation.GetOutput().GetPointData()
        for name in ["Normals", "Displacement", "MeanCurvatureNormal", "RadiusRatio", "Distance"]:
            self.assertTrue(point_data.HasArray(name), name)

    def test_deviation_figures_are_in_the_field_data_too(self):
        deviation = vtkSurfaceDeviation()
        deviation.SetInputData(testing.to_polydata(testing.torus(9, 8)))
        deviation.SetReferenceData(testing.to_polydata(testing.torus(9, 8, seed=2)))
        deviation.Update()
        for name in [
            "HausdorffDistance",
            "RelativeHausdorffDistance",
            "MeanDistance",
            "RelativeMeanDistance",
        ]:
            got = getattr(deviation, "Get" + name)()
            self.assertGreater(got, 0)
            self.assertEqual(testing.metric(deviation.GetOutput(), name), got, name)

    def test_the_input_is_left_alone(self):
        V, T = testing.torus(9, 8)
        surface = testing.to_polydata((V, T))
        testing.updated(vtkLaplacianMeshOptimizer, surface)
        self.assertTrue((testing.points_of(surface) == V).all())
        self.assertEqual(surface.GetPointData().GetNumberOfArrays(), 0)


class InputArrays(unittest.TestCase):
    """SetInputArrayToProcess() with each of the four arrays."""

    MESH = testing.torus(9, 8)
    SOME = (np.arange(72) % 5 == 0).astype(np.int8)

    def optimized(self, index, values, **properties):
        optimizer = vtkLaplacianMeshOptimizer()
        optimizer.SetMode(vtkLaplacianMeshOptimizer.OPTIMIZE_TRIANGLES)
        optimizer.SetInputData(testing.to_polydata(self.MESH, chosen=values))
        optimizer.SetInputArrayToProcess(index, 0, 0, POINTS, "chosen")
        for name, value in properties.items():
            getattr(optimizer, "Set" + name)(value)
        optimizer.Update()
        return optimizer.GetOutput()

    def test_anchors(self):
        output = self.optimized(
            vtkLaplacianMeshOptimizer.POSITION_WEIGHT_ARRAY,
            self.SOME,
            PositionWeighting=vtkLaplacianMeshOptimizer.ANCHORS,
            ScaleFactor=3,
        )
        weights = testing.point_array(output, "PositionWeight")
        self.assertTrue((weights == 3 * self.SOME).all())

    def test_position_weights(self):
        values = np.linspace(0.1, 1, 72)
        output = self.optimized(
            vtkLaplacianMeshOptimizer.POSITION_WEIGHT_ARRAY,
            values,
            PositionWeighting=vtkLaplacianMeshOptimizer.ARRAY,
        )
        self.assertTrue((testing.point_array(output, "PositionWeight") == values).all())

    def test_laplacian_weights(self):
        values = np.linspace(0.1, 1, 72)
        output = self.optimized(
            vtkLaplacianMeshOptimizer.LAPLACIAN_WEIGHT_ARRAY,
            values,
            LaplacianWeighting=vtkLaplacianMeshOptimizer.ARRAY,
        )
        self.assertTrue((testing.point_array(output, "LaplacianWeight") == values).all())

    def test_laplacians_of_the_mesh_itself_move_nothing(self):
        laplacian = testing.updated(vtkMeshLaplacian, testing.to_polydata(self.MESH)).GetOutput()
        output = self.optimized(
            vtkLaplacianMeshOptimizer.PRESCRIBED_LAPLACIAN_ARRAY,
            testing.point_array(laplacian, "UniformLaplacian"),
            Mode=vtkLaplacianMeshOptimizer.PRESCRIBED_LAPLACIANS,
        )
        self.assertLess(np.abs(testing.point_array(output, "Displacement")).max(), 1e-14)

    def test_mean_curvature_normals_of_the_mesh_itself_move_nothing_in_any_unit(self):
        meshes = {
            "torus": testing.torus(9, 8),
            "patch": testing.patch(9, 8),
            "box": testing.box(5, bulge=0.1)[0],
        }
        boundaries = [vtkLaplacianMeshOptimizer.FIXED, vtkLaplacianMeshOptimizer.FREE]
        for name, (V, T) in meshes.items():
            for unit in (1e-3, 1, 100):
                for boundary in boundaries:
                    with self.subTest(mesh=name, unit=unit, boundary=boundary):
                        error = self.displacement_by_own_normals((V * unit, T), boundary)
                        self.assertLess(error, 1e-9)

    def displacement_by_own_normals(self, mesh, boundary):
        """Of the points, divided by the size of the mesh."""
        laplacian = testing.updated(vtkMeshLaplacian, testing.to_polydata(mesh)).GetOutput()
        optimizer = vtkLaplacianMeshOptimizer()
        optimizer.SetInputData(laplacian)
        optimizer.SetMode(vtkLaplacianMeshOptimizer.PRESCRIBED_LAPLACIANS)
        optimizer.SetLaplacianType(vtkLaplacianMeshOptimizer.MEAN_CURVATURE)
        optimizer.SetBoundaryCondition(boundary)
        optimizer.SetInputArrayToProcess(
            vtkLaplacianMeshOptimizer.PRESCRIBED_LAPLACIAN_ARRAY,
            0,
            0,
            POINTS,
            "MeanCurvatureNormal",
        )
        optimizer.Update()
        return optimizer.GetRelativeMaximumDisplacement()

    def test_twice_the_mean_curvature_normals_move_the_surface_alike_in_any_unit(self):
        V, T = testing.torus(9, 8)
        moved = []
        for unit in (1e-3, 1, 100):
            mesh = testing.to_polydata((V * unit, T))
            normals = testing.point_array(
                testing.updated(vtkMeshLaplacian, mesh).GetOutput(), "MeanCurvatureNormal"
            )
            mesh = testing.to_polydata((V * unit, T), chosen=2 * normals)
            optimizer = vtkLaplacianMeshOptimizer()
            optimizer.SetInputData(mesh)
            optimizer.SetMode(vtkLaplacianMeshOptimizer.PRESCRIBED_LAPLACIANS)
            optimizer.SetLaplacianType(vtkLaplacianMeshOptimizer.MEAN_CURVATURE)
            optimizer.SetSolverType(vtkLaplacianMeshOptimizer.DIRECT)
            optimizer.SetInputArrayToProcess(
                vtkLaplacianMeshOptimizer.PRESCRIBED_LAPLACIAN_ARRAY, 0, 0, POINTS, "chosen"
            )
            optimizer.Update()
            moved.append(testing.points_of(optimizer.GetOutput()) / unit - V)
        self.assertGreater(np.abs(moved[1]).max(), 0.01)
        for other in (moved[0], moved[2]):
            self.assertLess(np.abs(other - moved[1]).max(), 1e-9)

    def test_fixed_points_do_not_move(self):
        output = self.optimized(vtkLaplacianMeshOptimizer.FIXED_POINT_ARRAY, self.SOME)
        moves = testing.point_array(output, "Displacement").any(axis=1)
        self.assertTrue((moves == (self.SOME == 0)).all())


class CompositeInput(unittest.TestCase):
    def test_each_block_is_treated_alone(self):
        surfaces = [testing.to_polydata(testing.torus(9, 8, seed=seed)) for seed in (1, 2)]
        blocks = vtkMultiBlockDataSet()
        for number, surface in enumerate(surfaces):
            blocks.SetBlock(number, surface)
        optimizer = vtkLaplacianMeshOptimizer()
        optimizer.SetMode(vtkLaplacianMeshOptimizer.OPTIMIZE_TRIANGLES)
        optimizer.SetInputDataObject(blocks)
        optimizer.Update()
        output = optimizer.GetOutputDataObject(0)
        self.assertTrue(output.IsA("vtkMultiBlockDataSet"))
        for number, surface in enumerate(surfaces):
            alone = testing.updated(vtkLaplacianMeshOptimizer, surface).GetOutput()
            difference = testing.points_of(output.GetBlock(number)) - testing.points_of(alone)
            self.assertTrue((difference == 0).all())

    def test_a_block_that_is_no_surface_does_no_harm(self):
        run_python(FILTER_AN_IMAGE)


class Threads(unittest.TestCase):
    def test_results_do_not_depend_on_threads(self):
        sequential, threaded = (
            run_python(PRINT_POINTS, VTK_SMP_BACKEND_IN_USE=backend).split()
            for backend in ("Sequential", "STDThread")
        )
        self.assertEqual([sequential[0], threaded[0]], ["Sequential", "STDThread"])
        self.assertTrue(sequential[1] == threaded[1])


class Package(unittest.TestCase):
    def test_offers_the_filters_and_a_version(self):
        names = {name for name in dir(laplacianmesh) if name.startswith("vtk")}
        self.assertLessEqual(
            {
                "vtkLaplacianMeshOptimizer",
                "vtkMeshLaplacian",
                "vtkSurfaceDeviation",
                "vtkTriangleRadiusRatio",
            },
            names,
        )
        self.assertRegex(laplacianmesh.__version__, r"^\d+\.\d+\.\d+$")

    def test_import_has_no_side_effects(self):
        """No output, no rendering or user-interface modules, no other threading."""
        output = run_python(
            "import sys; import vtkmodules.vtkCommonExecutionModel\n"
            "from vtkmodules.vtkCommonCore import vtkSMPTools\n"
            "backend, before = vtkSMPTools.GetBackend(), set(sys.modules)\n"
            "import laplacianmesh\n"
            "assert vtkSMPTools.GetBackend() == backend\n"
            "new = {name for name in set(sys.modules) - before if 'vtkmodules' in name}\n"
            "print(*new)\n"
        )
        self.assertEqual(output.strip(), "")


if __name__ == "__main__":
    unittest.main()
