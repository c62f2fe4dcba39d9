// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLaplacianMeshOptimizer.h"

#include "Private/FilterSupport.h"
#include "Private/OptimizerInternals.h"
#include "Private/PolyDataOutput.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <utility>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkObjectFactoryNewMacro(vtkLaplacianMeshOptimizer);

vtkLaplacianMeshOptimizer::vtkLaplacianMeshOptimizer()
  : State(new Internals(this))
{
  this->SetNumberOfInputPorts(2);
}

vtkLaplacianMeshOptimizer::~vtkLaplacianMeshOptimizer() = default;

std::unique_ptr<vtkLaplacianMeshOptimizer::Engine> vtkLaplacianMeshOptimizer::MakeEngine()
{
  return std::make_unique<Engine>(this);
}

void vtkLaplacianMeshOptimizer::Internals::Execute(
  vtkPolyData* input, vtkSelection* selection, vtkPolyData* output, int pieces)
{
  if (!this->Engine)
  {
    this->Engine = this->Filter->MakeEngine();
  }
  this->Engine->CheckPieces(pieces);
  lmo::OptimizerOptions options;
  lmo::VertexArrays arrays;
  this->Engine->Try(
    [&]
    {
      this->CheckProperties();
      options = this->ReadOptions();
      arrays = this->ReadArrays(input, selection);
    });
  const bool hasNormals = input->GetPointData()->GetNormals() != nullptr;
  options.computeNormals = this->Filter->ComputeNormals && hasNormals;
  options.roundToFloat = input->GetPoints() && input->GetPoints()->GetDataType() == VTK_FLOAT;
  const std::unique_ptr<lmo::ProgressMonitor> monitor = this->Engine->MakeMonitor();
  monitor->Begin("Reading the mesh");
  this->Engine->SetInput(input);
  lmo::OptimizerResult result = this->Engine->Run(options, arrays, *monitor);
  this->Engine->Try([&] { lmo::CheckRange(result.positions); });
  if (!result.isConverged)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "The solver stopped at the relative residual "
        << result.relativeResidual << ", above the tolerance " << options.solver.tolerance
        << ". Raise MaximumNumberOfIterations or choose another SolverType.");
  }
  if (result.isCancelled)
  {
    lmo::KeepOutput(this->Filter);
  }
  else
  {
    monitor->Begin("Writing the result");
  }
  output->ShallowCopy(input);
  this->SetFigures(result);
  this->WriteFigures(output->GetFieldData());
  this->WritePoints(std::move(result), input, output);
}

void vtkLaplacianMeshOptimizer::Internals::WritePoints(
  lmo::OptimizerResult result, vtkPolyData* input, vtkPolyData* output) const
{
  if (input->GetPoints())
  {
    output->SetPoints(lmo::MakePoints(std::move(result.positions), input->GetPoints()));
  }
  vtkPointData* pointData = output->GetPointData();
  pointData->AddArray(lmo::MakeArray("MeanCurvature", std::move(result.meanCurvatures)));
  pointData->AddArray(lmo::MakeArray("PositionWeight", std::move(result.positionWeights)));
  pointData->AddArray(lmo::MakeArray("LaplacianWeight", std::move(result.laplacianWeights)));
  pointData->AddArray(lmo::MakeArray("Displacement", std::move(result.displacements)));
  if (result.featureClass.rows() > 0)
  {
    pointData->AddArray(lmo::MakeArray("FeatureClass", std::move(result.featureClass)));
  }
  if (result.normals.rows() > 0)
  {
    pointData->SetNormals(lmo::ReplaceNormals(pointData->GetNormals(), result.normals));
  }
  const lmo::TriangleCells& cells = this->Engine->GetTriangleCells();
  lmo::AddRadiusRatios("InputRadiusRatio", *result.comparison.before, cells, output);
  lmo::AddRadiusRatios("RadiusRatio", result.comparison.after, cells, output);
}

void vtkLaplacianMeshOptimizer::Internals::SetFigures(const lmo::OptimizerResult& result) const
{
  const lmo::SurfaceComparison& comparison = result.comparison;
  vtkLaplacianMeshOptimizer& filter = *this->Filter;
  filter.MeanRadiusRatio = comparison.after.mean;
  filter.MinimumRadiusRatio = comparison.after.minimum;
  filter.InputMeanRadiusRatio = comparison.before->mean;
  filter.InputMinimumRadiusRatio = comparison.before->minimum;
  filter.MaximumDisplacement = comparison.maximumDisplacement;
  filter.RelativeMaximumDisplacement = comparison.relativeMaximumDisplacement;
  filter.RelativeVolumeChange = comparison.relativeVolumeChange;
  filter.FlippedTriangles = comparison.flippedTriangles;
  filter.Iterations = result.iterations;
  filter.RelativeResidual = result.relativeResidual;
  filter.RelativeHausdorffBound = result.deviation.relativeBound;
  filter.Passes = result.deviation.passes;
  filter.RolledBackPoints = result.deviation.rolledBack;
}

