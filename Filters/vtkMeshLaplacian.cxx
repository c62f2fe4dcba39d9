// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshLaplacian.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Operators/CotangentQuantities.h"
#include "Core/Operators/Curvature.h"
#include "Core/Operators/PolygonLaplacian.h"
#include "Private/FilterSupport.h"
#include "Private/PolyDataConversion.h"
#include "Private/PolyDataOutput.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkMeshLaplacian);

namespace
{
lmo::Vector AngleDefects(const lmo::MeshQuantities& mesh)
{
  return mesh.GetPolygons().IsEmpty()
           ? lmo::AngleDefects(mesh.GetPoints(), mesh.GetTriangles(), mesh.GetTopology())
           : lmo::PolygonAngleDefects(mesh.GetPoints(), mesh.GetTriangles(), mesh.GetPolygons());
}

void AddLaplacians(const lmo::CotangentQuantities& quantities, const lmo::MeshNumbering& numbering,
  lmo::ResultArrays& results, vtkPointData* pointData)
{
  const lmo::MeshQuantities& mesh = quantities.GetMesh();
  const lmo::Points& V = mesh.GetPoints();
  const lmo::MeshTopology& topology = mesh.GetTopology();
  const std::shared_ptr<const lmo::CotangentWeights> weights = quantities.GetWeights();
  const lmo::Vector& areas = weights->GetVoronoiAreas();
  const auto add = [&](const char* name, auto values)
  { results.Add(pointData, lmo::MakeArray(name, std::move(values), numbering)); };
  const auto laplacian = [&](lmo::LaplacianType type)
  { return lmo::Apply(quantities.MakeLaplacian(type), V); };

  add("UniformLaplacian", laplacian(lmo::LaplacianType::UNIFORM));
  add("CotangentLaplacian", laplacian(lmo::LaplacianType::COTANGENT));
  add("MeanCurvatureNormal", quantities.ComputeMeanCurvatureNormals());
  add("MeanCurvature", quantities.GetMeanCurvatures());
  add("GaussianCurvature", lmo::GaussianCurvatures(AngleDefects(mesh), areas, topology));
  add("VoronoiArea", areas);
}
}

int vtkMeshLaplacian::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return lmo::RunFilter(this, input, output,
    [&]
    {
      lmo::SurfaceMesh surface = lmo::ReadMesh(input);
      if (this->WeldCoincidentPoints)
      {
        lmo::WeldCoincidentPoints(surface);
      }
      const lmo::MeshQuantities mesh(
        std::move(surface.points), std::move(surface.triangles), std::move(surface.polygons));
      output->ShallowCopy(input);
      lmo::ResultArrays results;
      AddLaplacians(lmo::CotangentQuantities(mesh, this->RobustLaplacian), surface.numbering,
        results, output->GetPointData());
      results.Warn(this);
    });
}

void vtkMeshLaplacian::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RobustLaplacian: " << this->RobustLaplacian << "\n";
  os << indent << "WeldCoincidentPoints: " << this->WeldCoincidentPoints << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
