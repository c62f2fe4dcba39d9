# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""An isosurface that is in pieces on several processes, in pvbatch or in a server.

usage: pvbatch TestPartitionedIsosurface.py
       pvpython TestPartitionedIsosurface.py <command that starts a server, without its port>
"""
import os
import socket
import subprocess
import sys
import time
import unittest

import numpy as np
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSetCollection
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFeatureEdges

PLUGIN = os.environ["LMO_PLUGIN"]


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def connect(command):
    """Starts a server, which ends with the client, and connects to it."""
    port = free_port()
    # The client has its own MPI, whose variables would make the server part of it.
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("OMPI_", "PMIX_"))}
    server = subprocess.Popen([*command, f"--server-port={port}"], env=environment)
    for _ in range(60):
        time.sleep(1)
        if is_listening(port):
            Connect("127.0.0.1", port)
            return
    server.terminate()
    sys.exit("The server does not listen.")


def is_listening(port):
    """Looked up: the server would take a connection that tries for the client's."""
    with open("/proc/net/tcp") as connections:
        return any(f":{port:04X} 00000000:0000 0A" in line for line in connections)


def isosurface():
    """Closed, in as many pieces as there are processes."""
    return Contour(Input=Wavelet(), ContourBy=["POINTS", "RTData"], Isosurfaces=[200.0])


def fetched(proxy):
    """All pieces, one after the other, without ghost cells: contours bring some along."""
    pieces = servermanager.Fetch(proxy)
    pieces.RemoveGhostCells()
    return pieces


def merged(proxy):
    """All pieces as one surface; points that coincide are one."""
    clean = vtkCleanPolyData()
    clean.ToleranceIsAbsoluteOn()
    clean.SetAbsoluteTolerance(0)
    clean.SetInputData(fetched(proxy))
    clean.Update()
    return clean.GetOutput()


def boundary_edges(surface):
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


def coordinates(surface):
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float)


def metric(surface, name):
    return surface.GetFieldData().GetArray(name).GetValue(0)


class Isosurface(unittest.TestCase):
    def setUp(self):
        self.surface = isosurface()
        self.optimizer = LaplacianMeshOptimizer(
            Input=self.surface,
            Mode="Optimize Triangles",
            BoundaryCondition="Free",
            Tolerance=1e-12,
        )

    def test_the_surface_is_in_pieces(self):
        pieces = fetched(self.surface).GetNumberOfPoints()
        self.assertGreater(pieces, merged(self.surface).GetNumberOfPoints())

    def test_the_input_is_closed(self):
        self.assertEqual(boundary_edges(merged(self.surface)), 0)

    def test_the_borders_stay_closed(self):
        before, after = merged(self.surface), merged(self.optimizer)
        self.assertEqual(boundary_edges(after), 0)
        self.assertEqual(after.GetNumberOfPoints(), before.GetNumberOfPoints())

    def test_points_at_the_borders_move(self):
        pieces = coordinates(fetched(self.surface))
        _, first, copies = np.unique(pieces, axis=0, return_index=True, return_counts=True)
        displacement = vtk_to_numpy(
            fetched(self.optimizer).GetPointData().GetArray("Displacement")
        )
        boundary = np.linalg.norm(displacement[first[copies > 1]], axis=1)
        self.assertGreater(len(boundary), 0)
        self.assertGreater(np.median(boundary), 0)

    def test_the_result_is_that_of_one_process(self):
        # Constant weights: equal curvatures, of which this surface is full, are ranked by chance.
        for mode in ("Optimize Triangles", "Smooth"):
            self.optimizer.Mode = mode
            self.optimizer.PositionWeighting = "Constant"
            before, after = fetched(self.surface), fetched(self.optimizer)
            alone = self.optimized_alone(merged(self.surface))
            expected = {tuple(x): y for x, y in alone}
            difference = max(
                np.abs(y - expected[tuple(x)]).max()
                for x, y in zip(coordinates(before), coordinates(after))
            )
            self.assertLess(difference / before.GetLength(), 1e-6)  # float coordinates

    def optimized_alone(self, surface):
        """Pairs of old and new coordinates."""
        from laplacianmesh import vtkPLaplacianMeshOptimizer
        from vtkmodules.vtkParallelCore import vtkDummyController

        alone = vtkPLaplacianMeshOptimizer()
        alone.SetController(vtkDummyController())
        alone.SetInputData(surface)
        alone.SetTolerance(1e-12)
        alone.SetBoundaryCondition(alone.FREE)
        alone.SetPositionWeighting(alone.CONSTANT)
        alone.SetMode(alone.SMOOTH if self.optimizer.Mode == "Smooth" else alone.OPTIMIZE_TRIANGLES)
        alone.Update()
        return zip(coordinates(surface), coordinates(alone.GetOutput()))

    def test_figures_are_those_of_the_whole_surface(self):
        after = merged(self.optimizer)
        quality = vtk_to_numpy(after.GetCellData().GetArray("RadiusRatio"))
        after = servermanager.Fetch(self.optimizer)
        self.assertAlmostEqual(metric(after, "MeanRadiusRatio"), quality.mean(), 6)
        self.assertAlmostEqual(metric(after, "MinimumRadiusRatio"), quality.min(), 6)


