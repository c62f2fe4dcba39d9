// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshLaplacian.h"

#include "Core/Mesh/TriangleGeometry.h"
#include "Core/Mesh/TriangleNeighbours.h"
#include "Core/Operators/CotangentQuantities.h"
#include "Core/Operators/Curvature.h"
#include "Core/Operators/PolygonLaplacian.h"
#include "Core/Operators/PrincipalCurvatures.h"
#include "Private/FilterSupport.h"
#include "Private/PolyDataConversion.h"
#include "Private/PolyDataOutput.h"
#include "Private/SurfaceExtraction.h"

#include "vtkDataSet.h"
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

/// Normals of the vertices towards the outer side of a closed surface; of others, and where
/// triangles differ in their orientation, towards the side from which the triangles at the vertex
/// are counter-clockwise.
lmo::Points OuterNormals(const lmo::MeshQuantities& mesh)
{
  const lmo::Points& V = mesh.GetPoints();
  const lmo::Triangles& triangles = mesh.GetTriangles();
  lmo::Points normals = lmo::VertexNormals(V, triangles, mesh.GetTopology());
  if (lmo::IsInsideOut(V, triangles, mesh.GetTopology()))
  {
    normals *= -1;
  }
  return normals;
}

/// Adds arrays of values at the vertices to the point data.
class PointArrays
{
public:
  PointArrays(const lmo::MeshNumbering& meshNumbering, vtkPointData* data)
    : Numbering(meshNumbering)
    , PointData(data)
  {
  }

  template <typename Values>
  void Add(const char* name, Values values)
  {
    this->Results.Add(this->PointData, lmo::MakeArray(name, std::move(values), this->Numbering));
  }

  void Warn(vtkAlgorithm* filter) const { this->Results.Warn(filter); }

private:
  const lmo::MeshNumbering& Numbering;
  vtkPointData* PointData;
  lmo::ResultArrays Results;
};

void AddLaplacians(
  const lmo::CotangentQuantities& quantities, const lmo::Points& vertexNormals, PointArrays& arrays)
{
  const lmo::MeshQuantities& mesh = quantities.GetMesh();
  const lmo::MeshTopology& topology = mesh.GetTopology();
  const std::shared_ptr<const lmo::CotangentWeights> weights = quantities.GetWeights();
  const lmo::Vector& areas = weights->GetVoronoiAreas();
  const lmo::Vector& mean = quantities.GetMeanCurvatures();
  const auto laplacian = [&](lmo::LaplacianType type)
  { return lmo::Apply(quantities.MakeLaplacian(type), mesh.GetPoints()); };

  arrays.Add("UniformLaplacian", laplacian(lmo::LaplacianType::UNIFORM));
  arrays.Add("CotangentLaplacian", laplacian(lmo::LaplacianType::COTANGENT));
  lmo::Points normals = quantities.ComputeMeanCurvatureNormals();
  lmo::Vector signedMean = lmo::SignedMeanCurvatures(normals, mean, vertexNormals, topology);
  arrays.Add("MeanCurvatureNormal", std::move(normals));
  arrays.Add("MeanCurvature", mean);
  arrays.Add("SignedMeanCurvature", std::move(signedMean));
  arrays.Add("GaussianCurvature", lmo::GaussianCurvatures(AngleDefects(mesh), areas, topology));
  arrays.Add("VoronoiArea", areas);
}

void AddPrincipalCurvatures(const lmo::MeshQuantities& mesh, const lmo::Points& vertexNormals,
  lmo::ProgressMonitor& monitor, PointArrays& arrays)
{
  lmo::PrincipalCurvatures curvatures = lmo::ComputePrincipalCurvatures(
    mesh.GetPoints(), vertexNormals, mesh.GetTopology(), mesh.GetDiagonal(), monitor);
  arrays.Add("PrincipalCurvature1", std::move(curvatures.first));
  arrays.Add("PrincipalCurvature2", std::move(curvatures.second));
  arrays.Add("PrincipalDirection1", std::move(curvatures.firstDirections));
  arrays.Add("PrincipalDirection2", std::move(curvatures.secondDirections));
}
}

int vtkMeshLaplacian::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

int vtkMeshLaplacian::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* data = vtkDataSet::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return lmo::RunFilter(this, data, output,
    [&]
    {
      const vtkSmartPointer<vtkPolyData> input = lmo::SurfaceOf(data);
      lmo::SurfaceMesh surface = lmo::ReadMesh(input);
      if (this->WeldCoincidentPoints)
      {
        lmo::WeldCoincidentPoints(surface);
      }
      const lmo::MeshQuantities mesh(
        std::move(surface.points), std::move(surface.triangles), std::move(surface.polygons));
      output->ShallowCopy(input);
      const lmo::Points vertexNormals = OuterNormals(mesh);
      PointArrays arrays(surface.numbering, output->GetPointData());
      AddLaplacians(lmo::CotangentQuantities(mesh, this->RobustLaplacian), vertexNormals, arrays);
      if (this->PrincipalCurvatures)
      {
        lmo::FilterMonitor monitor(this);
        AddPrincipalCurvatures(mesh, vertexNormals, monitor, arrays);
      }
      arrays.Warn(this);
    });
}

void vtkMeshLaplacian::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RobustLaplacian: " << this->RobustLaplacian << "\n";
  os << indent << "PrincipalCurvatures: " << this->PrincipalCurvatures << "\n";
  os << indent << "WeldCoincidentPoints: " << this->WeldCoincidentPoints << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
