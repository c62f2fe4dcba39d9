// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfacePartitions_h
#define SurfacePartitions_h

#include "FilterTesting.h"

#include "vtkPartitionedDataSet.h"

/// A mesh of triangles whose triangles were dealt out to partitions.
struct PartitionsOfMesh
{
  vtkSmartPointer<vtkPartitionedDataSet> data;
  std::vector<std::vector<lmo::Index>> points; ///< of the mesh, for each point of each partition
  lmo::Index size = 0;                         ///< number of points of the mesh
};

/// Triangle t goes to partition (7 t / 3) mod count. Points that no triangle uses go to partition
/// 0. The partitions have the points in reverse order, and no arrays.
PartitionsOfMesh CutIntoPartitions(vtkPolyData* mesh, unsigned int count);

#endif
