// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshMeasures.h"
#include "SurfacePartitions.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSurfaceDeviation.h"

#include <cmath>

using namespace lmo;

namespace
{
struct Deviation
{
  Vector distances; ///< point array
  double hausdorff;
  double mean;
  double relativeHausdorff;
  double relativeMean;
};

Deviation Measure(const TestMesh& surface, const TestMesh& reference, int samples = 100000)
{
  vtkNew<vtkSurfaceDeviation> filter;
  filter->SetInputData(MakePolyData(surface));
  filter->SetReferenceData(MakePolyData(reference));
  filter->SetNumberOfSamples(samples);
  filter->Update();
  return { PointValues(filter->GetOutput(), "Distance").col(0), filter->GetHausdorffDistance(),
    filter->GetMeanDistance(), filter->GetRelativeHausdorffDistance(),
    filter->GetRelativeMeanDistance() };
}

/// Unit squares, as many as wide and high, with the lower left corner at \a origin.
TestMesh Rectangle(int width, const Vector3& origin)
{
  TestMesh mesh = Transformed(Grid(1, 0), 1, origin);
  mesh.V.col(0) += (width - 1) * (mesh.V.col(0).array() - origin[0]).matrix();
  return mesh;
}

void CheckPlanes(Checks& c)
{
  const TestMesh square = Rectangle(1, { 0, 0, 0 });
  const Deviation above = Measure(square, Rectangle(1, { 0, 0, 0.25 }));
  c.Error("parallel squares are their distance apart", std::abs(above.hausdorff - 0.25), 1e-15);
  c.Error(
    "parallel squares are their distance apart in the mean", std::abs(above.mean - 0.25), 1e-14);

  const Deviation beside = Measure(square, Rectangle(1, { 0.5, 0, 0 }));
  c.Error("a square moved in its plane by t is t away", std::abs(beside.hausdorff - 0.5), 1e-15);
  // The mean of the integral of x from 0 to t.
  c.Error("a square moved in its plane by t is t^2 / 2 away in the mean",
    std::abs(beside.mean - 0.125), 1e-4);

  const Deviation part = Measure(square, Rectangle(3, { 0, 0, 0 }));
  c.Error("a part has no distance to the whole", LargestMagnitude(part.distances), 1e-15);
  c.Error("the whole has a distance to a part", std::abs(part.hausdorff - 2), 1e-15);
  c.Error("distances are relative to the reference's diagonal",
    std::abs(part.relativeHausdorff - part.hausdorff / std::sqrt(10)) +
      std::abs(part.relativeMean - part.mean / std::sqrt(10)),
    1e-15);
  // 0 forth and (0 + 1/2 + 3/2) / 3 back.
  c.Error("the mean is that of both directions", std::abs(part.mean - 1.0 / 3), 1e-4);
  const Deviation whole = Measure(Rectangle(3, { 0, 0, 0 }), square);
  c.Error("the deviation is the same in both directions",
    std::abs(whole.hausdorff - part.hausdorff) + std::abs(whole.mean - part.mean), 1e-15);
  c.Error("the distances are those of port 0", std::abs(whole.distances.maxCoeff() - 2), 1e-15);
}

void CheckSpheres(Checks& c)
{
  const TestMesh sphere = Irregular(Icosphere(4), 0.001);
  const Deviation same = Measure(sphere, sphere, 10000);
  c.Error("identical surfaces have no distance", same.hausdorff, 1e-12);
  const Deviation concentric = Measure(Icosphere(4, 2), Icosphere(4, 3), 1000);
  c.Error("concentric spheres are the difference of their radii apart",
    std::abs(concentric.hausdorff - 1), 0.01);
  c.Error("concentric spheres are the difference of their radii apart in the mean",
    std::abs(concentric.mean - 1), 0.01);
}

/// A square of side 3 with a hole of side 1 in the middle.
TestMesh Frame()
{
  TestMesh mesh = Grid(3, 0);
  Triangles frame(16, 3);
  frame << mesh.T.topRows(8), mesh.T.bottomRows(8);
  mesh.T = frame;
  return mesh;
}

void CheckSamples(Checks& c)
{
  TestMesh plate = Grid(1, 0);
  plate.V *= 3;
  const Deviation hole = Measure(plate, Frame());
  c.Error("all points of the plate lie on the frame", LargestMagnitude(hole.distances), 1e-15);
  c.Error(
    "the middle of the hole is found inside a triangle", std::abs(hole.hausdorff - 0.5), 0.01);
  // A pyramid of height 1/2 over the hole, volume 1/6, over the area 9; nothing back.
  c.Error("the mean counts the area", std::abs(hole.mean - 1.0 / 6 / 9 / 2), 1e-4);
  c.Error("few samples find less", Measure(plate, Frame(), 10).hausdorff, 0.4);
}

TestMesh Triangle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  TestMesh mesh = EquilateralTriangle();
  mesh.V << a, b, c;
  return mesh;
}

