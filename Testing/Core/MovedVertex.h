// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MovedVertex_h
#define MovedVertex_h

#include "MeshFixtures.h"

#include "Core/Deviation/TriangleValidity.h"
#include "Core/Mesh/TriangleNeighbours.h"

#include <numeric>

/// A mesh with a candidate that differs in the position of one vertex.
class MovedVertex
{
public:
  MovedVertex(const TestMesh& mesh, lmo::Index vertex, const lmo::Vector3& position)
    : MovedVertex(mesh, mesh.V, vertex, position)
  {
  }

  /// \param accepted the positions before
  MovedVertex(const TestMesh& mesh, const lmo::Points& accepted, lmo::Index vertex,
    const lmo::Vector3& position)
    : T(mesh.T)
    , Accepted(accepted)
    , Candidate(accepted)
    , Topology(lmo::BuildTopology(lmo::Index(mesh.V.rows()), mesh.T))
    , Neighbours(lmo::FindTriangleNeighbours(this->T, this->Topology))
    , Validity(this->Accepted, this->Candidate, this->T, this->Topology, this->Neighbours,
        lmo::NormalsToKeep(accepted, this->T, this->Topology),
        lmo::SmoothedNormals(accepted, this->T, this->Topology))
  {
    for (lmo::Index t = 0; t < this->T.rows(); ++t)
    {
      this->Validity.Accept(t, t);
    }
    this->Candidate.row(vertex) = position;
    std::vector<lmo::Index> all(this->T.rows());
    std::iota(all.begin(), all.end(), 0);
    this->Validity.Update(all);
  }

  lmo::Index Turned() const
  {
    return this->Count([this](lmo::Index t) { return this->Validity.IsTurned(t, t); });
  }
  lmo::Index Folded() const
  {
    return this->Count([this](lmo::Index t) { return this->Validity.IsFolded(t); });
  }
  lmo::Index Inverted() const
  {
    return this->Count([this](lmo::Index t) { return this->Validity.IsInverted(t); });
  }

private:
  template <typename Condition>
  lmo::Index Count(const Condition& condition) const
  {
    lmo::Index count = 0;
    for (lmo::Index t = 0; t < this->T.rows(); ++t)
    {
      count += condition(t);
    }
    return count;
  }

  const lmo::Triangles T;
  const lmo::Points Accepted;
  lmo::Points Candidate;
  const lmo::MeshTopology Topology;
  const lmo::Triangles Neighbours;
  lmo::TriangleValidity Validity;
};

#endif
