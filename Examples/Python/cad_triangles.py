# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Better triangles on a CAD part in one solve: corners stay, points on sharp edges slide along
them."""
import common
import shapes
from laplacianmesh import vtkLaplacianMeshOptimizer
from vtkmodules.util.numpy_support import vtk_to_numpy

arguments = common.parse_arguments(__doc__, feature_angle=40)
part = common.read_mesh(arguments.mesh) if arguments.mesh else shapes.machine_part()

optimizer = vtkLaplacianMeshOptimizer()
optimizer.SetInputData(part)
optimizer.SetMode(vtkLaplacianMeshOptimizer.OPTIMIZE_TRIANGLES)
optimizer.SetPositionWeighting(vtkLaplacianMeshOptimizer.CONSTANT)
optimizer.SetScaleFactor(0.1)
optimizer.FeatureConstraintsOn()
optimizer.SetFeatureAngle(arguments.feature_angle)  # degrees
optimizer.Update()
better = optimizer.GetOutput()

common.print_triangles(optimizer)
common.print_distance(better, part)

if arguments.output:
    common.write_mesh(arguments.output, better)
if arguments.picture:
    import viewing

    before = viewing.surface(part, edges=True)
    after = viewing.surface(better, "FeatureClass", (0, 2), viewing.CLASSES, edges=True)
    is_corner = vtk_to_numpy(better.GetPointData().GetArray("FeatureClass")) == 2
    corners = viewing.balls(shapes.points_of(better)[is_corner], 0.006 * better.GetLength())
    detail = {"direction": viewing.PART, "zoom": 3.2, "focus": (0.8, 0.15, 0.5)}
    viewing.save_picture(
        arguments.picture,
        [
            viewing.renderer([before], title="before", **detail),
            viewing.renderer([after, corners], title="after: edges orange, corners red", **detail),
        ],
    )
