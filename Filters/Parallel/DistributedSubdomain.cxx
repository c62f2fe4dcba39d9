// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedSubdomain.h"

#include "DistributedRanking.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace lmo
{
namespace
{
/// A vertex on a line, as all processes get to know it.
struct LineVertex
{
  std::int64_t row;
  double position[3];
  unsigned char pointClass;
  std::int64_t neighbours[2]; ///< of an EDGE
};

std::vector<LineVertex> JoinLines(
  const DistributedMesh& mesh, const FeatureLines& features, const Points& V)
{
  std::vector<LineVertex> vertices;
  for (Index i = 0; i < mesh.GetNumberOfOwned(); ++i)
  {
    const unsigned char pointClass = features.pointClass[i];
    if (pointClass == FeatureLines::SMOOTH)
    {
      continue;
    }
    LineVertex vertex{ mesh.GetRow(i), { V(i, 0), V(i, 1), V(i, 2) }, pointClass, {} };
    for (int k = 0; k < 2 && pointClass == FeatureLines::EDGE; ++k)
    {
      vertex.neighbours[k] = mesh.GetRow(features.lines->Begin(i)[k]);
    }
    vertices.push_back(vertex);
  }
  return mesh.GetCommunicator().Join(vertices); // rows ascend with the ranks
}

Index FindLineVertex(const std::vector<LineVertex>& vertices, std::int64_t row)
{
  const auto found = std::lower_bound(vertices.begin(), vertices.end(), row,
    [](const LineVertex& vertex, std::int64_t value) { return vertex.row < value; });
  return static_cast<Index>(found - vertices.begin());
}

/// The lines alone, with vertices numbered as in the list.
FeatureLines MakeLines(const std::vector<LineVertex>& vertices)
{
  FeatureLines features;
  auto lines = std::make_shared<AdjacencyLists>();
  lines->offsets.push_back(0);
  for (const LineVertex& vertex : vertices)
  {
    features.pointClass.push_back(vertex.pointClass);
    for (int k = 0; k < 2 && vertex.pointClass == FeatureLines::EDGE; ++k)
    {
      lines->ids.push_back(FindLineVertex(vertices, vertex.neighbours[k]));
    }
    lines->offsets.push_back(static_cast<Index>(lines->ids.size()));
  }
  features.lines = std::move(lines);
  return features;
}
}

DistributedSubdomain::DistributedSubdomain(
  std::shared_ptr<const DistributedMesh> mesh, const Triangles& triangles)
  : Mesh(std::move(mesh))
  , IsTriangleOwned(triangles.rows())
{
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    this->IsTriangleOwned[t] = this->OwnsVertex(triangles(t, 0));
  }
}

double DistributedSubdomain::Sum(double value) const
{
  return this->Mesh->GetCommunicator().Sum(value);
}

double DistributedSubdomain::Norm(double part) const
{
  return std::sqrt(this->Sum(part * part));
}

Eigen::Array4d DistributedSubdomain::Sum(const Eigen::Array4d& values) const
{
  Eigen::Array4d sums = values;
  this->Mesh->GetCommunicator().Sum(sums.data(), 4);
  return sums;
}

double DistributedSubdomain::Maximum(double value) const
{
  return this->Mesh->GetCommunicator().Maximum(value);
}

double DistributedSubdomain::Quantile(std::vector<double> values, double q) const
{
  return DistributedQuantile(this->Mesh->GetCommunicator(), values, q);
}

Vector DistributedSubdomain::CumulativeShares(const Vector& values, const Mask& counts) const
{
  return DistributedShares(this->Mesh->GetCommunicator(), values, counts);
}

void DistributedSubdomain::UpdateGhosts(Vector& values) const
{
  this->Mesh->UpdateGhosts(values.data(), 1);
}

void DistributedSubdomain::UpdateGhosts(Points& values) const
{
  this->Mesh->UpdateGhosts(values.data(), 3);
}

