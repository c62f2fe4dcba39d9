# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin's filters in pvpython, as users write them with paraview.simple."""
import unittest

import laplacianmesh
import numpy as np
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger

LoadPlugin("LaplacianMeshOptimization", remote=False, ns=globals())

ENUMERATIONS = {
    "Mode": [
        "Optimize Triangles",
        "Smooth",
        "Prescribed Laplacians",
        "Optimize Within Deviation",
        "Smooth Guided",
    ],
    "LaplacianType": ["Uniform", "Cotangent", "Mean Curvature"],
    "PositionWeighting": ["Constant", "Linear", "CDF", "Anchors", "Array"],
    "LaplacianWeighting": ["Constant", "Linear Complement", "CDF Complement", "Gaussian", "Array"],
    "BoundaryCondition": ["Fixed", "Sliding", "Free", "Curve"],
    "SelectionUse": ["Selected Points Stay", "Only Selected Points Move"],
    "SolverType": ["Automatic", "Direct", "Iterative"],
}

NUMBERS = {
    "RobustLaplacian": 1,
    "ScaleFactor": 0.25,
    "GaussianWidth": 0.75,
    "ModulateByTriangleQuality": 1,
    "TangentPlaneConstraints": 1,
    "TangentPlaneWeight": 2.5,
    "Tolerance": 1e-9,
    "MaximumNumberOfIterations": 77,
    "MaximumDeviation": 0.001,
    "DeviationIsAbsolute": 1,
    "NumberOfPasses": 3,
    "ImproveWorstTriangles": 0,
    "DetailWeight": 0.5,
    "NormalIterations": 20,
    "NormalWidth": 0.5,
    "FeatureConstraints": 1,
    "DetectFeatures": 0,
    "FeatureAngle": 60,
    "PreserveVolume": 1,
    "Twicing": 1,
    "ComputeNormals": 0,
    "FeatureSmoothing": 1,
    "FreeAxes": [1, 1, 0],
    "InterpolatePointData": 0,
    "WeldCoincidentPoints": 0,
    "CheckSelfIntersections": 1,
    "DiagnosticArrays": 0,
    "StartFromPreviousTimeStep": 1,
}

ARRAYS = [
    "PositionWeightArray",
    "LaplacianWeightArray",
    "PrescribedLaplacianArray",
    "FixedPointArray",
    "FeatureArray",
]

RESULTS = [
    "InputMeanRadiusRatio",
    "MeanRadiusRatio",
    "InputMinimumRadiusRatio",
    "MinimumRadiusRatio",
    "MaximumDisplacement",
    "RelativeMaximumDisplacement",
    "RelativeVolumeChange",
    "FlippedTriangles",
    "Iterations",
    "RelativeResidual",
    "HausdorffBound",
    "RelativeHausdorffBound",
    "SelfIntersections",
    "InputSelfIntersections",
    "PinnedBadTriangles",
]

# What the panel asks the filter for, beside its results.
INFORMATION = ["AreMetricsUpToDate", "HasVolume", "DeviationLength"]

# Those of Optimize Within Deviation alone.
OF_DEVIATION = RESULTS[RESULTS.index("HausdorffBound"):]

PROPERTIES = {
    "LaplacianMeshOptimizer": [
        "Input",
        "Selection",
        "Reference",
        *ENUMERATIONS,
        *NUMBERS,
        *ARRAYS,
        *RESULTS,
        *INFORMATION,
        "ReadResults",
    ],
    "MeshLaplacian": [
        "Input",
        "RobustLaplacian",
        "PrincipalCurvatures",
        "WeldCoincidentPoints",
    ],
    "TriangleRadiusRatio": ["Input", "WeldCoincidentPoints"],
    "SurfaceDeviation": ["Input", "Reference", "NumberOfSamples"],
}


