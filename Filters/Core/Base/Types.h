// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Types_h
#define lmo_Types_h

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstdint>
#include <vector>

/// Numerics of "Laplacian Mesh Optimization" (Nealen, Igarashi, Sorkine, Alexa 2006).
/// Equation numbers in this namespace are those of the paper.
namespace lmo
{
/// Id of a vertex or triangle; also an offset into a one-ring list, which limits a mesh to
/// about 350 million vertices.
using Index = std::int32_t;

using Vector = Eigen::VectorXd;
using Vector3 = Eigen::RowVector3d;
using Matrix3 = Eigen::Matrix3d;

/// One row (x, y, z) per vertex.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// One row per triangle: its three vertex ids, counter-clockwise seen from outside.
using Triangles = Eigen::Matrix<Index, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// One row per triangle: a value for each of its three corners.
using CornerValues = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// One label of each triangle, or two: those of the regions on its two sides, the lower one first.
using TriangleLabels = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

/// One flag per vertex or triangle; bytes, so that threads can write neighbouring ones.
using Mask = std::vector<unsigned char>;
}

#endif