void DistributedSubdomain::UpdateGhosts(Eigen::Array4Xf& values) const
{
  this->Mesh->UpdateGhosts(values.data(), 4);
}

void DistributedSubdomain::UpdateGhosts(Eigen::Array4Xd& values) const
{
  this->Mesh->UpdateGhosts(values.data(), 4);
}

void DistributedSubdomain::UniteFlags(const std::vector<Index>& component, Mask& flags) const
{
  for (bool isChanged = true; isChanged;)
  {
    Vector reached(component.size());
    for (std::size_t i = 0; i < component.size(); ++i)
    {
      reached[i] = flags[component[i]];
    }
    this->Mesh->UniteMaximum(reached);
    isChanged = false;
    for (std::size_t i = 0; i < component.size(); ++i)
    {
      isChanged = isChanged || reached[i] > flags[component[i]];
      flags[component[i]] |= reached[i] > 0;
    }
    isChanged = this->Maximum(isChanged) > 0;
  }
}

std::vector<double> DistributedSubdomain::UniteComponents(
  const std::vector<Index>& component, Index count) const
{
  std::vector<double> largest(count, -1);
  Vector rows = this->Mesh->GetRows();
  for (bool isChanged = true; isChanged;)
  {
    isChanged = false;
    for (std::size_t i = 0; i < component.size(); ++i)
    {
      isChanged = isChanged || rows[i] > largest[component[i]];
      largest[component[i]] = std::max(largest[component[i]], rows[i]);
    }
    for (std::size_t i = 0; i < component.size(); ++i)
    {
      rows[i] = largest[component[i]];
    }
    this->Mesh->UniteMaximum(rows);
    isChanged = this->Maximum(isChanged) > 0;
  }
  return largest;
}

void DistributedSubdomain::SumOverComponents(
  const std::vector<Index>& component, Eigen::ArrayXXd& values) const
{
  const auto count = static_cast<Index>(values.rows());
  const Eigen::Index columns = values.cols();
  const std::vector<double> names = this->UniteComponents(component, count);
  std::vector<double> numbers; // of each component its name and its values
  for (Index k = 0; k < count; ++k)
  {
    if (!values.row(k).isZero(0))
    {
      numbers.push_back(names[k]);
      numbers.insert(numbers.end(), values.row(k).begin(), values.row(k).end());
    }
  }
  numbers = this->Mesh->GetCommunicator().Join(numbers);
  std::unordered_map<double, Eigen::ArrayXd> sums;
  for (auto number = numbers.cbegin(); number != numbers.cend(); number += 1 + columns)
  {
    Eigen::ArrayXd& sum = sums.try_emplace(*number, Eigen::ArrayXd::Zero(columns)).first->second;
    sum += Eigen::Map<const Eigen::ArrayXd>(&number[1], columns);
  }
  for (Index k = 0; k < count; ++k)
  {
    const auto found = sums.find(names[k]);
    if (found != sums.end())
    {
      values.row(k) = found->second;
    }
  }
}

void DistributedSubdomain::ProjectOntoLines(
  const FeatureLines& features, const Points& V, Points& moved) const
{
  const std::vector<LineVertex> vertices = JoinLines(*this->Mesh, features, V);
  const auto size = static_cast<Index>(vertices.size());
  Points before(size, 3);
  for (Index k = 0; k < size; ++k)
  {
    before.row(k) = Eigen::Map<const Vector3>(vertices[k].position);
  }
  const std::int64_t firstRow = this->Mesh->GetFirstRow();
  const Index begin = FindLineVertex(vertices, firstRow);
  const Index end = FindLineVertex(vertices, firstRow + this->Mesh->GetNumberOfOwned());
  Points after = before; // those of other processes stay
  for (Index k = begin; k < end; ++k)
  {
    after.row(k) = moved.row(vertices[k].row - firstRow);
  }
  lmo::ProjectOntoLines(MakeLines(vertices), before, after);
  for (Index k = begin; k < end; ++k)
  {
    moved.row(vertices[k].row - firstRow) = after.row(k);
  }
}
}
