# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin on both sides of a connection to pvserver.

usage: TestServer.py <port of a pvserver>
"""
import os
import sys
import unittest

import numpy as np
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

PORT = int(sys.argv.pop())
PLUGIN = os.environ["LMO_PLUGIN"]


def optimized():
    contour = Contour(Input=Wavelet(), ContourBy=["POINTS", "RTData"], Isosurfaces=[157.09])
    selection = IDSelectionSource(FieldType="POINT", IDs=[-1, 20, -1, 30])
    optimizer = LaplacianMeshOptimizer(Input=contour, Selection=selection)
    optimizer.UpdatePipeline()
    optimizer.UpdatePropertyInformation()
    return optimizer


def points(proxy):
    return vtk_to_numpy(servermanager.Fetch(proxy).GetPoints().GetData()).copy()


class Server(unittest.TestCase):
    def setUp(self):
        LoadPlugin(PLUGIN, remote=False, ns=globals())
        local = optimized()
        self.local_points = points(local)
        self.local_ratio = local.MeanRadiusRatio
        Connect("127.0.0.1", PORT)

    def test_the_server_does_what_the_client_alone_does(self):
        LoadPlugin(PLUGIN, remote=True, ns=globals())
        LoadPlugin(PLUGIN, remote=False, ns=globals())
        remote = optimized()
        self.assertTrue(servermanager.ActiveConnection.IsRemote())
        self.assertTrue(np.array_equal(points(remote), self.local_points))
        self.assertEqual(remote.MeanRadiusRatio, self.local_ratio)
        self.assertGreater(remote.MeanRadiusRatio, remote.InputMeanRadiusRatio)
        ImproveTriangleQualitynoRemesh(Input=Sphere()).UpdatePipeline()


if __name__ == "__main__":
    unittest.main()
