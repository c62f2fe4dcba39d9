// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ParallelTesting.h"

#include "Checks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDummyController.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkPLaplacianMeshOptimizer.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace lmo;

MpiJob::MpiJob(int argc, char* argv[])
{
  this->Controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(this->Controller);
  if (this->Rank() > 0)
  {
    std::cout.rdbuf(nullptr);
  }
}

MpiJob::~MpiJob()
{
  vtkMultiProcessController::SetGlobalController(nullptr);
  this->Controller->Finalize();
}

double MpiJob::Largest(double value)
{
  const double local = std::isnan(value) ? HUGE_VAL : value;
  double largest = 0;
  this->Controller->AllReduce(&local, &largest, 1, vtkCommunicator::MAX_OP);
  return largest;
}

Points MpiJob::Largest(const Points& values)
{
  Points largest(values.rows(), 3);
  this->Controller->AllReduce(
    values.data(), largest.data(), values.size(), vtkCommunicator::MAX_OP);
  return largest;
}

Cut Sectors(const TestMesh& mesh)
{
  return [mesh](Index t, int processes)
  {
    const Vector3 centre = mesh.V(mesh.T.row(t).transpose(), Eigen::indexing::all).colwise().mean();
    const double turn =
      std::atan2(centre[1] - 0.01, centre[0] + 0.02) / (2 * 3.14159265358979) + 0.5;
    return std::min(static_cast<int>(turn * processes), processes - 1);
  };
}

Cut Scattered()
{
  return [](Index t, int processes) { return static_cast<int>(t * 7 / 3) % processes; };
}

Cut AllInLast()
{
  return [](Index, int processes) { return processes - 1; };
}

namespace
{
void CopyArrays(vtkPolyData* whole, PieceOfMesh& piece)
{
  for (int k = 0; k < whole->GetPointData()->GetNumberOfArrays(); ++k)
  {
    const char* name = whole->GetPointData()->GetArrayName(k);
    const Eigen::MatrixXd values = PointValues(whole, name);
    AddPointArray(piece.surface, name, values(piece.points, Eigen::indexing::all));
  }
  if (vtkDataArray* normals = whole->GetPointData()->GetNormals())
  {
    piece.surface->GetPointData()->SetActiveNormals(normals->GetName());
  }
}

void MakeSurface(vtkPolyData* whole, PieceOfMesh& piece)
{
  std::vector<Index> numbers(whole->GetNumberOfPoints(), -1);
  vtkNew<vtkPoints> points;
  points->SetDataType(whole->GetPoints()->GetDataType());
  for (const Index i : piece.points)
  {
    numbers[i] = static_cast<Index>(points->InsertNextPoint(whole->GetPoint(i)));
  }
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (const Index t : piece.cells)
  {
    whole->GetPolys()->GetCellAtId(t, ids);
    triangles->InsertNextCell(
      { numbers[ids->GetId(0)], numbers[ids->GetId(1)], numbers[ids->GetId(2)] });
  }
  piece.surface = vtkSmartPointer<vtkPolyData>::New();
  piece.surface->SetPoints(points);
  piece.surface->SetPolys(triangles);
  CopyArrays(whole, piece);
}

/// Lists the points of the cells after those that are listed.
void ListPoints(vtkPolyData* whole, PieceOfMesh& piece)
{
  Mask isListed(whole->GetNumberOfPoints(), 0);
  for (const Index i : piece.points)
  {
    isListed[i] = 1;
  }
  vtkNew<vtkIdList> ids;
  for (const Index t : piece.cells)
  {
    whole->GetPolys()->GetCellAtId(t, ids);
    for (const vtkIdType id : *ids)
    {
      if (!isListed[id])
      {
        isListed[id] = 1;
        piece.points.push_back(static_cast<Index>(id));
      }
    }
  }
}

/// Points that no cell uses.
std::vector<Index> UnusedPoints(vtkPolyData* whole)
{
  Mask isUsed(whole->GetNumberOfPoints(), 0);
  const Eigen::MatrixXd corners = ValuesOf(whole->GetPolys()->GetConnectivityArray());
  for (const double id : corners.reshaped())
  {
    isUsed[static_cast<Index>(id)] = 1;
  }
  std::vector<Index> unused;
  for (std::size_t i = 0; i < isUsed.size(); ++i)
  {
    if (!isUsed[i])
    {
      unused.push_back(static_cast<Index>(i));
    }
  }
  return unused;
}
}

