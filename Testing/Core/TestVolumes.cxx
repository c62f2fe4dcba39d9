// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Optimizer/Optimizer.h"

#include <array>
#include <functional>
#include <map>

using namespace lmo;

namespace
{
constexpr int Voxels = 12; ///< along each axis

using LabelAt = std::function<int(int x, int y, int z)>;

/// The faces between voxels of different labels, with shared points. The normals lead from the
/// lower label to the higher one.
struct LabelSurface
{
  TestMesh mesh;
  TriangleLabels labels; ///< the lower one first

  explicit LabelSurface(const LabelAt& labelAt)
  {
    const auto label = [&](std::array<int, 3> x)
    {
      const bool isInside = *std::min_element(x.begin(), x.end()) >= 0 &&
                            *std::max_element(x.begin(), x.end()) < Voxels;
      return isInside ? labelAt(x[0], x[1], x[2]) : 0;
    };
    for (int k = 0; k < (Voxels + 1) * (Voxels + 1) * (Voxels + 1); ++k)
    {
      const std::array<int, 3> x{ k % (Voxels + 1), k / (Voxels + 1) % (Voxels + 1),
        k / (Voxels + 1) / (Voxels + 1) };
      for (int axis = 0; axis < 3; ++axis)
      {
        std::array<int, 3> before = x;
        --before[axis];
        this->AddFace(x, axis, label(before), label(x));
      }
    }
    this->Finish();
  }

  /// The volume of a label as the sum over its triangles, which look outwards with the lower label.
  double Volume(const Points& V, double label) const
  {
    double volume = 0;
    for (Index t = 0; t < this->mesh.T.rows(); ++t)
    {
      const int sign = (this->labels(t, 0) == label) - (this->labels(t, 1) == label);
      volume += sign * VolumeTo(Vector3::Zero(), V, this->mesh.T, t);
    }
    return volume;
  }

private:
  void AddFace(std::array<int, 3> x, int axis, int before, int behind)
  {
    if (before == behind)
    {
      return;
    }
    std::array<Index, 4> quad;
    for (int corner = 0; corner < 4; ++corner)
    {
      std::array<int, 3> p = x;
      p[(axis + 1) % 3] += corner == 1 || corner == 2;
      p[(axis + 2) % 3] += corner >= 2;
      quad[corner] = this->Ids.emplace(p, Index(this->Ids.size())).first->second;
    }
    if (before > behind)
    {
      std::swap(quad[1], quad[3]);
    }
    this->Corners.push_back({ quad[0], quad[1], quad[2] });
    this->Corners.push_back({ quad[0], quad[2], quad[3] });
    this->Pairs.insert(this->Pairs.end(), 2, std::minmax(before, behind));
  }

  void Finish()
  {
    this->mesh.V.resize(Eigen::Index(this->Ids.size()), 3);
    for (const auto& [x, id] : this->Ids)
    {
      this->mesh.V.row(id) = Vector3(x[0], x[1], x[2]);
    }
    this->mesh.T.resize(Eigen::Index(this->Corners.size()), 3);
    this->labels.resize(this->mesh.T.rows(), 2);
    for (Index t = 0; t < this->mesh.T.rows(); ++t)
    {
      this->mesh.T.row(t) = Eigen::Map<const Eigen::Matrix<Index, 1, 3>>(this->Corners[t].data());
      this->labels.row(t) << this->Pairs[t].first, this->Pairs[t].second;
    }
  }

