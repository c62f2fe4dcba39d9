// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DeviationCertificates_h
#define lmo_DeviationCertificates_h

#include "Core/Deviation/OverlayBound.h"
#include "Core/Mesh/TriangleBvh.h"

namespace lmo
{
/// Proofs that each triangle of one mesh lies within a distance of a second mesh. Both meshes have
/// the same triangles and positions of their own, either of which may move.
class DistanceProofs
{
public:
  /// A triangle without a proof, and one of the second mesh that is close to where it fails, or -1.
  struct Failure
  {
    Index triangle;
    Index close;
  };

  /// What is known of one triangle.
  struct Proof
  {
    Index seed;              ///< triangle of the second mesh over its centre
    HeightRange heights;     ///< of the second mesh over it
    std::vector<Index> used; ///< triangles of the second mesh that the proof needs
  };

  /// Begins with equal positions.
  explicit DistanceProofs(Index triangles);

  /// Proves anew that the triangles of \a list with the corners in \a V are within \a distance of
  /// \a mesh.
  /// \param tree of \a mesh; refitted if it is needed
  /// \throw Cancelled if the monitor says so; the proofs are of no use then.
  std::vector<Failure> Check(const std::vector<Index>& list, const Points& V,
    const SurfaceView& mesh, TriangleTree& tree, double distance, Monitor& monitor);

  const Proof& Get(Index triangle) const { return this->Proofs[triangle]; }
  void Set(Index triangle, Proof proof) { this->Proofs[triangle] = std::move(proof); }

  /// Copies all proofs of as many triangles.
  void Assign(const DistanceProofs& other);

  Index Size() const { return static_cast<Index>(this->Proofs.size()); }

  /// The triangles whose proofs need one of the marked ones.
  std::vector<Index> FindDependent(const Mask& isMarked) const;

  /// The largest bound.
  double GetBound() const;

private:
  std::vector<Proof> Proofs;
};
}

#endif
