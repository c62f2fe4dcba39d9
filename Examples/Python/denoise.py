# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Removes noise from a smooth shape and keeps its details and its volume."""
import common
import shapes
from laplacianmesh import vtkLaplacianMeshOptimizer

arguments = common.parse_arguments(__doc__, scale_factor=0.3)
clean = shapes.animal()
noisy = common.read_mesh(arguments.mesh) if arguments.mesh else shapes.with_noise(clean, 0.0015)

optimizer = vtkLaplacianMeshOptimizer()
optimizer.SetInputData(noisy)
optimizer.SetMode(vtkLaplacianMeshOptimizer.SMOOTH)
optimizer.SetLaplacianType(vtkLaplacianMeshOptimizer.UNIFORM)
optimizer.SetPositionWeighting(vtkLaplacianMeshOptimizer.CONSTANT)  # noise is everywhere
optimizer.SetScaleFactor(arguments.scale_factor)  # less is smoother
optimizer.TwicingOn()  # less shrinking of details
optimizer.PreserveVolumeOn()
optimizer.Update()
smooth = optimizer.GetOutput()

if not arguments.mesh:
    common.print_distance(noisy, clean, "noisy to clean")
    common.print_distance(smooth, clean, "smooth to clean")
common.print_triangles(optimizer)
print("change of volume     %.1e" % optimizer.GetRelativeVolumeChange())

if arguments.output:
    common.write_mesh(arguments.output, smooth)
if arguments.picture:
    import viewing

    viewing.save_picture(
        arguments.picture,
        [
            viewing.renderer([viewing.surface(noisy)], title="noisy"),
            viewing.renderer([viewing.surface(smooth)], title="smooth"),
        ],
    )