void CheckDegenerateTriangles(Checks& c)
{
  const TestMesh triangle = Triangle({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 });
  const TestMesh line = Triangle({ 0, 0, 1 }, { 2, 0, 1 }, { 3, 0, 1 });
  const TestMesh point = Triangle({ 0, 0, 1 }, { 0, 0, 1 }, { 0, 0, 1 });
  const double root2 = std::sqrt(2);
  c.Error("a triangle without area is as far as its longest edge",
    LargestMagnitude(Measure(triangle, line).distances - Vector3(1, 1, root2).transpose()), 1e-15);
  c.Error(
    "the way back is found too", std::abs(Measure(triangle, line).hausdorff - std::sqrt(5)), 1e-15);
  c.Error("a triangle of equal points is as far as they are",
    LargestMagnitude(Measure(triangle, point).distances - Vector3(1, root2, root2).transpose()),
    1e-15);
  c.Error("a line is on itself", Measure(line, line).hausdorff, 1e-15);
  const TestMesh cross = WithTriangle(CrossRing(), 1, 1, 2);
  c.Error("degenerate triangles do not count", Measure(cross, CrossRing()).hausdorff, 1e-15);

  TestMesh degenerate = triangle;
  degenerate.T << 0, 0, 1;
  const Deviation deviation = Measure(degenerate, degenerate);
  c.True("degenerate triangles alone do no harm", !(deviation.hausdorff > 0));
}

void CheckOtherInput(Checks& c)
{
  vtkNew<vtkSurfaceDeviation> filter;
  const auto isRefused = [&](const std::string& what, vtkPolyData* surface, vtkPolyData* reference,
                           const std::string& text)
  {
    filter->SetInputData(surface);
    filter->SetReferenceData(reference);
    c.Says(what + " are an error which says '" + text + "'", Update(filter).errors, text);
    c.True(what + " leave the output empty", IsEmpty(filter->GetOutput()));
    c.Equal(what + " leave no distance of before", filter->GetHausdorffDistance(), -1);
  };
  const auto cube = MakePolyData(Cube());
  c.Equal("nothing is updated before the first execution", filter->UpdateMetrics(), 0);
  filter->SetInputData(cube);
  filter->SetReferenceData(cube);
  filter->Update();
  filter->Modified();
  c.Equal("afterwards the distances are brought up to date", filter->UpdateMetrics(), 1);
  c.Error("a surface has no distance to itself", filter->GetHausdorffDistance(), 1e-15);
  const auto edges = MakePolyData(Cube());
  edges->GetPolys()->InsertNextCell({ 0, 1 });
  vtkNew<vtkPolyData> nothing;
  isRefused("polygons of two points", edges, cube, "vtkCleanPolyData");
  isRefused("polygons of two points of the reference", cube, edges, "vtkCleanPolyData");
  isRefused("references without triangles", cube, nothing, "reference");
  filter->SetNumberOfSamples(0);
  isRefused("0 samples", cube, cube, "NumberOfSamples");
  filter->SetNumberOfSamples(100);

  filter->SetInputData(nothing);
  c.Equal("an empty surface is no error", Update(filter).errors, "");
  filter->SetReferenceData(nothing);
  c.Equal("two empty surfaces are no error", Update(filter).errors, "");
  c.Equal("two empty surfaces have no distance", filter->GetHausdorffDistance(), 0);
}

void CheckSignedDistance(Checks& c)
{
  const TestMesh sphere = Icosphere(4);
  vtkNew<vtkSurfaceDeviation> filter;
  filter->SetNumberOfSamples(100);
  for (const double radius : { 0.5, 1.5 })
  {
    filter->SetInputData(MakePolyData(Transformed(sphere, radius)));
    for (const TestMesh& reference : { sphere, Soup(sphere) })
    {
      filter->SetReferenceData(MakePolyData(reference));
      filter->Update();
      c.Error("the signed distance of a sphere is the difference of the radii",
        LargestMagnitude(PointValues(filter->GetOutput(), "SignedDistance").array() - (radius - 1)),
        0.002);
      c.Error("its magnitude is the distance",
        LargestMagnitude(PointValues(filter->GetOutput(), "SignedDistance").cwiseAbs() -
                         PointValues(filter->GetOutput(), "Distance")),
        0);
    }
  }
  vtkNew<vtkPolyData> earlier;
  earlier->ShallowCopy(filter->GetOutput());
  filter->SetInputData(earlier);
  filter->SetReferenceData(MakePolyData(HalfSphere(2)));
  filter->Update();
  c.True("an open reference has no signed distance, and an earlier one goes",
    !filter->GetOutput()->GetPointData()->HasArray("SignedDistance"));
}