# XML name, function, settings other than the defaults.
PRESETS = [
    ("ImproveTriangles", "ImproveTriangleQuality", {}),
    (
        "ImproveTrianglesFast",
        "ImproveTriangleQualityfast",
        {"Mode": "Optimize Triangles", "FeatureConstraints": 1},
    ),
    (
        "DenoiseSurface",
        "DenoiseSurface",
        {
            "Mode": "Smooth",
            "PositionWeighting": "Constant",
            "ScaleFactor": 0.2,
            "PreserveVolume": 1,
            "Twicing": 1,
        },
    ),
    (
        "DenoiseSurfaceFlatFaces",
        "DenoiseSurfaceflatfacessharpedges",
        {"Mode": "Smooth Guided"},
    ),
    (
        "ImproveTriangleQuality",
        "ImproveTriangleQualitynoRemesh",
        {"Mode": "Optimize Triangles"},
    ),
    (
        "ImproveTriangleQualityFeatures",
        "ImproveTriangleQualitynoRemeshCAD",
        {
            "Mode": "Optimize Triangles",
            "PositionWeighting": "Constant",
            "ScaleFactor": 0.1,
            "FeatureConstraints": 1,
        },
    ),
    (
        "ImproveTriangleQualityCAD",
        "ImproveTriangleQualityPaperCAD",
        {
            "Mode": "Optimize Triangles",
            "PositionWeighting": "Linear",
            "LaplacianWeighting": "Linear Complement",
        },
    ),
    (
        "SmoothAndFair",
        "SmoothandFair",
        {
            "Mode": "Smooth",
            "LaplacianType": "Cotangent",
            "ScaleFactor": 0.3,
            "LaplacianWeighting": "CDF Complement",
        },
    ),
    (
        "SmoothAndFairFeatures",
        "SmoothandFairCAD",
        {
            "Mode": "Smooth",
            "PositionWeighting": "Constant",
            "ScaleFactor": 0.3,
            "FeatureConstraints": 1,
            "PreserveVolume": 1,
        },
    ),
    (
        "SmoothAndFairCAD",
        "SmoothandFairPaperCAD",
        {
            "Mode": "Smooth",
            "PositionWeighting": "Linear",
            "ScaleFactor": 0.1,
            "LaplacianWeighting": "Linear Complement",
        },
    ),
    (
        "BestTrianglesWithinError",
        "BestTriangleswithinanErrornoRemesh",
        {},
    ),
    (
        "RemoveNoise",
        "RemoveNoise",
        {
            "Mode": "Smooth",
            "PositionWeighting": "Constant",
            "ScaleFactor": 0.2,
            "PreserveVolume": 1,
            "Twicing": 1,
        },
    ),
    ("RemoveNoiseCAD", "RemoveNoiseCAD", {"Mode": "Smooth Guided"}),
]

SETTINGS = {function: settings for _, function, settings in PRESETS}

DOCUMENTED = [*PROPERTIES, *(name for name, _, _ in PRESETS)]

# Proxies and labels of the menu.
MENU = {
    "LaplacianMeshOptimizer": "Laplacian Mesh Optimizer",
    "ImproveTriangles": "Improve Triangle Quality",
    "ImproveTrianglesFast": "Improve Triangle Quality (fast)",
    "DenoiseSurface": "Denoise Surface",
    "DenoiseSurfaceFlatFaces": "Denoise Surface (flat faces, sharp edges)",
    "MeshLaplacianAndCurvature": "Mesh Laplacian and Curvature",
    "TriangleRadiusRatio": "Triangle Radius Ratio",
    "SurfaceDeviationHausdorff": "Surface Deviation (Hausdorff Distance)",
}


def proxy_class(name):
    return globals()[name]


def made(name):
    """A filter with a sphere on all of its inputs."""
    sphere = Sphere()
    inputs = [prop for prop in PROPERTIES[name] if prop in ("Input", "Reference")]
    return proxy_class(name)(**{prop: sphere for prop in inputs})


def prototype(name):
    return servermanager.ProxyManager().GetPrototypeProxy("filters", name)


def nested(element):
    numbers = range(element.GetNumberOfNestedElements() if element else 0)
    return [element.GetNestedElement(number) for number in numbers]


def descendants(element):
    for child in nested(element):
        yield child
        yield from descendants(child)


# Of the properties that others depend on: the defaults, of a closed surface after an execution.
SHOWN_VALUES = {
    "Mode": 3,
    "InputMeanRadiusRatio": 0.5,
    "HasVolume": 1,
    "DeviationLength": 0.1,
    "DeviationIsAbsolute": 0,
    "CheckSelfIntersections": 0,
    "FeatureConstraints": 0,
    "FeatureSmoothing": 0,
    "FeatureArray": "None",
    "DetectFeatures": 1,
    "PreserveVolume": 0,
    "PositionWeighting": 0,
    "LaplacianWeighting": 0,
    "TangentPlaneConstraints": 0,
}


