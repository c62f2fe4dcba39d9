// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_DependentCertificates_h
#define lmo_DependentCertificates_h

#include "Core/Deviation/DeviationCertificates.h"

#include <unordered_map>

namespace lmo
{
/// For each triangle of a second mesh, the triangles whose proofs need it. A proof that is replaced
/// may stay listed.
class DependentProofs
{
public:
  bool IsEmpty() const { return this->Listed.offsets.empty(); }

  void Clear();

  /// Lists all proofs.
  void Build(const DistanceProofs& proofs);

  /// Lists a new proof of one triangle.
  void Add(Index triangle, const DistanceProofs::Proof& proof);

  /// The triangles whose proofs need one of \a used, each once.
  std::vector<Index> Find(const std::vector<Index>& used) const;

private:
  AdjacencyLists Listed;
  std::unordered_map<Index, std::vector<Index>> Added; ///< since Build()
};
}

#endif
