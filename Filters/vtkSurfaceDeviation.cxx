// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceDeviation.h"

#include "Core/Base/Threading.h"
#include "Core/Deviation/SurfaceSampler.h"
#include "Core/Mesh/TriangleGeometry.h"
#include "Private/FilterSupport.h"
#include "Private/PolyDataOutput.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkSurfaceDeviation);

namespace
{
/// One of the two surfaces, ready for closest-point queries.
class Surface
{
public:
  explicit Surface(vtkPolyData* input)
    : Mesh(lmo::ReadMesh(input))
    , Topology(lmo::BuildTopology(lmo::Index(this->Mesh.points.rows()), this->Mesh.triangles))
    , Sampler(this->Mesh.points, this->Mesh.triangles)
  {
    if (!this->IsEmpty())
    {
      this->Locator->SetDataSet(this->ForLocator(input->GetPoints()));
      this->Locator->BuildLocator();
    }
  }

  bool IsEmpty() const { return this->Topology.cornersAt.ids.empty(); }
  const lmo::Points& GetPoints() const { return this->Mesh.points; }
  double Diagonal() const { return lmo::BoundingBoxDiagonal(this->Mesh.points, this->Topology); }

  /// The points that triangles use.
  lmo::Points UsedPoints() const
  {
    const lmo::Mask& isUsed = this->Topology.isUsed;
    lmo::Points used(std::count(isUsed.begin(), isUsed.end(), true), 3);
    lmo::Index count = 0;
    for (lmo::Index i = 0; i < this->Topology.vertices; ++i)
    {
      if (isUsed[i])
      {
        used.row(count++) = this->Mesh.points.row(i);
      }
    }
    return used;
  }

  lmo::Points Samples(lmo::Index count) const
  {
    lmo::Points samples(this->Sampler.Area() > 0 ? count : 0, 3);
    lmo::ParallelFor(lmo::Index(samples.rows()),
      [&](lmo::Index k) { samples.row(k) = this->Sampler.Sample(k, count); });
    return samples;
  }