def holds(element, values):
    """Whether a decorator, or an expression in one, shows its property."""
    if element.GetName() == "Expression":
        combine = {"and": all, "or": any}[element.GetAttribute("type")]
        return combine(holds(child, values) for child in nested(element))
    if element.GetAttribute("type") == "CompositeDecorator":
        return all(holds(child, values) for child in nested(element))
    if element.GetAttribute("type") == "SessionTypeDecorator":
        return False
    wanted = element.GetAttribute("values") or element.GetAttribute("value")
    is_equal = str(values[element.GetAttribute("property")]) in wanted.split()
    return is_equal != (element.GetAttribute("inverse") == "1")


def half_sphere():
    """Open, with point normals and the arrays `weight`, 0 to 1, and `upper`, 0 or 1."""
    sphere = Sphere(ThetaResolution=20, PhiResolution=14, EndTheta=180)
    weight = Calculator(Input=sphere, Function="coordsZ + 0.5", ResultArrayName="weight")
    return Calculator(Input=weight, Function="coordsZ > 0.2", ResultArrayName="upper")


def fetched(proxy):
    return servermanager.Fetch(proxy)


def points(proxy):
    return vtk_to_numpy(fetched(proxy).GetPoints().GetData())


def point_array(proxy, name):
    return vtk_to_numpy(fetched(proxy).GetPointData().GetArray(name))


def metric(proxy, name):
    return fetched(proxy).GetFieldData().GetArray(name).GetValue(0)


def all_points(proxy):
    return set(range(fetched(proxy).GetNumberOfPoints()))


def moved_points(proxy):
    return set(np.flatnonzero(point_array(proxy, "Displacement").any(axis=1)))


def points_of_cell(proxy, cell):
    ids = fetched(proxy).GetCell(cell).GetPointIds()
    return {ids.GetId(corner) for corner in range(ids.GetNumberOfIds())}


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


class Results(unittest.TestCase):
    def test_the_panel_shows_the_figures_of_the_field_data(self):
        of_all_modes = [name for name in RESULTS if name not in OF_DEVIATION]
        for mode, names in [("Smooth", of_all_modes), ("Optimize Within Deviation", RESULTS)]:
            optimizer = LaplacianMeshOptimizer(Input=Sphere(), Mode=mode)
            optimizer.UpdatePipeline()
            optimizer.UpdatePropertyInformation()
            for name in names:
                self.assertEqual(getattr(optimizer, name), metric(optimizer, name), name)

    def test_metrics_follow_the_properties(self):
        optimizer = LaplacianMeshOptimizer(Input=Sphere(), Mode="Smooth")
        optimizer.UpdatePipelineInformation()
        self.assertEqual(optimizer.MeanRadiusRatio, -1)
        optimizer.UpdatePipeline()
        optimizer.ScaleFactor = 0.1
        optimizer.UpdatePipelineInformation()
        shown = optimizer.MeanRadiusRatio
        self.assertEqual(shown, metric(optimizer, "MeanRadiusRatio"))
        self.assertNotEqual(shown, -1)


    def test_an_error_after_a_result_leaves_the_input_to_look_at(self):
        optimizer = LaplacianMeshOptimizer(Input=half_sphere())
        optimizer.UpdatePipeline()
        verbosity = vtkLogger.GetCurrentVerbosityCutoff()
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        optimizer.Mode = "Prescribed Laplacians"
        optimizer.UpdatePipeline()
        vtkLogger.SetStderrVerbosity(verbosity)
        output = optimizer.GetClientSideObject().GetOutputDataObject(0)
        self.assertEqual(output.GetNumberOfPoints(), len(points(optimizer.Input)))
        self.assertFalse(output.GetCellData().HasArray("RadiusRatio"))

    def test_the_volume_is_that_of_a_closed_surface(self):
        for surface, has_volume in [(Sphere(), 1), (half_sphere(), 0)]:
            optimizer = LaplacianMeshOptimizer(Input=surface)
            optimizer.UpdatePipeline()
            optimizer.UpdatePropertyInformation()
            self.assertEqual(optimizer.SMProxy.GetProperty("HasVolume").GetElement(0), has_volume)

    def test_the_deviation_is_known_as_a_length_before_the_first_execution(self):
        sphere = Sphere(Radius=2)
        optimizer = LaplacianMeshOptimizer(Input=sphere, MaximumDeviation=0.001)
        sphere.UpdatePipeline()
        optimizer.UpdateVTKObjects()
        optimizer.UpdatePropertyInformation()
        bounds = np.reshape(fetched(sphere).GetBounds(), (3, 2))
        diagonal = np.linalg.norm(bounds[:, 1] - bounds[:, 0])
        self.assertAlmostEqual(optimizer.DeviationLength, 0.001 * diagonal, delta=1e-12)


