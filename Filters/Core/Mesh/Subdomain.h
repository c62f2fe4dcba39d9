// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Subdomain_h
#define lmo_Subdomain_h

#include "Core/Base/EmpiricalDistribution.h"
#include "Core/Mesh/FeatureLines.h"

#include <Eigen/Geometry>

namespace lmo
{
/// The part of a mesh that this process holds, and what it asks of the other processes. This class
/// is a mesh that one process holds whole; classes derived from it know of others.
///
/// Each vertex and each triangle is owned by one process. A part has all triangles within two edges
/// of the vertices it owns: what the numerics compute for a vertex from its neighbours is right
/// where the vertex is owned. The other vertices are ghosts, whose values come from their owners.
///
/// All processes call Sum() and what follows it in the same order.
class Subdomain
{
public:
  virtual ~Subdomain() = default;

  virtual bool OwnsVertex(Index) const { return true; }
  virtual bool OwnsTriangle(Index) const { return true; }

  /// The vertices of a mask that are owned.
  Mask OwnedOf(Mask mask) const;

  /// Over the processes.
  virtual double Sum(double value) const { return value; }
  virtual Eigen::Array4d Sum(const Eigen::Array4d& values) const { return values; }
  virtual double Maximum(double value) const { return value; }

  /// Bounding box over the processes.
  Eigen::AlignedBox3d Unite(const Eigen::AlignedBox3d& box) const;

  /// The norm of a vector from the norm of this process's part.
  virtual double Norm(double part) const { return part; }

  /// Quantile() of the values of all processes.
  /// \param values >= 0
  virtual double Quantile(std::vector<double> values, double q) const;

  /// CumulativeShares() with the values that count in all processes.
  virtual Vector CumulativeShares(const Vector& values, const Mask& counts) const;

  /// Gives ghosts the values of their owners.
  virtual void UpdateGhosts(Vector&) const {}
  virtual void UpdateGhosts(Points&) const {}
  virtual void UpdateGhosts(Eigen::Array4Xf&) const {}
  virtual void UpdateGhosts(Eigen::Array4Xd&) const {}

  /// Sets the flags of the components that are connected, through other processes, to one whose
  /// flag is set.
  /// \param component connected component, within this process, of each vertex
  /// \param flags one for each component
  virtual void UniteFlags(const std::vector<Index>& component, Mask& flags) const;

  /// Sums the values of components that are connected through other processes: each gets the sum of
  /// all of them.
  /// \param component connected component, within this process, of each vertex
  /// \param values a row for each component, of the vertices and triangles that are owned
  virtual void SumOverComponents(
    const std::vector<Index>& component, Eigen::ArrayXXd& values) const;

  /// ProjectOntoLines() for the vertices that are owned, along lines that may lead through several
  /// processes.
  virtual void ProjectOntoLines(const FeatureLines& features, const Points& V, Points& moved) const;
};
}

#endif
