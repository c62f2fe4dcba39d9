// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FilterTesting_h
#define FilterTesting_h

#include "MeshFixtures.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkCellArray;
class vtkDataArray;
class vtkFieldData;
class vtkLaplacianMeshOptimizer;
class vtkPolyData;
class vtkPolyDataAlgorithm;
class vtkSelection;
class vtkSelectionNode;

/// The mesh as polygons.
/// \param pointType VTK_DOUBLE or VTK_FLOAT
vtkSmartPointer<vtkPolyData> MakePolyData(const TestMesh& mesh, int pointType = VTK_DOUBLE);

/// Every triangle with points of its own, as STL files hold them.
TestMesh Soup(const TestMesh& mesh);

/// Vertices, lines, triangles and strips of a curved surface, an isolated point, and arrays of all
/// kinds. Cells 0 and 1 are vertices, 2 is a line, the triangles are 3 to 146, the strips the rest.
vtkSmartPointer<vtkPolyData> MakeMixedPolyData();

/// The same surface with triangles in the place of the strips.
vtkSmartPointer<vtkPolyData> MakeMixedPolyDataWithoutStrips();

void AddPointArray(vtkPolyData* mesh, const char* name, const Eigen::MatrixXd& values);

lmo::Points PointsOf(vtkPolyData* mesh);

/// One row per tuple; no rows if there is no array.
Eigen::MatrixXd ValuesOf(vtkDataArray* array);
Eigen::MatrixXd PointValues(vtkPolyData* mesh, const char* name);
Eigen::MatrixXd CellValues(vtkPolyData* mesh, const char* name);

/// Value of a field array with one tuple of one component; NaN if there is no such array.
double FieldValue(vtkPolyData* mesh, const char* name);

bool AreEqual(vtkCellArray* a, vtkCellArray* b);

/// Same points, cells and arrays.
bool AreEqual(vtkPolyData* a, vtkPolyData* b);

/// True if all arrays of \a some are in \a all, with the same type and values.
bool Contains(vtkFieldData* all, vtkFieldData* some);

/// No points, no cells, no arrays.
bool IsEmpty(vtkPolyData* mesh);

/// What the filter said during an Update(), all of it.
struct Messages
{
  std::string errors;
  std::string warnings;
};
Messages Update(vtkAlgorithm* filter);

/// \param fieldType vtkSelectionNode::POINT or CELL
vtkSmartPointer<vtkSelectionNode> SelectionNode(int fieldType, const std::set<vtkIdType>& ids);

vtkSmartPointer<vtkSelection> Selection(
  const std::vector<vtkSmartPointer<vtkSelectionNode>>& nodes);

/// Output of a new vtkLaplacianMeshOptimizer, in mode OPTIMIZE_TRIANGLES unless setUp() chooses
/// another one.
vtkSmartPointer<vtkPolyData> Optimized(
  vtkPolyData* input,
  const std::function<void(vtkLaplacianMeshOptimizer*)>& setUp = [](vtkLaplacianMeshOptimizer*) {});

#endif