class Colors(unittest.TestCase):
    """Of the arrays of triangle quality, from the first time that they are shown."""

    def test_red_is_bad_and_blue_is_good_in_a_range_that_stays(self):
        for name in ("RadiusRatio", "InputRadiusRatio"):
            table = GetColorTransferFunction(name)
            points = np.reshape(table.RGBPoints, (-1, 4))
            self.assertEqual((points[0, 0], points[-1, 0]), (0, 1))
            self.assertGreater(points[0, 1], points[0, 3])
            self.assertGreater(points[-1, 3], points[-1, 1])
            self.assertEqual(table.ColorSpace, "Lab")
            self.assertEqual(table.AutomaticRescaleRangeMode, "Never")

    def test_other_arrays_have_the_colours_of_paraview(self):
        other = GetColorTransferFunction("Displacement")
        self.assertNotEqual(list(other.RGBPoints), list(GetColorTransferFunction("RadiusRatio").RGBPoints))

    def test_colouring_does_not_change_the_range(self):
        quality = TriangleRadiusRatio(Input=Sphere())
        view = CreateRenderView()
        display = Show(quality, view)
        # As the client does. ColorBy() rescales the range in any case.
        display.SetScalarColoring("RadiusRatio", servermanager.GetAssociationFromString("CELLS"))
        display.SMProxy.RescaleTransferFunctionToDataRange(False, False)
        points = np.reshape(GetColorTransferFunction("RadiusRatio").RGBPoints, (-1, 4))
        self.assertEqual((points[0, 0], points[-1, 0]), (0, 1))
        Delete(view)


