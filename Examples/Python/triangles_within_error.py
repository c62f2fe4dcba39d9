# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Better triangles within an error that you name: the new surface is nowhere farther from the old
one than MaximumDeviation, which is proved and not sampled."""
import common
import shapes
from laplacianmesh import vtkLaplacianMeshOptimizer

arguments = common.parse_arguments(__doc__, max_deviation=0.002)
mesh = common.read_mesh(arguments.mesh) if arguments.mesh else shapes.animal()

optimizer = vtkLaplacianMeshOptimizer()
optimizer.SetInputData(mesh)
optimizer.SetMode(vtkLaplacianMeshOptimizer.OPTIMIZE_WITHIN_DEVIATION)
optimizer.SetMaximumDeviation(arguments.max_deviation)  # of the bounding box's diagonal
optimizer.Update()
better = optimizer.GetOutput()

common.print_triangles(optimizer)
common.print_distance(better, mesh)
print("proved               %.5f of the diagonal" % optimizer.GetRelativeHausdorffBound())

if arguments.output:
    common.write_mesh(arguments.output, better)
if arguments.picture:
    import viewing

    before = viewing.surface(better, "InputRadiusRatio", edges=True)
    after = viewing.surface(better, "RadiusRatio", edges=True)
    detail = {"zoom": 3.5, "focus": (0.75, 0.4, 0.72)}
    viewing.save_picture(
        arguments.picture,
        [
            viewing.renderer([before], title="before", **detail),
            viewing.renderer([after], title="after", **detail),
        ],
    )
