# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""The trace and the state of the session that TestSession.xml played give the same surface.

usage: TestSession.py <folder with session.py and session.pvsm>
"""
import os
import sys
import unittest

import numpy as np
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

FOLDER = sys.argv.pop()

LoadPlugin("LaplacianMeshOptimization", remote=False, ns=globals())


def point_array(proxy, name):
    return vtk_to_numpy(servermanager.Fetch(proxy).GetPointData().GetArray(name))


class Session(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        script = {}
        with open(os.path.join(FOLDER, "session.py")) as trace:
            exec(trace.read(), script)
        cls.traced = script["laplacianMeshOptimizer1"]
        LoadState(os.path.join(FOLDER, "session.pvsm"))
        others = [proxy for proxy in GetSources().values() if proxy != cls.traced]
        cls.loaded = next(proxy for proxy in others if hasattr(proxy, "LaplacianWeighting"))

    def test_the_slider_was_moved(self):
        self.assertEqual(self.traced.Mode, "Smooth")
        self.assertLess(self.traced.ScaleFactor, 0.5)

    def test_the_state_has_the_properties_of_the_trace(self):
        for name in ["Mode", "ScaleFactor", "LaplacianWeighting", "PositionWeighting"]:
            self.assertEqual(getattr(self.loaded, name), getattr(self.traced, name), name)

    def test_selected_points_stay_and_others_move(self):
        selected = [point for point in list(self.loaded.Selection.Input[0].IDs)[1::2]]
        self.assertGreater(len(selected), 100)
        moves = point_array(self.loaded, "Displacement").any(axis=1)
        self.assertFalse(moves[selected].any())
        self.assertGreater(moves.sum(), 100)

    def test_without_the_selection_the_state_gives_what_the_trace_gives(self):
        selection = self.loaded.Selection
        self.loaded.Selection = None
        self.assertTrue(
            np.array_equal(
                point_array(self.loaded, "Displacement"), point_array(self.traced, "Displacement")
            )
        )
        self.loaded.Selection = selection


if __name__ == "__main__":
    unittest.main()