class Panel(unittest.TestCase):
    """What the panel is built from."""

    def test_every_property_but_the_inputs_is_in_a_group(self):
        optimizer = prototype("LaplacianMeshOptimizer")
        grouped = []
        for number in range(optimizer.GetNumberOfPropertyGroups()):
            group = optimizer.GetPropertyGroup(number)
            self.assertTrue(group.GetXMLLabel())
            properties = [group.GetProperty(k) for k in range(group.GetNumberOfProperties())]
            self.assertNotIn(None, properties)
            grouped += [optimizer.GetPropertyName(prop) for prop in properties]
        self.assertEqual(
            sorted(grouped),
            sorted(
                set(PROPERTIES["LaplacianMeshOptimizer"])
                - {"Input", "AreMetricsUpToDate", "HasVolume"}
            ),
        )

    def decorators(self, name):
        hints = prototype("LaplacianMeshOptimizer").GetProperty(name).GetHints()
        return [one for one in nested(hints) if one.GetName() == "PropertyWidgetDecorator"]

    def is_shown(self, name, **values):
        """Whether the panel shows a property, advanced or not, where others have these values."""
        values = {**SHOWN_VALUES, **values}
        return all(holds(decorator, values) for decorator in self.decorators(name))

    def test_decorators_name_properties(self):
        for name in PROPERTIES["LaplacianMeshOptimizer"]:
            for decorator in self.decorators(name):
                for element in [decorator, *descendants(decorator)]:
                    if element.GetAttribute("property"):
                        self.assertIn(
                            element.GetAttribute("property"), PROPERTIES["LaplacianMeshOptimizer"]
                        )

    def test_each_mode_shows_what_it_uses(self):
        uses = {
            "Optimize Triangles": {"ScaleFactor", "PositionWeighting", "FeatureConstraints"},
            "Smooth": {"LaplacianType", "ScaleFactor", "PositionWeighting", "FeatureConstraints"},
            "Prescribed Laplacians": {"LaplacianType", "ScaleFactor", "PositionWeighting"},
            "Optimize Within Deviation": {
                "MaximumDeviation",
                "DeviationLength",
                "DetectFeatures",
                "FeatureAngle",
                "FeatureArray",
                "RelativeHausdorffBound",
                "PinnedBadTriangles",
                "SelfIntersections",
            },
            "Smooth Guided": {"NormalWidth"},
        }
        for mode, name in enumerate(uses):
            candidates = set().union(*uses.values())
            shown = {candidate for candidate in candidates if self.is_shown(candidate, Mode=mode)}
            self.assertEqual(shown, uses[name], name)

    def test_features_are_shown_where_they_are_used(self):
        for name in ("DetectFeatures", "FeatureAngle", "FeatureArray"):
            for mode in (0, 1):
                self.assertTrue(self.is_shown(name, Mode=mode, FeatureConstraints=1))
            self.assertTrue(self.is_shown(name, Mode=1, FeatureSmoothing=1))
            self.assertFalse(self.is_shown(name, Mode=0, FeatureSmoothing=1))
            self.assertFalse(self.is_shown(name, Mode=2, FeatureConstraints=1))
            self.assertFalse(self.is_shown(name, Mode=4, FeatureConstraints=1))

    def test_a_feature_array_is_shown_where_volumes_are_preserved(self):
        for mode in (1, 4):
            self.assertTrue(self.is_shown("FeatureArray", Mode=mode, PreserveVolume=1))

    def test_a_feature_array_hides_the_detection(self):
        for name in ("DetectFeatures", "FeatureAngle"):
            self.assertFalse(self.is_shown(name, FeatureArray="edges"))
        self.assertFalse(self.is_shown("FeatureAngle", DetectFeatures=0))

    def test_feature_smoothing_hides_what_it_includes(self):
        self.assertFalse(self.is_shown("FeatureConstraints", Mode=1, FeatureSmoothing=1))
        self.assertTrue(self.is_shown("FeatureConstraints", Mode=0, FeatureSmoothing=1))

    def test_the_use_of_a_selection_is_shown_with_one(self):
        self.assertFalse(self.is_shown("SelectionUse", Selection="null"))
        self.assertTrue(self.is_shown("SelectionUse", Selection="AppendSelections"))

    def test_no_result_is_shown_before_the_first_execution(self):
        for name in RESULTS:
            mode = 1 if name == "RelativeResidual" else 3
            self.assertTrue(self.is_shown(name, Mode=mode), name)
            self.assertFalse(self.is_shown(name, Mode=mode, InputMeanRadiusRatio=-1), name)

    def test_a_volume_change_is_shown_of_closed_surfaces(self):
        self.assertFalse(self.is_shown("RelativeVolumeChange", HasVolume=0))

    def test_intersections_are_shown_where_they_are_counted(self):
        for name in ("SelfIntersections", "InputSelfIntersections"):
            self.assertTrue(self.is_shown(name, Mode=1, CheckSelfIntersections=1))
            self.assertFalse(self.is_shown(name, Mode=1))

    def test_a_length_is_not_shown_twice(self):
        self.assertFalse(self.is_shown("DeviationLength", DeviationIsAbsolute=1))

    def test_the_results_need_no_button_in_one_process(self):
        (decorator,) = self.decorators("ReadResults")
        self.assertEqual(decorator.GetAttribute("type"), "SessionTypeDecorator")
        self.assertEqual(decorator.GetAttribute("requires"), "parallel_data_server")


class Presets(unittest.TestCase):
    def test_presets_are_the_optimizer_with_other_defaults(self):
        sphere = Sphere()
        for _, function, settings in PRESETS:
            preset = proxy_class(function)(Input=sphere)
            optimizer = LaplacianMeshOptimizer(Input=sphere, **settings)
            for name in [*ENUMERATIONS, *NUMBERS]:
                self.assertEqual(getattr(preset, name), getattr(optimizer, name), name)
            self.assertEqual(preset.ListProperties(), optimizer.ListProperties())
            self.assertTrue((points(preset) == points(optimizer)).all(), function)

    def test_presets_can_be_changed(self):
        smooth = SmoothandFair(Input=Sphere(), ScaleFactor=0.05)
        changed = LaplacianMeshOptimizer(Input=Sphere(), **{**SETTINGS["SmoothandFair"], "ScaleFactor": 0.05})
        self.assertTrue((points(smooth) == points(changed)).all())

    def test_the_panel_of_a_preset_is_that_of_the_optimizer(self):
        def layout(name):
            proxy = prototype(name)
            properties = proxy.NewPropertyIterator()
            order = []
            while not properties.IsAtEnd():
                order.append(properties.GetKey())
                properties.Next()
            return proxy.GetNumberOfPropertyGroups(), order

        for name, _, _ in PRESETS:
            self.assertEqual(layout(name), layout("LaplacianMeshOptimizer"))

    def test_the_search_finds_them_by_their_jobs(self):
        labels = [label.lower() for label in MENU.values()]
        for words in ["triangle quality", "laplacian", "noise", "curvature", "hausdorff distance"]:
            self.assertTrue(
                any(all(word in label for word in words.split()) for label in labels), words
            )


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
