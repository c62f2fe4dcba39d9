// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/PrincipalCurvatures.h"

#include "Core/Base/Threading.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>

namespace lmo
{
namespace
{
constexpr int LargestDegree = 4;
constexpr int LeastDegree = 2;
constexpr int Rings = 3;
constexpr int LargestNumberOfRings = 6; ///< where vertices are few
constexpr int Enough = 28;              ///< vertices, with which no further ring counts
constexpr int LargestPatch = 96;        ///< vertices that count at most
constexpr int LargestShare = 16;        ///< neighbours of one vertex that count at most
constexpr double LeastCosine = 0.3;     ///< between the normals of vertices that count
constexpr double LeastPivot = 1e-6;     ///< of a matrix of full rank, relative to the largest

/// Number of monomials in two variables up to a degree.
constexpr int Monomials(int degree)
{
  return (degree + 1) * (degree + 2) / 2;
}

using Matrix2 = Eigen::Matrix2d;
using Directions = Eigen::Matrix<double, 2, 3, Eigen::RowMajor>;
using PatchPoints = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor, LargestPatch, 3>;

/// The vertices around a vertex, itself first, ring by ring.
class Patch
{
public:
  Patch(const Points& vertexNormals, const AdjacencyLists& rings, Index centre)
    : Normals(vertexNormals)
    , OneRings(rings)
  {
    this->Ids[0] = centre;
    int begin = 0;
    for (int ring = 0; ring < LargestNumberOfRings; ++ring)
    {
      const int end = this->Count;
      if (begin == end || (ring >= Rings && end >= Enough))
      {
        return;
      }
      for (; begin < end; ++begin)
      {
        this->AddNeighbours(this->Ids[begin]);
      }
    }
  }

  /// Relative to the centre.
  PatchPoints PointsOf(const Points& V) const
  {
    PatchPoints points(this->Count, 3);
    for (int k = 0; k < this->Count; ++k)
    {
      points.row(k) = V.row(this->Ids[k]) - V.row(this->Ids[0]);
    }
    return points;
  }

private:
  /// Neighbours at equal steps along the one-ring, if it is long.
  void AddNeighbours(Index i)
  {
    const Index size = this->OneRings.Size(i);
    const Index share = std::min<Index>(size, LargestShare);
    for (Index k = 0; k < share; ++k)
    {
      const Index j = this->OneRings.Begin(i)[std::int64_t(size) * k / share];
      if (this->Count < LargestPatch && this->IsNew(j))
      {
        this->Ids[this->Count++] = j;
      }
    }
  }

  bool IsNew(Index j) const
  {
    const Index* end = this->Ids.data() + this->Count;
    return this->Normals.row(j).dot(this->Normals.row(this->Ids[0])) > LeastCosine &&
           std::find(this->Ids.data(), end, j) == end;
  }

