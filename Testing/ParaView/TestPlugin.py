# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin's filters in pvpython, as users write them with paraview.simple."""
import unittest

import laplacianmesh
import numpy as np

from plugin_proxies import *
from plugin_tables import *


class Proxies(unittest.TestCase):
    def test_every_property_is_an_attribute(self):
        for name, properties in PROPERTIES.items():
            self.assertEqual(sorted(made(name).ListProperties()), sorted(properties))

    def test_every_property_is_documented(self):
        for name, properties in PROPERTIES.items():
            for prop in properties:
                documentation = prototype(name).GetProperty(prop).GetDocumentation()
                self.assertTrue(documentation.GetDescription().strip(), f"{name}.{prop}")

    def test_every_filter_is_documented(self):
        for name in [*DOCUMENTED, *MENU]:
            documentation = prototype(name).GetDocumentation()
            self.assertTrue(documentation.GetDescription().strip(), name)
            self.assertTrue(documentation.GetShortHelp().strip(), name)

    def test_the_menu_has_these_entries_and_no_others(self):
        for name in [*DOCUMENTED, *MENU]:
            hints = prototype(name).GetHints()
            menu = hints and hints.FindNestedElementByName("ShowInMenu")
            self.assertEqual(menu is not None, name in MENU, name)
            if menu:
                self.assertEqual(menu.GetAttribute("category"), "Surface Mesh Improvement", name)
                self.assertEqual(prototype(name).GetXMLLabel(), MENU[name])

    def test_search_by_ctrl_space_finds_the_words_that_users_type(self):
        for word, names in SEARCH.items():
            for name in names:
                found = prototype(name).GetDocumentation().GetShortHelp() + MENU[name]
                self.assertIn(word, found.lower(), f"{word}: {name}")

    def test_client_side_objects_are_the_wrapped_classes(self):
        for name in PROPERTIES:
            expected = getattr(laplacianmesh, "vtk" + name)
            self.assertIsInstance(made(name).GetClientSideObject(), expected)


class OptimizerProperties(unittest.TestCase):
    def test_enumerations_by_text(self):
        for name, texts in ENUMERATIONS.items():
            for number, text in enumerate(texts):
                optimizer = LaplacianMeshOptimizer(Input=Sphere(), **{name: text})
                optimizer.UpdateVTKObjects()
                self.assertEqual(getattr(optimizer, name), text)
                self.assertEqual(
                    getattr(optimizer.GetClientSideObject(), "Get" + name)(), number, text
                )

    def test_enumerations_by_number(self):
        for name, texts in ENUMERATIONS.items():
            for number, text in enumerate(texts):
                optimizer = LaplacianMeshOptimizer(Input=Sphere(), **{name: number})
                self.assertEqual(getattr(optimizer, name), text)

    def test_numbers(self):
        for name, value in NUMBERS.items():
            optimizer = LaplacianMeshOptimizer(Input=Sphere(), **{name: value})
            optimizer.UpdateVTKObjects()
            value = tuple(value) if isinstance(value, list) else value
            got = getattr(optimizer, name)
            self.assertEqual(tuple(got) if isinstance(value, tuple) else got, value)
            self.assertEqual(getattr(optimizer.GetClientSideObject(), "Get" + name)(), value)

    def test_arrays(self):
        for name in ARRAYS:
            optimizer = LaplacianMeshOptimizer(Input=half_sphere(), **{name: ("POINTS", "weight")})
            self.assertEqual(list(getattr(optimizer, name)), ["POINTS", "weight"])

    def test_defaults_are_those_of_the_filter(self):
        proxy = LaplacianMeshOptimizer(Input=Sphere())
        default = laplacianmesh.vtkLaplacianMeshOptimizer()
        for name in [*ENUMERATIONS, *NUMBERS]:
            from_proxy = getattr(proxy.GetClientSideObject(), "Get" + name)()
            self.assertEqual(from_proxy, getattr(default, "Get" + name)(), name)

    def test_no_array_is_chosen_by_default(self):
        optimizer = LaplacianMeshOptimizer(Input=half_sphere())
        for name in ARRAYS:
            self.assertEqual(list(getattr(optimizer, name)), ["POINTS", "None"])
        optimizer.UpdatePipeline()
        self.assertEqual(len(points(optimizer)), len(points(optimizer.Input)))

    def test_no_array_can_be_chosen_again(self):
        optimizer = LaplacianMeshOptimizer(Input=half_sphere())
        before = points(optimizer).copy()
        for nothing in [None, ("POINTS", "None"), ("POINTS", "")]:
            optimizer.FixedPointArray = ("POINTS", "upper")
            self.assertFalse((points(optimizer) == before).all())
            optimizer.FixedPointArray = nothing
            self.assertTrue((points(optimizer) == before).all())


