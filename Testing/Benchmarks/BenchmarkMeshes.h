// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchmarkMeshes_h
#define BenchmarkMeshes_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

/// A mesh that is made when it is its turn: the largest ones take much memory.
struct MeshSource
{
  std::string name;
  /// Triangles without any arrays; null if there is no such mesh.
  std::function<vtkSmartPointer<vtkPolyData>()> make;
};

/// Noisy spheres, whose points are in the bad order of a subdivision, and isosurfaces, whose points
/// are in the order of a contour filter. The names end with the number of vertices.
std::vector<MeshSource> GeneratedMeshes();

/// The .ply, .obj, .stl and .vtp files in a folder, and each subdivided once and twice (NAME-x4,
/// NAME-x16) as long as that has fewer than a million vertices.
/// \throw std::filesystem::filesystem_error if the folder cannot be read
std::vector<MeshSource> MeshesInFolder(const std::string& folder);

#endif
