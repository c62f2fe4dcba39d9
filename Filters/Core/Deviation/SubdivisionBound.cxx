// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Deviation/SubdivisionBound.h"

#include <algorithm>

namespace lmo
{
namespace
{
constexpr int DeepestDivision = 6;

/// A point and the triangle of the mesh that is closest to it.
struct Sample
{
  Vector3 point;
  Index closest;
};

class Division
{
public:
  Division(Subdivision& subdivision, double distance, Nearness& result)
    : Tree(subdivision.tree)
    , SearchesLeft(subdivision.searchesLeft)
    , Distance(distance)
    , Result(result)
  {
  }

  /// False if no triangle is close enough to x, or if there are no searches left.
  bool Find(const Vector3& x, Index hint, Sample& sample)
  {
    if (this->SearchesLeft-- <= 0)
    {
      this->Result.failure = hint;
      return false;
    }
    sample = { x, this->Tree.FindClosest(x, this->Distance, hint).triangle };
    if (sample.closest < 0)
    {
      this->Result.failure = this->Tree.FindClosest(x, 4 * this->Distance, hint).triangle;
    }
    return sample.closest >= 0;
  }

  bool Test(const Sample& a, const Sample& b, const Sample& c, int depth)
  {
    for (const Index t : { a.closest, b.closest, c.closest })
    {
      if (this->Reaches(t, a.point) && this->Reaches(t, b.point) && this->Reaches(t, c.point))
      {
        this->Result.used.push_back(t);
        return true;
      }
    }
    if (depth == DeepestDivision)
    {
      this->Result.failure = a.closest;
      return false;
    }
    Sample ab;
    Sample bc;
    Sample ca;
    return this->Find(0.5 * (a.point + b.point), a.closest, ab) &&
           this->Find(0.5 * (b.point + c.point), b.closest, bc) &&
           this->Find(0.5 * (c.point + a.point), c.closest, ca) &&
           this->Test(ab, bc, ca, depth + 1) && this->Test(a, ab, ca, depth + 1) &&
           this->Test(b, bc, ab, depth + 1) && this->Test(c, ca, bc, depth + 1);
  }

private:
  bool Reaches(Index t, const Vector3& x) const
  {
    return this->Tree.SquaredDistance(t, x) <= this->Distance * this->Distance;
  }

  const TriangleBvh& Tree;
  int& SearchesLeft;
  const double Distance;
  Nearness& Result;
};
}

Nearness TestBySubdivision(
  const TriangleCorners& triangle, Subdivision& subdivision, double distance, Index hint)
{
  Nearness result;
  Division division(subdivision, distance, result);
  Sample a;
  Sample b;
  Sample c;
  result.isProven = division.Find(triangle.row(0), hint, a) &&
                    division.Find(triangle.row(1), hint, b) &&
                    division.Find(triangle.row(2), hint, c) && division.Test(a, b, c, 0);
  std::sort(result.used.begin(), result.used.end());
  result.used.erase(std::unique(result.used.begin(), result.used.end()), result.used.end());
  return result;
}
}
