// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// Composite data sets, which the pipeline executes block by block.
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"

#include "vtkInformation.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

TestMesh First()
{
  return WithThinTriangles(Icosphere(2), 7, 0.7);
}

TestMesh Second()
{
  return Irregular(Icosphere(1), 0.1);
}

vtkSmartPointer<vtkMultiBlockDataSet> Blocks()
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, MakePolyData(First()));
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, MakePolyData(Second()));
  return blocks;
}

vtkPolyData* BlockOf(Optimizer* filter, unsigned int index)
{
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  return vtkPolyData::SafeDownCast(output->GetBlock(index));
}

void CheckMetrics(Checks& c)
{
  vtkNew<Optimizer> filter;
  filter->SetInputDataObject(Blocks());
  filter->SetMaximumDeviation(0.01);
  filter->Update();
  const auto of = [&](unsigned int index, const char* name)
  { return FieldValue(BlockOf(filter, index), name); };
  const double triangles[2] = { double(First().T.rows()), double(Second().T.rows()) };
  const double mean =
    (triangles[0] * of(0, "MeanRadiusRatio") + triangles[1] * of(2, "MeanRadiusRatio")) /
    (triangles[0] + triangles[1]);
  c.Error("the mean radius ratio is that of all triangles",
    std::abs(filter->GetMeanRadiusRatio() - mean), 1e-14);
  c.Greater("and not that of a block", std::abs(mean - of(2, "MeanRadiusRatio")), 1e-3);
  c.Equal("the smallest radius ratio is that of all triangles", filter->GetMinimumRadiusRatio(),
    std::min(of(0, "MinimumRadiusRatio"), of(2, "MinimumRadiusRatio")));
  c.Equal("the largest displacement is that of all points", filter->GetMaximumDisplacement(),
    std::max(of(0, "MaximumDisplacement"), of(2, "MaximumDisplacement")));
  c.Equal("the iterations are those of all blocks", double(filter->GetIterations()),
    of(0, "Iterations") + of(2, "Iterations"));
  filter->SetMaximumDeviation(0.02);
  filter->Update();
  c.Equal("the next execution begins anew", double(filter->GetIterations()),
    of(0, "Iterations") + of(2, "Iterations"));
}

/// The points of one block, by its flat index.
vtkSmartPointer<vtkSelection> PointsOfBlock(int flatIndex, const std::set<vtkIdType>& ids)
{
  const auto node = SelectionNode(vtkSelectionNode::POINT, ids);
  node->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), flatIndex);
  return Selection({ node });
}

/// Rows that differ.
int CountMoved(vtkPolyData* output, const TestMesh& before)
{
  int moved = 0;
  for (Eigen::Index i = 0; i < before.V.rows(); ++i)
  {
    moved += PointsOf(output).row(i) != before.V.row(i);
  }
  return moved;
}

void CheckSelection(Checks& c)
{
  vtkNew<Optimizer> filter;
  filter->SetInputDataObject(Blocks());
  filter->SetMode(Optimizer::SMOOTH);
  filter->SetSelectionData(PointsOfBlock(3, { 2, 5, 6 })); // the root is 0
  filter->SetSelectionUse(Optimizer::ONLY_SELECTED_POINTS_MOVE);
  c.True("a selection may name a block", Update(filter).errors.empty());
  c.Equal("of that block the selected points move", CountMoved(BlockOf(filter, 2), Second()), 3);
  c.Equal("of another block none", CountMoved(BlockOf(filter, 0), First()), 0);
  const auto twins = Blocks();
  vtkNew<vtkPolyData> twin;
  twin->ShallowCopy(twins->GetBlock(2));
  twins->SetBlock(0, twin);
  filter->SetInputDataObject(twins);
  filter->Update();
  c.Equal("nor of a block that shares its points", CountMoved(BlockOf(filter, 0), Second()), 0);
}
}

int TestOptimizerBlocks(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Metrics", CheckMetrics);
  groups.Run("Selection", CheckSelection);
  return groups.Result();
}
