# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the examples share: their arguments, files and measures."""
import argparse
import os

from laplacianmesh import vtkSurfaceDeviation
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

READERS = {
    ".obj": vtkOBJReader,
    ".ply": vtkPLYReader,
    ".stl": vtkSTLReader,
    ".vtp": vtkXMLPolyDataReader,
}


def parse_arguments(description, **options):
    """options: further options with numbers, and their defaults."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("mesh", nargs="?", help=".obj .ply .stl .vtp; default: one made in code")
    parser.add_argument("--output", help="the new mesh, .vtp")
    parser.add_argument("--picture", help="a picture, .png; needs a screen or xvfb-run")
    for name, default in options.items():
        parser.add_argument("--" + name.replace("_", "-"), type=float, default=default)
    return parser.parse_args()


def read_mesh(path):
    reader = READERS[os.path.splitext(path)[1].lower()]()
    reader.SetFileName(path)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(reader.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


def write_mesh(path, mesh):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(mesh)
    writer.SetDataModeToBinary()
    writer.Write()


def deviation(mesh, reference):
    """Distances of the two surfaces, in both directions."""
    measure = vtkSurfaceDeviation()
    measure.SetInputData(mesh)
    measure.SetReferenceData(reference)
    measure.Update()
    return measure


def print_triangles(optimizer):
    print(
        "mean radius ratio    %.3f -> %.3f\nminimum radius ratio %.3f -> %.3f"
        % (
            optimizer.GetInputMeanRadiusRatio(),
            optimizer.GetMeanRadiusRatio(),
            optimizer.GetInputMinimumRadiusRatio(),
            optimizer.GetMinimumRadiusRatio(),
        )
    )


def print_distance(mesh, reference, name="distance"):
    measure = deviation(mesh, reference)
    print(
        "%-20s mean %.5f, largest %.5f of the diagonal"
        % (name, measure.GetRelativeMeanDistance(), measure.GetRelativeHausdorffDistance())
    )
