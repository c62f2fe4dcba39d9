// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Multigrid/BasisEnergies.h"

#include "Core/Base/Threading.h"
#include "Core/LeastSquares/PackedProjections.h"

#include <array>
#include <utility>

namespace lmo
{
namespace
{
using Row = PackedRow<float>;

/// Sums |W sum_j c_j w_j P_j|^2 over rows of the energy with their coefficients c and weights W,
/// for each function w.
class RowSums
{
public:
  RowSums(const SparseRows& functions, const PackedProjections<float>& projections)
    : Functions(functions)
    , Project(projections.GetRows())
    , PlaceOf(functions.cols(), -1)
    , Sums(Eigen::ArrayXf::Zero(functions.cols()))
  {
  }

  /// Adds a vertex to the present row.
  void Add(Index j, float coefficient)
  {
    Matrix projection;
    for (int c = 0; c < 3; ++c)
    {
      Row axis = Row::Zero();
      axis[c] = coefficient;
      projection[c] = this->Project(j, axis);
    }
    for (SparseRows::InnerIterator entry(this->Functions, j); entry; ++entry)
    {
      Matrix& sum = this->MatrixOf(static_cast<Index>(entry.col()));
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += entry.value() * projection[c];
      }
    }
  }

  /// Ends the present row.
  void Finish(double squaredWeight)
  {
    for (const auto& [function, matrix] : this->Present)
    {
      const Row squares = matrix[0].square() + matrix[1].square() + matrix[2].square();
      this->Sums[function] += static_cast<float>(squaredWeight) * squares.sum();
      this->PlaceOf[function] = -1;
    }
    this->Present.clear();
  }

  const Eigen::ArrayXf& Get() const { return this->Sums; }

private:
  using Matrix = std::array<Row, 3>;
  using Projection = decltype(std::declval<const PackedProjections<float>&>().GetRows());

  Matrix& MatrixOf(Index function)
  {
    Index& place = this->PlaceOf[function];
    if (place < 0)
    {
      place = static_cast<Index>(this->Present.size());
      this->Present.emplace_back(function, Matrix{ Row::Zero(), Row::Zero(), Row::Zero() });
    }
    return this->Present[place].second;
  }

  const SparseRows& Functions;
  const Projection Project;
  std::vector<std::pair<Index, Matrix>> Present; ///< sum_j c_j w_j P_j of the functions so far
  std::vector<Index> PlaceOf;                    ///< of a function in Present; -1: none
  Eigen::ArrayXf Sums;
};

void AddVertex(const LeastSquaresProblem& problem, Index i, RowSums& sums)
{
  sums.Add(i, 1);
  sums.Finish(problem.position.SquaredWeight(i));
  const double rowWeight = problem.laplacian.RowWeight(i);
  if (rowWeight > 0)
  {
    const Laplacian& L = problem.laplacian.L;
    sums.Add(i, static_cast<float>(WeightSum(L, i)));
    for (Index k = L.rings->offsets[i]; k < L.rings->offsets[i + 1]; ++k)
    {
      sums.Add(L.rings->ids[k], L.edgeWeights ? -static_cast<float>((*L.edgeWeights)[k]) : -1.0f);
    }
    sums.Finish(rowWeight);
  }
}

void AddPolylineRow(const PolylineRow& row, RowSums& sums)
{
  const std::array<Index, 3> vertices{ row.previous, row.vertex, row.next };
  for (int place = 0; place < 3; ++place)
  {
    sums.Add(vertices[place], static_cast<float>(row.Coefficient(place)));
  }
  sums.Finish(row.weight * row.weight);
}
}

Eigen::ArrayXf BasisEnergies(const LeastSquaresProblem& problem, const SparseRows& functions)
{
  constexpr Index parts = 64; // of the vertices, whatever the number of threads
  const PackedProjections<float> projections(problem);
  std::vector<Eigen::ArrayXf> energies(parts);
  ParallelTasks(parts,
    [&](Index part)
    {
      RowSums sums(functions, projections);
      const auto bound = [&](Index k)
      { return static_cast<Index>(std::int64_t(problem.Size()) * k / parts); };
      for (Index i = bound(part); i < bound(part + 1); ++i)
      {
        AddVertex(problem, i, sums);
      }
      energies[part] = sums.Get();
    });
  RowSums sums(functions, projections);
  for (const PolylineRow& row : problem.polylines.rows)
  {
    AddPolylineRow(row, sums);
  }
  Eigen::ArrayXf total = sums.Get();
  for (const Eigen::ArrayXf& energy : energies)
  {
    total += energy;
  }
  return total / 2;
}
}
