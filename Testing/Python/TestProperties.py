# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""The filters have the properties, defaults and enumerations that their headers document, and
ParaView's panels those of the filters."""
import re
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import laplacianmesh
from laplacianmesh import vtkLaplacianMeshOptimizer

import lmo_testing as testing

SOURCE = Path(__file__).resolve().parents[2]
FILTERS = ["LaplacianMeshOptimizer", "MeshLaplacian", "SurfaceDeviation", "TriangleRadiusRatio"]

# Metrics of the filter that the panel does not show, and what it shows that is no metric.
HIDDEN_METRICS = {"Passes", "RolledBackPoints"}
INFORMATION = {"DeviationLength"}


class Setter:
    """A property as the header documents it: with the default, and the entries by name if it is
    an enumeration."""

    def __init__(self, text, value_type):
        self.type = value_type
        self.entries = {
            name: int(value) for name, value in re.findall(r"\b([A-Z][A-Z_]+) \((\d+)\)", text)
        }
        (default,) = re.findall(r"Default: (\(.*\)|\S+)\.(?:\s|$)", text)
        values = {"on": 1, "off": 0, **self.entries}
        if default.startswith("("):
            self.default = tuple(map(float, default[1:-1].split(",")))
        else:
            self.default = values[default] if default in values else float(default)
        self.is_vector = isinstance(self.default, tuple)


class Header:
    """What the header of a filter declares."""

    def __init__(self, name):
        text = (SOURCE / "Filters" / f"vtk{name}.h").read_text()
        declaration = r"/\*\*((?:(?!\*/).)*)\*/\s*vtkSet(?:Vector3)?Macro\((\w+), (\w+)\);"
        self.setters = {
            name: Setter(documentation, value_type)
            for documentation, name, value_type in re.findall(declaration, text, re.DOTALL)
        }
        assert len(self.setters) == len(re.findall(r"vtkSet\w*Macro", text)), name
        getters = re.findall(r"vtkGet(?:Vector3)?Macro\((\w+), \w+\);", text)
        self.metrics = [name for name in getters if name not in self.setters]
        self.enumerations = {
            name: {key: int(value) for key, value in re.findall(r"(\w+) = (\d+)", body)}
            for name, body in re.findall(r"\n  enum (\w+)\s*\{([^}]*)\}", text)
        }


def read_proxies():
    """The proxies of all XML files of the plugin by name."""
    return {
        proxy.get("name"): proxy
        for path in sorted((SOURCE / "Plugin").glob("*.xml"))
        for proxy in ElementTree.parse(path).iter("SourceProxy")
    }


HEADERS = {name: Header(name) for name in FILTERS}
PROXIES = read_proxies()
PRESETS = [
    proxy
    for proxy in PROXIES.values()
    if proxy.get("base_proxyname") == "LaplacianMeshOptimizer"
]


def commanded(proxy, prefix):
    """The properties of a proxy by what their commands set or get."""
    return {
        prop.get("command")[len(prefix) :]: prop
        for prop in proxy
        if prop.get("command", "").startswith(prefix)
        and prop.get("command") not in ("SetInputConnection", "SetInputArrayToProcess")
    }


def without_default(prop):
    """What a preset shares with the optimizer: all but the default and whether it is advanced."""
    attributes = {key: prop.get(key) for key in ("name", "label", "command")}
    children = "".join(ElementTree.tostring(child, encoding="unicode") for child in prop)
    return prop.tag, attributes, children.split()


def new(name):
    return getattr(laplacianmesh, "vtk" + name)()


def all_setters():
    for filter_name, header in HEADERS.items():
        for name, setter in header.setters.items():
            yield filter_name, name, setter


