// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "ParallelTesting.h"

#include "Core/Base/EmpiricalDistribution.h"
#include "Parallel/DistributedRanking.h"

#include <algorithm>
#include <cmath>

using namespace lmo;

namespace
{
/// Values over many magnitudes, with ties and zeros.
std::vector<double> MakeValues(int count)
{
  Random random;
  std::vector<double> values;
  for (int k = 0; k < count; ++k)
  {
    const double value = std::exp(20 * random());
    values.push_back(k % 5 == 0 ? 0 : k % 7 == 0 ? 1.5 : value);
  }
  return values;
}

/// The part of the values that a process has; the first has none if there are others.
std::vector<double> TakePart(const std::vector<double>& values, int rank, int processes)
{
  std::vector<double> part;
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    if (static_cast<int>(k) % std::max(processes - 1, 1) == std::max(rank - 1, 0) &&
        (rank > 0 || processes == 1))
    {
      part.push_back(values[k]);
    }
  }
  return part;
}

void CheckQuantiles(MpiJob& job, const Communicator& comm, Checks& c, int count)
{
  const std::vector<double> values = MakeValues(count);
  const std::vector<double> part = TakePart(values, job.Rank(), job.Size());
  double error = 0;
  for (const double q : { 0.0, 0.1, 0.25, 0.5, 0.75, 1.0 })
  {
    error = Larger(error, std::abs(DistributedQuantile(comm, part, q) - Quantile(values, q)));
  }
  c.Error("quantiles of " + std::to_string(count) + " values are those of all values",
    job.Largest(error), 0);
}

void CheckShares(MpiJob& job, const Communicator& comm, Checks& c, int count)
{
  const std::vector<double> values = MakeValues(count);
  const std::vector<double> part = TakePart(values, job.Rank(), job.Size());
  const auto size = static_cast<Index>(part.size());
  // Two values that do not count: one of the others and one that is nowhere else.
  Vector asked(size + 2);
  asked << Eigen::Map<const Vector>(part.data(), size), 1.5, 0.7;
  Mask counts(size + 2, 1);
  counts[size] = counts[size + 1] = 0;
  const Vector shares = DistributedShares(comm, asked, counts);
  double error = 0;
  for (Index i = 0; i < asked.size(); ++i)
  {
    const auto below =
      std::count_if(values.begin(), values.end(), [&](double value) { return value <= asked[i]; });
    error = Larger(error, std::abs(shares[i] - double(below) / std::max(count, 1)));
  }
  c.Error("shares of " + std::to_string(count) + " values are those of all values",
    job.Largest(error), 0);
}
}

int TestDistributedRanking(int argc, char* argv[])
{
  MpiJob job(argc, argv);
  Checks c;
  const Communicator comm(MPI_COMM_WORLD);
  for (const int count : { 0, 1, 2, 3, 1000, 20001 })
  {
    CheckQuantiles(job, comm, c, count);
    CheckShares(job, comm, c, count);
  }
  return c.Result();
}
