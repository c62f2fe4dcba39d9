// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationCertificates_h
#define lmo_DeviationCertificates_h

#include "Core/Deviation/OverlayBound.h"
#include "Core/Mesh/TriangleBvh.h"

#include <unordered_map>

namespace lmo
{
/// Certificates that each triangle of one mesh lies within a distance of a second mesh. Both meshes
/// have the same triangles and positions of their own, either of which may move.
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

  /// What a check looks for, and how hard.
  enum Extent
  {
    ALL_FAILURES, ///< each triangle gets all that a proof may need
    FIRST_FAILURE ///< it ends at one failure, and what takes long to prove is one, too
  };

  /// Begins with equal positions.
  explicit DeviationCertificates(Index triangles);

  /// Proves anew that the triangles of \a list with the corners in \a V are within \a distance of
  /// \a mesh.
  /// \param tree of \a mesh; refitted if it is needed
  /// \throw Cancelled if the monitor says so; the certificates are of no use then.
  std::vector<Failure> Check(const std::vector<Index>& list, const Points& V,
    const SurfaceView& mesh, TriangleBvh& tree, double distance, Extent extent,
    ProgressMonitor& monitor);

  const Certificate& Get(Index triangle) const { return this->Certificates[triangle]; }
  void Set(Index triangle, Certificate certificate)
  {
    this->Certificates[triangle] = std::move(certificate);
  }

  /// Copies all certificates of as many triangles.
  void Assign(const DeviationCertificates& other);

  Index Size() const { return static_cast<Index>(this->Certificates.size()); }

  /// Number of proofs that Check() has tried, and of searches for closest points where it looked
  /// for the FIRST_FAILURE: about proportional to its time.
  std::int64_t GetEffort() const { return this->Effort; }

  /// The triangles whose certificates need one of the marked ones.
  std::vector<Index> FindDependent(const Mask& isMarked) const;

  /// The largest bound.
  double GetBound() const;

private:
  std::vector<Failure> FindAll(const std::vector<Index>& list, const Points& V,
    const SurfaceView& mesh, TriangleBvh& tree, double distance, ProgressMonitor& monitor);
  std::vector<Failure> FindFirst(const std::vector<Index>& list, const Points& V,
    const SurfaceView& mesh, TriangleBvh& tree, double distance);

  std::vector<Certificate> Certificates;
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
  void Build(const DeviationCertificates& certificates);

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
