// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace lmo;

// The filter renumbers a mesh whose neighbours lie far apart in memory. All that it reads and
// writes has to be in the order of the input nevertheless.

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;
using Numbers = std::vector<Index>;

/// So many squares to a side make a shuffled mesh scattered.
constexpr int Cells = 230;

Numbers InOrder(Eigen::Index count)
{
  Numbers order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// The same numbers in every run, in another order.
Numbers Shuffled(Eigen::Index count)
{
  Numbers order = InOrder(count);
  const Points keys = Random().Displacements(count);
  std::sort(order.begin(), order.end(), [&](Index i, Index j) { return keys(i, 0) < keys(j, 0); });
  return order;
}

Numbers Inverse(const Numbers& order)
{
  Numbers inverse(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    inverse[order[i]] = static_cast<Index>(i);
  }
  return inverse;
}

/// A wavy sheet with arrays that differ from point to point and from cell to cell. Cell 0 is a
/// vertex.
struct Sheet
{
  TestMesh mesh = Grid(Cells, 0.2);
  Eigen::VectorXd weights;
  Eigen::VectorXd isFixed;
  Eigen::VectorXd isAnchor;
  Eigen::MatrixXd laplacians;
  Eigen::MatrixXd normals;
  Eigen::VectorXd regions; ///< of the triangles

  Sheet()
  {
    const Eigen::Index count = this->mesh.V.rows();
    this->mesh.V.col(2) =
      (this->mesh.V.col(0) / 5).array().sin() * (this->mesh.V.col(1) / 7).array().cos();
    const Points numbers = Random().Displacements(count);
    this->weights = numbers.col(0).cwiseAbs();
    this->isFixed = (numbers.col(1).array() > 0.95).cast<double>();
    this->isAnchor = (numbers.col(2).array() > 0).cast<double>();
    this->laplacians = 0.01 * Random().Displacements(count);
    this->normals = Points::Ones(count, 3);
    this->regions.resize(this->mesh.T.rows());
    for (Eigen::Index t = 0; t < this->mesh.T.rows(); ++t)
    {
      this->regions[t] = this->mesh.V(this->mesh.T(t, 0), 0) > Cells / 3;
    }
  }
};

/// The sheet with points and triangles in another order.
vtkSmartPointer<vtkPolyData> MakeInput(
  const Sheet& sheet, const Numbers& points, const Numbers& triangles)
{
  const Numbers place = Inverse(points);
  TestMesh mesh;
  mesh.V = sheet.mesh.V(points, Eigen::indexing::all);
  mesh.T =
    sheet.mesh.T(triangles, Eigen::indexing::all).unaryExpr([&](Index i) { return place[i]; });
  const auto input = MakePolyData(mesh);
  const vtkIdType vertex = 0;
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell(1, &vertex);
  input->SetVerts(vertices);
  AddPointArray(input, "weights", sheet.weights(points));
  AddPointArray(input, "fixed", sheet.isFixed(points));
  AddPointArray(input, "anchors", sheet.isAnchor(points));
  AddPointArray(input, "f", sheet.laplacians(points, Eigen::indexing::all));
  AddPointArray(input, "normals", sheet.normals(points, Eigen::indexing::all));
  input->GetPointData()->SetActiveNormals("normals");
  vtkNew<vtkDoubleArray> regions;
  regions->SetName("regions");
  regions->InsertNextValue(2);
  for (const Index t : triangles)
  {
    regions->InsertNextValue(sheet.regions[t]);
  }
  input->GetCellData()->AddArray(regions);
  return input;
}

/// Largest difference of the arrays of \a shuffled from those of \a original in another order.
double Difference(vtkFieldData* shuffled, vtkFieldData* original, const Numbers& order)
{
  double difference = 0;
  for (int k = 0; k < original->GetNumberOfArrays(); ++k)
  {
    const Eigen::MatrixXd expected = ValuesOf(original->GetArray(k));
    const Eigen::MatrixXd values = ValuesOf(shuffled->GetArray(original->GetArrayName(k)));
    const double error = values.rows() == expected.rows()
                           ? LargestMagnitude(values - expected(order, Eigen::indexing::all))
                           : HUGE_VAL;
    difference = Larger(difference, error);
  }
  return difference;
}

/// Compares the results of the sheet and of the shuffled one.
/// \param setUp called with the filter and the numbers of the sheet's points in its input
void CheckOrder(Checks& c, const std::string& name, const Sheet& sheet,
  const std::function<void(Optimizer*, const Numbers&)>& setUp)
{
  const Numbers points = Shuffled(sheet.mesh.V.rows());
  const Numbers triangles = Shuffled(sheet.mesh.T.rows());
  const auto optimized = [&](const Numbers& pointOrder, const Numbers& triangleOrder)
  {
    return Optimized(MakeInput(sheet, pointOrder, triangleOrder),
      [&](Optimizer* filter)
      {
        filter->SetTolerance(1e-10);
        setUp(filter, Inverse(pointOrder));
      });
  };
  const auto original = optimized(InOrder(sheet.mesh.V.rows()), InOrder(sheet.mesh.T.rows()));
  const auto shuffled = optimized(points, triangles);
  c.Greater("points move: " + name, MaximumDistance(PointsOf(original), sheet.mesh.V), 0.05);
  c.Error("points of a scattered mesh have their own positions: " + name,
    MaximumDistance(PointsOf(shuffled), PointsOf(original)(points, Eigen::indexing::all)), 1e-6);
  c.Error("point arrays of a scattered mesh are in the order of its points: " + name,
    Difference(shuffled->GetPointData(), original->GetPointData(), points), 1e-6);
  Numbers cells = triangles;
  std::transform(cells.begin(), cells.end(), cells.begin(), [](Index t) { return t + 1; });
  cells.insert(cells.begin(), 0);
  c.Error("cell arrays of a scattered mesh are in the order of its cells: " + name,
    Difference(shuffled->GetCellData(), original->GetCellData(), cells), 1e-6);
}

void ChooseArray(Optimizer* filter, int index, const char* name, bool isOfCells = false)
{
  filter->SetInputArrayToProcess(index, 0, 0, isOfCells ? vtkDataObject::CELL : 0, name);
}

void CheckArrays(Checks& c, const Sheet& sheet)
{
  CheckOrder(c, "weights, fixed points, regions", sheet,
    [](Optimizer* filter, const Numbers&)
    {
      filter->SetMode(Optimizer::OPTIMIZE_TRIANGLES);
      filter->SetPositionWeighting(Optimizer::ARRAY);
      filter->SetLaplacianWeighting(Optimizer::ARRAY);
      filter->FeatureConstraintsOn();
      ChooseArray(filter, Optimizer::POSITION_WEIGHT_ARRAY, "weights");
      ChooseArray(filter, Optimizer::LAPLACIAN_WEIGHT_ARRAY, "weights");
      ChooseArray(filter, Optimizer::FIXED_POINT_ARRAY, "fixed");
      ChooseArray(filter, Optimizer::FEATURE_ARRAY, "regions", true);
    });
  CheckOrder(c, "anchors, prescribed Laplacians, a selection", sheet,
    [](Optimizer* filter, const Numbers& place)
    {
      filter->SetMode(Optimizer::PRESCRIBED_LAPLACIANS);
      filter->SetPositionWeighting(Optimizer::ANCHORS);
      ChooseArray(filter, Optimizer::POSITION_WEIGHT_ARRAY, "anchors");
      ChooseArray(filter, Optimizer::PRESCRIBED_LAPLACIAN_ARRAY, "f");
      std::set<vtkIdType> ids;
      for (std::size_t i = 0; i < place.size(); i += 3)
      {
        ids.insert(place[i]);
      }
      filter->SetSelectionData(Selection({ SelectionNode(vtkSelectionNode::POINT, ids) }));
    });
}

void CheckErrors(Checks& c, Sheet sheet)
{
  const Numbers points = Shuffled(sheet.mesh.V.rows());
  sheet.weights[points[77]] = NAN;
  vtkNew<Optimizer> filter;
  filter->SetMode(Optimizer::SMOOTH);
  filter->SetPositionWeighting(Optimizer::ARRAY);
  ChooseArray(filter, Optimizer::POSITION_WEIGHT_ARRAY, "weights");
  filter->SetInputData(MakeInput(sheet, points, InOrder(sheet.mesh.T.rows())));
  c.Says("an error names the point of a scattered mesh by its own number", Update(filter).errors,
    "the first is point 77.");
}
}

int TestOptimizerNumbering(int, char*[])
{
  Checks c;
  const Sheet sheet;
  CheckArrays(c, sheet);
  CheckErrors(c, sheet);
  return c.Result();
}
