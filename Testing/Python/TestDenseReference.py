# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkLaplacianMeshOptimizer agrees with a dense least-squares solution of Eqn. 11."""
import unittest
from dataclasses import asdict
from itertools import product

import numpy as np
from laplacianmesh import vtkLaplacianMeshOptimizer
from vtkmodules.vtkCommonDataModel import vtkDataObject

import lmo_reference as reference
import lmo_testing as testing
from lmo_dense_optimizer import DenseOptimizer

CLOSED = testing.with_isolated_point(testing.torus(9, 8))
OPEN = testing.with_isolated_point(testing.patch(7, 7))

MODES = ["OPTIMIZE_TRIANGLES", "SMOOTH", "PRESCRIBED_LAPLACIANS"]
LAPLACIANS = ["UNIFORM", "COTANGENT", "MEAN_CURVATURE"]
POSITION_WEIGHTINGS = ["CONSTANT", "LINEAR", "CDF", "ANCHORS", "ARRAY"]
LAPLACIAN_WEIGHTINGS = ["CONSTANT", "LINEAR_COMPLEMENT", "CDF_COMPLEMENT", "GAUSSIAN", "ARRAY"]
ARRAY_INDICES = {
    "position_weight_array": vtkLaplacianMeshOptimizer.POSITION_WEIGHT_ARRAY,
    "laplacian_weight_array": vtkLaplacianMeshOptimizer.LAPLACIAN_WEIGHT_ARRAY,
    "prescribed_laplacian_array": vtkLaplacianMeshOptimizer.PRESCRIBED_LAPLACIAN_ARRAY,
    "fixed_point_array": vtkLaplacianMeshOptimizer.FIXED_POINT_ARRAY,
}


def modes_and_laplacians():
    """Every mode with every Laplacian that it looks at."""
    pairs = product(MODES, LAPLACIANS)
    return [pair for pair in pairs if pair[0] != "OPTIMIZE_TRIANGLES" or pair[1] == "UNIFORM"]


def arrays_for(mesh):
    """Position weights with zeros among them, and Laplacians about as long as the edges."""
    random = np.random.default_rng(7)
    n = len(mesh[0])
    return {
        "position_weight_array": random.uniform(0, 2, n) * (random.random(n) < 0.8),
        "laplacian_weight_array": random.uniform(0.5, 2, n),
        "prescribed_laplacian_array": 0.1 * random.standard_normal((n, 3)),
    }


def some_points(mesh, share=0.1):
    return (np.random.default_rng(3).random(len(mesh[0])) < share).astype(float)


def run_filter(mesh, dense, solver):
    """The filter with the properties of the dense reference."""
    properties = {name: value for name, value in asdict(dense).items() if value is not None}
    arrays = {name: properties.pop(name) for name in ARRAY_INDICES if name in properties}
    optimizer = vtkLaplacianMeshOptimizer()
    optimizer.SetInputData(testing.to_polydata(mesh, **arrays))
    for name in arrays:
        optimizer.SetInputArrayToProcess(
            ARRAY_INDICES[name], 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, name
        )
    for name, value in dict(properties, SolverType=solver, Tolerance=1e-13).items():
        is_enumeration = isinstance(value, str)
        value = getattr(vtkLaplacianMeshOptimizer, value) if is_enumeration else value
        getattr(optimizer, "Set" + name)(value)
    optimizer.Update()
    return optimizer.GetOutput()


