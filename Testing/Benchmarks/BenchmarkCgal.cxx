// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkCgal.h"

#include "vtkPolyDataAlgorithm.h"

#ifdef LMO_BENCHMARK_CGAL

#include "vtkCellArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <CGAL/Polygon_mesh_processing/tangential_relaxation.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

namespace
{
using CgalPoint = CGAL::Simple_cartesian<double>::Point_3;
using CgalMesh = CGAL::Surface_mesh<CgalPoint>;

/// \return false if the triangles are no manifold
bool Convert(vtkPolyData* mesh, CgalMesh& result)
{
  const vtkIdType vertices = mesh->GetNumberOfPoints();
  const vtkIdType triangles = mesh->GetNumberOfPolys();
  result.reserve(vertices, vertices + triangles, triangles);
  for (vtkIdType i = 0; i < vertices; ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    result.add_vertex({ point[0], point[1], point[2] });
  }
  for (vtkIdType k = 0; k < triangles; ++k)
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    mesh->GetPolys()->GetCellAtId(k, count, corners);
    const auto corner = [&](int c) { return CgalMesh::Vertex_index(corners[c]); };
    if (result.add_face(corner(0), corner(1), corner(2)) == CgalMesh::null_face())
    {
      return false;
    }
  }
  return true;
}

class CgalRelaxation : public vtkPolyDataAlgorithm
{
public:
  static CgalRelaxation* New();
  vtkTypeMacro(CgalRelaxation, vtkPolyDataAlgorithm);

  CgalMesh Mesh;
  int Iterations = 10;

protected:
  CgalRelaxation() { this->SetNumberOfInputPorts(0); }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    PMP::tangential_relaxation(
      this->Mesh, CGAL::parameters::number_of_iterations(this->Iterations));
    return 1;
  }
};
vtkStandardNewMacro(CgalRelaxation);
}

std::string CgalVersion()
{
  return CGAL_VERSION_STR;
}

vtkSmartPointer<vtkPolyDataAlgorithm> MakeCgalRelaxation(vtkPolyData* mesh, int iterations)
{
  auto relaxation = vtkSmartPointer<CgalRelaxation>::New();
  relaxation->Iterations = iterations;
  if (!Convert(mesh, relaxation->Mesh))
  {
    return nullptr;
  }
  return relaxation;
}

#else

std::string CgalVersion()
{
  return {};
}

vtkSmartPointer<vtkPolyDataAlgorithm> MakeCgalRelaxation(vtkPolyData*, int)
{
  return nullptr;
}

#endif
