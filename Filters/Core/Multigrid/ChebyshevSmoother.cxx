// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Multigrid/ChebyshevSmoother.h"

namespace lmo
{
std::vector<ChebyshevSmoother::Step> ChebyshevSmoother::MakeSteps(int degree)
{
  constexpr float share = 8; // of the range of eigenvalues that is not left to coarser levels
  const float upper = LargestEigenvalue;
  const float lower = upper / share;
  const float centre = (upper + lower) / 2;
  const float radius = (upper - lower) / 2;
  std::vector<Step> steps{ { 0, 1 / centre } };
  float rho = radius / centre;
  for (int step = 1; step < degree; ++step)
  {
    const float nextRho = 1 / (2 * centre / radius - rho);
    steps.push_back({ nextRho * rho, 2 * nextRho / radius });
    rho = nextRho;
  }
  return steps;
}
}
