# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Better triangles between a few anchors that keep the details in between (Eqn. 10; Nealen,
Sorkine, Alexa and Cohen-Or 2005). Where anchors are far apart, the shape drifts."""
import common
import shapes
from laplacianmesh import vtkLaplacianMeshOptimizer
from vtkmodules.vtkCommonDataModel import vtkDataObject

arguments = common.parse_arguments(__doc__, anchors=1000)
mesh = common.read_mesh(arguments.mesh) if arguments.mesh else shapes.animal()
anchors = shapes.spread_points(mesh, int(arguments.anchors))
shapes.add_point_array(mesh, "Anchors", shapes.mask(mesh, anchors))

optimizer = vtkLaplacianMeshOptimizer()
optimizer.SetInputData(mesh)
optimizer.SetMode(vtkLaplacianMeshOptimizer.OPTIMIZE_TRIANGLES)
optimizer.SetPositionWeighting(vtkLaplacianMeshOptimizer.ANCHORS)
optimizer.SetInputArrayToProcess(
    vtkLaplacianMeshOptimizer.POSITION_WEIGHT_ARRAY,
    0,
    0,
    vtkDataObject.FIELD_ASSOCIATION_POINTS,
    "Anchors",
)
optimizer.Update()
better = optimizer.GetOutput()

print("%d anchors of %d points" % (len(anchors), mesh.GetNumberOfPoints()))
common.print_triangles(optimizer)
common.print_distance(better, mesh)

if arguments.output:
    common.write_mesh(arguments.output, better)
if arguments.picture:
    import viewing

    balls = viewing.balls(shapes.points_of(mesh)[anchors], 0.004 * mesh.GetLength())
    before = viewing.surface(better, "InputRadiusRatio")
    after = viewing.surface(better, "RadiusRatio")
    viewing.save_picture(
        arguments.picture,
        [
            viewing.renderer([before, balls], title="before, and anchors"),
            viewing.renderer([after, balls], title="after"),
        ],
    )
