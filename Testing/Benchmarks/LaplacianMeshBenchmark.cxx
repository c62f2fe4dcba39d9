// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// Times vtkLaplacianMeshOptimizer with many settings on many meshes, together with other filters.
// They take turns, so that what else happens on the machine meets all of them.

#include "BenchmarkCases.h"
#include "BenchmarkMeasurement.h"
#include "BenchmarkMeshes.h"
#include "BenchmarkOptions.h"
#include "BenchmarkReport.h"

#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSMPTools.h"

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <numeric>
#include <stdexcept>

namespace
{
/// The items whose names match one of the patterns, in their own order; all if there is no pattern.
/// \throw std::invalid_argument if a pattern matches nothing
template <typename Item>
std::vector<Item> Select(const std::vector<Item>& items, const std::vector<std::string>& patterns)
{
  std::vector<bool> isSelected(items.size(), patterns.empty());
  for (const std::string& pattern : patterns)
  {
    bool isFound = false;
    for (std::size_t k = 0; k < items.size(); ++k)
    {
      if (Matches(items[k].name, pattern))
      {
        isSelected[k] = isFound = true;
      }
    }
    if (!isFound)
    {
      throw std::invalid_argument("Nothing is called '" + pattern + "'; see --list.");
    }
  }
  std::vector<Item> selected;
  for (std::size_t k = 0; k < items.size(); ++k)
  {
    if (isSelected[k])
    {
      selected.push_back(items[k]);
    }
  }
  return selected;
}

std::vector<MeshSource> AllMeshes(const BenchmarkOptions& options)
{
  std::vector<MeshSource> meshes = GeneratedMeshes();
  if (!options.dataFolder.empty())
  {
    const std::vector<MeshSource> more = MeshesInFolder(options.dataFolder);
    meshes.insert(meshes.end(), more.begin(), more.end());
  }
  return meshes;
}

/// \throw std::runtime_error if the filter failed
void CheckOutput(const Case& c, vtkPolyDataAlgorithm* filter, vtkPolyData* mesh)
{
  if (c.hasOutput && filter->GetOutput()->GetNumberOfPoints() != mesh->GetNumberOfPoints())
  {
    throw std::runtime_error(c.name + " failed.");
  }
}

/// All cases with one mesh and the current number of threads.
class MeshBenchmark
{
public:
  MeshBenchmark(const std::vector<Case>& cases, vtkPolyData* mesh)
    : Cases(cases)
    , Mesh(mesh)
    , Measurements(cases.size())
    , Bytes(cases.size(), NoValue)
  {
  }

  /// One round of all cases, which measures memory as well.
  void RunFirst()
  {
    this->ForEachCase([](std::size_t) { return true; },
      [this](std::size_t k, vtkPolyDataAlgorithm* filter)
      {
        const auto update = [&] { this->Measurements[k].push_back(MeasureTime(filter)); };
        if (this->Cases[k].hasOutput)
        {
          this->Bytes[k] = MeasureMemory(filter, this->Mesh, update);
        }
        else
        {
          update();
        }
      });
  }

  /// One round of the cases that have not taken \a budget seconds so far.
  void Run(double budget)
  {
    this->ForEachCase(
      [&](std::size_t k)
      {
        const double spent =
          std::accumulate(this->Measurements[k].begin(), this->Measurements[k].end(), 0.,
            [](double sum, const Measurement& one) { return sum + one.seconds; });
        return spent < budget || this->Cases[k].name == ReferenceCase;
      },
      [this](std::size_t k, vtkPolyDataAlgorithm* filter)
      { this->Measurements[k].push_back(MeasureTime(filter)); });
  }

  /// \param common what all results share
  std::vector<Result> Results(const Result& common) const
  {
    std::vector<Result> results;
    for (std::size_t k = 0; k < this->Cases.size(); ++k)
    {
      if (!this->Measurements[k].empty())
      {
        results.push_back(common);
        results.back().caseName = this->Cases[k].name;
        results.back().median = Median(this->Measurements[k]);
        results.back().bytesPerVertex = this->Bytes[k] / static_cast<double>(common.vertices);
      }
    }
    return results;
  }

private:
  /// Prepares only what is wanted: preparing may include an Update().
  template <typename IsWanted, typename Body>
  void ForEachCase(const IsWanted& isWanted, const Body& body)
  {
    for (std::size_t k = 0; k < this->Cases.size(); ++k)
    {
      const Case& c = this->Cases[k];
      if (this->Mesh->GetNumberOfPoints() > c.maximumVertices || !isWanted(k))
      {
        continue;
      }
      if (const auto filter = c.prepare(this->Mesh))
      {
        body(k, filter);
        CheckOutput(c, filter, this->Mesh);
      }
    }
  }