class DefaultEntry(unittest.TestCase):
    """The first entry of the menu, without any setting."""

    def setUp(self):
        self.surface = isosurface()
        self.optimizer = ImproveTriangleQuality(Input=self.surface)

    def test_the_triangles_become_better_within_the_error(self):
        output = servermanager.Fetch(self.optimizer)
        self.assertGreater(
            metric(output, "MeanRadiusRatio"), metric(output, "InputMeanRadiusRatio") + 0.03
        )
        self.assertGreater(
            metric(output, "MinimumRadiusRatio"), metric(output, "InputMinimumRadiusRatio")
        )
        self.assertLessEqual(metric(output, "RelativeHausdorffBound"), 0.002)

    def test_the_surface_is_within_the_error(self):
        from laplacianmesh import vtkSurfaceDeviation

        deviation = vtkSurfaceDeviation()
        deviation.SetInputData(merged(self.optimizer))
        deviation.SetReferenceData(merged(self.surface))
        deviation.Update()
        self.assertLess(deviation.GetRelativeHausdorffDistance(), 0.002)

    def test_the_borders_stay_closed(self):
        before, after = merged(self.surface), merged(self.optimizer)
        self.assertEqual(boundary_edges(after), 0)
        self.assertEqual(after.GetNumberOfPoints(), before.GetNumberOfPoints())

    def test_every_process_has_the_arrays(self):
        ratios = fetched(self.optimizer).GetCellData().GetArray("RadiusRatio")
        self.assertEqual(
            ratios.GetNumberOfTuples(), fetched(self.surface).GetNumberOfCells()
        )

    def test_a_second_filter_renews_the_results(self):
        second = ImproveTriangleQuality(Input=self.optimizer)
        output = servermanager.Fetch(second)
        self.assertIsNone(output.GetFieldData().GetArray("MeanRadiusRatioOptimized"))
        self.assertIsNone(output.GetPointData().GetArray("RadiusRatioOptimized"))

    def test_partitions_are_one_surface(self):
        partitions = ConvertToPartitionedDataSetCollection(Input=self.surface)
        optimized = ImproveTriangleQuality(Input=partitions)
        optimized.UpdatePipeline()
        self.assertEqual(
            optimized.GetDataInformation().GetCompositeDataSetType(),
            vtkPartitionedDataSetCollection().GetDataObjectType(),
        )
        pieces = MergeBlocks(
            Input=optimized, OutputDataSetType="Polygonal Mesh", MergePoints=False
        )
        self.assertEqual(boundary_edges(merged(pieces)), 0)
        ratios = vtk_to_numpy(fetched(pieces).GetCellData().GetArray("RadiusRatio"))
        whole = metric(servermanager.Fetch(self.optimizer), "MeanRadiusRatio")
        self.assertAlmostEqual(ratios.mean(), whole, 6)

    def test_the_picture_shows_the_surface_as_one(self):
        picture = os.environ.get("LMO_PICTURE")
        if picture:
            view = CreateView("RenderView")
            view.ViewSize = [900, 700]
            shown = Show(self.optimizer, view)
            shown.Representation = "Surface With Edges"
            ColorBy(shown, ("CELLS", "RadiusRatio"))
            ResetCamera(view)
            SaveScreenshot(picture, view)
            self.assertGreater(os.path.getsize(picture), 20000)


def main():
    command = sys.argv[1:]
    if command:
        connect(command)
        LoadPlugin(PLUGIN, remote=True, ns=globals())
    LoadPlugin(PLUGIN, remote=False, ns=globals())
    result = unittest.main(argv=sys.argv[:1], exit=False).result
    if not result.wasSuccessful():
        sys.exit(1)


main()