void vtkLaplacianMeshOptimizer::Internals::WriteFigures(vtkFieldData* fieldData) const
{
  const vtkLaplacianMeshOptimizer& filter = *this->Filter;
  const std::pair<const char*, double> figures[] = {
    { "MeanRadiusRatio", filter.MeanRadiusRatio },
    { "MinimumRadiusRatio", filter.MinimumRadiusRatio },
    { "InputMeanRadiusRatio", filter.InputMeanRadiusRatio },
    { "InputMinimumRadiusRatio", filter.InputMinimumRadiusRatio },
    { "MaximumDisplacement", filter.MaximumDisplacement },
    { "RelativeMaximumDisplacement", filter.RelativeMaximumDisplacement },
    { "RelativeVolumeChange", filter.RelativeVolumeChange },
    { "FlippedTriangles", double(filter.FlippedTriangles) },
    { "Iterations", double(filter.Iterations) },
    { "RelativeResidual", filter.RelativeResidual },
  };
  const std::pair<const char*, double> figuresWithinDeviation[] = {
    { "RelativeHausdorffBound", filter.RelativeHausdorffBound },
    { "Passes", double(filter.Passes) },
    { "RolledBackPoints", double(filter.RolledBackPoints) },
  };
  for (const auto& [name, value] : figures)
  {
    fieldData->AddArray(lmo::MakeArray(name, value));
  }
  for (const auto& [name, value] : figuresWithinDeviation)
  {
    fieldData->RemoveArray(name); // a filter before may have proved it, for another surface
    if (filter.Mode == OPTIMIZE_WITHIN_DEVIATION)
    {
      fieldData->AddArray(lmo::MakeArray(name, value));
    }
  }
}

void vtkLaplacianMeshOptimizer::SetSelectionConnection(vtkAlgorithmOutput* selection)
{
  this->SetInputConnection(1, selection);
}

void vtkLaplacianMeshOptimizer::SetSelectionData(vtkSelection* selection)
{
  this->SetInputData(1, selection);
}

int vtkLaplacianMeshOptimizer::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkSelection");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkLaplacianMeshOptimizer::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // ParaView reads the figures before it executes the filter again.
  lmo::OptimizerResult none;
  none.comparison.before = std::make_shared<lmo::MeshQuality>();
  this->State->SetFigures(none);
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

int vtkLaplacianMeshOptimizer::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkSelection* selection = vtkSelection::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* request = outputVector->GetInformationObject(0);
  const int pieces = request->Has(Pipeline::UPDATE_NUMBER_OF_PIECES())
                       ? request->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())
                       : 1;
  return lmo::RunFilter(
    this, input, output, [&] { this->State->Execute(input, selection, output, pieces); });
}

void vtkLaplacianMeshOptimizer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "LaplacianType: " << this->LaplacianType << "\n";
  os << indent << "RobustLaplacian: " << this->RobustLaplacian << "\n";
  os << indent << "PositionWeighting: " << this->PositionWeighting << "\n";
  os << indent << "ScaleFactor: " << this->ScaleFactor << "\n";
  os << indent << "LaplacianWeighting: " << this->LaplacianWeighting << "\n";
  os << indent << "GaussianWidth: " << this->GaussianWidth << "\n";
  os << indent << "ModulateByTriangleQuality: " << this->ModulateByTriangleQuality << "\n";
  os << indent << "TangentPlaneConstraints: " << this->TangentPlaneConstraints << "\n";
  os << indent << "TangentPlaneWeight: " << this->TangentPlaneWeight << "\n";
  os << indent << "BoundaryCondition: " << this->BoundaryCondition << "\n";
  os << indent << "SelectionUse: " << this->SelectionUse << "\n";
  os << indent << "SolverType: " << this->SolverType << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumNumberOfIterations: " << this->MaximumNumberOfIterations << "\n";
  os << indent << "MaximumDeviation: " << this->MaximumDeviation << "\n";
  os << indent << "NumberOfPasses: " << this->NumberOfPasses << "\n";
  os << indent << "ImproveWorstTriangles: " << this->ImproveWorstTriangles << "\n";
  os << indent << "FeatureConstraints: " << this->FeatureConstraints << "\n";
  os << indent << "DetectFeatures: " << this->DetectFeatures << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "NormalIterations: " << this->NormalIterations << "\n";
  os << indent << "NormalWidth: " << this->NormalWidth << "\n";
  os << indent << "DetailWeight: " << this->DetailWeight << "\n";
  os << indent << "PreserveVolume: " << this->PreserveVolume << "\n";
  os << indent << "Twicing: " << this->Twicing << "\n";
  os << indent << "ComputeNormals: " << this->ComputeNormals << "\n";
  os << indent << "MeanRadiusRatio: " << this->MeanRadiusRatio << "\n";
  os << indent << "MinimumRadiusRatio: " << this->MinimumRadiusRatio << "\n";
  os << indent << "InputMeanRadiusRatio: " << this->InputMeanRadiusRatio << "\n";
  os << indent << "InputMinimumRadiusRatio: " << this->InputMinimumRadiusRatio << "\n";
  os << indent << "MaximumDisplacement: " << this->MaximumDisplacement << "\n";
  os << indent << "RelativeMaximumDisplacement: " << this->RelativeMaximumDisplacement << "\n";
  os << indent << "RelativeVolumeChange: " << this->RelativeVolumeChange << "\n";
  os << indent << "FlippedTriangles: " << this->FlippedTriangles << "\n";
  os << indent << "Iterations: " << this->Iterations << "\n";
  os << indent << "RelativeResidual: " << this->RelativeResidual << "\n";
  os << indent << "RelativeHausdorffBound: " << this->RelativeHausdorffBound << "\n";
  os << indent << "Passes: " << this->Passes << "\n";
  os << indent << "RolledBackPoints: " << this->RolledBackPoints << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
