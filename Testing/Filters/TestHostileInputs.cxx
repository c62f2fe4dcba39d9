// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FilterTesting.h"
#include "HostileInputs.h"
#include "ResultChecks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkMeshLaplacian.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSurfaceDeviation.h"
#include "vtkTriangleRadiusRatio.h"

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

constexpr int Modes = 5;
constexpr int ChoicesOfMode = 3 * 5 * 5 * 3 * 3;

/// One choice of all enumerations, by its number; each switch is on in half of the choices.
class Choice
{
public:
  explicit Choice(int number)
    : Number(number)
  {
  }

  bool IsDirect() const { return this->Solver() == Optimizer::DIRECT; }
  bool PreservesVolume() const { return this->IsOn(3); }

  std::string Name() const
  {
    std::ostringstream text;
    text << "choice " << this->Number << ": mode " << this->Mode() << ", L " << this->Laplacian()
         << ", W_p " << this->PositionWeighting() << ", W_L " << this->LaplacianWeighting()
         << ", boundary " << this->Boundary() << ", solver " << this->Solver();
    return text.str();
  }

  void Set(Optimizer* filter) const
  {
    constexpr double deviations[] = { 0.002, 1e-300, 1e-9, 0.05, 1 };
    filter->SetMode(this->Mode());
    filter->SetLaplacianType(this->Laplacian());
    filter->SetPositionWeighting(this->PositionWeighting());
    filter->SetLaplacianWeighting(this->LaplacianWeighting());
    filter->SetBoundaryCondition(this->Boundary());
    filter->SetSolverType(this->Solver());
    filter->SetMaximumDeviation(deviations[this->LaplacianWeighting()]);
    filter->SetModulateByTriangleQuality(this->IsOn(0));
    filter->SetTangentPlaneConstraints(this->IsOn(1));
    filter->SetRobustLaplacian(this->IsOn(2));
    filter->SetPreserveVolume(this->PreservesVolume());
    filter->SetFeatureConstraints(this->IsOn(4));
    filter->SetTwicing(this->IsOn(5));
    filter->SetImproveWorstTriangles(this->IsOn(6));
    filter->SetInputArrayToProcess(Optimizer::FEATURE_ARRAY, 0, 0,
      vtkDataObject::FIELD_ASSOCIATION_POINTS, this->IsOn(7) ? "Weights" : "None");
  }

private:
  int Mode() const { return this->Number / ChoicesOfMode; }
  int Laplacian() const { return this->Number % 3; }
  int PositionWeighting() const { return this->Number / 3 % 5; }
  int LaplacianWeighting() const { return this->Number / 15 % 5; }
  int Boundary() const { return this->Number / 75 % 3; }
  int Solver() const { return this->Number / 225 % 3; }

  bool IsOn(int k) const { return (unsigned(this->Number) * 2654435761U) >> (16 + k) & 1U; }

  int Number;
};

/// Every choice whose number has that remainder.
std::vector<Choice> EachChoice(int step, int remainder)
{
  std::vector<Choice> choices;
  for (int k = remainder; k < Modes * ChoicesOfMode; k += step)
  {
    choices.emplace_back(k);
  }
  return choices;
}

void ChooseArrays(Optimizer* filter)
{
  const auto choose = [&](int index, const char* name)
  { filter->SetInputArrayToProcess(index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name); };
  choose(Optimizer::POSITION_WEIGHT_ARRAY, "Weights");
  choose(Optimizer::LAPLACIAN_WEIGHT_ARRAY, "Weights");
}

/// Prescribed Laplacians have the mesh's unit, mean curvature normals its inverse.
void ChooseLaplacians(Optimizer* filter)
{
  const bool isCurvature = filter->GetLaplacianType() == Optimizer::MEAN_CURVATURE;
  filter->SetInputArrayToProcess(Optimizer::PRESCRIBED_LAPLACIAN_ARRAY, 0, 0,
    vtkDataObject::FIELD_ASSOCIATION_POINTS, isCurvature ? "CurvatureVectors" : "Vectors");
}

/// True if the direct solver refuses weights or vertices that it is not made for.
bool IsDirectRefusal(const Choice& choice, const std::string& errors)
{
  return choice.IsDirect() && errors.find("use the iterative solver") != std::string::npos;
}

/// True if smoothing has made of a closed surface what has no inside.
bool IsVolumeRefusal(const Choice& choice, const std::string& errors)
{
  return choice.PreservesVolume() && errors.find("the volume back") != std::string::npos;
}

/// Empty if the choice gives a result without fault, or one that the error's remedy gives.
std::string FaultOfChoice(Optimizer* filter, const Choice& choice)
{
  choice.Set(filter);
  ChooseLaplacians(filter);
  Messages messages = Update(filter);
  if (IsDirectRefusal(choice, messages.errors))
  {
    filter->SetSolverType(Optimizer::ITERATIVE);
    messages = Update(filter);
  }
  if (IsVolumeRefusal(choice, messages.errors))
  {
    filter->PreserveVolumeOff();
    messages = Update(filter);
  }
  return FaultOfResult(filter, messages);
}

