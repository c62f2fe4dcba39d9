// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePartitions.h"

#include "Checks.h"
#include "MeshMeasures.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

using namespace lmo;

namespace
{
unsigned int PartitionOf(vtkIdType triangle, unsigned int count)
{
  return static_cast<unsigned int>(triangle * 7 / 3) % count;
}

vtkSmartPointer<vtkPolyData> TakePartition(
  vtkPolyData* mesh, const std::vector<Index>& points, unsigned int k, unsigned int count)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataType(mesh->GetPoints()->GetDataType());
  std::vector<vtkIdType> numbers(mesh->GetNumberOfPoints(), -1);
  for (const Index i : points)
  {
    numbers[i] = coordinates->InsertNextPoint(mesh->GetPoint(i));
  }
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    if (PartitionOf(t, count) == k)
    {
      mesh->GetPolys()->GetCellAtId(t, ids);
      triangles->InsertNextCell(
        { numbers[ids->GetId(0)], numbers[ids->GetId(1)], numbers[ids->GetId(2)] });
    }
  }
  part->SetPoints(coordinates);
  part->SetPolys(triangles);
  return part;
}
}

PartitionsOfMesh CutIntoPartitions(vtkPolyData* mesh, unsigned int count)
{
  PartitionsOfMesh result;
  result.size = static_cast<Index>(mesh->GetNumberOfPoints());
  std::vector<std::vector<bool>> isUsed(count, std::vector<bool>(result.size, false));
  std::vector<bool> isUsedAnywhere(result.size, false);
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, ids);
    for (const vtkIdType id : *ids)
    {
      isUsed[PartitionOf(t, count)][id] = true;
      isUsedAnywhere[id] = true;
    }
  }
  result.data = vtkSmartPointer<vtkPartitionedDataSet>::New();
  for (unsigned int k = 0; k < count; ++k)
  {
    std::vector<Index> points;
    for (Index i = result.size - 1; i >= 0; --i)
    {
      if (isUsed[k][i] || (k == 0 && !isUsedAnywhere[i]))
      {
        points.push_back(i);
      }
    }
    result.data->SetPartition(k, TakePartition(mesh, points, k, count));
    result.points.push_back(std::move(points));
  }
  return result;
}

void Precise(vtkLaplacianMeshOptimizer* filter)
{
  filter->SetMode(vtkLaplacianMeshOptimizer::OPTIMIZE_TRIANGLES);
  filter->SetTolerance(1e-12);
}

vtkSmartPointer<vtkPartitionedDataSet> OptimizedPartitions(
  vtkDataObject* input, const std::function<void(vtkLaplacianMeshOptimizer*)>& setUp)
{
  vtkNew<vtkLaplacianMeshOptimizer> filter;
  filter->SetInputDataObject(input);
  setUp(filter);
  filter->Update();
  return vtkPartitionedDataSet::SafeDownCast(filter->GetOutputDataObject(0));
}

vtkPolyData* Part(vtkPartitionedDataSet* partitions, unsigned int k)
{
  return partitions ? vtkPolyData::SafeDownCast(partitions->GetPartition(k)) : nullptr;
}

double DistanceToWhole(
  const PartitionsOfMesh& mesh, vtkPartitionedDataSet* optimized, vtkPolyData* whole)
{
  const Points expected = PointsOf(whole);
  double difference = 0;
  for (unsigned int k = 0; k < mesh.points.size(); ++k)
  {
    const std::vector<Index>& points = mesh.points[k];
    const Points moved = PointsOf(Part(optimized, k));
    difference = Larger(difference, MaximumDistance(moved, expected(points, Eigen::indexing::all)));
  }
  return difference;
}

double DistanceOfCopies(const PartitionsOfMesh& mesh, vtkPartitionedDataSet* optimized)
{
  std::vector<std::vector<Vector3>> places(mesh.size);
  for (unsigned int k = 0; k < mesh.points.size(); ++k)
  {
    const Points moved = PointsOf(Part(optimized, k));
    for (std::size_t i = 0; i < mesh.points[k].size(); ++i)
    {
      places[mesh.points[k][i]].push_back(moved.row(static_cast<Eigen::Index>(i)));
    }
  }
  double difference = 0;
  for (const std::vector<Vector3>& copies : places)
  {
    for (const Vector3& copy : copies)
    {
      difference = Larger(difference, (copy - copies.front()).cwiseAbs().maxCoeff());
    }
  }
  return difference;
}
