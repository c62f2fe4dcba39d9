// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"
#include "PolygonFixtures.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Operators/PolygonLaplacian.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <cmath>

using namespace lmo;

namespace
{
CotangentParts WeightsOf(const PolygonMesh& mesh)
{
  return ComputePolygonWeights(mesh.V, mesh.T, mesh.polygons);
}

Laplacian CotangentOf(const PolygonMesh& mesh)
{
  const CotangentParts weights = WeightsOf(mesh);
  return CotangentLaplacian(weights.rings, weights.edgeWeights);
}

Laplacian MeanCurvatureOf(const PolygonMesh& mesh)
{
  const CotangentParts weights = WeightsOf(mesh);
  return MeanCurvatureLaplacian(weights.rings, weights.edgeWeights, weights.voronoiAreas);
}

Eigen::MatrixXd Stiffness(const PolygonMesh& mesh)
{
  return StiffnessMatrix(CotangentOf(mesh));
}

/// The largest magnitude off the diagonal.
double LargestWeight(Eigen::MatrixXd K)
{
  K.diagonal().setZero();
  return LargestMagnitude(K);
}

/// K of the triangles alone.
Eigen::MatrixXd StiffnessOfTriangles(const Points& V, const Triangles& T)
{
  const auto topology =
    std::make_shared<const MeshTopology>(BuildTopology(static_cast<Index>(V.rows()), T));
  return StiffnessMatrix(
    CotangentLaplacian(std::shared_ptr<const AdjacencyLists>(topology, &topology->oneRings),
      CotangentEdgeWeights(*topology, T, Cotangents(V, T))));
}

/// Every polygon as the triangles around a vertex of its own, and the matrix that gives the values
/// of all vertices from those of the corners.
struct Refinement
{
  TestMesh mesh;
  Eigen::MatrixXd prolongation;
};

/// The point with the least sum of squared areas, by the derivative of that sum.
Eigen::Vector3d PointOfLeastAreas(const Eigen::MatrixXd& corners)
{
  const auto cross = [](const Eigen::Vector3d& e)
  {
    Matrix3 matrix;
    matrix << 0, -e[2], e[1], e[2], 0, -e[0], -e[1], e[0], 0;
    return matrix;
  };
  const Eigen::Index size = corners.rows();
  Eigen::MatrixXd system(3 * size, 3);
  Eigen::VectorXd right(3 * size);
  for (Eigen::Index k = 0; k < size; ++k)
  {
    const Eigen::Vector3d edge = corners.row((k + 1) % size) - corners.row(k);
    system.middleRows(3 * k, 3) = cross(edge);
    right.segment(3 * k, 3) = cross(edge) * corners.row(k).transpose();
  }
  return system.colPivHouseholderQr().solve(right);
}

Refinement Refine(const PolygonMesh& mesh)
{
  const Eigen::Index vertices = mesh.V.rows();
  const Index polygons = mesh.polygons.Size();
  Refinement result;
  result.prolongation = Eigen::MatrixXd::Zero(vertices + polygons, vertices);
  result.prolongation.topRows(vertices).setIdentity();
  std::vector<Index> triangles;
  for (Index p = 0; p < polygons; ++p)
  {
    const Polygon ids(mesh.polygons.corners.Begin(p), mesh.polygons.corners.End(p));
    const auto size = static_cast<Eigen::Index>(ids.size());
    const Eigen::MatrixXd corners = mesh.V(ids, Eigen::indexing::all);
    Eigen::MatrixXd affine(4, size);
    affine << corners.transpose(), Eigen::RowVectorXd::Ones(size);
    Eigen::Vector4d right;
    right << PointOfLeastAreas(corners), 1;
    const Eigen::VectorXd weights = affine.completeOrthogonalDecomposition().solve(right);
    for (Eigen::Index k = 0; k < size; ++k)
    {
      result.prolongation(vertices + p, ids[k]) = weights[k];
      triangles.insert(
        triangles.end(), { ids[k], ids[(k + 1) % size], static_cast<Index>(vertices + p) });
    }
  }
  result.mesh.V = result.prolongation * mesh.V;
  result.mesh.T =
    Eigen::Map<const Triangles>(triangles.data(), Eigen::Index(triangles.size() / 3), 3);
  return result;
}

/// Difference from P^T K P, computed densely.
double RefinementError(const PolygonMesh& mesh)
{
  const Refinement refined = Refine(mesh);
  const Eigen::MatrixXd expected = refined.prolongation.transpose() *
                                   StiffnessOfTriangles(refined.mesh.V, refined.mesh.T) *
                                   refined.prolongation;
  return LargestMagnitude(Stiffness(mesh) - expected) / LargestMagnitude(expected);
}

double AreaError(const PolygonMesh& mesh)
{
  const double expected = SurfaceArea(Refine(mesh).mesh);
  return std::abs(WeightsOf(mesh).voronoiAreas.sum() / expected - 1);
}

/// Largest |values| off the boundary.
double InnerError(const PolygonMesh& mesh, const Vector& values)
{
  const std::vector<bool> isBoundary = BoundaryVertices(mesh);
  double error = 0;
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    error = Larger(error, isBoundary[i] ? 0 : std::abs(values[i]));
  }
  return error;
}

