// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "MeshMeasures.h"
#include "OperatorFixtures.h"

#include "Core/Operators/SharpVertices.h"
#include "Core/Operators/Weights.h"

#include <cmath>

using namespace lmo;

namespace
{
Vector Values(std::initializer_list<double> values)
{
  return Eigen::Map<const Vector>(values.begin(), static_cast<Eigen::Index>(values.size()));
}

CurvatureStatistics Statistics(const Vector& curvatures)
{
  return ComputeStatistics(curvatures, Mask(curvatures.size(), 1));
}

double Difference(const Vector& a, const Vector& b)
{
  return LargestMagnitude(a - b);
}

void CheckStatistics(Checks& c)
{
  const std::vector<double> values = { 8, 1, 4, 2 };
  c.Error("the first quartile of 1, 2, 4, 8 is 1.75", std::abs(Quantile(values, 0.25) - 1.75), 0);
  c.Error("the median of 1, 2, 4, 8 is 3", std::abs(Quantile(values, 0.5) - 3), 0);
  c.Error("the third quartile of 1, 2, 4, 8 is 5", std::abs(Quantile(values, 0.75) - 5), 0);
  c.Error("quantile 0 is the minimum", std::abs(Quantile(values, 0) - 1), 0);
  c.Error("quantile 1 is the maximum", std::abs(Quantile(values, 1) - 8), 0);
  c.Error("one value is every quantile", std::abs(Quantile({ 3 }, 0.75) - 3), 0);
  c.Error("no values have quantile 0", std::abs(Quantile({}, 0.5)), 0);

  const CurvatureStatistics statistics = Statistics(Values({ 8, 1, 4, 2 }));
  c.Error("minimum and maximum",
    Difference(Values({ statistics.minimum, statistics.maximum }), Values({ 1, 8 })), 0);
  c.Error("the threshold is Q3 + 1.5 (Q3 - Q1)", std::abs(statistics.threshold - 9.875), 0);

  const CurvatureStatistics used =
    ComputeStatistics(Values({ 0, 8, 1, 100, 4, 2 }), { 0, 1, 1, 0, 1, 1 });
  c.Error("unused vertices do not count",
    Difference(Values({ used.minimum, used.maximum, used.threshold }), Values({ 1, 8, 9.875 })), 0);
  c.Equal("no vertices have statistics of 0", Statistics(Vector()).threshold, 0);
}

void CheckLinearWeights(Checks& c)
{
  // Quartiles 1 and 3, threshold 6.
  const Vector curvatures = Values({ 0, 1, 2, 3, 12 });
  c.Error("W_linear maps minimum to 0 and the threshold to 1, and clamps outliers",
    Difference(LinearWeights(curvatures, Statistics(curvatures)),
      Values({ 0, 1.0 / 6, 2.0 / 6, 3.0 / 6, 1 })),
    1e-15);
  const Vector compact = Values({ 2, 3, 4, 6 });
  c.Error("W_linear maps the maximum to 1 if it is below the threshold",
    Difference(LinearWeights(compact, Statistics(compact)), Values({ 0, 0.25, 0.5, 1 })), 1e-15);
  c.Error("W_linear of a vertex below the minimum is 0",
    LinearWeights(Values({ 1 }), Statistics(compact))[0], 0);
  const Vector equal = Values({ 5, 5, 5 });
  c.Error("W_linear of equal curvatures is 1",
    Difference(LinearWeights(equal, Statistics(equal)), Vector::Ones(3)), 0);
  const Vector mostlyFlat = Values({ 0, 0, 0, 0, 0, 7 });
  c.Error("W_linear is 1 on the features of a shape that is flat but for them, and 0 elsewhere",
    Difference(LinearWeights(mostlyFlat, Statistics(mostlyFlat)), Values({ 0, 0, 0, 0, 0, 1 })), 0);
}

void CheckOtherWeights(Checks& c)
{
  const Vector curvatures = Values({ 3, 0, 1, 0, 1 });
  c.Error("W_cdf is the share of vertices with at most this curvature; ties share the upper rank",
    Difference(CumulativeWeights(curvatures, Mask(5, 1)), Values({ 1, 0.4, 0.8, 0.4, 0.8 })),
    1e-15);
  const Mask used = { 1, 0, 1, 0, 1 };
  c.Error("W_cdf is a share of the used vertices",
    Difference(CumulativeWeights(curvatures, used), Values({ 1, 0, 2.0 / 3, 0, 2.0 / 3 })), 1e-15);
  c.Error("curvatures that differ by round-off have one rank, others have their own",
    Difference(
      CumulativeWeights(Values({ 3, 3 * (1 + 1e-15), 3 * (1 - 1e-15), 3.00001, 0 }), Mask(5, 1)),
      Values({ 0.8, 0.8, 0.8, 1, 0.2 })),
    1e-15);
  c.Error("the complement is 1 - W",
    Difference(ComplementWeights(Values({ 0, 0.25, 1 })), Values({ 1, 0.75, 0 })), 0);
  c.Error("Gaussian weights are exp(-kappa^2 / 2 sigma^2)",
    Difference(
      GaussianWeights(Values({ 0, 2, 4 }), 2), Values({ 1, std::exp(-0.5), std::exp(-2) })),
    1e-15);
  c.Error("Gaussian weights of width 0 are 1 on flat parts only",
    Difference(GaussianWeights(Values({ 0, 1e-9, 4 }), 0), Values({ 1, 0, 0 })), 0);
  c.Error("anchors are where the tag is not 0",
    Difference(AnchorWeights(Values({ 0, 1, -2, 0.1 })), Values({ 0, 1, 1, 1 })), 0);
}

Vector Held(const Vector& weights, const Mask& isFixed)
{
  Vector held = weights;
  WeightUnconstrainedComponents({ 0, 0, 1, 1, 0 }, isFixed, 7, held);
  return held;
}

void CheckUnconstrainedComponents(Checks& c)
{
  const Mask none(5, 0);
  c.Error("a component without weights is held",
    Difference(Held(Values({ 0, 2, 0, 0, 0 }), none), Values({ 0, 2, 7, 7, 0 })), 0);
  c.Error("a component with a fixed vertex is not held",
    Difference(Held(Vector::Zero(5), { 0, 0, 0, 1, 0 }), Values({ 7, 7, 0, 0, 7 })), 0);
  c.Error("components with weights keep them",
    Difference(Held(Values({ 0, 0, 1, 0, 3 }), none), Values({ 0, 0, 1, 0, 3 })), 0);
}
}