class OptimizerEffects(unittest.TestCase):
    """Each property changes the output."""

    def assert_moves_points(self, context=None, **change):
        surface = half_sphere()
        context = {"Mode": "Optimize Triangles", **(context or {})}
        before = LaplacianMeshOptimizer(Input=surface, **context)
        after = LaplacianMeshOptimizer(Input=surface, **{**context, **change})
        self.assertEqual(len(points(after)), len(points(surface)))
        self.assertGreater(np.abs(points(after) - points(before)).max(), 1e-5)

    def test_mode(self):
        self.assert_moves_points(Mode="Smooth")
        surface = MeshLaplacian(Input=half_sphere())
        optimizer = LaplacianMeshOptimizer(
            Input=surface,
            Mode="Prescribed Laplacians",
            PrescribedLaplacianArray=("POINTS", "UniformLaplacian"),
        )
        self.assertLess(np.abs(point_array(optimizer, "Displacement")).max(), 1e-7)

    def test_laplacian_type(self):
        self.assert_moves_points({"Mode": "Smooth"}, LaplacianType="Cotangent")
        self.assert_moves_points({"Mode": "Smooth"}, LaplacianType="Mean Curvature")

    def test_position_weighting(self):
        self.assert_moves_points(PositionWeighting="Constant")
        self.assert_moves_points(PositionWeighting="Linear")
        weight = ("POINTS", "weight")
        self.assert_moves_points(PositionWeighting="Array", PositionWeightArray=weight)
        upper = ("POINTS", "upper")
        self.assert_moves_points(PositionWeighting="Anchors", PositionWeightArray=upper)

    def test_laplacian_weighting(self):
        self.assert_moves_points(LaplacianWeighting="Linear Complement")
        self.assert_moves_points(LaplacianWeighting="CDF Complement")
        self.assert_moves_points(LaplacianWeighting="Gaussian")
        weight = ("POINTS", "weight")
        self.assert_moves_points(LaplacianWeighting="Array", LaplacianWeightArray=weight)

    def test_scale_factor(self):
        self.assert_moves_points(ScaleFactor=0.1)

    def test_gaussian_width(self):
        self.assert_moves_points({"LaplacianWeighting": "Gaussian"}, GaussianWidth=0.2)

    def test_modulate_by_triangle_quality(self):
        self.assert_moves_points(ModulateByTriangleQuality=1)

    def test_tangent_plane_constraints(self):
        self.assert_moves_points({"Mode": "Smooth"}, TangentPlaneConstraints=1)

    def test_tangent_plane_weight(self):
        context = {"Mode": "Smooth", "TangentPlaneConstraints": 1}
        self.assert_moves_points(context, TangentPlaneWeight=10)

    def test_boundary_condition(self):
        self.assert_moves_points(BoundaryCondition="Free")
        self.assert_moves_points(BoundaryCondition="Sliding")

    def test_fixed_point_array(self):
        optimizer = LaplacianMeshOptimizer(
            Input=half_sphere(),
            Mode="Optimize Triangles",
            BoundaryCondition="Free",
            FixedPointArray=("POINTS", "upper"),
            InterpolatePointData=0,
        )
        moves = point_array(optimizer, "Displacement").any(axis=1)
        self.assertTrue((moves == (point_array(optimizer, "upper") == 0)).all())

    def test_selection(self):
        surface = half_sphere()
        selections = [
            (IDSelectionSource(FieldType="POINT", IDs=[-1, 20, -1, 30]), {20, 30}),
            (IDSelectionSource(FieldType="CELL", IDs=[-1, 100]), points_of_cell(surface, 100)),
        ]
        for selection, selected in selections:
            optimizer = LaplacianMeshOptimizer(
                Input=surface,
                Mode="Optimize Triangles",
                BoundaryCondition="Free",
                Selection=selection,
            )
            self.assertEqual(moved_points(optimizer), all_points(surface) - selected)
            optimizer.SelectionUse = "Only Selected Points Move"
            self.assertEqual(moved_points(optimizer), selected)
            optimizer.Selection = None
            self.assertEqual(moved_points(optimizer), all_points(surface))

    def test_solver_type(self):
        surface = half_sphere()
        direct = LaplacianMeshOptimizer(Input=surface, Mode="Optimize Triangles", SolverType="Direct")
        iterative = LaplacianMeshOptimizer(Input=surface, Mode="Optimize Triangles", SolverType="Iterative")
        self.assertEqual(metric(direct, "Iterations"), 0)
        self.assertGreater(metric(iterative, "Iterations"), 0)

    def test_tolerance(self):
        surface = half_sphere()
        coarse = LaplacianMeshOptimizer(Input=surface, Mode="Optimize Triangles", Tolerance=1e-2)
        fine = LaplacianMeshOptimizer(Input=surface, Mode="Optimize Triangles", Tolerance=1e-10)
        self.assertLess(metric(coarse, "Iterations"), metric(fine, "Iterations"))

    def test_maximum_number_of_iterations(self):
        optimizer = LaplacianMeshOptimizer(
            Input=half_sphere(), Mode="Optimize Triangles", MaximumNumberOfIterations=1
        )
        self.assertEqual(metric(optimizer, "Iterations"), 1)

    def test_compute_normals(self):
        surface = half_sphere()
        kept = LaplacianMeshOptimizer(Input=surface, Mode="Smooth", ComputeNormals=0)
        computed = LaplacianMeshOptimizer(Input=surface, Mode="Smooth")
        normals = point_array(surface, "Normals")
        self.assertTrue((point_array(kept, "Normals") == normals).all())
        self.assertFalse((point_array(computed, "Normals") == normals).all())


