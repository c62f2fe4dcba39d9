// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshLaplacian.h"

#include "Core/Curvature.h"
#include "Core/Laplacian.h"
#include "Core/TriangleGeometry.h"
#include "Private/FilterSupport.h"
#include "Private/PolyDataConversion.h"

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
void AddLaplacians(const lmo::SurfaceMesh& mesh, vtkPointData* pointData)
{
  const lmo::Points& V = mesh.points;
  const auto topology = std::make_shared<const lmo::MeshTopology>(
    lmo::BuildTopology(static_cast<lmo::Index>(V.rows()), mesh.triangles));
  const std::shared_ptr<const lmo::AdjacencyLists> oneRings(topology, &topology->oneRings);
  const lmo::CornerValues cotangents = lmo::Cotangents(V, mesh.triangles);
  const auto edgeWeights = lmo::CotangentEdgeWeights(*topology, mesh.triangles, cotangents);
  const lmo::Vector areas = lmo::MixedVoronoiAreas(V, mesh.triangles, *topology, cotangents);
  const lmo::Points curvatureNormals = lmo::MeanCurvatureNormals(
    lmo::MeanCurvatureLaplacian(oneRings, edgeWeights, areas), V, *topology);

  pointData->AddArray(
    lmo::MakeArray("UniformLaplacian", lmo::Apply(lmo::UniformLaplacian(oneRings), V)));
  pointData->AddArray(lmo::MakeArray(
    "CotangentLaplacian", lmo::Apply(lmo::CotangentLaplacian(oneRings, edgeWeights), V)));
  pointData->AddArray(lmo::MakeArray("MeanCurvatureNormal", curvatureNormals));
  pointData->AddArray(lmo::MakeArray("MeanCurvature",
    lmo::MeanCurvatures(curvatureNormals, lmo::BoundingBoxDiagonal(V, *topology), *topology)));
  pointData->AddArray(lmo::MakeArray("GaussianCurvature",
    lmo::GaussianCurvatures(lmo::AngleDefects(V, mesh.triangles, *topology), areas, *topology)));
  pointData->AddArray(lmo::MakeArray("VoronoiArea", areas));
}
}

int vtkMeshLaplacian::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return lmo::RunFilter(this, output,
    [&]
    {
      const lmo::SurfaceMesh mesh = lmo::ReadMesh(input);
      output->ShallowCopy(input);
      AddLaplacians(mesh, output->GetPointData());
    });
}

void vtkMeshLaplacian::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
