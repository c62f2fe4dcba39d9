// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"

#include "vtkInformation.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <set>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;
using Ids = std::set<vtkIdType>;

TestMesh Mesh()
{
  return Irregular(Icosphere(2), 0.05);
}

/// Smoothes so that all points move that may.
vtkSmartPointer<vtkPolyData> Smoothed(
  vtkPolyData* input, vtkSelection* selection, const std::function<void(Optimizer*)>& setUp)
{
  return Optimized(input,
    [&](Optimizer* filter)
    {
      filter->SetMode(Optimizer::SMOOTH);
      filter->SetSelectionData(selection);
      setUp(filter);
    });
}

Ids MovedPoints(vtkPolyData* output)
{
  const Eigen::MatrixXd displacements = PointValues(output, "Displacement");
  Ids moved;
  for (Eigen::Index i = 0; i < displacements.rows(); ++i)
  {
    if (!displacements.row(i).isZero(0))
    {
      moved.insert(i);
    }
  }
  return moved;
}

Ids Moved(vtkSelection* selection, int use = Optimizer::ONLY_SELECTED_POINTS_MOVE)
{
  return MovedPoints(Smoothed(
    MakePolyData(Mesh()), selection, [=](Optimizer* filter) { filter->SetSelectionUse(use); }));
}

Ids AllBut(const Ids& ids)
{
  Ids others;
  for (vtkIdType i = 0; i < 162; ++i)
  {
    others.insert(i);
  }
  for (const vtkIdType id : ids)
  {
    others.erase(id);
  }
  return others;
}

void CheckUses(Checks& c)
{
  const Ids ids = { 0, 7, 160 };
  const auto selection = Selection({ SelectionNode(vtkSelectionNode::POINT, ids) });
  const auto nothing = Selection({});
  const int stay = Optimizer::SELECTED_POINTS_STAY;
  const int move = Optimizer::ONLY_SELECTED_POINTS_MOVE;
  c.True("without a selection all points move",
    Moved(nullptr, stay) == AllBut({}) && Moved(nullptr, move) == AllBut({}));
  c.Equal("selected points stay and all others move", Moved(selection, stay), AllBut(ids));
  c.Equal("only selected points move", Moved(selection, move), ids);
  c.True("if nothing is selected all points move or none",
    Moved(nothing, stay) == AllBut({}) && Moved(nothing, move).empty());
}

void CheckKinds(Checks& c)
{
  const TestMesh mesh = Mesh();
  const auto corners = [&](vtkIdType t) { return Ids{ mesh.T(t, 0), mesh.T(t, 1), mesh.T(t, 2) }; };
  c.Equal("a cell stands for its points",
    Moved(Selection({ SelectionNode(vtkSelectionNode::CELL, { 33 }) })), corners(33));

  Ids points = corners(33);
  points.insert(5);
  c.Equal("nodes add up",
    Moved(Selection({ SelectionNode(vtkSelectionNode::POINT, corners(33)),
      SelectionNode(vtkSelectionNode::POINT, { 5 }) })),
    points);

  const auto others = SelectionNode(vtkSelectionNode::POINT, { 5 });
  others->GetProperties()->Set(vtkSelectionNode::INVERSE(), 1);
  c.Equal("a selection can be inverse", Moved(Selection({ others })), AllBut({ 5 }));

  const auto strip =
    Smoothed(MakeMixedPolyData(), Selection({ SelectionNode(vtkSelectionNode::CELL, { 147 }) }),
      [](Optimizer* filter)
      {
        filter->SetSelectionUse(Optimizer::ONLY_SELECTED_POINTS_MOVE);
        filter->SetBoundaryCondition(Optimizer::FREE);
      });
  Ids stripPoints;
  for (vtkIdType i = 13 * 6; i < 13 * 8; ++i)
  {
    stripPoints.insert(i);
  }
  c.Equal("a strip stands for its points", MovedPoints(strip), stripPoints);
}

void CheckFixedPointArray(Checks& c)
{
  const auto input = MakePolyData(Mesh());
  Vector marks = Vector::Zero(162);
  marks[7] = -1;
  marks[9] = 2;
  AddPointArray(input, "marks", marks);
  const auto choose = [](Optimizer* filter)
  { filter->SetInputArrayToProcess(Optimizer::FIXED_POINT_ARRAY, 0, 0, 0, "marks"); };
  const auto byArray = Smoothed(input, nullptr, choose);
  const auto bySelection = Smoothed(
    input, Selection({ SelectionNode(vtkSelectionNode::POINT, { 7, 9 }) }), [](Optimizer*) {});
  c.Error("a selection does what an array does",
    MaximumDistance(PointsOf(byArray), PointsOf(bySelection)), 0);
  const auto byBoth =
    Smoothed(input, Selection({ SelectionNode(vtkSelectionNode::POINT, { 8, 9 }) }), choose);
  c.Equal(
    "points of the array and of the selection stay", MovedPoints(byBoth), AllBut({ 7, 8, 9 }));
}

void CheckRefusals(Checks& c)
{
  const auto error = [](vtkSelection* selection)
  {
    vtkNew<Optimizer> filter;
    filter->SetInputData(MakePolyData(Mesh()));
    filter->SetSelectionData(selection);
    const std::string errors = Update(filter).errors;
    return IsEmpty(filter->GetOutput()) ? errors : "";
  };
  const auto ofBlock = SelectionNode(vtkSelectionNode::POINT, { 1 });
  ofBlock->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), 2);
  c.Says("a selection in a block is refused with a remedy", error(Selection({ ofBlock })),
    "extract the block");
  vtkNew<vtkSelectionNode> query;
  query->SetFieldType(vtkSelectionNode::POINT);
  query->SetContentType(vtkSelectionNode::QUERY);
  query->SetQueryString("id < 4");
  c.Says("a query is refused with a remedy", error(Selection({ query.Get() })), "Freeze");
  const auto mixed = Selection({ SelectionNode(vtkSelectionNode::POINT, { 1 }),
    SelectionNode(vtkSelectionNode::CELL, { 1 }) });
  c.Says("a mixture of points and cells is refused with a remedy", error(mixed), "alone");
}
}

int TestOptimizerSelection(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Uses", CheckUses);
  groups.Run("Kinds", CheckKinds);
  groups.Run("FixedPointArray", CheckFixedPointArray);
  groups.Run("Refusals", CheckRefusals);
  return groups.Result();
}
