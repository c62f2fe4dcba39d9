// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLaplacianMeshOptimizer.h"

#include "Private/FilterSupport.h"
#include "Private/OptimizerEngine.h"
#include "Private/PointSelection.h"
#include "Private/PolyDataOutput.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
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

#include <cmath>
#include <cstring>
#include <sstream>
#include <utility>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

namespace
{
void CheckEnumeration(const char* name, int value, int count)
{
  if (value < 0 || value >= count)
  {
    throw lmo::InputError(std::string(name) + " is " + std::to_string(value) +
                          "; choose a value from 0 to " + std::to_string(count - 1) + ".");
  }
}

void CheckNumber(const char* name, double value, bool isValid, const char* range)
{
  if (!isValid || !std::isfinite(value))
  {
    std::ostringstream text;
    text << name << " is " << value << "; it must be " << range << ".";
    throw lmo::InputError(text.str());
  }
}
}

/// What needs the numerics' types.
struct vtkLaplacianMeshOptimizer::Internals
{
  explicit Internals(vtkLaplacianMeshOptimizer* filter)
    : Filter(filter)
  {
  }

  vtkLaplacianMeshOptimizer* const Filter;

  std::unique_ptr<vtkLaplacianMeshOptimizer::Engine> Engine;

  /// \throw lmo::InputError if a property is out of range.
  lmo::OptimizerOptions ReadOptions() const;

  /// The point array of an index; null if none is chosen.
  /// \throw lmo::InputError if the chosen one does not exist.
  vtkDataArray* FindArray(int index, vtkPolyData* input) const;

  /// \param selection may be null
  lmo::VertexArrays ReadArrays(vtkPolyData* input, vtkSelection* selection) const;

  /// \param selection may be null
  /// \param pieces in which the whole surface comes
  void Execute(vtkPolyData* input, vtkSelection* selection, vtkPolyData* output, int pieces);

  void WritePoints(lmo::OptimizerResult result, vtkPolyData* input, vtkPolyData* output) const;

  /// Sets the figures that the Get methods return.
  void SetFigures(const lmo::OptimizerResult& result) const;

  void WriteFigures(vtkFieldData* fieldData) const;
};

vtkObjectFactoryNewMacro(vtkLaplacianMeshOptimizer);

vtkLaplacianMeshOptimizer::vtkLaplacianMeshOptimizer()
  : State(new Internals(this))
{
  this->SetNumberOfInputPorts(2);
}

vtkLaplacianMeshOptimizer::~vtkLaplacianMeshOptimizer() = default;

lmo::OptimizerOptions vtkLaplacianMeshOptimizer::Internals::ReadOptions() const
{
  const vtkLaplacianMeshOptimizer& filter = *this->Filter;
  CheckEnumeration("Mode", filter.Mode, 5);
  CheckEnumeration("LaplacianType", filter.LaplacianType, 3);
  CheckEnumeration("PositionWeighting", filter.PositionWeighting, 5);
  CheckEnumeration("LaplacianWeighting", filter.LaplacianWeighting, 5);
  CheckEnumeration("BoundaryCondition", filter.BoundaryCondition, 3);
  CheckEnumeration("SelectionUse", filter.SelectionUse, 2);
  CheckEnumeration("SolverType", filter.SolverType, 3);
  CheckNumber("ScaleFactor", filter.ScaleFactor,
    filter.ScaleFactor >= lmo::SmallestScaleFactor && filter.ScaleFactor <= lmo::LargestWeight,
    "more than 0, from 1e-40 to 1e40");
  CheckNumber("GaussianWidth", filter.GaussianWidth, filter.GaussianWidth > 0, "more than 0");
  CheckNumber("TangentPlaneWeight", filter.TangentPlaneWeight,
    filter.TangentPlaneWeight >= 0 && filter.TangentPlaneWeight <= lmo::LargestWeight,
    "0 or more, up to 1e40");
  CheckNumber(
    "Tolerance", filter.Tolerance, filter.Tolerance > 0 && filter.Tolerance < 1, "between 0 and 1");
  CheckNumber("MaximumNumberOfIterations", filter.MaximumNumberOfIterations,
    filter.MaximumNumberOfIterations > 0, "more than 0");

  CheckNumber("MaximumDeviation", filter.MaximumDeviation,
    filter.MaximumDeviation > 0 && filter.MaximumDeviation <= 1, "more than 0, up to 1");
  CheckNumber("NumberOfPasses", filter.NumberOfPasses, filter.NumberOfPasses > 0, "more than 0");
  CheckNumber("FeatureAngle", filter.FeatureAngle,
    filter.FeatureAngle >= 0 && filter.FeatureAngle <= 180, "from 0 to 180");
  CheckNumber(
    "NormalIterations", filter.NormalIterations, filter.NormalIterations >= 0, "0 or more");
  CheckNumber("NormalWidth", filter.NormalWidth, filter.NormalWidth > 0, "more than 0");
  CheckNumber("DetailWeight", filter.DetailWeight,
    filter.DetailWeight > 0 && filter.DetailWeight <= lmo::LargestWeight,
    "more than 0, up to 1e40");

  lmo::OptimizerOptions options;
  options.mode = static_cast<lmo::Mode>(filter.Mode);
  options.laplacianType = static_cast<lmo::LaplacianType>(filter.LaplacianType);
  options.robustLaplacian = filter.RobustLaplacian;
  options.positionWeighting = static_cast<lmo::PositionWeighting>(filter.PositionWeighting);
  options.scaleFactor = filter.ScaleFactor;
  options.laplacianWeighting = static_cast<lmo::LaplacianWeighting>(filter.LaplacianWeighting);
  options.gaussianWidth = filter.GaussianWidth;
  options.modulateByTriangleQuality = filter.ModulateByTriangleQuality;
  options.tangentPlaneConstraints = filter.TangentPlaneConstraints;
  options.tangentPlaneWeight = filter.TangentPlaneWeight;
  options.boundaryCondition = static_cast<lmo::BoundaryCondition>(filter.BoundaryCondition);
  options.solverType = static_cast<lmo::SolverType>(filter.SolverType);
  options.solver.tolerance = filter.Tolerance;
  options.solver.maximumIterations = filter.MaximumNumberOfIterations;
  options.deviation.maximum = filter.MaximumDeviation;
  options.deviation.passes = filter.NumberOfPasses;
  options.deviation.improveWorstTriangles = filter.ImproveWorstTriangles;
  options.guide.normalIterations = filter.NormalIterations;
  options.guide.normalWidth = filter.NormalWidth;
  options.guide.detailWeight = filter.DetailWeight;
  options.featureConstraints = filter.FeatureConstraints;
  options.detectFeatures = filter.DetectFeatures;
  options.featureAngle = filter.FeatureAngle;
  options.preserveVolume = filter.PreserveVolume;
  options.twicing = filter.Twicing;
  return options;
}

