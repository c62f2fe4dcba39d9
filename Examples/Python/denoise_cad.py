# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Removes noise from a CAD part: flat faces become flat, edges sharp."""
import common
import shapes
from laplacianmesh import vtkLaplacianMeshOptimizer

arguments = common.parse_arguments(__doc__, normal_iterations=10)
clean = shapes.machine_part()
noisy = common.read_mesh(arguments.mesh) if arguments.mesh else shapes.with_noise(clean, 0.002)

optimizer = vtkLaplacianMeshOptimizer()
optimizer.SetInputData(noisy)
optimizer.SetMode(vtkLaplacianMeshOptimizer.SMOOTH_GUIDED)
optimizer.SetNormalIterations(int(arguments.normal_iterations))  # 20 for strong noise
optimizer.Update()
smooth = optimizer.GetOutput()

if not arguments.mesh:
    common.print_distance(noisy, clean, "noisy to clean")
    common.print_distance(smooth, clean, "smooth to clean")
common.print_triangles(optimizer)

if arguments.output:
    common.write_mesh(arguments.output, smooth)
if arguments.picture:
    import viewing

    viewing.save_picture(
        arguments.picture,
        [
            viewing.renderer([viewing.surface(noisy)], viewing.PART, title="noisy"),
            viewing.renderer([viewing.surface(smooth)], viewing.PART, title="smooth"),
        ],
    )
