// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_MultilevelBasis_h
#define lmo_MultilevelBasis_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/LeastSquares/LeastSquaresProblem.h"
#include "Core/Multigrid/PaddedCsrMatrix.h"

#include <vector>

namespace lmo
{
/// Smooth functions of the vertices on several scales, with their energies: the sum of
/// w w^T / energy over the functions w approximates the inverse of A for long waves (Bramble,
/// Pasciak, Xu 1990). It serves as well for problems with other weights and axes of the same kind.
class MultilevelBasis
{
public:
  /// \param problem with at most two free directions at each vertex
  /// \throw Cancelled if the monitor says so; it is asked a few times for each scale.
  MultilevelBasis(const LeastSquaresProblem& problem, ProgressMonitor& monitor);

  /// Calls body(rows), where rows(i), cheap to copy, is row i of the sum times the residual.
  template <typename Body>
  void WithRows(const PackedPoints<float>& residual, const Body& body)
  {
    if (this->Scales.empty())
    {
      body([](Index) { return PackedRow<float>(PackedRow<float>::Zero()); });
      return;
    }
    this->Expand(residual);
    this->Scales[0].prolongation.WithRows(this->Scales[0].values, body);
  }

private:
  struct Scale
  {
    PaddedCsrMatrix prolongation; ///< to the vertices or the scale before
    PaddedCsrMatrix restriction;  ///< its transpose
    Eigen::ArrayXf inverseEnergies;
    PackedPoints<float> values; ///< of the functions
  };

  /// Computes the values of the functions.
  void Expand(const PackedPoints<float>& residual);

  std::vector<Scale> Scales;
};
}

#endif
