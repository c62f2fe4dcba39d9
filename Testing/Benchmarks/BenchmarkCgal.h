// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchmarkCgal_h
#define BenchmarkCgal_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;
class vtkPolyDataAlgorithm;

/// Empty if the benchmark is built without CGAL.
std::string CgalVersion();

/// CGAL's tangential_relaxation() in the dress of a filter: Update() is the relaxation alone, the
/// mesh is converted here. It has no output.
/// \return null without CGAL, or if its Surface_mesh cannot hold the mesh
vtkSmartPointer<vtkPolyDataAlgorithm> MakeCgalRelaxation(vtkPolyData* mesh, int iterations);

#endif
