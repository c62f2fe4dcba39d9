# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Mean and Gaussian curvature of a surface as point arrays, and as colours."""
import common
import numpy as np
import shapes
from laplacianmesh import vtkMeshLaplacian
from vtkmodules.util.numpy_support import vtk_to_numpy

arguments = common.parse_arguments(__doc__)
mesh = common.read_mesh(arguments.mesh) if arguments.mesh else shapes.animal()

laplacian = vtkMeshLaplacian()
laplacian.SetInputData(mesh)
laplacian.RobustLaplacianOn()  # the mesh may have very thin triangles
laplacian.Update()
curved = laplacian.GetOutput()

limits = {}
for name in ("MeanCurvature", "GaussianCurvature"):
    values = vtk_to_numpy(curved.GetPointData().GetArray(name))
    low, middle, high = np.percentile(values, [5, 50, 95])
    limits[name] = max(-low, high)
    print("%-18s median %8.4g, 90 %% of the points from %.4g to %.4g" % (name, middle, low, high))

if arguments.output:
    common.write_mesh(arguments.output, curved)
if arguments.picture:
    import viewing

    limit = limits["MeanCurvature"]
    mean = viewing.surface(curved, "MeanCurvature", (0, limit), viewing.MAGNITUDE)
    limit = limits["GaussianCurvature"]
    gaussian = viewing.surface(curved, "GaussianCurvature", (-limit, limit), viewing.SIGNED)
    viewing.save_picture(
        arguments.picture,
        [
            viewing.renderer([mean], title="mean curvature"),
            viewing.renderer([gaussian], title="Gaussian curvature"),
        ],
    )