class DenseReference(unittest.TestCase):
    def assert_agrees(self, mesh, dense, **case):
        """The filter's points are those of the dense solution to 1e-10 of the diagonal."""
        V, T = mesh
        expected = dense.optimize(V, T)
        used = reference.is_used(len(V), T)
        for solver in ["DIRECT", "ITERATIVE"]:
            with self.subTest(solver=solver, **case):
                points = testing.points_of(run_filter(mesh, dense, solver))
                error = np.abs(points - expected).max() / testing.diagonal(V[used])
                self.assertLess(error, 1e-10)

    def assert_agrees_everywhere(self, mesh, boundary):
        """Every mode, Laplacian and weighting, with and without W_t and tangent planes."""
        for (mode, laplacian), position, laplacian_weighting, modulate, tangent_planes in product(
            modes_and_laplacians(), POSITION_WEIGHTINGS, LAPLACIAN_WEIGHTINGS, [0, 1], [0, 1]
        ):
            case = {
                "Mode": mode,
                "LaplacianType": laplacian,
                "PositionWeighting": position,
                "LaplacianWeighting": laplacian_weighting,
                "ModulateByTriangleQuality": modulate,
                "TangentPlaneConstraints": tangent_planes,
                "BoundaryCondition": boundary,
            }
            self.assert_agrees(mesh, DenseOptimizer(**case, **arrays_for(mesh)), **case)

    def test_every_combination_on_a_closed_surface(self):
        self.assert_agrees_everywhere(CLOSED, "FIXED")

    def test_every_combination_with_a_fixed_boundary(self):
        self.assert_agrees_everywhere(OPEN, "FIXED")

    def test_every_combination_with_a_free_boundary(self):
        self.assert_agrees_everywhere(OPEN, "FREE")

    def test_fixed_points(self):
        for mesh, boundary in [(CLOSED, "FIXED"), (OPEN, "FIXED"), (OPEN, "FREE")]:
            for (mode, laplacian), tangent_planes in product(modes_and_laplacians(), [0, 1]):
                arrays = dict(arrays_for(mesh), fixed_point_array=some_points(mesh))
                case = {"Mode": mode, "LaplacianType": laplacian, "BoundaryCondition": boundary}
                case["TangentPlaneConstraints"] = tangent_planes
                self.assert_agrees(mesh, DenseOptimizer(**case, **arrays), **case)

    def test_boundaries_that_slide_along_straight_lines(self):
        for (mode, laplacian), weighting, tangent_planes in product(
            modes_and_laplacians(), LAPLACIAN_WEIGHTINGS, [0, 1]
        ):
            case = {"Mode": mode, "LaplacianType": laplacian, "LaplacianWeighting": weighting}
            case["TangentPlaneConstraints"] = tangent_planes
            dense = DenseOptimizer(BoundaryCondition="SLIDING", **case, **arrays_for(OPEN))
            self.assert_agrees(OPEN, dense, **case)

    def test_a_component_without_weight_gets_the_scale_factor(self):
        mesh = testing.beside(CLOSED, CLOSED)
        anchors = some_points(mesh) * (mesh[0][:, 0] < 5)
        for mode in ["OPTIMIZE_TRIANGLES", "SMOOTH"]:
            dense = DenseOptimizer(
                Mode=mode,
                PositionWeighting="ANCHORS",
                ScaleFactor=0.7,
                position_weight_array=anchors,
            )
            self.assert_agrees(mesh, dense, Mode=mode)

    def test_numbers_other_than_the_default(self):
        for name, value in [
            ("ScaleFactor", 0.3),
            ("ScaleFactor", 20),
            ("GaussianWidth", 0.2),
            ("TangentPlaneWeight", 3),
            ("TangentPlaneWeight", 0),
        ]:
            dense = DenseOptimizer(LaplacianWeighting="GAUSSIAN", TangentPlaneConstraints=True)
            setattr(dense, name, value)
            self.assert_agrees(OPEN, dense, **{name: value})

    def test_weights_in_the_output(self):
        for position, laplacian, modulate, mesh in product(
            POSITION_WEIGHTINGS, LAPLACIAN_WEIGHTINGS, [0, 1], [CLOSED, OPEN]
        ):
            dense = DenseOptimizer(
                PositionWeighting=position,
                LaplacianWeighting=laplacian,
                ModulateByTriangleQuality=modulate,
                **arrays_for(mesh),
            )
            output = run_filter(mesh, dense, "DIRECT")
            for name, expected in [
                ("PositionWeight", dense.position_weights(*mesh)),
                ("LaplacianWeight", dense.laplacian_weights(*mesh)),
                ("MeanCurvature", reference.mean_curvatures(*mesh)),
            ]:
                with self.subTest(array=name, position=position, laplacian=laplacian):
                    error = np.abs(testing.point_array(output, name) - expected).max()
                    self.assertLess(error, 1e-12)


class Meshes(unittest.TestCase):
    """The conventions have something to decide on these meshes."""

    def test_some_triangles_are_obtuse(self):
        for V, T in [CLOSED, OPEN]:
            self.assertTrue((reference.cotangents(V, T) < 0).any())

    def test_some_inner_points_are_flat(self):
        V, T = OPEN
        flat = reference.mean_curvatures(V, T) == 0
        inner = reference.is_used(len(V), T) & ~reference.is_boundary(len(V), T)
        self.assertTrue((flat & inner).any())

    def test_a_boundary_point_has_no_inner_neighbour(self):
        V, T = OPEN
        boundary = reference.is_boundary(len(V), T)
        inner_neighbours = (reference.triangles_at_edges(len(V), T) > 0) & ~boundary
        self.assertTrue((boundary & ~inner_neighbours.any(axis=1)).any())

    def test_some_curvatures_are_outliers(self):
        V, T = CLOSED
        kappa = reference.mean_curvatures(V, T)[reference.is_used(len(V), T)]
        self.assertLess(reference.box_plot_threshold(kappa), kappa.max())


if __name__ == "__main__":
    unittest.main()