vtkDataArray* vtkLaplacianMeshOptimizer::Internals::FindArray(int index, vtkPolyData* input) const
{
  vtkInformation* choice = this->Filter->GetInputArrayInformation(index);
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  // ParaView's choice of no array is the name "None".
  const bool isNamed = name && *name && std::strcmp(name, "None") != 0;
  if (input->GetNumberOfPoints() == 0)
  {
    return nullptr; // an empty piece has no arrays
  }
  if (!isNamed && !choice->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
  {
    return nullptr;
  }
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* array = this->Filter->GetInputArrayToProcess(index, input, association);
  const bool isOfCells =
    index == FEATURE_ARRAY && association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  if (!array || !(isOfCells || association == vtkDataObject::FIELD_ASSOCIATION_POINTS))
  {
    throw lmo::InputError(std::string("There is no numeric point ") +
                          (index == FEATURE_ARRAY ? "or cell " : "") + "array '" +
                          std::string(isNamed ? name : "of the chosen attribute") +
                          "'. Choose one that the input has.");
  }
  return array;
}

lmo::VertexArrays vtkLaplacianMeshOptimizer::Internals::ReadArrays(
  vtkPolyData* input, vtkSelection* selection) const
{
  const vtkLaplacianMeshOptimizer& filter = *this->Filter;
  const vtkIdType points = input->GetNumberOfPoints();
  const int weighting = filter.PositionWeighting;
  lmo::VertexArrays arrays;
  vtkDataArray* array = nullptr;
  if ((weighting == ARRAY || weighting == ANCHORS) &&
      (array = this->FindArray(POSITION_WEIGHT_ARRAY, input)))
  {
    arrays.positionWeights =
      weighting == ARRAY ? lmo::ReadWeights(array, points) : lmo::ReadScalars(array, points);
  }
  if (filter.LaplacianWeighting == ARRAY &&
      (array = this->FindArray(LAPLACIAN_WEIGHT_ARRAY, input)))
  {
    arrays.laplacianWeights = lmo::ReadWeights(array, points);
  }
  if (filter.Mode == PRESCRIBED_LAPLACIANS &&
      (array = this->FindArray(PRESCRIBED_LAPLACIAN_ARRAY, input)))
  {
    arrays.prescribedLaplacians = lmo::ReadVectors(array, points);
  }
  if ((array = this->FindArray(FIXED_POINT_ARRAY, input)))
  {
    arrays.fixedPoints = lmo::ReadScalars(array, points);
  }
  const bool hasFeatures = filter.Mode == OPTIMIZE_WITHIN_DEVIATION || filter.FeatureConstraints;
  if (hasFeatures && (array = this->FindArray(FEATURE_ARRAY, input)))
  {
    const bool isOfPoints = input->GetPointData()->HasArray(array->GetName()) &&
                            input->GetPointData()->GetArray(array->GetName()) == array;
    isOfPoints ? arrays.featurePoints = lmo::ReadScalars(array, points)
               : arrays.regions = lmo::ReadScalars(array, input->GetNumberOfCells());
  }
  if (selection)
  {
    lmo::Vector isFixed = lmo::SelectedPoints(input, selection);
    if (filter.SelectionUse == ONLY_SELECTED_POINTS_MOVE)
    {
      isFixed = 1 - isFixed.array();
    }
    arrays.fixedPoints = arrays.fixedPoints ? lmo::Vector(arrays.fixedPoints->cwiseAbs() + isFixed)
                                            : std::move(isFixed);
  }
  return arrays;
}

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
  const std::unique_ptr<lmo::Monitor> monitor = this->Engine->MakeMonitor();
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
