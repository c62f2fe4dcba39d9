// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RandomMeshes_h
#define RandomMeshes_h

#include "MeshFixtures.h"

#include "Core/Optimizer/Optimizer.h"

#include <functional>

/// Choices from a seed, the same with every standard library.
class Seeded
{
public:
  explicit Seeded(unsigned seed)
    : Engine(seed)
  {
  }

  /// 0 to \a count - 1.
  int Take(int count) { return static_cast<int>(this->Engine() % unsigned(count)); }

  /// \a least to \a most.
  double Number(double least, double most)
  {
    return least + (most - least) * (this->Engine() / 4294967295.0);
  }

  lmo::Points Vectors(Eigen::Index rows)
  {
    return lmo::Points::NullaryExpr(rows, 3, [this] { return this->Number(-1, 1); });
  }

private:
  std::mt19937 Engine;
};

/// What a seed gives.
struct Sample
{
  TestMesh mesh;
  lmo::VertexArrays arrays;
  lmo::OptimizerOptions options;
};

/// Faults of one seed, an empty list if there are none.
class Findings
{
public:
  void AddIf(bool isFault, const std::string& what)
  {
    if (isFault)
    {
      this->Text += " " + what + ";";
    }
  }
  std::string Text;
};

/// A mesh of any kind, its points moved so that no two curvatures are equal but for round-off, some
/// triangles doubled, reversed or put elsewhere.
TestMesh MakeRandomMesh(Seeded& seeded);

/// Looks for faults of seeds 1 to \a count, fewer with a sanitizer, or of the one that is the first
/// argument.
/// \param faultsOf text for a seed, empty if there are none
/// \return exit code
int CheckSeeds(
  int argc, char* argv[], unsigned count, const std::function<std::string(unsigned)>& faultsOf);

#endif
