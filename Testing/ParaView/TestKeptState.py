# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""State files of earlier versions mean what they meant.

State-0.1.pvsm was saved by version 0.1 with what build() makes.
"""
import os
import unittest

import numpy as np
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

LoadPlugin("LaplacianMeshOptimization", remote=False, ns=globals())

KEPT_STATE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "State-0.1.pvsm")

OPTIMIZER = {
    "Mode": "Smooth",
    "LaplacianType": "Cotangent",
    "PositionWeighting": "Array",
    "PositionWeightArray": ["POINTS", "weight"],
    "ScaleFactor": 0.25,
    "LaplacianWeighting": "Gaussian",
    "GaussianWidth": 0.75,
    "BoundaryCondition": "Free",
    "SelectionUse": "Selected Points Stay",
    "Tolerance": 1e-9,
}


def build():
    sphere = Sphere(ThetaResolution=20, PhiResolution=14, EndTheta=180)
    weight = Calculator(Input=sphere, Function="coordsZ + 0.5", ResultArrayName="weight")
    selection = IDSelectionSource(FieldType="POINT", IDs=[-1, 20, -1, 30])
    optimizer = LaplacianMeshOptimizer(Input=weight, Selection=selection, **OPTIMIZER)
    deviation = SurfaceDeviation(Input=optimizer, Reference=sphere, NumberOfSamples=1000)
    return {
        "Optimizer": optimizer,
        "Laplacian": MeshLaplacian(Input=sphere),
        "Ratio": TriangleRadiusRatio(Input=sphere),
        "Deviation": deviation,
        "Preset": SmoothandFairPaperCAD(Input=sphere, ScaleFactor=0.5),
    }


def arrays(proxy):
    """All points and arrays of the output by name."""
    output = servermanager.Fetch(proxy)
    result = {"points": vtk_to_numpy(output.GetPoints().GetData())}
    for data in [output.GetPointData(), output.GetCellData(), output.GetFieldData()]:
        for k in range(data.GetNumberOfArrays()):
            result[data.GetClassName() + data.GetArrayName(k)] = vtk_to_numpy(data.GetArray(k))
    return result


class KeptState(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        LoadState(KEPT_STATE)

    def test_properties_are_those_that_were_saved(self):
        optimizer = FindSource("Optimizer")
        for name, value in OPTIMIZER.items():
            self.assertEqual(getattr(optimizer, name), value, name)
        self.assertEqual(list(optimizer.Selection.IDs), [-1, 20, -1, 30])
        self.assertEqual(FindSource("Preset").ScaleFactor, 0.5)
        self.assertEqual(FindSource("Preset").PositionWeighting, "Linear")

    def test_results_are_those_of_the_same_pipeline_made_now(self):
        for name, proxy in build().items():
            kept = arrays(FindSource(name))
            made = arrays(proxy)
            self.assertEqual(kept.keys(), made.keys())
            for array in made:
                self.assertTrue(np.array_equal(kept[array], made[array]), (name, array))


if __name__ == "__main__":
    unittest.main()
