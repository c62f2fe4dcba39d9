# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the client shows of the plugin: results, colours, the panel, the menu's entries."""
import unittest

import numpy as np
from paraview import servermanager
from vtkmodules.vtkCommonCore import vtkLogger

from plugin_proxies import *
from plugin_tables import *


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


class Results(unittest.TestCase):
    def test_the_panel_shows_the_figures_of_the_field_data(self):
        of_all_modes = [name for name in RESULTS if name not in OF_DEVIATION]
        for mode, names in [("Smooth", of_all_modes), ("Optimize Within Deviation", RESULTS)]:
            optimizer = LaplacianMeshOptimizer(Input=Sphere(), Mode=mode)
            optimizer.UpdatePipeline()
            optimizer.UpdatePropertyInformation()
            for name in names:
                self.assertEqual(getattr(optimizer, name), metric(optimizer, name), name)

    def test_the_panel_of_surface_deviation_shows_its_distances(self):
        deviation = SurfaceDeviation(Input=Sphere(Radius=1), Reference=Sphere(Radius=1.5))
        deviation.UpdatePipelineInformation()
        self.assertEqual(deviation.HausdorffDistance, -1)
        deviation.UpdatePipeline()
        deviation.Reference = Sphere(Radius=2)
        deviation.UpdatePropertyInformation()
        for name in DISTANCES:
            self.assertEqual(getattr(deviation, name), metric(deviation, name), name)

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


if __name__ == "__main__":
    unittest.main()
