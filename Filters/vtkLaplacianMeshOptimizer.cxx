// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLaplacianMeshOptimizer.h"

#include "Private/CellNormals.h"
#include "Private/FilterSupport.h"
#include "Private/OptimizerSession.h"
#include "Private/OptimizerTables.h"
#include "Private/PointNormals.h"
#include "Private/PolyDataConversion.h"
#include "Private/PolyDataOutput.h"
#include "Private/ResultArrays.h"
#include "Private/SurfaceBlocks.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
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
{
  this->SetNumberOfInputPorts(3);
}

vtkLaplacianMeshOptimizer::~vtkLaplacianMeshOptimizer() = default;

std::unique_ptr<vtkLaplacianMeshOptimizer::Session> vtkLaplacianMeshOptimizer::MakeSession()
{
  return std::make_unique<Session>(this);
}

void vtkLaplacianMeshOptimizer::Session::OptimizeWhole(
  const Whole& whole, const Job& job, const Whole& reference, vtkPolyData* output)
{
  vtkPolyData* input = whole.data;
  lmo::OptimizerOptions options;
  this->Try([&] { options = this->ReadOptions(input); });
  const std::unique_ptr<lmo::ProgressMonitor> monitor = this->MakeMonitor();
  monitor->Begin("Reading the mesh");
  this->SetInput(input, whole.firstPoints);
  lmo::VertexArrays arrays;
  this->Try(
    [&]
    {
      arrays = this->ReadArrays(input, job.isSelected);
      arrays.reference = this->ReadReference(reference);
      arrays.earlier = this->FindEarlierStep(job);
    });
  lmo::OptimizerResult result = this->Optimizer->Run(options, arrays, *monitor);
  this->KeepStep(job, result);
  this->Try([&] { lmo::CheckRange(result.positions, this->Numbering); });
  this->Warn(options, result);
  if (result.isCancelled)
  {
    lmo::KeepOutput(this->Filter);
  }
  else
  {
    monitor->Begin("Writing the result");
  }
  output->ShallowCopy(input);
  lmo::ResultArrays results;
  this->AddMetrics(result);
  this->WriteMetrics(result, results, output->GetFieldData());
  this->WritePoints(std::move(result), input, reference.data, results, output);
  results.Warn(this->Filter);
}

void vtkLaplacianMeshOptimizer::Session::Warn(
  const lmo::OptimizerOptions& options, const lmo::OptimizerResult& result) const
{
  if (!result.isConverged)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "The solver stopped at the relative residual "
        << result.relativeResidual << ", above the tolerance " << options.solver.tolerance
        << ". Raise MaximumNumberOfIterations or choose another SolverType.");
  }
  std::vector<std::string> texts = lmo::WarnOfDamage(options, result.comparison, result.volumeLoss);
  texts.push_back(lmo::WarnOfFreedom(result.freedom));
  texts.push_back(lmo::WarnOfUnmoved(result.unmovedComponents));
  texts.push_back(lmo::WarnOfUnpreserved(result.unpreservedVolumes));
  texts.push_back(lmo::WarnOfBeyond(result.deviation.beyond));
  texts.push_back(lmo::WarnOfIntersections(result.intersections));
  for (const std::string& text : texts)
  {
    if (!text.empty())
    {
      vtkWarningWithObjectMacro(this->Filter, << text);
    }
  }
}

void vtkLaplacianMeshOptimizer::Session::WritePoints(lmo::OptimizerResult result,
  vtkPolyData* input, vtkPolyData* reference, lmo::ResultArrays& results, vtkPolyData* output) const
{
  const lmo::MeshNumbering& numbering = this->Numbering;
  vtkPointData* pointData = output->GetPointData();
  this->WritePointData(result, input, pointData);
  this->AddDataOfReference(reference, result, output);
  const auto add = [&](const char* name, auto& values)
  { results.Add(pointData, lmo::MakeArray(name, std::move(values), numbering)); };
  if (input->GetPoints())
  {
    output->SetPoints(lmo::MakePoints(result.positions, numbering, input->GetPoints()));
    result.positions.resize(0, 3); // memory for the arrays
  }
  if (this->Filter->DiagnosticArrays)
  {
    add("MeanCurvature", result.meanCurvatures);
    add("PositionWeight", result.positionWeights);
    add("LaplacianWeight", result.laplacianWeights);
    add("Displacement", result.displacements);
    lmo::AddRadiusRatios("InputRadiusRatio", *result.comparison.before, numbering, results, output);
  }
  if (result.featureClass)
  {
    add("FeatureClass", *result.featureClass);
  }
  if (result.intersections.isKnown)
  {
    lmo::AddCellFlags(
      "SelfIntersecting", result.intersections.isIntersecting, numbering, results, output);
  }
  lmo::AddRadiusRatios("RadiusRatio", result.comparison.after, numbering, results, output);
  this->WriteCellNormals(output);
}

void vtkLaplacianMeshOptimizer::SetSelectionConnection(vtkAlgorithmOutput* selection)
{
  this->SetInputConnection(1, selection);
}

void vtkLaplacianMeshOptimizer::SetSelectionData(vtkSelection* selection)
{
  this->SetInputData(1, selection);
}

void vtkLaplacianMeshOptimizer::SetReferenceConnection(vtkAlgorithmOutput* reference)
{
  this->SetInputConnection(2, reference);
}

void vtkLaplacianMeshOptimizer::SetReferenceData(vtkDataObject* reference)
{
  this->SetInputData(2, reference);
}

int vtkLaplacianMeshOptimizer::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkSelection");
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  if (port > 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkLaplacianMeshOptimizer::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // as the input
  return 1;
}

vtkTypeBool vtkLaplacianMeshOptimizer::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, inputVector, outputVector);
  }
  lmo::SetOutputFor(vtkDataObject::GetData(inputVector[0]), outputVector->GetInformationObject(0));
  return 1;
}

int vtkLaplacianMeshOptimizer::UpdateMetrics()
{
  if (this->State)
  {
    this->Update();
  }
  return this->State != nullptr;
}

int vtkLaplacianMeshOptimizer::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // ParaView reads the metrics before it executes the filter again.
  Session::SetMetrics(this, {});
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

int vtkLaplacianMeshOptimizer::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const Session::Inputs inputs{ vtkDataObject::GetData(inputVector[0]),
    vtkSelection::GetData(inputVector[1]), vtkDataObject::GetData(inputVector[2]) };
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* request = outputVector->GetInformationObject(0);
  const int pieces = request->Has(Pipeline::UPDATE_NUMBER_OF_PIECES())
                       ? request->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())
                       : 1;
  if (!this->State)
  {
    this->State = this->MakeSession();
  }
  return lmo::RunFilter(
    this, inputs.data, output, [&] { this->State->Execute(inputs, output, pieces); },
    [&]
    {
      if (pieces == 1)
      {
        this->State->ReturnInput(inputs, output);
      }
    });
}

void vtkLaplacianMeshOptimizer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, auto value, auto...)
  { os << indent << name << ": " << value << "\n"; };
  const lmo::OptimizerOptions options;
  Tables::VisitProperties(*this, options, print);
  Tables::VisitMetrics(*this, {}, print);
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