  const std::vector<Case>& Cases;
  vtkPolyData* Mesh;
  std::vector<std::vector<Measurement>> Measurements; ///< of each case
  std::vector<double> Bytes;                          ///< of each case
};

template <typename Write>
void WriteFile(const std::string& name, const Write& write)
{
  if (name.empty())
  {
    return;
  }
  std::ofstream file(name);
  write(file);
  if (!file.flush())
  {
    throw std::runtime_error("Cannot write '" + name + "'.");
  }
}

void WriteFiles(const Report& report, const BenchmarkOptions& options)
{
  WriteFile(options.csvFile, [&](std::ostream& out) { report.WriteCsv(out); });
  WriteFile(options.markdownFile, [&](std::ostream& out) { report.WriteMarkdown(out); });
}

void RunMesh(const MeshSource& source, const std::vector<Case>& cases,
  const BenchmarkOptions& options, Report& report)
{
  const vtkSmartPointer<vtkPolyData> mesh = source.make();
  if (!mesh)
  {
    std::cout << source.name << ": left out\n";
    return;
  }
  for (const int threads : options.threads)
  {
    vtkSMPTools::Initialize(threads);
    MeshBenchmark benchmark(cases, mesh);
    benchmark.RunFirst();
    for (int round = 1; round < options.repeats; ++round)
    {
      benchmark.Run(options.budget);
    }
    Result common;
    common.mesh = source.name;
    common.vertices = mesh->GetNumberOfPoints();
    common.threads = threads;
    for (const Result& result : benchmark.Results(common))
    {
      report.Add(result);
      std::cout << source.name << ", threads " << threads << ", " << result.caseName << ": "
                << Format(MicrosecondsPerVertex(result), 2) << " us / vertex, ratio "
                << Format(report.Ratio(result), 2) << std::endl;
    }
    WriteFiles(report, options);
  }
}

void PrintNames(const std::vector<MeshSource>& meshes, const std::vector<Case>& cases)
{
  std::cout << "meshes:\n";
  for (const MeshSource& mesh : meshes)
  {
    std::cout << "  " << mesh.name << "\n";
  }
  std::cout << "cases:\n";
  for (const Case& c : cases)
  {
    std::cout << "  " << c.name << "\n";
  }
}

void Run(const BenchmarkOptions& options)
{
  std::vector<std::string> patterns = options.cases;
  if (!patterns.empty())
  {
    patterns.emplace_back(ReferenceCase);
  }
  const std::vector<Case> cases = Select(AllCases(), patterns);
  const std::vector<MeshSource> meshes = Select(AllMeshes(options), options.meshes);
  if (options.isList)
  {
    PrintNames(meshes, cases);
    return;
  }
  if (!vtkSMPTools::SetBackend("STDThread"))
  {
    throw std::runtime_error("This VTK's vtkSMPTools lack the backend STDThread.");
  }
  // What happens once, as loading code, shall not count for the case that comes first.
  const vtkSmartPointer<vtkPolyData> smallMesh = GeneratedMeshes().front().make();
  MeshBenchmark(cases, smallMesh).RunFirst();

  Report report(cases, options.repeats, options.budget, options.machine);
  WriteFiles(report, options); // now: a wrong name shows before hours of work
  for (const MeshSource& mesh : meshes)
  {
    RunMesh(mesh, cases, options, report);
  }
}
}

int main(int argc, char* argv[])
{
  try
  {
    const BenchmarkOptions options = ReadOptions({ argv + 1, argv + argc });
    if (options.isHelp)
    {
      std::cout << HelpText;
      return EXIT_SUCCESS;
    }
    Run(options);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "LaplacianMeshBenchmark: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
