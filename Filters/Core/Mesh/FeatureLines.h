// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_FeatureLines_h
#define lmo_FeatureLines_h

#include "Core/Mesh/MeshTopology.h"

#include <memory>

namespace lmo
{
/// Polylines of mesh edges along which vertices may slide, such as the boundary.
struct FeatureLines
{
  enum Class : unsigned char
  {
    SMOOTH = 0, ///< on no line
    EDGE = 1,   ///< inside a line: two line edges and a turn of at most 60 degrees
    CORNER = 2  ///< end, junction or sharp turn
  };
  Mask pointClass;                             ///< Class of each vertex
  std::shared_ptr<const AdjacencyLists> lines; ///< neighbours along the lines
  Points tangents;                             ///< unit direction of the line at an EDGE, else 0
};

/// True if a line that leads from vertex previous over i to next turns at i by at most 60 degrees.
bool IsSmoothTurn(const Points& V, Index previous, Index i, Index next);

FeatureLines ClassifyLines(std::shared_ptr<const AdjacencyLists> lines, const Points& V);

/// Calls visit(vertex, previous, next) for each EDGE.
template <typename Visit>
void ForEachLineVertex(const FeatureLines& features, const Visit& visit)
{
  for (Index i = 0; i < static_cast<Index>(features.pointClass.size()); ++i)
  {
    if (features.pointClass[i] == FeatureLines::EDGE)
    {
      visit(i, features.lines->Begin(i)[0], features.lines->Begin(i)[1]);
    }
  }
}

/// The point of EDGE i's line in \a V that is closest to x, which is close to the line.
Vector3 ProjectOntoLine(const FeatureLines& features, const Points& V, Index i, const Vector3& x);

/// Moves each EDGE to the closest point of its line in \a V.
/// \param moved vertices close to their line
void ProjectOntoLines(const FeatureLines& features, const Points& V, Points& moved);
}

#endif