  /// Distance of each query point to the closest point of the triangles.
  lmo::Vector Distances(const lmo::Points& queries)
  {
    lmo::Vector distances = lmo::Vector::Zero(queries.rows());
    lmo::ParallelRanges(
      lmo::Index(queries.rows()),
      [&](lmo::Index begin, lmo::Index end)
      {
        vtkNew<vtkGenericCell> cell;
        for (lmo::Index i = begin; i < end; ++i)
        {
          double closest[3];
          vtkIdType id = -1;
          int subId = 0;
          double squaredDistance = 0;
          this->Locator->FindClosestPoint(
            queries.row(i).data(), closest, cell, id, subId, squaredDistance);
          distances[i] = std::sqrt(squaredDistance);
        }
      },
      lmo::ParallelGrain);
    return distances;
  }

private:
  /// The triangles alone: strips of one or two points make vtkPolyData crash. The locator does not
  /// find triangles without area; it does find their edges.
  vtkSmartPointer<vtkPolyData> ForLocator(vtkPoints* points) const
  {
    vtkNew<vtkCellArray> edges;
    vtkNew<vtkCellArray> triangles;
    const lmo::Triangles& T = this->Mesh.triangles;
    triangles->AllocateExact(T.rows(), T.size());
    for (lmo::Index t = 0; t < T.rows(); ++t)
    {
      if (lmo::ScaledNormal(this->Mesh.points, T, t).norm() > 0)
      {
        triangles->InsertNextCell({ T(t, 0), T(t, 1), T(t, 2) });
        continue;
      }
      for (int corner = 0; corner < 3 && !lmo::IsCollapsed(T, t); ++corner)
      {
        edges->InsertNextCell({ T(t, corner), T(t, (corner + 1) % 3) });
      }
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(edges);
    data->SetPolys(triangles);
    return data;
  }

  lmo::SurfaceMesh Mesh;
  lmo::MeshTopology Topology;
  lmo::SurfaceSampler Sampler;
  vtkNew<vtkStaticCellLocator> Locator;
};

struct Deviation
{
  double maximum = 0;
  double mean = 0;
};

/// Distance from one surface to the other, in this direction.
Deviation MeasureDeviation(const Surface& from, Surface& to, lmo::Index samples)
{
  const lmo::Vector atPoints = to.Distances(from.UsedPoints());
  const lmo::Vector atSamples = to.Distances(from.Samples(samples));
  Deviation deviation;
  deviation.maximum = atPoints.maxCoeff();
  if (atSamples.size() > 0)
  {
    deviation.maximum = std::max(deviation.maximum, atSamples.maxCoeff());
    deviation.mean = atSamples.mean();
  }
  return deviation;
}
}

vtkSurfaceDeviation::vtkSurfaceDeviation()
{
  this->SetNumberOfInputPorts(2);
}

void vtkSurfaceDeviation::SetReferenceConnection(vtkAlgorithmOutput* reference)
{
  this->SetInputConnection(1, reference);
}

void vtkSurfaceDeviation::SetReferenceData(vtkPolyData* reference)
{
  this->SetInputData(1, reference);
}

int vtkSurfaceDeviation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkSurfaceDeviation::Compare(
  vtkPolyData* surfaceData, vtkPolyData* referenceData, vtkPolyData* output)
{
  if (this->NumberOfSamples <= 0)
  {
    throw lmo::InputError(
      "NumberOfSamples is " + std::to_string(this->NumberOfSamples) + "; it must be more than 0.");
  }
  Surface surface(surfaceData);
  Surface reference(referenceData);
  if (reference.IsEmpty() && !surface.IsEmpty())
  {
    throw lmo::InputError(
      "The reference surface on port 1 has no triangles. Connect one that has.");
  }
  Deviation forth;
  Deviation back;
  lmo::Vector distances = lmo::Vector::Zero(surface.GetPoints().rows());
  if (!surface.IsEmpty())
  {
    distances = reference.Distances(surface.GetPoints());
    forth = MeasureDeviation(surface, reference, this->NumberOfSamples);
    this->UpdateProgress(0.5);
    back = MeasureDeviation(reference, surface, this->NumberOfSamples);
  }
  const double diagonal = reference.Diagonal();
  this->HausdorffDistance = std::max(forth.maximum, back.maximum);
  this->MeanDistance = (forth.mean + back.mean) / 2;
  this->RelativeHausdorffDistance = diagonal > 0 ? this->HausdorffDistance / diagonal : 0;
  this->RelativeMeanDistance = diagonal > 0 ? this->MeanDistance / diagonal : 0;

  output->ShallowCopy(surfaceData);
  output->GetPointData()->AddArray(lmo::MakeArray("Distance", distances));
  vtkFieldData* figures = output->GetFieldData();
  figures->AddArray(lmo::MakeArray("HausdorffDistance", this->HausdorffDistance));
  figures->AddArray(lmo::MakeArray("RelativeHausdorffDistance", this->RelativeHausdorffDistance));
  figures->AddArray(lmo::MakeArray("MeanDistance", this->MeanDistance));
  figures->AddArray(lmo::MakeArray("RelativeMeanDistance", this->RelativeMeanDistance));
}

int vtkSurfaceDeviation::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* surface = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* reference = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return lmo::RunFilter(this, surface, output, [&] { this->Compare(surface, reference, output); });
}

void vtkSurfaceDeviation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "HausdorffDistance: " << this->HausdorffDistance << "\n";
  os << indent << "RelativeHausdorffDistance: " << this->RelativeHausdorffDistance << "\n";
  os << indent << "MeanDistance: " << this->MeanDistance << "\n";
  os << indent << "RelativeMeanDistance: " << this->RelativeMeanDistance << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