  const Points& Normals;
  const AdjacencyLists& OneRings;
  std::array<Index, LargestPatch> Ids;
  int Count = 1;
};

/// The height over the tangent plane as a function of two coordinates in it, at the vertex.
struct HeightField
{
  Directions axes; ///< of the coordinates, orthonormal
  Vector3 normal;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  Matrix2 hessian = Matrix2::Zero();
};

/// Sets the axes to the principal axes of the points in the tangent plane, the longer one first.
/// Polynomials of coordinates that are divided by the result are well conditioned, also on long
/// thin triangles.
/// \return root mean square of the points along each axis
Eigen::Vector2d AlignAxes(const PatchPoints& points, HeightField& surface)
{
  surface.axes.row(0) = surface.normal.unitOrthogonal();
  surface.axes.row(1) = surface.normal.cross(surface.axes.row(0));
  const Eigen::Matrix<double, Eigen::Dynamic, 2, 0, LargestPatch, 2> flat =
    points * surface.axes.transpose();
  const Matrix2 scatter = flat.transpose() * flat / double(points.rows());
  const Eigen::SelfAdjointEigenSolver<Matrix2> solver(scatter);
  surface.axes = Directions(solver.eigenvectors().rowwise().reverse().transpose() * surface.axes);
  return solver.eigenvalues().reverse().cwiseMax(0).cwiseSqrt();
}

using Basis = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, LargestPatch,
  Monomials(LargestDegree)>;

/// All monomials of u and v up to the degree, one per column: 1, u, v, u^2, u v, v^2, ...
Basis EvaluateMonomials(const PatchPoints& points, int degree)
{
  Basis basis(points.rows(), Monomials(degree));
  basis.col(0).setOnes();
  for (int d = 1; d <= degree; ++d)
  {
    const int first = Monomials(d - 1);
    const int before = Monomials(d - 2);
    for (int k = 0; k < d; ++k)
    {
      basis.col(first + k) = basis.col(before + k).cwiseProduct(points.col(0));
    }
    basis.col(first + d) = basis.col(first - 1).cwiseProduct(points.col(1));
  }
  return basis;
}

/// Fits the height to u and v, with respect to which the derivatives are.
/// \param points u, v and height of each
/// \return false if the points do not determine a polynomial of this degree
bool FitPolynomial(const PatchPoints& points, int degree, HeightField& surface)
{
  // A third more points than coefficients damp the noise.
  const int needed = degree > LeastDegree ? Monomials(degree) * 4 / 3 : Monomials(degree);
  if (points.rows() < needed)
  {
    return false;
  }
  Basis basis = EvaluateMonomials(points, degree);
  const Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, Monomials(LargestDegree)>
    lengths = basis.colwise().norm();
  basis.array().rowwise() /= lengths.array();
  Eigen::ColPivHouseholderQR<Basis> factors(basis);
  factors.setThreshold(LeastPivot);
  if (factors.rank() < basis.cols())
  {
    return false;
  }
  const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, Monomials(LargestDegree), 1> coefficients =
    factors.solve(points.col(2)).cwiseQuotient(lengths.transpose());
  surface.gradient << coefficients[1], coefficients[2];
  surface.hessian << 2 * coefficients[3], coefficients[4], coefficients[4], 2 * coefficients[5];
  return true;
}

/// \param points relative to the vertex
/// \param surface with its normal, gets the rest
/// \return false if the points do not determine a polynomial of degree 2
bool FitHeights(PatchPoints points, HeightField& surface)
{
  const Eigen::Vector2d units = AlignAxes(points, surface);
  if (!(units[1] > LeastPivot * units[0]))
  {
    return false;
  }
  Matrix3 frame;
  frame << surface.axes.row(0) / units[0], surface.axes.row(1) / units[1], surface.normal;
  points *= frame.transpose();
  bool isFitted = false;
  for (int degree = LargestDegree; degree >= LeastDegree && !isFitted; --degree)
  {
    isFitted = FitPolynomial(points, degree, surface);
  }
  const Eigen::Vector2d scale = units.cwiseInverse();
  surface.gradient = scale.asDiagonal() * surface.gradient;
  surface.hessian = scale.asDiagonal() * surface.hessian * scale.asDiagonal();
  return isFitted;
}

/// Sets row i of the result from the fundamental forms I and II of the height field (do Carmo,
/// Differential Geometry of Curves and Surfaces, 3.3), unless they are not finite.
/// \param diagonal of the bounding box
void SetCurvatures(
  const HeightField& surface, double diagonal, Index i, PrincipalCurvatures& result)
{
  const Eigen::Vector2d& gradient = surface.gradient;
  const Matrix2 first = Matrix2::Identity() + gradient * gradient.transpose();
  const Matrix2 second = -surface.hessian / std::sqrt(1 + gradient.squaredNorm());
  const Directions tangents = surface.axes + gradient * surface.normal;
  const Vector3 normal = (surface.normal - gradient.transpose() * surface.axes).normalized();
  if (!first.allFinite() || !second.allFinite())
  {
    return;
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix2> solver(second, first);
  Vector3 direction = (solver.eigenvectors().col(1).transpose() * tangents).normalized();
  if (!direction.allFinite() || !solver.eigenvalues().allFinite())
  {
    return;
  }
  Eigen::Index largest;
  direction.cwiseAbs().maxCoeff(&largest);
  direction *= direction[largest] < 0 ? -1 : 1;
  const auto withoutRoundOff = [&](double curvature)
  { return std::abs(curvature) * diagonal < 1e-6 ? 0 : curvature; };
  result.first[i] = withoutRoundOff(solver.eigenvalues()[1]);
  result.second[i] = withoutRoundOff(solver.eigenvalues()[0]);
  result.firstDirections.row(i) = direction;
  result.secondDirections.row(i) = normal.cross(direction);
}
}

PrincipalCurvatures::PrincipalCurvatures(Index vertices)
  : first(Vector::Zero(vertices))
  , second(Vector::Zero(vertices))
  , firstDirections(Points::Zero(vertices, 3))
  , secondDirections(Points::Zero(vertices, 3))
{
}

PrincipalCurvatures ComputePrincipalCurvatures(const Points& V, const Points& vertexNormals,
  const MeshTopology& topology, double diagonal, ProgressMonitor& monitor)
{
  PrincipalCurvatures result(topology.vertices);
  InterruptibleFor(topology.vertices, monitor,
    [&](Index i)
    {
      HeightField surface;
      surface.normal = vertexNormals.row(i);
      const Patch patch(vertexNormals, topology.oneRings, i);
      if (!surface.normal.isZero(0) && FitHeights(patch.PointsOf(V), surface))
      {
        SetCurvatures(surface, diagonal, i, result);
      }
    });
  return result;
}
}
