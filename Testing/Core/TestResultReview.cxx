// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshFixtures.h"
#include "OperatorFixtures.h"

#include "Core/Optimizer/ResultReview.h"

using namespace lmo;

namespace
{
/// A comparison in which nothing got worse.
SurfaceComparison Harmless()
{
  MeshQuality before;
  before.mean = 0.8;
  SurfaceComparison comparison;
  comparison.before = std::make_shared<MeshQuality>(before);
  comparison.after.mean = 0.9;
  comparison.triangles = 2000;
  return comparison;
}

OptimizerOptions OfMode(Mode mode)
{
  OptimizerOptions options;
  options.mode = mode;
  return options;
}

/// All warnings as one text.
std::string Damage(
  Mode mode, const SurfaceComparison& comparison, const VolumeLoss& loss = VolumeLoss())
{
  std::string all;
  for (const std::string& warning : WarnOfDamage(OfMode(mode), comparison, loss))
  {
    all += warning + "\n";
  }
  return all;
}

bool Has(const std::string& text, const char* part)
{
  return text.find(part) != std::string::npos;
}

void CheckQualityWarnings(Checks& c)
{
  SurfaceComparison worse = Harmless();
  worse.after.mean = 0.75;
  const std::string text = Damage(Mode::OPTIMIZE_TRIANGLES, worse);
  c.True(
    "a fall of the mean radius ratio is told with both values", Has(text, "fell from 0.8 to 0.75"));
  c.True("its remedy is the mode with a guarantee", Has(text, "OPTIMIZE_WITHIN_DEVIATION"));
  c.True("smoothing may lower the mean radius ratio", Damage(Mode::SMOOTH, worse).empty());
  c.True(
    "better triangles are no reason to warn", Damage(Mode::OPTIMIZE_TRIANGLES, Harmless()).empty());
  worse.after.mean = worse.before->mean - 1e-7;
  c.True("a fall within the solver's tolerance is no reason to warn",
    Damage(Mode::OPTIMIZE_TRIANGLES, worse).empty());
}

void CheckFlipWarnings(Checks& c)
{
  SurfaceComparison flipped = Harmless();
  flipped.flippedTriangles = 2;
  c.True("one triangle in a thousand may turn", Damage(Mode::SMOOTH, flipped).empty());
  flipped.flippedTriangles = 3;
  for (const Mode mode :
    { Mode::OPTIMIZE_TRIANGLES, Mode::SMOOTH, Mode::PRESCRIBED_LAPLACIANS, Mode::SMOOTH_GUIDED })
  {
    c.True("more are told in mode " + std::to_string(int(mode)),
      Has(Damage(mode, flipped), "3 of 2000 triangles (0.15 %)"));
  }
  c.True("a mode with guarantees is not reviewed",
    Damage(Mode::OPTIMIZE_WITHIN_DEVIATION, flipped).empty());
}

void CheckVolumeWarnings(Checks& c)
{
  const VolumeLoss loss{ 3, 2, 0.43 };
  for (const Mode mode : { Mode::SMOOTH, Mode::SMOOTH_GUIDED })
  {
    const std::string text = Damage(mode, Harmless(), loss);
    c.True("components that shrank are counted, with the largest loss",
      Has(text, "2 of 3 closed components") && Has(text, "43 %"));
    c.True("the remedy is to preserve the volume", Has(text, "PreserveVolume"));
  }
  SurfaceComparison changed = Harmless();
  for (const double change : { -0.6, 0.53 })
  {
    changed.relativeVolumeChange = change;
    c.True("OPTIMIZE_TRIANGLES is warned of with the change of volume",
      Has(Damage(Mode::OPTIMIZE_TRIANGLES, changed), change < 0 ? "-60 %" : "+53 %"));
  }
  changed.relativeVolumeChange = -0.09;
  c.True(
    "less than a tenth of the volume may go", Damage(Mode::OPTIMIZE_TRIANGLES, changed).empty());
}

/// A sphere of 42 vertices, another one beside it, and an open patch.
TestMesh TwoSpheresAndPatch()
{
  const TestMesh parts[] = { Icosphere(1), Transformed(Icosphere(1), 0.5, { 5, 0, 0 }),
    Transformed(CylinderPatch(2), 1, { 0, 9, 0 }) };
  TestMesh all{ Points(0, 3), Triangles(0, 3) };
  for (const TestMesh& part : parts)
  {
    const Eigen::Index first = all.V.rows();
    all.V.conservativeResize(first + part.V.rows(), 3);
    all.V.bottomRows(part.V.rows()) = part.V;
    all.T.conservativeResize(all.T.rows() + part.T.rows(), 3);
    all.T.bottomRows(part.T.rows()) = part.T.array() + static_cast<Index>(first);
  }
  return all;
}

void CheckVolumeLoss(Checks& c)
{
  TestMesh mesh = TwoSpheresAndPatch();
  for (const double offset : { 0., 1e6 })
  {
    mesh.V.rowwise() += Vector3(offset, 0, 0);
    MeshQuantities quantities(mesh.V, mesh.T);
    Points after = mesh.V;
    const Vector3 centre(5 + offset, 0, 0);
    after.middleRows(42, 42).rowwise() -= centre;
    after.middleRows(42, 42) *= 0.9;
    after.middleRows(42, 42).rowwise() += centre;
    after.bottomRows(169) *= 0.5;
    const VolumeLoss loss = MeasureVolumeLoss(quantities, after);
    c.Equal("two components of three have a volume", loss.closed, 2);
    c.Equal("one of them lost more than a tenth", loss.shrunk, 1);
    c.Error("a sphere of 0.9 times the radius has lost 1 - 0.9^3",
      std::abs(loss.largest - (1 - 0.729)), 1e-6);
  }
  TestMesh turned = Icosphere(1);
  turned.T.row(0).reverseInPlace();
  MeshQuantities inconsistent(turned.V, turned.T);
  c.Equal("a surface of two orientations has no volume",
    MeasureVolumeLoss(inconsistent, 0.5 * turned.V).closed, 0);
}

void CheckManyComponents(Checks& c)
{
  TestMesh mesh{ Points(40, 3), Triangles(40, 3) };
  const TestMesh one = Tetrahedron();
  for (Index k = 0; k < 10; ++k)
  {
    mesh.V.middleRows(4 * k, 4) = one.V.rowwise() + Vector3(10 * k, 0, 0);
    mesh.T.middleRows(4 * k, 4) = one.T.array() + 4 * k;
  }
  Points after = mesh.V;
  after.row(0) += 0.5 * (after.row(1) - after.row(0)); // half of the volume
  MeshQuantities quantities(mesh.V, mesh.T);
  const VolumeLoss loss = MeasureVolumeLoss(quantities, after);
  c.True("each of ten components has its volume", loss.closed == 10 && loss.shrunk == 1);
  c.Error("one of ten lost half of it", std::abs(loss.largest - 0.5), 1e-12);
}

std::string Freedom(
  const TestMesh& mesh, const OptimizerOptions& options, const VertexArrays& arrays = {})
{
  return WarnOfFreedom(Run(mesh, options, arrays).freedom);
}

void CheckFreedom(Checks& c)
{
  for (const Mode mode :
    { Mode::OPTIMIZE_TRIANGLES, Mode::OPTIMIZE_WITHIN_DEVIATION, Mode::SMOOTH_GUIDED })
  {
    const std::string name = " in mode " + std::to_string(int(mode));
    OptimizerOptions options = OfMode(mode);
    c.True("a closed surface can move" + name, Freedom(Icosphere(1), options).empty());
    c.True("points on fixed boundaries are counted" + name,
      Has(Freedom(EquilateralTriangle(), options), "3 on boundaries, which are fixed."));
    c.True("the remedy for boundaries names the filter that merges points" + name,
      Has(Freedom(EquilateralTriangle(), options), "vtkCleanPolyData"));
    VertexArrays pinned;
    pinned.fixedPoints = Vector::Ones(42);
    c.True("pinned points are counted" + name,
      Has(Freedom(Icosphere(1), options, pinned), "42 fixed by the array"));
    pinned.fixedPoints->coeffRef(7) = 0;
    c.True(
      "one point that can move is enough" + name, Freedom(Icosphere(1), options, pinned).empty());
    options.boundaryCondition = BoundaryCondition::SLIDING;
    c.True("corners of a sliding boundary are counted" + name,
      Has(Freedom(EquilateralTriangle(), options), "3 at corners"));
    c.True("points without a triangle are counted" + name,
      Has(Freedom({ Points::Random(5, 3), Triangles(0, 3) }, options), "5 without a triangle"));
  }
  OptimizerOptions cad = OfMode(Mode::OPTIMIZE_TRIANGLES);
  cad.featureConstraints = true;
  VertexArrays tags;
  tags.featurePoints = Vector::Ones(4);
  c.True("corners of features are counted", Has(Freedom(Tetrahedron(), cad, tags), "4 at corners"));
  c.True("no points are no reason to warn",
    Freedom({ Points(0, 3), Triangles(0, 3) }, OptimizerOptions()).empty());
}

void CheckMissingArea(Checks& c)
{
  TestMesh line = Icosphere(1);
  line.V.rightCols(2).setZero();
  const OptimizerOptions options = OfMode(Mode::OPTIMIZE_TRIANGLES);
  const std::string text = Freedom(line, options);
  c.True("points of triangles without area are counted", Has(text, "all 42 points"));
  c.True("the warning says that the triangles have no area", Has(text, "no area"));
  line.V.row(0) = Vector3(0, 1, 0);
  c.True("one triangle with area is enough", Freedom(line, options).empty());
}
}

int TestResultReview(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("QualityWarnings", CheckQualityWarnings);
  groups.Run("FlipWarnings", CheckFlipWarnings);
  groups.Run("VolumeWarnings", CheckVolumeWarnings);
  groups.Run("VolumeLoss", CheckVolumeLoss);
  groups.Run("ManyComponents", CheckManyComponents);
  groups.Run("Freedom", CheckFreedom);
  groups.Run("MissingArea", CheckMissingArea);
  return groups.Result();
}
