// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMeasurement.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace
{
using Clock = std::chrono::steady_clock;

double Seconds(Clock::time_point begin, Clock::time_point end)
{
  return std::chrono::duration<double>(end - begin).count();
}

/// Notes when each stage begins.
class StageObserver : public vtkCommand
{
public:
  static StageObserver* New() { return new StageObserver; }

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    const char* text = static_cast<vtkAlgorithm*>(caller)->GetProgressText();
    if (text && (this->Begins.empty() || this->Begins.back().first != text))
    {
      this->Begins.emplace_back(text, Clock::now());
    }
  }

  std::vector<std::pair<std::string, Clock::time_point>> Begins;
};

std::size_t FindStage(const std::string& name)
{
  for (std::size_t k = 0; k < Stages.size(); ++k)
  {
    if (name.rfind(Stages[k].name, 0) == 0)
    {
      return k;
    }
  }
  throw std::runtime_error("The stage '" + name + "' is unknown; add it to Stages.");
}

std::array<double, Stages.size()> StagePercents(
  const StageObserver& observer, Clock::time_point begin, Clock::time_point end)
{
  std::array<double, Stages.size()> percents{};
  for (std::size_t k = 0; k < observer.Begins.size(); ++k)
  {
    const bool isLast = k + 1 == observer.Begins.size();
    const auto& [name, stageBegin] = observer.Begins[k];
    const Clock::time_point stageEnd = isLast ? end : observer.Begins[k + 1].second;
    percents[FindStage(name)] += 100 * Seconds(stageBegin, stageEnd) / Seconds(begin, end);
  }
  return percents;
}

#ifdef __GLIBC__
/// A number about this process, in bytes.
double ProcessBytes(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
  {
    double kibibytes = 0;
    if (word == key && status >> kibibytes)
    {
      return 1024 * kibibytes;
    }
  }
  return NoValue;
}

/// What a mesh consists of, with the size in bytes.
std::set<std::pair<vtkObject*, double>> Parts(vtkPolyData* mesh)
{
  std::set<std::pair<vtkObject*, double>> parts;
  const auto add = [&parts](vtkAbstractArray* array)
  {
    if (array)
    {
      parts.emplace(array, double(array->GetDataSize()) * array->GetDataTypeSize());
    }
  };
  const auto addAll = [&add](vtkFieldData* data)
  {
    for (int k = 0; k < data->GetNumberOfArrays(); ++k)
    {
      add(data->GetAbstractArray(k));
    }
  };
  add(mesh->GetPoints()->GetData());
  add(mesh->GetPolys()->GetConnectivityArray());
  add(mesh->GetPolys()->GetOffsetsArray());
  addAll(mesh->GetPointData());
  addAll(mesh->GetCellData());
  addAll(mesh->GetFieldData());
  return parts;
}

double BytesOfNewParts(vtkPolyData* output, vtkPolyData* input)
{
  const auto old = Parts(input);
  double bytes = 0;
  for (const auto& part : Parts(output))
  {
    bytes += old.count(part) ? 0 : part.second;
  }
  return bytes;
}
#endif
}

Measurement MeasureTime(vtkPolyDataAlgorithm* filter)
{
  vtkNew<StageObserver> observer;
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  filter->SetProgressText(nullptr); // an earlier Update() may have left its last stage
  const Clock::time_point begin = Clock::now();
  filter->Update();
  const Clock::time_point end = Clock::now();

  Measurement result;
  result.seconds = Seconds(begin, end);
  if (auto* optimizer = vtkLaplacianMeshOptimizer::SafeDownCast(filter))
  {
    result.stagePercents = StagePercents(*observer, begin, end);
    result.iterations = optimizer->GetIterations();
    result.inputMeanRadiusRatio = optimizer->GetInputMeanRadiusRatio();
    result.meanRadiusRatio = optimizer->GetMeanRadiusRatio();
  }
  return result;
}

Measurement Median(std::vector<Measurement> measurements)
{
  const auto middle = measurements.begin() + measurements.size() / 2;
  std::nth_element(measurements.begin(), middle, measurements.end(),
    [](const Measurement& a, const Measurement& b) { return a.seconds < b.seconds; });
  return *middle;
}

#ifdef __GLIBC__
double MeasureMemory(
  vtkPolyDataAlgorithm* filter, vtkPolyData* mesh, const std::function<void()>& update)
{
  // Free memory goes back to the system: taking it again shall count. 5 resets the peak.
  malloc_trim(0);
  if (!(std::ofstream("/proc/self/clear_refs") << "5" << std::flush))
  {
    update();
    return NoValue;
  }
  const double before = ProcessBytes("VmRSS:");
  update();
  const double peak = ProcessBytes("VmHWM:");
  return std::max(0., peak - before - BytesOfNewParts(filter->GetOutput(), mesh));
}
#else
double MeasureMemory(vtkPolyDataAlgorithm*, vtkPolyData*, const std::function<void()>& update)
{
  update();
  return NoValue;
}
#endif
