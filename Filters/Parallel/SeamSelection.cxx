// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SeamSelection.h"

#include "NearTriangles.h"

#include <algorithm>

namespace lmo
{
namespace
{
bool HasVertex(const Triangles& triangles, Index t, const Vector& isMarked)
{
  return isMarked[triangles(t, 0)] || isMarked[triangles(t, 1)] || isMarked[triangles(t, 2)];
}

/// Box of the triangles that are owned, wider by a distance; empty if there are none.
Box3 ReachOf(const Points& V, const Triangles& triangles, const Subdomain& subdomain, double wider)
{
  Box3 reach;
  for (Index t = 0; t < static_cast<Index>(triangles.rows()); ++t)
  {
    if (subdomain.OwnsTriangle(t))
    {
      reach.extend(WideBoxOf(V, triangles, t, wider));
    }
  }
  return reach;
}

/// Marks what lies within so many edges of the marked vertices.
void Widen(const AdjacencyLists& rings, int edges, Vector& isMarked)
{
  std::vector<Index> front;
  for (Index i = 0; i < static_cast<Index>(isMarked.size()); ++i)
  {
    if (isMarked[i])
    {
      front.push_back(i);
    }
  }
  for (; edges > 0; --edges)
  {
    std::vector<Index> next;
    for (const Index i : front)
    {
      for (const Index j : rings[i])
      {
        if (!isMarked[j])
        {
          isMarked[j] = 1;
          next.push_back(j);
        }
      }
    }
    front = std::move(next);
  }
}

/// Chooses what one process sends.
class Selection
{
public:
  Selection(const MeshQuantities& mesh, const DistributedSubdomain& subdomain, const RunPlan& plan,
    const Points& V, double distance)
    : Mesh(mesh)
    , T(mesh.GetTriangles())
    , Domain(subdomain)
    , Plan(plan)
    , V(V)
    , Distance(distance)
  {
  }

  SeamPart Select(const Vector& isInner, int edges)
  {
    this->ChooseFree(isInner, edges);
    this->AddReference();
    this->AddTriangles();
    this->AddVertices();
    return std::move(this->Part);
  }

private:
  bool IsMovable(Index i) const
  {
    return this->Plan.problem.constraints.freedom[i] != DisplacementConstraints::FIXED;
  }

  void ChooseFree(const Vector& isInner, int edges)
  {
    const Index size = this->Mesh.GetTopology().vertices;
    const AdjacencyLists& rings = this->Mesh.GetTopology().oneRings;
    this->IsFree = Vector::Zero(size);
    for (Index i = 0; i < size; ++i)
    {
      this->IsFree[i] = this->Domain.OwnsVertex(i) && this->IsMovable(i) && !isInner[i];
    }
    this->Domain.UpdateGhosts(this->IsFree);
    Widen(rings, edges, this->IsFree);
    for (Index i = 0; i < size; ++i)
    {
      this->IsFree[i] = this->IsFree[i] && this->Domain.OwnsVertex(i) && this->IsMovable(i);
    }
    this->Domain.UpdateGhosts(this->IsFree);
    this->IsAround = this->IsFree;
    Widen(rings, 2, this->IsAround);
    this->Domain.GetMesh().UniteMaximum(this->IsAround);
  }

  void AddReference()
  {
    std::vector<TravellingCorners> moving;
    for (Index t = 0; t < static_cast<Index>(this->T.rows()); ++t)
    {
      if (this->Domain.OwnsTriangle(t) && HasVertex(this->T, t, this->IsFree))
      {
        moving.push_back(CornersOfTriangle(this->V, this->T, t));
      }
    }
    const Communicator& comm = this->Domain.GetMesh().GetCommunicator();
    const Points& original = this->Mesh.GetPoints();
    const NearTriangles nearMoving(
      ExchangeNear(comm, moving, ReachOf(original, this->T, this->Domain, this->Distance), true));
    for (Index t = 0; t < static_cast<Index>(this->T.rows()); ++t)
    {
      if (this->Domain.OwnsTriangle(t) &&
          nearMoving.IsNear(WideBoxOf(original, this->T, t, this->Distance)))
      {
        this->Part.reference.push_back(RowsOf(this->Domain.GetMesh(), this->T, t));
        this->Reference.push_back(CornersOfTriangle(original, this->T, t));
        this->Use(t);
      }
    }
  }

