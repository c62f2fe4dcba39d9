// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Optimizer/VolumePreservation.h"

#include "Core/Base/Exceptions.h"
#include "Core/Base/Threading.h"
#include "Core/Mesh/TriangleGeometry.h"

#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace lmo
{
namespace
{
constexpr int MostNewtonSteps = 100;
constexpr double Tolerance = 1e-12;
constexpr double RoundOff = 1e-14; ///< in terms of what the sum adds and subtracts

/// Where the volume of one region is minus the sum of the others, the matrix is singular.
constexpr double Regularisation = 1e-10;

using RegionVectors = std::vector<std::pair<Index, Vector3>>;

/// Six times the gradient of the volume of each region at vertex i.
RegionVectors VolumeGradients(const Points& V, const Triangles& triangles,
  const MeshTopology& topology, const EnclosedRegions& regions, Index i)
{
  RegionVectors gradients;
  const AdjacencyLists& corners = topology.cornersAt;
  for (const Index corner : corners[i])
  {
    const Index t = corner / 3;
    for (int side = 0; side < 2; ++side)
    {
      const Index region = regions.sides(t, side);
      if (region == EnclosedRegions::None)
      {
        continue;
      }
      auto found = std::find_if(gradients.begin(), gradients.end(),
        [&](const auto& gradient) { return gradient.first == region; });
      if (found == gradients.end())
      {
        found = gradients.insert(found, { region, Vector3::Zero() });
      }
      found->second += (side == 0 ? 1 : -1) * ScaledNormal(V, triangles, t);
    }
  }
  return gradients;
}

/// How the vertices move with the offsets h of the regions.
struct OffsetDirections
{
  AdjacencyLists regionsAt; ///< of each vertex
  Points directions;        ///< for each entry of regionsAt: dV / dh

  OffsetDirections(const Points& V, const Triangles& triangles, const MeshTopology& topology,
    const EnclosedRegions& regions, const DisplacementConstraints& constraints)
  {
    std::vector<RegionVectors> gradients(topology.vertices);
    ParallelFor(topology.vertices,
      [&](Index i)
      {
        if (constraints.freedom[i] == DisplacementConstraints::FREE)
        {
          gradients[i] = VolumeGradients(V, triangles, topology, regions, i);
        }
      });
    this->regionsAt.offsets.push_back(0);
    for (const RegionVectors& atVertex : gradients)
    {
      this->regionsAt.offsets.push_back(
        this->regionsAt.offsets.back() + static_cast<Index>(atVertex.size()));
    }
    this->regionsAt.ids.resize(this->regionsAt.offsets.back());
    this->directions.resize(this->regionsAt.offsets.back(), 3);
    ParallelFor(topology.vertices, [&](Index i) { this->Fill(i, gradients[i], constraints); });
  }

private:
  void Fill(Index i, const RegionVectors& gradients, const DisplacementConstraints& constraints)
  {
    double longest = 0;
    for (const auto& [region, gradient] : gradients)
    {
      longest = std::max(longest, gradient.norm());
    }
    Index entry = this->regionsAt.offsets[i];
    for (const auto& [region, gradient] : gradients)
    {
      const Vector3 direction = longest > 0 ? Vector3(gradient / longest) : gradient;
      this->directions.row(entry) = constraints.Project(i, direction);
      this->regionsAt.ids[entry++] = region;
    }
  }
};

/// Gives each region its volume.
class Restoration
{
public:
  Restoration(const Points& V, const Triangles& triangles, const MeshTopology& topology,
    const EnclosedRegions& regions, const DisplacementConstraints& constraints, const Points& moved)
    : T(triangles)
    , Regions(regions)
    , Target(MeasureVolumes(V, triangles, regions))
    , Offsets(moved, triangles, topology, regions, constraints)
    , CanMove(regions.count, false)
  {
    for (const Index region : this->Offsets.regionsAt.ids)
    {
      this->CanMove[region] = true;
    }
  }

  /// How many regions have another volume than they should have, or none.
  Index CountUnpreserved(const Points& moved) const
  {
    const Vector change = this->Change(moved);
    Index count = 0;
    for (Index k = 0; k < this->Regions.count; ++k)
    {
      count += !this->Target.IsSignificant(k) || change[k] != 0;
    }
    return count;
  }

  /// Newton's method for the offsets of all regions.
  void Run(Points& moved) const
  {
    Vector missing = this->Missing(moved);
    for (int step = 0; step < MostNewtonSteps && !missing.isZero(0); ++step)
    {
      this->Move(this->SolveFor(missing, moved), moved);
      missing = this->Missing(moved);
    }
    if (const auto open = (missing.array() != 0).count()) // NaN is one
    {
      throw SolverError("No offset along the normals gives " + std::to_string(open) +
                        (open == 1 ? " component" : " components") +
                        " the volume back: smoothing has left too little of the shape. Raise "
                        "ScaleFactor or DetailWeight, or switch PreserveVolume off.");
    }
  }

private:
  /// What the volume of each region lacks; 0 for what is round-off.
  Vector Change(const Points& V) const
  {
    Vector change = this->Target.volume - MeasureVolumes(V, this->T, this->Regions).volume;
    for (Index k = 0; k < this->Regions.count; ++k)
    {
      const double allowed =
        Tolerance * std::abs(this->Target.volume[k]) + RoundOff * this->Target.magnitude[k];
      if (!this->Target.IsSignificant(k) || std::abs(change[k]) <= allowed)
      {
        change[k] = 0;
      }
    }
    return change;
  }

  /// Change() of the regions that offsets change.
  Vector Missing(const Points& V) const
  {
    Vector missing = this->Change(V);
    for (Index k = 0; k < this->Regions.count; ++k)
    {
      if (!this->CanMove[k])
      {
        missing[k] = 0;
      }
    }
    return missing;
  }

  /// The derivatives of the volumes for the offsets; the diagonal is 1 where there is none.
  Eigen::SparseMatrix<double> Jacobian(const Points& V) const
  {
    const AdjacencyLists& regionsAt = this->Offsets.regionsAt;
    Vector diagonal = Vector::Zero(this->Regions.count);
    std::vector<Eigen::Triplet<double>> entries;
    for (Index corner = 0; corner < static_cast<Index>(this->T.size()); ++corner)
    {
      const Index t = corner / 3;
      const Index i = this->T.data()[corner];
      if (IsDegenerate(this->T, t) || regionsAt.Size(i) == 0)
      {
        continue;
      }
      const Vector3 gradient = ScaledNormal(V, this->T, t) / 6;
      for (int side = 0; side < 2; ++side)
      {
        const Index k = this->Regions.sides(t, side);
        for (Index n = regionsAt.offsets[i]; k >= 0 && n < regionsAt.offsets[i + 1]; ++n)
        {
          const double change =
            (side == 0 ? 1 : -1) * gradient.dot(this->Offsets.directions.row(n));
          const Index l = regionsAt.ids[n];
          if (l == k)
          {
            diagonal[k] += change;
          }
          else
          {
            entries.emplace_back(k, l, change);
          }
        }
      }
    }
    for (Index k = 0; k < this->Regions.count; ++k)
    {
      entries.emplace_back(k, k, diagonal[k] != 0 ? (1 + Regularisation) * diagonal[k] : 1);
    }
    Eigen::SparseMatrix<double> jacobian(this->Regions.count, this->Regions.count);
    jacobian.setFromTriplets(entries.begin(), entries.end());
    return jacobian;
  }

  Vector SolveFor(const Vector& missing, const Points& V) const
  {
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(this->Jacobian(V));
    return factors.info() == Eigen::Success ? Vector(factors.solve(missing)) : missing;
  }

  void Move(const Vector& offsets, Points& V) const
  {
    const AdjacencyLists& regionsAt = this->Offsets.regionsAt;
    ParallelFor(static_cast<Index>(V.rows()),
      [&](Index i)
      {
        for (Index n = regionsAt.offsets[i]; n < regionsAt.offsets[i + 1]; ++n)
        {
          V.row(i) += offsets[regionsAt.ids[n]] * this->Offsets.directions.row(n);
        }
      });
  }

  const Triangles& T;
  const EnclosedRegions& Regions;
  const RegionVolumes Target;
  const OffsetDirections Offsets;
  Mask CanMove; ///< a vertex of the region may move freely
};
}

Index RestoreVolumes(const Points& V, const Triangles& triangles, const MeshTopology& topology,
  const EnclosedRegions& regions, const DisplacementConstraints& constraints, Points& moved)
{
  const Restoration restoration(V, triangles, topology, regions, constraints, moved);
  restoration.Run(moved);
  return restoration.CountUnpreserved(moved);
}
}