class OtherFilters(unittest.TestCase):
    def test_mesh_laplacian(self):
        laplacian = MeshLaplacian(Input=Sphere(Radius=2, ThetaResolution=40, PhiResolution=40))
        self.assertAlmostEqual(np.median(point_array(laplacian, "MeanCurvature")), 0.5, delta=0.01)

    def test_principal_curvatures(self):
        sphere = Sphere(Radius=2, ThetaResolution=40, PhiResolution=40)
        laplacian = MeshLaplacian(Input=sphere, PrincipalCurvatures=1)
        for name in ("SignedMeanCurvature", "PrincipalCurvature1", "PrincipalCurvature2"):
            self.assertAlmostEqual(np.median(point_array(laplacian, name)), 0.5, delta=0.01)

    def test_signed_distance(self):
        deviation = SurfaceDeviation(Input=Sphere(Radius=1), Reference=Sphere(Radius=2))
        self.assertTrue((point_array(deviation, "SignedDistance") < 0).all())

    def test_triangle_radius_ratio(self):
        quality = TriangleRadiusRatio(Input=Sphere())
        ratios = vtk_to_numpy(fetched(quality).GetCellData().GetArray("RadiusRatio"))
        self.assertAlmostEqual(ratios.mean(), metric(quality, "MeanRadiusRatio"), delta=1e-12)
        self.assertEqual(ratios.min(), metric(quality, "MinimumRadiusRatio"))

    def test_surface_deviation_of_two_inputs(self):
        low, high = (Plane(Origin=[0, 0, z], Point1=[1, 0, z], Point2=[0, 1, z]) for z in (0, 0.25))
        deviation = SurfaceDeviation(
            Input=Triangulate(Input=low), Reference=Triangulate(Input=high), NumberOfSamples=100
        )
        self.assertEqual(deviation.NumberOfSamples, 100)
        self.assertAlmostEqual(metric(deviation, "HausdorffDistance"), 0.25)
        self.assertAlmostEqual(metric(deviation, "MeanDistance"), 0.25)
        self.assertTrue(np.allclose(point_array(deviation, "Distance"), 0.25))


class Inputs(unittest.TestCase):
    def test_composite_input_gives_composite_output(self):
        spheres = [Sphere(), Sphere(Center=[3, 0, 0], ThetaResolution=12)]
        for name in ["LaplacianMeshOptimizer", "MeshLaplacian", "TriangleRadiusRatio"]:
            blocks = fetched(proxy_class(name)(Input=GroupDatasets(Input=spheres)))
            self.assertEqual(blocks.GetNumberOfBlocks(), 2)
            for number, sphere in enumerate(spheres):
                alone = fetched(proxy_class(name)(Input=sphere))
                block = blocks.GetBlock(number)
                self.assertTrue(
                    (
                        vtk_to_numpy(block.GetPoints().GetData())
                        == vtk_to_numpy(alone.GetPoints().GetData())
                    ).all()
                )
                self.assertEqual(
                    block.GetPointData().GetNumberOfArrays(),
                    alone.GetPointData().GetNumberOfArrays(),
                )

    def test_contour_of_the_wavelet(self):
        contour = Contour(Input=Wavelet(), ContourBy=["POINTS", "RTData"], Isosurfaces=[157.09])
        optimizer = LaplacianMeshOptimizer(Input=contour)
        self.assertGreater(
            metric(optimizer, "MeanRadiusRatio"), metric(optimizer, "InputMeanRadiusRatio") + 0.08
        )
        self.assertEqual(points(optimizer).dtype, points(contour).dtype)


if __name__ == "__main__":
    unittest.main()