class Filters(unittest.TestCase):
    def test_defaults_are_those_of_the_documentation(self):
        for filter_name, name, setter in all_setters():
            value = getattr(new(filter_name), "Get" + name)()
            self.assertEqual(value, setter.default, name)

    def test_what_is_set_can_be_got(self):
        for filter_name, name, setter in all_setters():
            vtk_filter = new(filter_name)
            others = [(1, 0, 1)] if setter.is_vector else [*setter.entries.values()] or [0, 1, 7]
            for other in others:
                getattr(vtk_filter, "Set" + name)(other)
                self.assertEqual(getattr(vtk_filter, "Get" + name)(), other, name)

    def test_enumerations_are_documented_and_class_attributes(self):
        header = HEADERS["LaplacianMeshOptimizer"]
        choices = {name for name, setter in header.setters.items() if setter.entries}
        declared = {*header.enumerations} - {"InputArrayIndex"}
        self.assertEqual({name + "Type" for name in choices}, declared)
        for name in choices:
            entries = header.setters[name].entries
            self.assertEqual(sorted(entries.values()), list(range(len(entries))), name)
            self.assertLessEqual(header.enumerations[name + "Type"].items(), entries.items())
            for key, value in entries.items():
                self.assertEqual(getattr(vtkLaplacianMeshOptimizer, key), value, key)

    def test_the_tables_have_all_properties_and_metrics_in_order(self):
        """What the filter prints is what its tables hold."""
        header = HEADERS["LaplacianMeshOptimizer"]
        printed = re.findall(r"^  (\w+): ", str(vtkLaplacianMeshOptimizer()), re.MULTILINE)
        declared = [*header.setters, *header.metrics]
        self.assertEqual([*dict.fromkeys(name for name in printed if name in declared)], declared)

    def test_metrics_are_in_the_field_data_too(self):
        surface = testing.to_polydata(testing.torus(9, 8))
        for name in ["LaplacianMeshOptimizer", "TriangleRadiusRatio"]:
            vtk_filter = new(name)
            vtk_filter.SetInputData(surface)
            if name == "LaplacianMeshOptimizer":
                vtk_filter.SetMode(vtkLaplacianMeshOptimizer.OPTIMIZE_WITHIN_DEVIATION)
            vtk_filter.Update()
            for metric in HEADERS[name].metrics:
                got = getattr(vtk_filter, "Get" + metric)()
                self.assertEqual(testing.metric(vtk_filter.GetOutput(), metric), got, metric)


class Panels(unittest.TestCase):
    def test_the_panel_has_all_properties_and_no_others(self):
        for name, header in HEADERS.items():
            properties = commanded(PROXIES[name], "Set")
            self.assertEqual(properties.keys(), header.setters.keys(), name)
            for key, prop in properties.items():
                self.assertEqual(prop.get("name"), key)

    def test_defaults_and_types_are_those_of_the_header(self):
        for filter_name, name, setter in all_setters():
            prop = commanded(PROXIES[filter_name], "Set")[name]
            values = tuple(map(float, prop.get("default_values").split()))
            self.assertEqual(values if setter.is_vector else values[0], setter.default, name)
            kind = "Double" if setter.type == "double" else "Int"
            self.assertEqual(prop.tag, kind + "VectorProperty", name)
            is_switch = setter.type == "vtkTypeBool"
            self.assertEqual(prop.find("BooleanDomain") is not None, is_switch, name)

    def test_enumerations_have_the_entries_of_the_header(self):
        for filter_name, name, setter in all_setters():
            entries = commanded(PROXIES[filter_name], "Set")[name].iter("Entry")
            texts = {
                entry.get("text").upper().replace(" ", "_"): int(entry.get("value"))
                for entry in entries
            }
            self.assertEqual(texts, setter.entries, name)

    def test_input_arrays_have_the_indices_of_the_header(self):
        indices = {
            prop.get("name"): int(prop.get("default_values").split(";")[0])
            for prop in PROXIES["LaplacianMeshOptimizer"]
            if prop.get("command") == "SetInputArrayToProcess"
        }
        declared = HEADERS["LaplacianMeshOptimizer"].enumerations["InputArrayIndex"]
        names = {name.title().replace("_", ""): index for name, index in declared.items()}
        self.assertEqual(indices, names)

    def test_the_optimizer_shows_its_metrics(self):
        shown = commanded(PROXIES["LaplacianMeshOptimizer"], "Get")
        metrics = set(HEADERS["LaplacianMeshOptimizer"].metrics)
        self.assertEqual(shown.keys(), metrics - HIDDEN_METRICS | INFORMATION)
        for key, prop in shown.items():
            self.assertEqual(prop.get("name"), key)

    def test_presets_change_defaults_alone(self):
        self.assertEqual(len(PRESETS), 13)
        for preset in PRESETS:
            base = commanded(PROXIES[preset.get("base_proxyname")], "Set")
            self.assertEqual(preset.get("class"), "vtkLaplacianMeshOptimizer")
            for name, prop in commanded(preset, "Set").items():
                self.assertEqual(without_default(prop), without_default(base[name]), name)
                self.assertEqual(prop.get("override"), "1", name)
                self.assertNotEqual(prop.get("default_values"), base[name].get("default_values"))


if __name__ == "__main__":
    unittest.main()
