// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ParallelTesting_h
#define ParallelTesting_h

#include "FilterTesting.h"

#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"

#include <functional>

/// An MPI job; all but its first process are silent.
class MpiJob
{
public:
  MpiJob(int argc, char* argv[]);
  ~MpiJob();
  MpiJob(const MpiJob&) = delete;
  void operator=(const MpiJob&) = delete;

  int Rank() { return this->Controller->GetLocalProcessId(); }
  int Size() { return this->Controller->GetNumberOfProcesses(); }

  /// The largest over the processes; NaN is the largest.
  double Largest(double value);

  /// The same of each number.
  lmo::Points Largest(const lmo::Points& values);

private:
  vtkNew<vtkMPIController> Controller;
};

/// Which process each triangle goes to.
using Cut = std::function<int(lmo::Index triangle, int processes)>;

/// Sectors around an axis that passes near the origin and meet there.
Cut Sectors(const TestMesh& mesh);

/// Triangles dealt out one by one.
Cut Scattered();

/// All triangles in the last process.
Cut AllInLast();

/// A piece of a mesh.
struct PieceOfMesh
{
  vtkSmartPointer<vtkPolyData> surface;
  std::vector<lmo::Index> points; ///< of the whole mesh, for each point
  std::vector<lmo::Index> cells;  ///< of the whole mesh, for each cell
};

/// The triangles of one process with the points that they use, and the point arrays of the whole.
/// Points that no triangle uses go to process 0.
PieceOfMesh TakePiece(vtkPolyData* whole, const Cut& cut, int rank, int processes);

/// Gives each point its number in the whole mesh as its global id.
void AddGlobalIds(PieceOfMesh& piece);

/// Adds the cells of the whole mesh that touch the piece, marked as duplicates.
void AddGhostCells(PieceOfMesh& piece, vtkPolyData* whole);

/// Sets the properties of a filter.
using SetUp = std::function<void(vtkLaplacianMeshOptimizer*)>;

/// Output in this process alone.
vtkSmartPointer<vtkPolyData> OptimizedAlone(vtkPolyData* whole, const SetUp& setUp);
vtkSmartPointer<vtkDataObject> OptimizedAlone(vtkPartitionedDataSet* pieces, const SetUp& setUp);

/// The largest differences between a piece and the whole surface: of coordinates and displacements
/// relative to the diagonal, of curvatures relative to the largest, of metrics relative to 1 or
/// their size, and of the other arrays.
double DifferenceFromWhole(const PieceOfMesh& piece, vtkPolyData* output, vtkPolyData* whole);

#endif
