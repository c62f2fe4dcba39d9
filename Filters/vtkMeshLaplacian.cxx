// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshLaplacian.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Operators/CotangentQuantities.h"
#include "Core/Operators/Curvature.h"
#include "Private/FilterSupport.h"
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
void AddLaplacians(
  const lmo::CotangentQuantities& quantities, lmo::ResultArrays& results, vtkPointData* pointData)
{
  const lmo::MeshQuantities& mesh = quantities.GetMesh();
  const lmo::Points& V = mesh.GetPoints();
  const lmo::MeshTopology& topology = mesh.GetTopology();
  const std::shared_ptr<const lmo::CotangentWeights> weights = quantities.GetWeights();
  const lmo::Vector& areas = weights->GetVoronoiAreas();
  const auto laplacian = [&](lmo::LaplacianType type)
  { return lmo::Apply(quantities.MakeLaplacian(type), V); };

  results.Add(
    pointData, lmo::MakeArray("UniformLaplacian", laplacian(lmo::LaplacianType::UNIFORM)));
  results.Add(
    pointData, lmo::MakeArray("CotangentLaplacian", laplacian(lmo::LaplacianType::COTANGENT)));
  results.Add(
    pointData, lmo::MakeArray("MeanCurvatureNormal", quantities.ComputeMeanCurvatureNormals()));
  results.Add(pointData, lmo::MakeArray("MeanCurvature", quantities.GetMeanCurvatures()));
  results.Add(
    pointData, lmo::MakeArray("GaussianCurvature",
                 lmo::GaussianCurvatures(
                   lmo::AngleDefects(V, mesh.GetTriangles(), topology), areas, topology)));
  results.Add(pointData, lmo::MakeArray("VoronoiArea", areas));
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
      const lmo::MeshQuantities mesh(std::move(surface.points), std::move(surface.triangles));
      output->ShallowCopy(input);
      lmo::ResultArrays results;
      AddLaplacians(
        lmo::CotangentQuantities(mesh, this->RobustLaplacian), results, output->GetPointData());
      results.Warn(this);
    });
}

void vtkMeshLaplacian::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RobustLaplacian: " << this->RobustLaplacian << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
