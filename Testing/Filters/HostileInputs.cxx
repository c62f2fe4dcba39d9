// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "HostileInputs.h"

#include "FilterTesting.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>

using namespace lmo;

namespace
{
using Data = vtkSmartPointer<vtkPolyData>;

const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

/// Collects inputs; gives those without arrays of their own the arrays that options ask for.
class Collection
{
public:
  void AddGood(const std::string& name, Data data) { this->Add(name, std::move(data), {}, false); }

  void AddGood(const std::string& name, const TestMesh& mesh)
  {
    this->AddGood(name, MakePolyData(mesh));
  }

  void AddLarge(const std::string& name, const TestMesh& mesh)
  {
    this->Add(name, MakePolyData(mesh), {}, true);
  }

  void AddBad(const std::string& name, Data data, std::vector<std::string> errors)
  {
    this->Add(name, std::move(data), std::move(errors), false);
  }

  std::vector<HostileInput> Inputs;

private:
  void Add(const std::string& name, Data data, std::vector<std::string> errors, bool isLarge)
  {
    Random random;
    const Points numbers = random.Displacements(data->GetNumberOfPoints());
    if (!data->GetPointData()->HasArray("Weights"))
    {
      AddPointArray(data, "Weights", numbers.col(0).cwiseAbs());
    }
    const double unit = data->GetNumberOfPoints() > 0 && errors.empty() ? data->GetLength() : 0;
    AddPointArray(data, "Vectors", 0.02 * unit * numbers);
    AddPointArray(data, "CurvatureVectors", (unit > 0 ? 0.02 / unit : 0) * numbers);
    this->Inputs.push_back({ name, std::move(data), std::move(errors), isLarge });
  }
};

TestMesh Sphere()
{
  return Irregular(Icosphere(1), 0.05);
}

TestMesh Sheet()
{
  return Irregular(HalfSphere(2), 0.05);
}

Data WithPoint(vtkIdType id, double x, double y, double z)
{
  Data data = MakePolyData(Sheet());
  data->GetPoints()->SetPoint(id, x, y, z);
  return data;
}

Data WithPolygon(std::initializer_list<vtkIdType> ids)
{
  Data data = MakePolyData(Sheet());
  data->GetPolys()->InsertNextCell(ids);
  return data;
}

TestMesh PointsOnly(Eigen::Index count)
{
  return { Random().Displacements(count), Triangles(0, 3) };
}

TestMesh FromTriangles(Eigen::Index points, std::initializer_list<std::initializer_list<Index>> ids)
{
  TestMesh mesh{ Random().Displacements(points), Triangles(ids.size(), 3) };
  Eigen::Index t = 0;
  for (const auto& triangle : ids)
  {
    std::copy(triangle.begin(), triangle.end(), mesh.T.row(t++).begin());
  }
  return mesh;
}

/// Corners on a line, or all at one place.
TestMesh OnLine(double step)
{
  TestMesh mesh = EquilateralTriangle();
  mesh.V << 0, 0, 0, step, 0, 0, 2 * step, 0, 0;
  return mesh;
}

/// A sheet in which one vertex was moved onto the line between two of its neighbours.
TestMesh WithFlatTriangle()
{
  TestMesh mesh = Grid(4, 0);
  mesh.V.row(12) << 1.5, 1, 0;
  return mesh;
}

TestMesh WithReversedTriangles()
{
  TestMesh mesh = Sphere();
  for (Index t = 0; t < mesh.T.rows(); t += 3)
  {
    mesh.T.row(t).reverseInPlace();
  }
  return mesh;
}

TestMesh WithHole()
{
  TestMesh mesh = Sphere();
  mesh.T = Triangles(mesh.T.bottomRows(mesh.T.rows() - 6));
  return mesh;
}

/// Many copies of a mesh, side by side.
TestMesh Copies(const TestMesh& mesh, Index count)
{
  const auto points = static_cast<Index>(mesh.V.rows());
  const auto triangles = static_cast<Index>(mesh.T.rows());
  TestMesh all{ Points(count * points, 3), Triangles(count * triangles, 3) };
  for (Index k = 0; k < count; ++k)
  {
    all.V.middleRows(k * points, points) = mesh.V.rowwise() + Vector3(3.0 * k, 0, 0);
    all.T.middleRows(k * triangles, triangles) = mesh.T.array() + k * points;
  }
  return all;
}

/// A closed cone of \a valence triangles around its tip.
TestMesh Cone(Index valence)
{
  TestMesh mesh{ Points(valence + 1, 3), Triangles(valence, 3) };
  mesh.V.row(valence) << 0, 0, 1;
  for (Index k = 0; k < valence; ++k)
  {
    const double angle = 2 * std::acos(-1.0) * k / valence;
    mesh.V.row(k) << std::cos(angle), std::sin(angle), 0;
    mesh.T.row(k) << k, (k + 1) % valence, valence;
  }
  return mesh;
}

Data WithWideIds(bool isWide)
{
  Data data = MakePolyData(Sheet());
  if (isWide)
  {
    data->GetPolys()->ConvertTo64BitStorage();
  }
  else
  {
    data->GetPolys()->ConvertTo32BitStorage();
  }
  return data;
}

/// Offsets that reach beyond the end of the connectivity.
Data WithBrokenOffsets()
{
  vtkNew<vtkTypeInt64Array> offsets;
  vtkNew<vtkTypeInt64Array> connectivity;
  for (const int offset : { 0, 3, 6, 9 })
  {
    offsets->InsertNextValue(offset);
  }
  for (const int id : { 0, 1, 2, 2 })
  {
    connectivity->InsertNextValue(id);
  }
  Data data = MakePolyData(Sheet());
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, connectivity);
  data->SetPolys(polygons);
  return data;
}

