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

/// OPTIMIZE_TRIANGLES with a small tolerance.
void Precise(vtkLaplacianMeshOptimizer* filter);

/// Output of a new vtkLaplacianMeshOptimizer; null if it is no vtkPartitionedDataSet.
vtkSmartPointer<vtkPartitionedDataSet> OptimizedPartitions(
  vtkDataObject* input, const std::function<void(vtkLaplacianMeshOptimizer*)>& setUp = Precise);

vtkPolyData* Part(vtkPartitionedDataSet* partitions, unsigned int k);

/// The largest distance between points of partitions and those of a whole surface.
double DistanceToWhole(
  const PartitionsOfMesh& mesh, vtkPartitionedDataSet* optimized, vtkPolyData* whole);

/// How far apart the copies of a point are, at most.
double DistanceOfCopies(const PartitionsOfMesh& mesh, vtkPartitionedDataSet* optimized);

#endif