void CheckMixedCells(Checks& c)
{
  const auto input = MakeMixedPolyData();
  vtkNew<vtkSurfaceDeviation> filter;
  filter->SetInputData(input);
  filter->SetReferenceData(MakeMixedPolyDataWithoutStrips());
  filter->SetNumberOfSamples(1000);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  c.Error("strips and triangles are the same surface; an unused point does not count",
    filter->GetHausdorffDistance(), 1e-12);
  c.True("all data pass through", Contains(output->GetPointData(), input->GetPointData()) &&
                                    Contains(output->GetFieldData(), input->GetFieldData()) &&
                                    AreEqual(output->GetStrips(), input->GetStrips()));
  c.True("field data hold what the getters return",
    FieldValue(output, "HausdorffDistance") == filter->GetHausdorffDistance() &&
      FieldValue(output, "RelativeHausdorffDistance") == filter->GetRelativeHausdorffDistance() &&
      FieldValue(output, "MeanDistance") == filter->GetMeanDistance() &&
      FieldValue(output, "RelativeMeanDistance") == filter->GetRelativeMeanDistance());
}

/// Two squares, 10 apart, at these heights.
vtkSmartPointer<vtkMultiBlockDataSet> TwoSquares(double first, double second)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, MakePolyData(Rectangle(1, { 0, 0, first })));
  blocks->SetBlock(2, MakePolyData(Rectangle(1, { 10, 0, second })));
  return blocks;
}

void CheckBlocks(Checks& c)
{
  vtkNew<vtkSurfaceDeviation> filter;
  filter->SetInputData(TwoSquares(0, 0));
  filter->SetReferenceData(TwoSquares(0.25, 0.5));
  c.Equal("blocks are compared with blocks", Update(filter).errors, "");
  c.Error("the largest distance is that of all blocks",
    std::abs(filter->GetHausdorffDistance() - 0.5), 1e-15);
  c.Error("the mean is that over the area of all blocks",
    std::abs(filter->GetMeanDistance() - 0.375), 1e-3);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  for (const unsigned int k : { 0, 2 })
  {
    auto* block = vtkPolyData::SafeDownCast(output->GetBlock(k));
    c.Error("each point has its distance",
      LargestMagnitude(PointValues(block, "Distance").array() - (k == 0 ? 0.25 : 0.5)), 1e-15);
    c.Equal("each block has the figures of all", FieldValue(block, "HausdorffDistance"),
      filter->GetHausdorffDistance());
  }
  filter->SetReferenceData(MakePolyData(Rectangle(1, { 0, 0, 0.25 })));
  filter->Update();
  c.AtLeast("one reference serves all blocks", filter->GetHausdorffDistance(), 9);
}

void CheckPartitions(Checks& c)
{
  const TestMesh sphere = Icosphere(3);
  const TestMesh reference = Icosphere(3, 1.1);
  const Deviation whole = Measure(sphere, reference);
  vtkNew<vtkSurfaceDeviation> filter;
  filter->SetInputData(CutIntoPartitions(MakePolyData(sphere), 3).data);
  filter->SetReferenceData(CutIntoPartitions(MakePolyData(reference), 2).data);
  filter->Update();
  c.Error("partitions are as far apart as the surfaces that they are of",
    std::abs(filter->GetHausdorffDistance() - whole.hausdorff), 1e-15);
  c.Error("partitions are as far apart in the mean",
    std::abs(filter->GetMeanDistance() - whole.mean), 1e-4);
  auto* output = vtkPartitionedDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  for (unsigned int k = 0; k < 3; ++k)
  {
    c.True("the reference is closed, as that of the whole",
      Part(output, k)->GetPointData()->HasArray("SignedDistance"));
  }
}
}

int TestSurfaceDeviation(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Planes", CheckPlanes);
  groups.Run("Spheres", CheckSpheres);
  groups.Run("Samples", CheckSamples);
  groups.Run("SignedDistance", CheckSignedDistance);
  groups.Run("MixedCells", CheckMixedCells);
  groups.Run("OtherInput", CheckOtherInput);
  groups.Run("DegenerateTriangles", CheckDegenerateTriangles);
  groups.Run("Blocks", CheckBlocks);
  groups.Run("Partitions", CheckPartitions);
  return groups.Result();
}
