# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Loads the plugin, and what its tests ask of its filters. Exports paraview.simple as well."""
import numpy as np
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

from plugin_tables import PROPERTIES

LoadPlugin("LaplacianMeshOptimization", remote=False, ns=globals())


def proxy_class(name):
    return globals()[name]


def made(name):
    """A filter with a sphere on all of its inputs."""
    sphere = Sphere()
    inputs = [prop for prop in PROPERTIES[name] if prop in ("Input", "Reference")]
    return proxy_class(name)(**{prop: sphere for prop in inputs})


def prototype(name):
    return servermanager.ProxyManager().GetPrototypeProxy("filters", name)


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
