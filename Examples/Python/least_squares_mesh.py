# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""A least-squares mesh: the smoothest surface with the same triangles that passes near a few
anchors (Eqn. 9; Sorkine and Cohen-Or 2004)."""
import common
import shapes
from laplacianmesh import vtkLaplacianMeshOptimizer
from vtkmodules.vtkCommonDataModel import vtkDataObject

arguments = common.parse_arguments(__doc__, anchors=300)
mesh = common.read_mesh(arguments.mesh) if arguments.mesh else shapes.animal()
anchors = shapes.spread_points(mesh, int(arguments.anchors))
shapes.add_point_array(mesh, "Anchors", shapes.mask(mesh, anchors))

optimizer = vtkLaplacianMeshOptimizer()
optimizer.SetInputData(mesh)
optimizer.SetMode(vtkLaplacianMeshOptimizer.SMOOTH)
optimizer.SetLaplacianType(vtkLaplacianMeshOptimizer.UNIFORM)
optimizer.SetPositionWeighting(vtkLaplacianMeshOptimizer.ANCHORS)
optimizer.SetInputArrayToProcess(
    vtkLaplacianMeshOptimizer.POSITION_WEIGHT_ARRAY,
    0,
    0,
    vtkDataObject.FIELD_ASSOCIATION_POINTS,
    "Anchors",
)
optimizer.Update()
smooth = optimizer.GetOutput()

print("%d anchors of %d points" % (len(anchors), mesh.GetNumberOfPoints()))
common.print_triangles(optimizer)
common.print_distance(smooth, mesh)

if arguments.output:
    common.write_mesh(arguments.output, smooth)
if arguments.picture:
    import viewing

    balls = viewing.balls(shapes.points_of(mesh)[anchors], 0.004 * mesh.GetLength())
    viewing.save_picture(
        arguments.picture,
        [
            viewing.renderer([viewing.surface(mesh), balls], title="input and anchors"),
            viewing.renderer([viewing.surface(smooth), balls], title="least-squares mesh"),
        ],
    )