namespace
{
/// A square bar of length 10 and width 1 whose points all lie on its long edges, unevenly, so that
/// its sides are strips of thin triangles; its ends are open.
TestMesh Bar()
{
  const Index count = 30;
  TestMesh bar{ Points(4 * count, 3), Triangles(8 * (count - 1), 3) };
  Random random;
  for (Index side = 0; side < 4; ++side)
  {
    for (Index k = 0; k < count; ++k)
    {
      const double x = (k + 0.45 * (k % (count - 1) != 0) * random()) * 10 / (count - 1);
      bar.V.row(side * count + k) = Vector3(x, side == 1 || side == 2 ? 1 : 0, side >= 2 ? 1 : 0);
    }
    for (Index k = 0; k + 1 < count; ++k)
    {
      const Index a = side * count + k, b = (side + 1) % 4 * count + k;
      bar.T.row(2 * (side * (count - 1) + k)) << a, a + 1, b;
      bar.T.row(2 * (side * (count - 1) + k) + 1) << a + 1, b + 1, b;
    }
  }
  return bar;
}

Vector Agreement(const TestMesh& mesh)
{
  return NormalAgreement(mesh.V, mesh.T, BuildTopology(static_cast<Index>(mesh.V.rows()), mesh.T));
}

void CheckSharpVertices(Checks& c)
{
  const TestMesh bar = Bar();
  c.Error("normals at an edge of a right angle agree by cos 45 degrees, however long the triangles",
    LargestMagnitude(Agreement(bar).array() - std::sqrt(0.5)), 1e-12);
  c.Error("normals of a plane agree", LargestMagnitude(Agreement(Grid(6, 0.3)).array() - 1), 1e-12);
  const MeshTopology topology = BuildTopology(120, bar.T);
  c.True(
    "all points of the bar are sharp", (SharpVertices(bar.V, bar.T, topology).array() == 1).all());
  const TestMesh sphere = Icosphere(2);
  c.True("no point of a sphere is sharp",
    (SharpVertices(sphere.V, sphere.T, BuildTopology(162, sphere.T)).array() == 0).all());
}

/// Section 5.3: sharp vertices are kept, also where the others have no curvature to compare with.
void CheckSharpFeatures(Checks& c)
{
  TestMesh box = Cube(1);
  box.V.col(0) = 8 * box.V.col(0).array().square(); // sides of uneven, thin triangles
  OptimizerOptions options = Options(Mode::OPTIMIZE_TRIANGLES);
  options.positionWeighting = PositionWeighting::LINEAR;
  options.laplacianWeighting = LaplacianWeighting::LINEAR_COMPLEMENT;
  const OptimizerResult result = Run(box, options);
  for (Index i = 0; i < static_cast<Index>(box.V.rows()); ++i)
  {
    const auto isOnSide = [&](double x, double size) { return x == 0 || x == size; };
    const int sides =
      isOnSide(box.V(i, 0), 8) + isOnSide(box.V(i, 1), 1) + isOnSide(box.V(i, 2), 1);
    if (sides > 1)
    {
      c.Error("a vertex on an edge of the box stays: " + std::to_string(i),
        result.displacements.row(i).norm(), 1e-12);
    }
  }
}
}

int TestWeights(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Statistics", CheckStatistics);
  groups.Run("LinearWeights", CheckLinearWeights);
  groups.Run("OtherWeights", CheckOtherWeights);
  groups.Run("UnconstrainedComponents", CheckUnconstrainedComponents);
  groups.Run("SharpVertices", CheckSharpVertices);
  groups.Run("SharpFeatures", CheckSharpFeatures);
  return groups.Result();
}