/// Every third cell is a ghost or blank.
Data WithCellFlags(unsigned char flag)
{
  Data data = MakePolyData(Sheet());
  vtkNew<vtkUnsignedCharArray> flags;
  flags->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    flags->InsertNextValue(cell % 3 == 0 ? flag : 0);
  }
  data->GetCellData()->AddArray(flags);
  return data;
}

/// An array that is not chosen.
Data WithArrayOfNaN()
{
  Data data = MakePolyData(Sheet());
  AddPointArray(data, "NotChosen", Vector::Constant(data->GetNumberOfPoints(), NaN));
  return data;
}

/// Two components, of which one has no positive weight.
Data WithUnconstrainedComponent()
{
  Data data = MakePolyData(TwoComponents());
  Vector weights = Vector::Zero(data->GetNumberOfPoints());
  weights.head(42).setOnes();
  AddPointArray(data, "Weights", weights);
  return data;
}

Data WithoutWeights()
{
  Data data = MakePolyData(TwoComponents());
  AddPointArray(data, "Weights", Vector::Zero(data->GetNumberOfPoints()));
  return data;
}

void AddSparseInputs(Collection& c)
{
  c.AddGood("no data", Data::New());
  c.AddGood("no points", PointsOnly(0));
  c.AddGood("one point", PointsOnly(1));
  c.AddGood("points only", PointsOnly(5));
  c.AddGood("one triangle", EquilateralTriangle());
  c.AddGood("two triangles back to back", FromTriangles(3, { { 0, 1, 2 }, { 0, 2, 1 } }));
  c.AddGood("isolated points", WithIsolatedPoint(Sheet()));
  c.AddGood("vertices, lines and strips", MakeMixedPolyData());
  Data lines = MakePolyData(PointsOnly(4));
  lines->AllocateExact(0, 0, 1, 4, 0, 0, 0, 0);
  lines->GetLines()->InsertNextCell({ 0, 1, 2, 3 });
  c.AddGood("lines only", lines);
  Data strips = MakePolyData(Sheet());
  vtkNew<vtkCellArray> shortStrips;
  shortStrips->InsertNextCell({ 0 });
  shortStrips->InsertNextCell({ 1, 2 });
  strips->SetStrips(shortStrips);
  c.AddGood("strips of one and two points", strips);
}

void AddCoordinates(Collection& c)
{
  c.AddBad("NaN", WithPoint(7, 0, NaN, 0),
    { "1 point", "NaN or infinite", "point 7", "Remove or repair" });
  c.AddBad("infinity", WithPoint(8, 0, -Infinity, 0),
    { "1 point", "NaN or infinite", "point 8", "Remove or repair" });
  c.AddBad(
    "1e300", WithPoint(9, 1e300, 0, 0), { "1 point", "above 1e70", "point 9", "Remove or scale" });
  c.AddBad("scale 1e-90", MakePolyData(Transformed(Sheet(), 1e-90)), { "1e-70", "Scale" });
  c.AddGood("scale 1e-60", Transformed(Sheet(), 1e-60));
  c.AddGood("scale 1e-20", Transformed(Sheet(), 1e-20));
  c.AddGood("scale 1e20", Transformed(Sheet(), 1e20));
  c.AddGood("scale 1e60", Transformed(Sheet(), 1e60));
  c.AddGood("a point at 1e20", WithPoint(9, 1e20, 0, 0));
  const TestMesh far = Transformed(Sheet(), 1, { 1e8, -1e8, 1e8 });
  c.AddGood("offset 1e8", far);
  c.AddGood("offset 1e8 in float", MakePolyData(far, VTK_FLOAT));
  c.AddGood("coordinates of integers", MakePolyData(Transformed(Sheet(), 100), VTK_INT));
}