/// Remembers the first of many faults.
struct FirstFault
{
  std::string text;
  int count = 0;

  void Add(const std::string& name, const std::string& fault)
  {
    if (!fault.empty() && this->count++ == 0)
    {
      this->text = name + ": " + fault;
    }
  }
};

void Check(Checks& c, const std::string& property, const FirstFault& fault)
{
  const std::string count = std::to_string(fault.count) + " faults, the first with ";
  c.Equal(fault.count > 0 ? property + "; " + count + fault.text : property, fault.count, 0);
}

/// \param scaleFactor s, and how many times its default the detail weight is
void CheckOptimizer(
  Checks& c, const HostileInput& input, const std::vector<Choice>& choices, double scaleFactor)
{
  std::ostringstream name;
  name << input.name << ", s = " << scaleFactor;
  const auto copy = CopyOf(input.data);
  vtkNew<Optimizer> filter;
  filter->SetInputData(input.data);
  filter->SetScaleFactor(scaleFactor);
  filter->SetDetailWeight(scaleFactor * filter->GetDetailWeight());
  ChooseArrays(filter);
  FirstFault fault;
  for (const Choice& choice : choices)
  {
    if (input.errors.empty())
    {
      fault.Add(choice.Name(), FaultOfChoice(filter, choice));
    }
    else
    {
      choice.Set(filter);
      fault.Add(choice.Name(), FaultOfRefusal(filter, Update(filter), input.errors));
    }
  }
  Check(c, (input.errors.empty() ? "a finite result: " : "a clear error: ") + name.str(), fault);
  c.True("the input is as it was: " + name.str(), AreEqual(input.data, copy));
}

/// \param arrays that the filter adds to the points
void CheckFilter(Checks& c, const std::string& name, const HostileInput& input,
  vtkPolyDataAlgorithm* filter, std::initializer_list<const char*> arrays)
{
  const auto copy = CopyOf(input.data);
  filter->SetInputData(input.data);
  const Messages messages = Update(filter);
  const std::string fault = input.errors.empty() ? FaultOfResult(filter, messages, arrays)
                                                 : FaultOfRefusal(filter, messages, input.errors);
  c.True(name + ": " + input.name + (fault.empty() ? "" : ": " + fault), fault.empty());
  c.True(name + ", the input is as it was: " + input.name, AreEqual(input.data, copy));
}

void CheckOtherFilters(Checks& c, const HostileInput& input)
{
  for (const int isRobust : { 0, 1 })
  {
    vtkNew<vtkMeshLaplacian> laplacian;
    laplacian->SetRobustLaplacian(isRobust);
    laplacian->PrincipalCurvaturesOn();
    CheckFilter(c, isRobust ? "robust mesh Laplacian" : "mesh Laplacian", input, laplacian,
      { "UniformLaplacian", "CotangentLaplacian", "MeanCurvatureNormal", "MeanCurvature",
        "GaussianCurvature", "VoronoiArea", "SignedMeanCurvature", "PrincipalCurvature1",
        "PrincipalCurvature2", "PrincipalDirection1", "PrincipalDirection2" });
  }
  CheckFilter(c, "radius ratio", input, vtkNew<vtkTriangleRadiusRatio>(), { "RadiusRatio" });
  vtkNew<vtkSurfaceDeviation> deviation;
  deviation->SetNumberOfSamples(100);
  deviation->SetReferenceData(input.data);
  CheckFilter(c, "deviation from itself", input, deviation, { "Distance" });
  deviation->SetReferenceData(MakePolyData(Icosphere(1)));
  CheckFilter(c, "deviation from a sphere", input, deviation, { "Distance", "SignedDistance" });
  if (!input.errors.empty())
  {
    vtkNew<vtkSurfaceDeviation> reverse;
    reverse->SetInputData(MakePolyData(Icosphere(1)));
    reverse->SetReferenceData(input.data);
    c.True("deviation of a sphere from it: " + input.name,
      FaultOfRefusal(reverse, Update(reverse), input.errors).empty());
  }
}
}

int TestHostileInputs(int, char*[])
{
  Checks c;
  int number = 0;
  for (const HostileInput& input : HostileInputs())
  {
    // All inputs together see every choice, if none is left out for a sanitizer.
    CheckOptimizer(c, input, EachChoice(Thinning * (input.isLarge ? 97 : 7), number % 7), 1);
    CheckOptimizer(c, input, EachChoice(Thinning * 97, number), 1e-12);
    CheckOptimizer(c, input, EachChoice(Thinning * 97, number), 1e12);
    CheckOtherFilters(c, input);
    ++number;
  }
  return c.Result();
}
