// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include <cmath>

using namespace lmo;

namespace
{
/// |L 1|
double RowSumError(const Laplacian& L)
{
  return LargestMagnitude(Apply(L, Points::Ones(L.rowScale.size(), 3)));
}

double Asymmetry(const Laplacian& L)
{
  const Eigen::MatrixXd K = StiffnessMatrix(L);
  return LargestMagnitude(K - K.transpose()) / LargestMagnitude(K);
}

/// Difference between L and -G K, entry by entry.
double FactorError(const Laplacian& L)
{
  const Eigen::MatrixXd K = StiffnessMatrix(L);
  const Eigen::MatrixXd dense = DenseMatrix(L);
  return LargestMagnitude(dense + L.rowScale.asDiagonal() * K) / LargestMagnitude(dense);
}

/// Distance of V + L_u V from the mean of each one-ring.
double CentroidError(const TestMesh& mesh)
{
  Points centroids = mesh.V;
  const auto neighbours = Neighbours(mesh);
  for (std::size_t i = 0; i < neighbours.size(); ++i)
  {
    if (!neighbours[i].empty())
    {
      centroids.row(i) = mesh.V(neighbours[i], Eigen::indexing::all).colwise().mean();
    }
  }
  return MaximumDistance(mesh.V + Apply(OperatorFixtures(mesh).uniform, mesh.V), centroids);
}

/// Maximum of |L f - expected| over the inner vertices.
double InnerError(const TestMesh& mesh, const Laplacian& L, const Vector& f, double expected)
{
  const Vector Lf = Apply(L, f.replicate(1, 3)).col(0);
  const std::vector<bool> isBoundary = BoundaryVertices(mesh);
  double error = 0;
  for (Eigen::Index i = 0; i < f.size(); ++i)
  {
    error = Larger(error, isBoundary[i] ? 0 : std::abs(Lf[i] - expected));
  }
  return error;
}

/// L of an arbitrary linear function, which is 0.
double LinearPrecisionError(const TestMesh& mesh, const Laplacian& L)
{
  return InnerError(mesh, L, (mesh.V * Eigen::Vector3d(2, -3, 5)).array() + 7, 0);
}

/// Change of L_c, and of L_ck times the square of the unit, with the unit.
double UnitError(const TestMesh& mesh, double scale)
{
  const OperatorFixtures before(mesh);
  const OperatorFixtures after(Transformed(mesh, scale));
  const Eigen::MatrixXd Lc = DenseMatrix(before.cotangent);
  const Eigen::MatrixXd Lk = DenseMatrix(before.meanCurvature);
  return Larger(LargestMagnitude(DenseMatrix(after.cotangent) - Lc) / LargestMagnitude(Lc),
    LargestMagnitude(DenseMatrix(after.meanCurvature) * scale * scale - Lk) / LargestMagnitude(Lk));
}

/// Change of L V for all three L when the mesh moves far away.
double OffsetError(const TestMesh& mesh)
{
  const TestMesh moved = Transformed(mesh, 1, Vector3(1e8, -1e8, 1e8));
  const OperatorFixtures before(mesh);
  const OperatorFixtures after(moved);
  return MaximumDistance(Apply(before.uniform, mesh.V), Apply(after.uniform, moved.V)) +
         MaximumDistance(Apply(before.cotangent, mesh.V), Apply(after.cotangent, moved.V)) +
         MaximumDistance(Apply(before.meanCurvature, mesh.V), Apply(after.meanCurvature, moved.V));
}

/// L_c of the unit cube: 1/3 along its edges, 0 along the faces' diagonals.
Eigen::MatrixXd CubeLaplacian()
{
  const Points V = Cube().V;
  Eigen::MatrixXd L = -Eigen::MatrixXd::Identity(8, 8);
  for (int i = 0; i < 8; ++i)
  {
    for (int j = 0; j < 8; ++j)
    {
      L(i, j) += (V.row(i) - V.row(j)).squaredNorm() == 1 ? 1.0 / 3 : 0;
    }
  }
  return L;
}

double CubeError(double scale)
{
  return LargestMagnitude(
    DenseMatrix(OperatorFixtures(Transformed(Cube(), scale)).cotangent) - CubeLaplacian());
}

void CheckHandDerivedEntries(Checks& c)
{
  using Row = Eigen::Matrix<double, 1, 5>;
  const OperatorFixtures cross(CrossRing());
  c.Error("L_u of the cross has 1/4 for each neighbour of the centre",
    LargestMagnitude(DenseMatrix(cross.uniform).row(0) - Row(-1, 0.25, 0.25, 0.25, 0.25)), 1e-15);
  c.Error("L_u of the cross has 1/3 for each neighbour at the rim",
    LargestMagnitude(DenseMatrix(cross.uniform).row(1) - Row(1, -3, 1, 0, 1) / 3), 1e-15);
  // An arm of length r between arms of lengths a and b has the weight (a + b) / r.
  c.Error("L_c of the cross has 1/6, 1/3, 1/3, 1/6 around the centre",
    LargestMagnitude(DenseMatrix(cross.cotangent).row(0) - Row(-6, 1, 2, 2, 1) / 6), 1e-15);
  // The boundary edges face the right angles at the centre.
  c.Error("L_c of the cross has 0 along the rim",
    LargestMagnitude(DenseMatrix(cross.cotangent).row(1) - Row(1, -1, 0, 0, 0)), 1e-15);
  // Each triangle gives the centre half its area, together 9/4.
  c.Error("L_ck of the cross is the sum of its cotangents over 4 A",
    LargestMagnitude(DenseMatrix(cross.meanCurvature).row(0) - Row(-9, 1.5, 3, 3, 1.5) / 9), 1e-15);
  c.Error("a boundary edge has the cotangent of one angle",
    std::abs(
      -StiffnessMatrix(OperatorFixtures(EquilateralTriangle()).cotangent)(0, 1) - 1 / std::sqrt(3)),
    1e-15);
  c.Error("L_c of the cube is right", CubeError(1), 1e-15);
  c.Error("L_c of the cube is right in a large unit", CubeError(1e-8), 1e-15);
  c.Error("L_c of the cube is right in a small unit", CubeError(1e8), 1e-15);
}

void CheckFlatMeshes(Checks& c)
{
  const TestMesh grid = Grid(10, 0.3);
  const TestMesh regular = Grid(6, 0);
  c.Error("L_c of a linear function is 0",
    LinearPrecisionError(grid, OperatorFixtures(grid).cotangent), 1e-13);
  c.Error("L_ck of a linear function is 0",
    LinearPrecisionError(grid, OperatorFixtures(grid).meanCurvature), 1e-13);
  c.Error("L_c V of a flat ring is 0",
    Apply(OperatorFixtures(CrossRing()).cotangent, CrossRing().V).row(0).norm(), 1e-15);
  c.Error("L_u V of a flat ring is not 0 but (1/4, -1/4)",
    (Apply(OperatorFixtures(CrossRing()).uniform, CrossRing().V).row(0) - Vector3(0.25, -0.25, 0))
      .norm(),
    1e-15);
  // Eqn. 7 is half the Laplace-Beltrami operator.
  c.Error("L_ck of x^2 + y^2 is 2",
    InnerError(
      regular, OperatorFixtures(regular).meanCurvature, regular.V.rowwise().squaredNorm(), 2),
    1e-13);
}

void CheckDegenerateMeshes(Checks& c)
{
  TestMesh line = EquilateralTriangle();
  line.V << 0, 0, 0, 1, 0, 0, 2, 0, 0;
  c.Error("L_c of a triangle without area is empty",
    LargestMagnitude(DenseMatrix(OperatorFixtures(line).cotangent)), 0);
  c.Error("L_ck of a triangle without area is empty",
    LargestMagnitude(DenseMatrix(OperatorFixtures(line).meanCurvature)), 0);
  c.Error("L_u of an isolated point is empty",
    LargestMagnitude(DenseMatrix(OperatorFixtures(WithIsolatedPoint(Cube())).uniform).row(0)), 0);
}

/// The clamped edge weights of one triangle; null if there are none.
std::shared_ptr<const Vector> ClampedWeights(const Vector3& a, const Vector3& b, const Vector3& c)
{
  TestMesh mesh = EquilateralTriangle();
  mesh.V << a, b, c;
  const MeshQuantities quantities(mesh.V, mesh.T);
  return CotangentWeights(quantities).GetClampedEdgeWeights();
}

void CheckClampedWeights(Checks& c)
{
  // Cotangents 0, 700 and 1 / 700 across the edges bc, ab and ca.
  const auto clamped = ClampedWeights({ 0, 0, 0 }, { 0, 1, 0 }, { 700, 0, 0 });
  c.True("a needle has clamped weights", clamped != nullptr);
  c.Error(
    "the clamped weight of a needle's short edge is 70", std::abs(clamped->maxCoeff() - 70), 1e-12);
  c.Error("the others are as many times smaller", std::abs(clamped->sum() - 2 * (70 + 1.0 / 7000)),
    1e-12);
  c.True("a cap has none", !ClampedWeights({ -1, 0, 0 }, { 0, -0.001, 0 }, { 1, 0, 0 }));
  c.True("a regular triangle has none", !ClampedWeights({ 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 0.9, 0 }));
}

void CheckLengthScale(Checks& c)
{
  // Five equilateral triangles at each vertex.
  const TestMesh icosahedron = Icosphere(0, 3);
  const double edge = (icosahedron.V.row(0) - icosahedron.V.row(11)).norm();
  c.Error("the icosahedron's length scale is edge^2 / 2",
    std::abs(
      SquaredLengthScale(OperatorFixtures(icosahedron).meanCurvature) / (edge * edge / 2) - 1),
    1e-14);
  // Rows of three neighbours with 4 A / sum of cotangents 1, 2, 4, 100.
  Laplacian L = OperatorFixtures(Tetrahedron()).uniform;
  L.rowScale = Eigen::Vector4d(1.0 / 12, 1.0 / 3, 1.0 / 300, 1.0 / 6);
  c.Error("the length scale is the median", std::abs(SquaredLengthScale(L) - 3), 1e-14);
  L.rowScale[2] = 0;
  c.Error("empty rows do not count in it", std::abs(SquaredLengthScale(L) - 2), 1e-14);
  c.Error("no triangles have no length scale",
    SquaredLengthScale(OperatorFixtures({ Points::Zero(2, 3), Triangles(0, 3) }).meanCurvature), 0);
}

void CheckAllMeshes(Checks& c)
{
  for (const auto& [name, mesh] : AllTestMeshes())
  {
    const OperatorFixtures operators(mesh);
    c.Error("L_u V + V is the ring's centroid: " + name, CentroidError(mesh), 1e-12);
    c.Error("cotangent weights are symmetric: " + name, Asymmetry(operators.cotangent), 1e-15);
    for (const Laplacian& L : { operators.uniform, operators.cotangent, operators.meanCurvature })
    {
      c.Error("L 1 is 0: " + name, RowSumError(L), 0);
      c.Error("L is -G K: " + name, FactorError(L), 1e-15);
    }
    c.Error("L_c and L_ck follow a small unit: " + name, UnitError(mesh, 1e8), 1e-12);
    c.Error("L_c and L_ck follow a large unit: " + name, UnitError(mesh, 1e-8), 1e-12);
  }
  c.Error("L V does not change far away", OffsetError(Irregular(Icosphere(2), 0.08)), 0);
}
}

int TestLaplacian(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("AllMeshes", CheckAllMeshes);
  groups.Run("HandDerivedEntries", CheckHandDerivedEntries);
  groups.Run("FlatMeshes", CheckFlatMeshes);
  groups.Run("DegenerateMeshes", CheckDegenerateMeshes);
  groups.Run("ClampedWeights", CheckClampedWeights);
  groups.Run("LengthScale", CheckLengthScale);
  return groups.Result();
}
