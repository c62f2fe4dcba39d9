// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationCertificates_h
#define lmo_DeviationCertificates_h

#include "Core/Deviation/OverlayBound.h"
#include "Core/Mesh/TriangleBvh.h"

#include <algorithm>
#include <functional>
#include <unordered_map>

namespace lmo
{
/// How far each triangle of a mesh may be from another mesh: the distance allowed, or more where it
/// began farther away.
class DistanceLimits
{
public:
  DistanceLimits(double distance, Index triangles)
    : Distance(distance)
    , Triangles(triangles)
  {
  }

  double operator()(Index triangle) const
  {
    return this->Raised.empty() ? this->Distance : this->Raised[triangle];
  }

  bool IsRaised(Index triangle) const { return (*this)(triangle) > this->Distance; }

  void Raise(Index triangle, double limit)
  {
    this->Raised.resize(this->Triangles, this->Distance);
    this->Raised[triangle] = limit;
  }

  /// Number of triangles with a limit of their own.
  Index Count() const
  {
    return static_cast<Index>(std::count_if(this->Raised.begin(), this->Raised.end(),
      [this](double limit) { return limit > this->Distance; }));
  }

private:
  double Distance;
  Index Triangles;
  std::vector<double> Raised; ///< empty if all limits are the distance
};

/// Certificates that each triangle of one mesh lies within a distance of a second mesh, either of
/// which may move.
class DeviationCertificates
{
public:
  /// A triangle without a certificate, and one of the second mesh that is close to where it fails,
  /// or -1.
  struct Failure
  {
    Index triangle;
    Index close;
  };

  /// What is known of one triangle.
  struct Certificate
  {
    Index seed;              ///< triangle of the second mesh over its centre
    HeightRange heights;     ///< of the second mesh over it
    std::vector<Index> used; ///< triangles of the second mesh that the certificate needs
  };

  /// How hard a check tries.
  enum Extent
  {
    MANY_VERTICES,  ///< each triangle gets all that a proof may need
    SINGLE_VERTICES ///< what takes long to prove is a failure: there are other places to try
  };

  /// What is kept of certificates.
  enum Content
  {
    BOUNDS,         ///< all but Certificate::used
    BOUNDS_AND_USED ///< all
  };

  /// Two meshes with the same triangles in the same places.
  DeviationCertificates(Index triangles, Content content);

  /// Nothing is certified yet.
  /// \param seeds for each triangle one of the second mesh that is close to its centre
  DeviationCertificates(const std::vector<Index>& seeds, Content content);

  /// Drops triangles from a list that need no proof any more, as others have failed.
  using Postpone =
    std::function<void(const std::vector<Failure>& failures, std::vector<Index>& list)>;

  /// Proves anew that the triangles of \a list of the mesh \a from are within their limits of the
  /// mesh \a to.
  /// \param tree of \a to; refitted if it is needed
  /// \param postpone called before each part of the proofs by subdivision, with what has failed so
  /// far and what is still to be proven; may be empty
  /// \throw Cancelled if the monitor says so; the certificates are of no use then.
  std::vector<Failure> Check(const std::vector<Index>& list, const SurfaceView& from,
    const SurfaceView& to, TriangleBvh& tree, const DistanceLimits& limits, Extent extent,
    const Postpone& postpone, ProgressMonitor& monitor);

  const Certificate& Get(Index triangle) const { return this->Certificates[triangle]; }
  void Set(Index triangle, Certificate certificate)
  {
    this->Certificates[triangle] = std::move(certificate);
  }

  Index Size() const { return static_cast<Index>(this->Certificates.size()); }

  /// Number of proofs that Check() has tried, and of searches for closest points in those of
  /// SINGLE_VERTICES: about proportional to its time.
  std::int64_t GetEffort() const { return this->Effort; }

  /// The triangles whose certificates need one of the marked ones.
  std::vector<Index> FindDependent(const Mask& isMarked) const;

  /// The largest bound.
  double GetBound() const;

private:
  /// Proves some triangles, by overlays and by subdivisions with so many searches, or by overlays
  /// alone without them.
  /// \param list is left with those that are unclear
  std::vector<Failure> Prove(std::vector<Index>& list, const SurfaceView& from,
    const SurfaceView& to, const TriangleBvh& tree, const DistanceLimits& limits, int searches,
    ProgressMonitor& monitor);

  std::vector<Certificate> Certificates;
  Content Kept;
  std::int64_t Effort = 0;
};

/// For each triangle of a second mesh, the triangles whose certificates need it. A certificate that
/// is replaced may stay listed.
class DependentCertificates
{
public:
  bool IsEmpty() const { return this->Listed.offsets.empty(); }

  void Clear();

  /// Lists all certificates.
  /// \param triangles of the second mesh
  void Build(const DeviationCertificates& certificates, Index triangles);

  /// Lists a new certificate of one triangle.
  void Add(Index triangle, const DeviationCertificates::Certificate& certificate);

  /// The triangles whose certificates need one of \a used, each once.
  std::vector<Index> Find(const std::vector<Index>& used) const;

private:
  AdjacencyLists Listed;
  std::unordered_map<Index, std::vector<Index>> Added; ///< since Build()
};
}

#endif