/// L_c of an arbitrary linear function off the boundary, which is 0.
double LinearPrecisionError(const PolygonMesh& mesh)
{
  const Vector f = (mesh.V * Eigen::Vector3d(2, -3, 5)).array() + 7;
  const Eigen::MatrixXd K = Stiffness(mesh);
  return InnerError(mesh, K * f) / LargestMagnitude(K);
}

double Asymmetry(const PolygonMesh& mesh)
{
  const Eigen::MatrixXd K = Stiffness(mesh);
  return LargestMagnitude(K - K.transpose());
}

/// Root mean square of kappa - 1 on the unit sphere.
double CurvatureError(const PolygonMesh& sphere)
{
  const Vector curvatures = Apply(MeanCurvatureOf(sphere), sphere.V).rowwise().norm();
  return std::sqrt((curvatures.array() - 1).square().mean());
}

Vector Defects(const PolygonMesh& mesh)
{
  return PolygonAngleDefects(mesh.V, mesh.T, mesh.polygons);
}

void CheckTriangles(Checks& c)
{
  for (const TestMesh& mesh : { Irregular(Icosphere(2), 0.08), Grid(8, 0.3), ThreeWings() })
  {
    const PolygonMesh polygons = AsPolygons(mesh);
    c.Error("weights of triangles are their cotangents, to the last bit",
      LargestWeight(Stiffness(polygons) - StiffnessOfTriangles(mesh.V, mesh.T)), 0);
    const MeshTopology topology = BuildTopology(static_cast<Index>(mesh.V.rows()), mesh.T);
    c.Error("areas of triangles are mixed Voronoi areas",
      LargestMagnitude(WeightsOf(polygons).voronoiAreas -
                       MixedVoronoiAreas(mesh.V, mesh.T, topology, Cotangents(mesh.V, mesh.T))),
      1e-14);
    c.Error("angle defects of triangles are those of the triangulation",
      LargestMagnitude(Defects(polygons) - AngleDefects(mesh.V, mesh.T, topology)), 1e-14);
  }
}

void CheckPlanes(Checks& c)
{
  const std::pair<const char*, PolygonMesh> planes[] = {
    { "squares", QuadGrid(6, 0) },
    { "quads", QuadGrid(8, 0.24) },
    { "Ls", Ls(3, 0.15) },
    { "a polygon of 30 corners", PolygonInRing(30) },
    { "a polygon of 50 corners", PolygonInRing(50) },
  };
  for (const auto& [name, plane] : planes)
  {
    for (const PolygonMesh& mesh : { plane, Tilted(plane) })
    {
      c.Error(
        std::string("K of a linear function is 0: ") + name, LinearPrecisionError(mesh), 1e-12);
      c.Error(std::string("K is symmetric to the last bit: ") + name, Asymmetry(mesh), 0);
      c.Error(std::string("angle defects in a plane are 0: ") + name,
        InnerError(mesh, Defects(mesh)), 1e-12);
      c.Error(std::string("areas are those of the polygons: ") + name,
        std::abs(WeightsOf(mesh).voronoiAreas.sum() / SurfaceArea({ mesh.V, mesh.T }) - 1), 1e-12);
    }
  }
  // The fan of a unit square has the weight 0 - 1/4 4 + 2 2/4 - 8/16 = 0.5 on a diagonal.
  const Eigen::MatrixXd square = Stiffness(QuadGrid(1, 0));
  c.Error("the diagonals of a square have the weight 1/2", std::abs(square(0, 3) + 0.5), 1e-12);
  c.Error("the sides of a square have the weight 1/2", std::abs(square(0, 1) + 0.5), 1e-12);
}