  std::map<std::array<int, 3>, Index> Ids;
  std::vector<std::array<Index, 3>> Corners;
  std::vector<std::pair<int, int>> Pairs;
};

/// Two boxes that touch along one edge.
int TouchingBoxes(int x, int y, int z)
{
  return (x < 6 && y < 6 && z < 8) || (x >= 6 && y >= 6 && z >= 3);
}

/// Two boxes that share a part of a wall, and a box inside the second one.
int SharedWall(int x, int y, int z)
{
  const bool isInner = x > 8 && x < 11 && y > 2 && y < 6 && z > 2 && z < 6;
  return isInner ? 3 : x < 6 && y < 8 && z > 0 ? 1 : x >= 6 && y > 0 && y < 11 ? 2 : 0;
}

OptimizerOptions Preserving()
{
  OptimizerOptions options;
  options.mode = Mode::SMOOTH;
  options.positionWeighting = PositionWeighting::CONSTANT;
  options.scaleFactor = 0.3;
  options.preserveVolume = true;
  return options;
}

OptimizerResult Run(
  const TestMesh& mesh, const OptimizerOptions& options, const TriangleLabels* labels = nullptr)
{
  VertexArrays arrays;
  if (labels)
  {
    arrays.labels = *labels;
  }
  ProgressMonitor monitor;
  return Optimize(mesh.V, mesh.T, options, arrays, monitor);
}

double VolumeChange(const TestMesh& mesh, const Points& V)
{
  return std::abs(EnclosedVolume(V, mesh.T) / EnclosedVolume(mesh.V, mesh.T) - 1);
}

void CheckTouchingBoxes(Checks& c)
{
  LabelSurface boxes(TouchingBoxes);
  boxes.mesh.T = boxes.mesh.T.rowwise().reverse().eval();
  OptimizerOptions options = Preserving();
  const OptimizerResult kept = Run(boxes.mesh, options);
  c.Error("boxes that touch along an edge keep their volume",
    VolumeChange(boxes.mesh, kept.positions), 1e-11);
  c.Equal("no volume is left out", kept.unpreservedVolumes, 0);
  options.preserveVolume = false;
  c.Greater("without that they lose it",
    VolumeChange(boxes.mesh, Run(boxes.mesh, options).positions), 1e-3);
}

void CheckLabelsOfBothSides(Checks& c)
{
  const LabelSurface surface(SharedWall);
  TestMesh turned = surface.mesh; // no convention tells which label is on which side
  for (Index t = 0; t < turned.T.rows(); t += 3)
  {
    turned.T.row(t).reverseInPlace();
  }
  for (const Mode mode : { Mode::SMOOTH, Mode::SMOOTH_GUIDED })
  {
    OptimizerOptions options = Preserving();
    options.mode = mode;
    const OptimizerResult result = Run(turned, options, &surface.labels);
    for (const int label : { 0, 1, 2, 3 })
    {
      const double volume = surface.Volume(surface.mesh.V, label);
      c.Error("label " + std::to_string(label) + " keeps its volume",
        std::abs(surface.Volume(result.positions, label) / volume - 1), 1e-11);
    }
    c.Equal("no volume is left out", result.unpreservedVolumes, 0);
  }
}

/// Each label has triangles of its own, which coincide where labels touch.
void CheckLabelsOfTriangles(Checks& c)
{
  const LabelSurface surface(SharedWall);
  const auto faces = surface.mesh.T.rows();
  TestMesh mesh{ surface.mesh.V, Triangles(2 * faces, 3) };
  mesh.T << surface.mesh.T, surface.mesh.T.rowwise().reverse();
  TriangleLabels labels(2 * faces, 1);
  labels << surface.labels.col(0), surface.labels.col(1);
  const OptimizerResult result = Run(mesh, Preserving(), &labels);
  for (const int label : { 1, 2, 3 })
  {
    c.Error("the triangles of label " + std::to_string(label) + " keep its volume",
      std::abs(surface.Volume(result.positions, label) / surface.Volume(surface.mesh.V, label) - 1),
      1e-11);
  }
}

/// Labels of faces, as CAD files have them, enclose nothing one by one.
void CheckLabelsOfFaces(Checks& c)
{
  const TestMesh cube = Irregular(Cube(3), 0.01);
  TriangleLabels labels(cube.T.rows(), 1);
  for (Index t = 0; t < cube.T.rows(); ++t)
  {
    const Vector3 normal = ScaledNormal(cube.V, cube.T, t);
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    labels(t, 0) = double(2 * axis) + (normal[axis] > 0);
  }
  const OptimizerResult result = Run(cube, Preserving(), &labels);
  c.Error(
    "a cube whose faces have labels keeps its volume", VolumeChange(cube, result.positions), 1e-11);
  c.Equal("no volume is left out", result.unpreservedVolumes, 0);
}

void CheckWhatHasNoVolume(Checks& c)
{
  const auto count = [](const TestMesh& mesh, const TriangleLabels* labels = nullptr)
  { return Run(mesh, Preserving(), labels).unpreservedVolumes; };
  TestMesh turned = Icosphere(1);
  turned.T.row(0).reverseInPlace();
  c.Equal("a sphere with a turned triangle has none", count(turned), 1);
  c.Equal("a grid has none", count(Grid(4, 0)), 1);
  c.Equal("of a sphere and a tetrahedron both have one", count(TwoComponents()), 0);
  c.Equal("a point alone is not counted", count(WithIsolatedPoint(Icosphere(1))), 0);
  const TestMesh grid = Grid(4, 0);
  TestMesh flat{ grid.V, Triangles(2 * grid.T.rows(), 3) };
  flat.T << grid.T, grid.T.rowwise().reverse();
  c.Equal("a closed sheet that lies on itself has none", count(flat), 1);
  LabelSurface cut(SharedWall);
  const TriangleLabels allButOne = cut.labels.topRows(cut.labels.rows() - 1);
  const TestMesh holed{ cut.mesh.V, cut.mesh.T.topRows(cut.mesh.T.rows() - 1) };
  c.Equal("a hole opens the labels on its two sides", count(holed, &allButOne), 2);
}

/// A prism whose points all lie on the rims of its two faces.
TestMesh Drum(Index sides)
{
  TestMesh drum;
  drum.V.resize(2 * sides, 3);
  drum.T.resize(4 * sides - 4, 3);
  for (Index i = 0; i < sides; ++i)
  {
    const double angle = 2 * EIGEN_PI * i / sides + 0.03 * std::sin(5.0 * i);
    drum.V.row(2 * i) << std::cos(angle), std::sin(angle), -1;
    drum.V.row(2 * i + 1) << std::cos(angle), std::sin(angle), 1;
    const Index next = 2 * ((i + 1) % sides);
    drum.T.row(2 * i) << 2 * i, next, next + 1;
    drum.T.row(2 * i + 1) << 2 * i, next + 1, 2 * i + 1;
    if (i > 0 && i < sides - 1)
    {
      drum.T.row(2 * sides + 2 * i - 2) << 0, next, 2 * i;
      drum.T.row(2 * sides + 2 * i - 1) << 1, 2 * i + 1, next + 1;
    }
  }
  return drum;
}

void CheckWhatCannotMove(Checks& c)
{
  OptimizerOptions options = Preserving();
  options.featureConstraints = true;
  const OptimizerResult still = Run(Cube(), options);
  c.Equal("of a cube that cannot move the volume is preserved", still.unpreservedVolumes, 0);
  const TestMesh drum = Drum(60);
  const OptimizerResult slid = Run(drum, options);
  c.Less("points that only slide along rims change the volume a little", 1e-6,
    VolumeChange(drum, slid.positions));
  c.Equal("that is counted", slid.unpreservedVolumes, 1);
}

void CheckFreeAxes(Checks& c)
{
  const TestMesh sphere = Irregular(Icosphere(3), 0.05);
  OptimizerOptions options = Preserving();
  options.freeAxes = Vector3(1, 1, 0);
  const Points moved = Run(sphere, options).positions;
  c.Error("the volume is given back", VolumeChange(sphere, moved), 1e-11);
  c.Error("along the free axes alone", (moved - sphere.V).col(2).cwiseAbs().maxCoeff(), 0);
}
}

int TestVolumes(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("TouchingBoxes", CheckTouchingBoxes);
  groups.Run("LabelsOfBothSides", CheckLabelsOfBothSides);
  groups.Run("LabelsOfTriangles", CheckLabelsOfTriangles);
  groups.Run("LabelsOfFaces", CheckLabelsOfFaces);
  groups.Run("WhatHasNoVolume", CheckWhatHasNoVolume);
  groups.Run("CannotMove", CheckWhatCannotMove);
  groups.Run("FreeAxes", CheckFreeAxes);
  return groups.Result();
}
