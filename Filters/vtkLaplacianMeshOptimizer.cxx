// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLaplacianMeshOptimizer.h"

#include "Private/CellNormals.h"
#include "Private/FilterSupport.h"
#include "Private/OptimizerInternals.h"
#include "Private/OptimizerTables.h"
#include "Private/PolyDataOutput.h"

#include "vtkCellData.h"
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

#include <type_traits>
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
  this->SetMetrics(result);
  this->WriteMetrics(result, results, output->GetFieldData());
  this->WritePoints(std::move(result), input, results, output);
  results.Warn(this->Filter);
}

void vtkLaplacianMeshOptimizer::Internals::Warn(
  const lmo::OptimizerOptions& options, const lmo::OptimizerResult& result) const
{
  if (!result.isConverged)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "The solver stopped at the relative residual "
        << result.relativeResidual << ", above the tolerance " << options.solver.tolerance
        << ". Raise MaximumNumberOfIterations or choose another SolverType.");
  }
  const std::string freedom = lmo::WarnOfFreedom(result.freedom);
  if (!freedom.empty())
  {
    vtkWarningWithObjectMacro(this->Filter, << freedom);
  }
  for (const std::string& damage : lmo::WarnOfDamage(options, result.comparison, result.volumeLoss))
  {
    vtkWarningWithObjectMacro(this->Filter, << damage);
  }
}

void vtkLaplacianMeshOptimizer::Internals::WritePoints(lmo::OptimizerResult result,
  vtkPolyData* input, lmo::ResultArrays& results, vtkPolyData* output) const
{
  if (input->GetPoints())
  {
    output->SetPoints(lmo::MakePoints(std::move(result.positions), input->GetPoints()));
  }
  vtkPointData* pointData = output->GetPointData();
  results.Add(pointData, lmo::MakeArray("MeanCurvature", std::move(result.meanCurvatures)));
  results.Add(pointData, lmo::MakeArray("PositionWeight", std::move(result.positionWeights)));
  results.Add(pointData, lmo::MakeArray("LaplacianWeight", std::move(result.laplacianWeights)));
  results.Add(pointData, lmo::MakeArray("Displacement", std::move(result.displacements)));
  if (result.featureClass.rows() > 0)
  {
    results.Add(pointData, lmo::MakeArray("FeatureClass", std::move(result.featureClass)));
  }
  this->WriteNormals(result.normals, output);
  const lmo::TriangleCells& cells = this->Engine->GetTriangleCells();
  lmo::AddRadiusRatios("InputRadiusRatio", *result.comparison.before, cells, results, output);
  lmo::AddRadiusRatios("RadiusRatio", result.comparison.after, cells, results, output);
}

void vtkLaplacianMeshOptimizer::Internals::WriteNormals(
  const lmo::Points& pointNormals, vtkPolyData* output) const
{
  if (pointNormals.rows() > 0)
  {
    vtkPointData* pointData = output->GetPointData();
    pointData->SetNormals(lmo::ReplaceNormals(pointData->GetNormals(), pointNormals));
  }
  vtkCellData* cellData = output->GetCellData();
  if (this->Filter->ComputeNormals && output->GetPoints() && cellData->GetNormals())
  {
    cellData->SetNormals(
      lmo::ReplaceNormals(cellData->GetNormals(), lmo::CellNormals(output), "cell"));
  }
}

void vtkLaplacianMeshOptimizer::Internals::SetMetrics(const lmo::OptimizerResult& result) const
{
  Tables::VisitMetrics(*this->Filter, result,
    [](const char*, auto& value, auto newValue, bool = true)
    { value = static_cast<std::decay_t<decltype(value)>>(newValue); });
}

void vtkLaplacianMeshOptimizer::Internals::WriteMetrics(
  const lmo::OptimizerResult& result, lmo::ResultArrays& results, vtkFieldData* fieldData) const
{
  Tables::VisitMetrics(*this->Filter, result,
    [&](const char* name, auto value, auto, bool isOfMode = true)
    {
      if (isOfMode)
      {
        results.Add(fieldData, lmo::MakeArray(name, static_cast<double>(value)));
      }
      else
      {
        lmo::ResultArrays::Remove(
          fieldData, name); // an earlier filter may have written it, for another surface
      }
    });
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
  // ParaView reads the metrics before it executes the filter again.
  this->State->SetMetrics({});
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
  const auto print = [&](const char* name, auto value, auto...)
  { os << indent << name << ": " << value << "\n"; };
  const lmo::OptimizerOptions options;
  Tables::VisitProperties(*this, options, print);
  Tables::VisitMetrics(*this, {}, print);
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