  void AddTriangles()
  {
    const Communicator& comm = this->Domain.GetMesh().GetCommunicator();
    const NearTriangles reference(ExchangeNear(
      comm, this->Reference, ReachOf(this->V, this->T, this->Domain, this->Distance), true));
    for (Index t = 0; t < static_cast<Index>(this->T.rows()); ++t)
    {
      if (this->Domain.OwnsTriangle(t) &&
          (HasVertex(this->T, t, this->IsAround) ||
            reference.IsNear(WideBoxOf(this->V, this->T, t, this->Distance))))
      {
        this->Part.triangles.push_back({ RowsOf(this->Domain.GetMesh(), this->T, t), comm.Rank() });
        this->Use(t);
      }
    }
  }

  void Use(Index t)
  {
    this->IsUsed.resize(this->Mesh.GetTopology().vertices, 0);
    for (const Index i : this->T.row(t))
    {
      this->IsUsed[i] = 1;
    }
  }

  void AddVertices()
  {
    const FeatureLines& lines = *this->Plan.lines;
    const DistributedMesh& mesh = this->Domain.GetMesh();
    for (Index i = 0; i < static_cast<Index>(this->IsUsed.size()); ++i)
    {
      if (!this->IsUsed[i])
      {
        continue;
      }
      SeamVertex vertex{};
      vertex.row = mesh.GetRow(i);
      Eigen::Map<Vector3>(vertex.original) = this->Mesh.GetPoints().row(i);
      Eigen::Map<Vector3>(vertex.position) = this->V.row(i);
      Eigen::Map<Vector3>(vertex.tangent) = lines.tangents.row(i);
      vertex.positionWeight = this->Plan.problem.position.weights[i];
      vertex.sender = mesh.GetCommunicator().Rank();
      vertex.isOwned = this->Domain.OwnsVertex(i);
      vertex.isFree = this->IsFree[i] != 0;
      vertex.pointClass = lines.pointClass[i];
      for (int k = 0; k < 2; ++k)
      {
        const bool isOnLine = vertex.isOwned && vertex.pointClass == FeatureLines::EDGE;
        vertex.neighbours[k] = isOnLine ? mesh.GetRow(lines.lines->Begin(i)[k]) : -1;
      }
      this->Part.vertices.push_back(vertex);
    }
  }

  const MeshQuantities& Mesh;
  const Triangles& T;
  const DistributedSubdomain& Domain;
  const RunPlan& Plan;
  const Points& V;
  const double Distance;
  Vector IsFree;   ///< moves
  Vector IsAround; ///< within two edges of these, whose Laplacians count
  Mask IsUsed;     ///< by a triangle that is sent
  std::vector<TravellingCorners> Reference;
  SeamPart Part;
};
}

RowTriple RowsOf(const DistributedMesh& mesh, const Triangles& triangles, Index t)
{
  return { mesh.GetRow(triangles(t, 0)), mesh.GetRow(triangles(t, 1)),
    mesh.GetRow(triangles(t, 2)) };
}

Vector FindInnerVertices(
  const MeshQuantities& mesh, const DistributedSubdomain& subdomain, double distance)
{
  const Points& V = mesh.GetPoints();
  const Triangles& T = mesh.GetTriangles();
  std::vector<TravellingCorners> own;
  for (Index t = 0; t < static_cast<Index>(T.rows()); ++t)
  {
    if (subdomain.OwnsTriangle(t))
    {
      own.push_back(CornersOfTriangle(V, T, t));
    }
  }
  const NearTriangles others(ExchangeNear(
    subdomain.GetMesh().GetCommunicator(), own, ReachOf(V, T, subdomain, 2 * distance), false));
  Vector isInner = Vector::Ones(mesh.GetTopology().vertices);
  for (Index t = 0; t < static_cast<Index>(T.rows()); ++t)
  {
    if (!subdomain.OwnsTriangle(t) || others.IsNear(WideBoxOf(V, T, t, 2 * distance)))
    {
      isInner(T.row(t)).setZero();
    }
  }
  for (Index i = 0; i < static_cast<Index>(isInner.size()); ++i)
  {
    isInner[i] = isInner[i] && subdomain.OwnsVertex(i);
  }
  return isInner;
}

SeamPart SelectSeam(const MeshQuantities& mesh, const DistributedSubdomain& subdomain,
  const RunPlan& plan, const Vector& isInner, int edges, const Points& V, double distance)
{
  return Selection(mesh, subdomain, plan, V, distance).Select(isInner, edges);
}
}
