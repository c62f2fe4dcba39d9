// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RandomMeshes.h"

#include "Checks.h"

using namespace lmo;

TestMesh MakeRandomMesh(Seeded& seeded)
{
  const auto meshes = AllTestMeshes();
  TestMesh mesh = meshes[seeded.Take(static_cast<int>(meshes.size()))].second;
  const double amplitude = (1 + seeded.Take(3)) * 0.05;
  mesh.V += amplitude * seeded.Vectors(mesh.V.rows());
  const auto anyTriangle = [&] { return seeded.Take(static_cast<int>(mesh.T.rows())); };
  for (int fault = seeded.Take(4); fault > 0; --fault)
  {
    const Index t = anyTriangle();
    switch (seeded.Take(3))
    {
      case 0:
        mesh.T.row(t) = mesh.T.row(anyTriangle());
        break;
      case 1:
        mesh.T.row(t).reverseInPlace();
        break;
      default:
        mesh.T(t, 0) = seeded.Take(static_cast<int>(mesh.V.rows()));
    }
  }
  return mesh;
}

int CheckSeeds(
  int argc, char* argv[], unsigned count, const std::function<std::string(unsigned)>& faultsOf)
{
  const unsigned first = argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 1;
  const unsigned last = argc > 1 ? first : count / Thinning;
  Checks c;
  for (unsigned seed = first; seed <= last; ++seed)
  {
    std::string faults;
    try
    {
      faults = faultsOf(seed);
    }
    catch (const std::exception& error)
    {
      faults = error.what();
    }
    if (!faults.empty() || seed == last)
    {
      c.Equal("seed " + std::to_string(seed) + ":" + faults, faults, "");
    }
  }
  return c.Result();
}
