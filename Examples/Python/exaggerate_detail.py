# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Exaggerates details: finds the surface whose Laplacians are a multiple of the input's.

The triangles are made better first: Laplacians of very thin ones say little of the surface.
"""
import common
import shapes
from laplacianmesh import vtkLaplacianMeshOptimizer, vtkMeshLaplacian
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject

arguments = common.parse_arguments(__doc__, factor=2)
mesh = common.read_mesh(arguments.mesh) if arguments.mesh else shapes.animal()

better = vtkLaplacianMeshOptimizer()
better.SetInputData(mesh)
better.SetMode(vtkLaplacianMeshOptimizer.OPTIMIZE_WITHIN_DEVIATION)
laplacian = vtkMeshLaplacian()
laplacian.SetInputConnection(better.GetOutputPort())
laplacian.Update()
mesh = laplacian.GetOutput()
detail = vtk_to_numpy(mesh.GetPointData().GetArray("CotangentLaplacian"))
shapes.add_point_array(mesh, "Prescribed", arguments.factor * detail)

optimizer = vtkLaplacianMeshOptimizer()
optimizer.SetInputData(mesh)
optimizer.SetMode(vtkLaplacianMeshOptimizer.PRESCRIBED_LAPLACIANS)
optimizer.SetLaplacianType(vtkLaplacianMeshOptimizer.COTANGENT)
optimizer.SetPositionWeighting(vtkLaplacianMeshOptimizer.CONSTANT)
optimizer.SetScaleFactor(0.1)  # less lets coarser details grow
optimizer.SetInputArrayToProcess(
    vtkLaplacianMeshOptimizer.PRESCRIBED_LAPLACIAN_ARRAY,
    0,
    0,
    vtkDataObject.FIELD_ASSOCIATION_POINTS,
    "Prescribed",
)
optimizer.Update()
exaggerated = optimizer.GetOutput()

common.print_triangles(optimizer)
common.print_distance(exaggerated, mesh)

if arguments.output:
    common.write_mesh(arguments.output, exaggerated)
if arguments.picture:
    import viewing

    viewing.save_picture(
        arguments.picture,
        [
            viewing.renderer([viewing.surface(mesh)], title="input"),
            viewing.renderer([viewing.surface(exaggerated)], title="exaggerated"),
        ],
    )
