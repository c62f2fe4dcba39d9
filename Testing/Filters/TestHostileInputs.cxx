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

/// One choice of all enumerations; each switch is on in half of the choices.
struct Choice
{
  int mode, laplacian, positionWeighting, laplacianWeighting, boundary, solver;

  bool Modulates() const { return (this->Sum() / 2) % 2; }
  bool HasTangentPlanes() const { return this->Sum() % 2; }
  bool IsRobust() const { return (this->positionWeighting + this->solver) % 2; }

  std::string Name() const
  {
    std::ostringstream text;
    text << "mode " << this->mode << ", L " << this->laplacian << ", W_p "
         << this->positionWeighting << ", W_L " << this->laplacianWeighting << ", boundary "
         << this->boundary << ", solver " << this->solver;
    return text.str();
  }

  void Set(Optimizer* filter) const
  {
    filter->SetMode(this->mode);
    filter->SetLaplacianType(this->laplacian);
    filter->SetPositionWeighting(this->positionWeighting);
    filter->SetLaplacianWeighting(this->laplacianWeighting);
    filter->SetBoundaryCondition(this->boundary);
    filter->SetSolverType(this->solver);
    filter->SetModulateByTriangleQuality(this->Modulates());
    filter->SetTangentPlaneConstraints(this->HasTangentPlanes());
    filter->SetRobustLaplacian(this->IsRobust());
  }

private:
  int Sum() const
  {
    return this->mode + this->laplacian + this->positionWeighting + this->laplacianWeighting +
           this->boundary + this->solver;
  }
};

std::vector<Choice> AllChoices()
{
  const std::vector<int> modes{ Optimizer::OPTIMIZE_TRIANGLES, Optimizer::SMOOTH,
    Optimizer::PRESCRIBED_LAPLACIANS };
  std::vector<Choice> choices;
  for (const int mode : modes)
  {
    for (int k = 0; k < 3 * 5 * 5 * 3 * 3; ++k)
    {
      choices.push_back({ mode, k % 3, k / 3 % 5, k / 15 % 5, k / 75 % 3, k / 225 });
    }
  }
  return choices;
}

/// The choices that a large input is tried with: each value of each enumeration several times.
std::vector<Choice> SomeChoices()
{
  const std::vector<Choice> all = AllChoices();
  std::vector<Choice> some;
  for (std::size_t k = 0; k < all.size(); k += 97)
  {
    some.push_back(all[k]);
  }
  return some;
}

void ChooseArrays(Optimizer* filter)
{
  const auto choose = [&](int index, const char* name)
  { filter->SetInputArrayToProcess(index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name); };
  choose(Optimizer::POSITION_WEIGHT_ARRAY, "Weights");
  choose(Optimizer::LAPLACIAN_WEIGHT_ARRAY, "Weights");
  choose(Optimizer::PRESCRIBED_LAPLACIAN_ARRAY, "Vectors");
}

/// True if the direct solver refuses weights or vertices that it is not made for.
bool IsDirectRefusal(const Choice& choice, const std::string& errors)
{
  return choice.solver == Optimizer::DIRECT &&
         errors.find("use the iterative solver") != std::string::npos;
}

/// Empty if the choice gives a result without fault, or one that the error's remedy gives.
std::string FaultOfChoice(Optimizer* filter, const Choice& choice)
{
  choice.Set(filter);
  Messages messages = Update(filter);
  if (IsDirectRefusal(choice, messages.errors))
  {
    filter->SetSolverType(Optimizer::ITERATIVE);
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
  c.True(fault.count > 0 ? property + "; " + count + fault.text : property, fault.count == 0);
}

/// \param scaleFactor s
void CheckOptimizer(
  Checks& c, const HostileInput& input, const std::vector<Choice>& choices, double scaleFactor)
{
  std::ostringstream name;
  name << input.name << ", s = " << scaleFactor;
  const auto copy = CopyOf(input.data);
  vtkNew<Optimizer> filter;
  filter->SetInputData(input.data);
  filter->SetScaleFactor(scaleFactor);
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
    CheckFilter(c, isRobust ? "robust mesh Laplacian" : "mesh Laplacian", input, laplacian,
      { "UniformLaplacian", "CotangentLaplacian", "MeanCurvatureNormal", "MeanCurvature",
        "GaussianCurvature", "VoronoiArea" });
  }
  CheckFilter(c, "radius ratio", input, vtkNew<vtkTriangleRadiusRatio>(), { "RadiusRatio" });
  vtkNew<vtkSurfaceDeviation> deviation;
  deviation->SetNumberOfSamples(100);
  deviation->SetReferenceData(input.data);
  CheckFilter(c, "deviation from itself", input, deviation, { "Distance" });
  deviation->SetReferenceData(MakePolyData(Icosphere(1)));
  CheckFilter(c, "deviation from a sphere", input, deviation, { "Distance" });
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
  const std::vector<Choice> all = AllChoices();
  const std::vector<Choice> some = SomeChoices();
  for (const HostileInput& input : HostileInputs())
  {
    CheckOptimizer(c, input, input.isLarge ? some : all, 1);
    CheckOptimizer(c, input, some, 1e-12);
    CheckOptimizer(c, input, some, 1e12);
    CheckOtherFilters(c, input);
  }
  return c.Result();
}