void CheckRefinement(Checks& c)
{
  const std::pair<const char*, PolygonMesh> meshes[] = {
    { "noisy torus of quads", Noisy(QuadTorus(8), 0.03) },
    { "sphere of quads", QuadSphere(4) },
    { "sphere of hexagons", Noisy(HexagonSphere(1), 0.02) },
    { "flat quads", Tilted(QuadGrid(6, 0.2)) },
  };
  for (const auto& [name, mesh] : meshes)
  {
    c.Error(
      std::string("K is that of the virtual refinement: ") + name, RefinementError(mesh), 1e-6);
    c.Error(std::string("K is symmetric to the last bit: ") + name, Asymmetry(mesh), 0);
    c.Error(
      std::string("areas are those of the virtual refinement: ") + name, AreaError(mesh), 1e-6);
    c.Error(std::string("K does not depend on how polygons are cut: ") + name,
      LargestMagnitude(Stiffness(mesh) - Stiffness(CutElsewhere(mesh, 1))), 0);
    const Eigen::VectorXd eigenvalues =
      Stiffness(mesh).selfadjointView<Eigen::Lower>().eigenvalues();
    c.Error(std::string("K is positive semidefinite: ") + name,
      -eigenvalues.minCoeff() / eigenvalues.maxCoeff(), 1e-14);
  }
}

void CheckCurvature(Checks& c)
{
  for (const auto& sphere : { QuadSphere, +[](int cells) {
                               return HexagonSphere(cells == 8 ? 2 : cells == 16 ? 3 : 4);
                             } })
  {
    const double coarse = CurvatureError(sphere(8));
    const double medium = CurvatureError(sphere(16));
    const double fine = CurvatureError(sphere(32));
    c.Error("kappa of a sphere of polygons comes close to 1", fine, 0.01);
    c.Error("its error falls with every refinement", Larger(medium / coarse, fine / medium), 0.6);
    c.Error("angle defects of a sphere add up to 4 pi", std::abs(Defects(sphere(8)).sum() - 4 * Pi),
      1e-11);
  }
  c.Error("angle defects of a torus add up to 0",
    std::abs(Defects(Noisy(QuadTorus(8), 0.03)).sum()), 1e-11);
}

void CheckDegeneratePolygons(Checks& c)
{
  Points V(6, 3);
  V << 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0, 0, 1, 0;
  const PolygonMesh flat =
    MakePolygonMesh(V, { { 0, 1, 2, 3, 4 }, { 0, 1, 0, 1 }, { 2, 2, 2, 2 } });
  c.Error("polygons without area have no weights", LargestMagnitude(Stiffness(flat)), 0);
  c.Error("and no areas", LargestMagnitude(WeightsOf(flat).voronoiAreas), 0);
  c.True("and finite angle defects", Defects(flat).allFinite());
  const PolygonMesh twice = MakePolygonMesh(V, { { 0, 2, 5, 5 } });
  Triangles triangle(1, 3);
  triangle << 0, 2, 5;
  c.Error("a quad with a corner twice is a triangle",
    LargestMagnitude(Stiffness(twice) - StiffnessOfTriangles(V, triangle)), 1e-12);
}
}

int TestPolygonLaplacian(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Triangles", CheckTriangles);
  groups.Run("Planes", CheckPlanes);
  groups.Run("Refinement", CheckRefinement);
  groups.Run("Curvature", CheckCurvature);
  groups.Run("DegeneratePolygons", CheckDegeneratePolygons);
  return groups.Result();
}