PieceOfMesh TakePiece(vtkPolyData* whole, const Cut& cut, int rank, int processes)
{
  PieceOfMesh piece;
  if (rank == 0)
  {
    piece.points = UnusedPoints(whole);
  }
  for (Index t = 0; t < whole->GetNumberOfPolys(); ++t)
  {
    if (cut(t, processes) == rank)
    {
      piece.cells.push_back(t);
    }
  }
  ListPoints(whole, piece);
  MakeSurface(whole, piece);
  return piece;
}

void AddGlobalIds(PieceOfMesh& piece)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("GlobalId");
  for (const Index i : piece.points)
  {
    ids->InsertNextValue(1000000007LL * i - 5);
  }
  piece.surface->GetPointData()->SetGlobalIds(ids);
}

void AddGhostCells(PieceOfMesh& piece, vtkPolyData* whole)
{
  const std::size_t real = piece.cells.size();
  vtkNew<vtkIdList> ids;
  for (Index t = 0; t < whole->GetNumberOfPolys() && real > 0; ++t)
  {
    whole->GetPolys()->GetCellAtId(t, ids);
    const bool isReal = std::binary_search(piece.cells.begin(), piece.cells.begin() + real, t);
    const bool touches = std::any_of(ids->begin(), ids->end(),
      [&](vtkIdType id)
      { return std::find(piece.points.begin(), piece.points.end(), id) != piece.points.end(); });
    if (touches && !isReal)
    {
      piece.cells.push_back(t);
    }
  }
  ListPoints(whole, piece);
  MakeSurface(whole, piece);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (std::size_t k = 0; k < piece.cells.size(); ++k)
  {
    ghosts->InsertNextValue(k < real ? 0 : vtkDataSetAttributes::DUPLICATECELL);
  }
  piece.surface->GetCellData()->AddArray(ghosts);
}

namespace
{
vtkSmartPointer<vtkDataObject> RunAlone(vtkDataObject* input, const SetUp& setUp)
{
  vtkNew<vtkDummyController> alone;
  vtkNew<vtkPLaplacianMeshOptimizer> filter;
  filter->SetMode(vtkLaplacianMeshOptimizer::OPTIMIZE_TRIANGLES);
  filter->SetController(alone);
  filter->SetInputDataObject(input);
  setUp(filter);
  filter->Update();
  return filter->GetOutputDataObject(0);
}
}

vtkSmartPointer<vtkPolyData> OptimizedAlone(vtkPolyData* whole, const SetUp& setUp)
{
  return vtkPolyData::SafeDownCast(RunAlone(whole, setUp));
}

vtkSmartPointer<vtkDataObject> OptimizedAlone(vtkPartitionedDataSet* pieces, const SetUp& setUp)
{
  return RunAlone(pieces, setUp);
}

namespace
{
double Difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double unit)
{
  if (a.rows() != b.rows() || a.cols() != b.cols())
  {
    return HUGE_VAL;
  }
  return a.size() > 0 ? (a - b).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() / unit : 0;
}

double FigureDifference(vtkPolyData* output, vtkPolyData* whole)
{
  double difference = 0;
  for (const char* name : { "MeanRadiusRatio", "MinimumRadiusRatio", "InputMeanRadiusRatio",
         "InputMinimumRadiusRatio", "MaximumDisplacement", "RelativeMaximumDisplacement",
         "RelativeVolumeChange", "FlippedTriangles" })
  {
    const double expected = FieldValue(whole, name);
    difference = Larger(difference,
      std::abs(FieldValue(output, name) - expected) / std::max(1.0, std::abs(expected)));
  }
  return difference;
}
}

double DifferenceFromWhole(const PieceOfMesh& piece, vtkPolyData* output, vtkPolyData* whole)
{
  double difference = FigureDifference(output, whole);
  const double diagonal = whole->GetLength();
  const Points V = PointsOf(whole);
  difference = Larger(
    difference, Difference(PointsOf(output), V(piece.points, Eigen::indexing::all), diagonal));
  for (int k = 0; k < whole->GetPointData()->GetNumberOfArrays(); ++k)
  {
    const std::string name = whole->GetPointData()->GetArrayName(k);
    const Eigen::MatrixXd expected = PointValues(whole, name.c_str());
    const double unit = name == "Displacement"    ? diagonal
                        : name == "MeanCurvature" ? std::max(expected.maxCoeff(), 1 / diagonal)
                                                  : 1;
    difference = Larger(difference, Difference(PointValues(output, name.c_str()),
                                      expected(piece.points, Eigen::indexing::all), unit));
  }
  for (const char* name : { "RadiusRatio", "InputRadiusRatio" })
  {
    difference =
      Larger(difference, Difference(CellValues(output, name),
                           CellValues(whole, name)(piece.cells, Eigen::indexing::all), 1));
  }
  return difference;
}