void AddDegenerateTriangles(Collection& c)
{
  c.AddGood("all points coincide", Transformed(Sphere(), 0));
  c.AddGood("all points coincide far away", Transformed(Sphere(), 0, { 1e8, 0, 0 }));
  c.AddGood("a triangle in one point", OnLine(0));
  c.AddGood("collinear points", OnLine(1));
  c.AddGood("a triangle without area", WithFlatTriangle());
  c.AddGood("thin triangles", WithThinTriangles(Irregular(Icosphere(2), 0.05)));
  c.AddGood("long triangles", LongTriangles());
}

void AddCells(Collection& c)
{
  const auto last = "cell " + std::to_string(Sheet().T.rows());
  c.AddGood("a point twice in a cell", WithTriangle(Sheet(), 0, 0, 1));
  c.AddGood("a point three times in a cell", WithTriangle(Sheet(), 2, 2, 2));
  c.AddBad(
    "a negative id", WithPolygon({ 0, -1, 2 }), { "1 cell", "does not exist", last, "Repair" });
  c.AddBad("an id out of range", WithPolygon({ 0, 1, 1000000 }),
    { "1 cell", "does not exist", last, "Repair" });
  c.AddBad("an id of 2^32", WithPolygon({ 0, 1, vtkIdType(1) << 32 }),
    { "1 cell", "does not exist", last, "Repair" });
  c.AddBad("broken offsets", WithBrokenOffsets(), { "polygons", "offsets", "Repair" });
  c.AddGood("a quad", WithPolygon({ 0, 1, 2, 3 }));
  c.AddGood("a concave polygon that crosses itself", WithPolygon({ 0, 3, 1, 4, 2 }));
  c.AddGood("a polygon of one point", WithPolygon({ 7, 7, 7, 7, 7 }));
  c.AddBad("a polygon of two points", WithPolygon({ 0, 1 }), { "1 polygon", last, "Remove" });
  c.AddBad("a polygon without points", WithPolygon({}), { "1 polygon", last, "Remove" });
  c.AddGood("64-bit ids", WithWideIds(true));
  c.AddGood("32-bit ids", WithWideIds(false));
  c.AddGood("ghost cells", WithCellFlags(vtkDataSetAttributes::DUPLICATECELL));
  c.AddGood("blanked cells", WithCellFlags(vtkDataSetAttributes::HIDDENCELL));
}

void AddTopologies(Collection& c)
{
  c.AddGood("three triangles at an edge", ThreeWings());
  c.AddGood("a fin", WithTriangle(Cube(), 0, 1, 7));
  c.AddGood("a bow tie", FromTriangles(5, { { 0, 1, 2 }, { 0, 3, 4 } }));
  c.AddGood("duplicate triangles", WithTriangle(WithTriangle(Cube(), 0, 2, 1), 0, 2, 1));
  c.AddGood("opposite orientations", WithReversedTriangles());
  c.AddGood("a Moebius strip",
    FromTriangles(5, { { 0, 1, 2 }, { 1, 3, 2 }, { 2, 3, 4 }, { 3, 0, 4 }, { 4, 0, 1 } }));
  c.AddGood("a hole", WithHole());
  c.AddLarge("ten thousand components", Copies(Tetrahedron(), 10000));
  c.AddLarge("a thousand triangles apart", Copies(EquilateralTriangle(), 1000));
  c.AddLarge("a vertex of valence 10000", Cone(10000));
}

void AddArrays(Collection& c)
{
  c.AddGood("an array of NaN that is not chosen", WithArrayOfNaN());
  c.AddGood("a component without weights", WithUnconstrainedComponent());
  c.AddGood("weights of 0 everywhere", WithoutWeights());
}
}

std::vector<HostileInput> HostileInputs()
{
  Collection collection;
  AddSparseInputs(collection);
  AddCoordinates(collection);
  AddDegenerateTriangles(collection);
  AddCells(collection);
  AddTopologies(collection);
  AddArrays(collection);
  return collection.Inputs;
}
