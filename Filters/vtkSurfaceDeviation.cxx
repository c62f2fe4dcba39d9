// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceDeviation.h"

#include "Core/Deviation/SignedDistance.h"
#include "Core/Deviation/SurfaceDistance.h"
#include "Private/FilterSupport.h"
#include "Private/JoinedPieces.h"
#include "Private/PolyDataConversion.h"
#include "Private/PolyDataOutput.h"
#include "Private/SurfaceBlocks.h"
#include "Private/SurfaceExtraction.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkSurfaceDeviation);

namespace
{
/// The surfaces of all blocks and partitions, one after the other.
lmo::SurfacePieces SurfacesOf(vtkDataObject* data)
{
  lmo::SurfacePieces surfaces;
  for (const lmo::SurfaceBlock& block : lmo::FindBlocks(data))
  {
    for (const lmo::SurfacePart& part : block.parts)
    {
      surfaces.push_back(lmo::SurfaceOf(part.data));
    }
  }
  return surfaces;
}

/// The surfaces of all blocks and partitions as one.
vtkSmartPointer<vtkPolyData> JoinedSurfaceOf(vtkDataObject* data)
{
  if (vtkCompositeDataSet::SafeDownCast(data))
  {
    return lmo::JoinedPieces(SurfacesOf(data), lmo::Joining::ONE_SURFACE).GetSurface();
  }
  return lmo::SurfaceOf(data);
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

void vtkSurfaceDeviation::SetReferenceData(vtkDataObject* reference)
{
  this->SetInputData(1, reference);
}

int vtkSurfaceDeviation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkSurfaceDeviation::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // as the input
  return 1;
}

vtkTypeBool vtkSurfaceDeviation::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, inputVector, outputVector);
  }
  lmo::SetOutputFor(vtkDataObject::GetData(inputVector[0]), outputVector->GetInformationObject(0));
  return 1;
}

void vtkSurfaceDeviation::Compare(
  vtkDataObject* input, vtkDataObject* reference, vtkDataObject* output)
{
  if (!vtkCompositeDataSet::SafeDownCast(input))
  {
    this->CompareSurfaces(
      lmo::SurfaceOf(input), JoinedSurfaceOf(reference), vtkPolyData::SafeDownCast(output));
    return;
  }
  const lmo::SurfacePieces pieces = SurfacesOf(input);
  const lmo::JoinedPieces joined(pieces, lmo::Joining::ONE_SURFACE);
  vtkNew<vtkPolyData> compared;
  this->CompareSurfaces(joined.GetSurface(), JoinedSurfaceOf(reference), compared);
  lmo::SurfacePieces parts;
  lmo::ResultArrays results;
  for (std::size_t k = 0; k < pieces.size(); ++k)
  {
    parts.push_back(joined.HandBack(pieces[k], k, compared, results));
  }
  results.Warn(this);
  lmo::SetParts(input, parts, output);
}

void vtkSurfaceDeviation::CompareSurfaces(
  vtkPolyData* surfaceData, vtkPolyData* referenceData, vtkPolyData* output)
{
  if (this->NumberOfSamples <= 0)
  {
    throw lmo::InputError(
      "NumberOfSamples is " + std::to_string(this->NumberOfSamples) + "; it must be more than 0.");
  }
  const lmo::SurfaceMesh surface = lmo::ReadMesh(surfaceData);
  lmo::SurfaceMesh reference = lmo::ReadMesh(referenceData);
  lmo::FilterMonitor monitor(this);
  const lmo::SurfaceDistance distance = lmo::MeasureSurfaceDistance(surface.points,
    surface.triangles, reference.points, reference.triangles, this->NumberOfSamples, monitor);
  const double diagonal = distance.diagonal;
  this->HausdorffDistance = distance.hausdorff;
  this->MeanDistance = distance.mean;
  this->RelativeHausdorffDistance = diagonal > 0 ? this->HausdorffDistance / diagonal : 0;
  this->RelativeMeanDistance = diagonal > 0 ? this->MeanDistance / diagonal : 0;

  output->ShallowCopy(surfaceData);
  lmo::ResultArrays results;
  const auto distances = lmo::MakeArray("Distance", distance.atVertices, surface.numbering);
  results.Add(output->GetPointData(), distances);
  output->GetPointData()->SetActiveScalars(distances->GetName()); // what viewers show first
  // Triangles that do not share their points are closed only together.
  lmo::WeldCoincidentPoints(reference);
  lmo::ResultArrays::Remove(output->GetPointData(), "SignedDistance");
  if (auto signedDistances = lmo::SignedDistances(surface.points, distance.atVertices,
        distance.closestTriangles, reference.points, reference.triangles, monitor))
  {
    results.Add(output->GetPointData(),
      lmo::MakeArray("SignedDistance", std::move(*signedDistances), surface.numbering));
  }
  vtkFieldData* metrics = output->GetFieldData();
  results.Add(metrics, lmo::MakeArray("HausdorffDistance", this->HausdorffDistance));
  results.Add(
    metrics, lmo::MakeArray("RelativeHausdorffDistance", this->RelativeHausdorffDistance));
  results.Add(metrics, lmo::MakeArray("MeanDistance", this->MeanDistance));
  results.Add(metrics, lmo::MakeArray("RelativeMeanDistance", this->RelativeMeanDistance));
  results.Warn(this);
}

int vtkSurfaceDeviation::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* surface = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* reference = vtkDataObject::GetData(inputVector[1]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  this->HasExecuted = true;
  this->HausdorffDistance = this->RelativeHausdorffDistance = -1;
  this->MeanDistance = this->RelativeMeanDistance = -1;
  return lmo::RunFilter(this, surface, output, [&] { this->Compare(surface, reference, output); });
}

int vtkSurfaceDeviation::UpdateMetrics()
{
  const int pieces =
    this->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES());
  if (!this->HasExecuted || pieces > 1)
  {
    return 0;
  }
  this->Update();
  return 1;
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
