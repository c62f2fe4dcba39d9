// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkReport.h"

#include "BenchmarkCgal.h"

#include "vtkVersion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <ostream>

namespace
{
template <typename Value>
void AddOnce(std::vector<Value>& values, const Value& value)
{
  if (std::find(values.begin(), values.end(), value) == values.end())
  {
    values.push_back(value);
  }
}

const char* const Legend =
  "Times of Update() of a new filter, as multiples of that of vtkWindowedSincPolyDataFilter with\n"
  "20 iterations (VTK sinc) on the same mesh in the same run, in which all columns take turns.\n"
  "\n"
  "- VTK smooth: vtkSmoothPolyDataFilter with 20 and 100 iterations; 100 up to 1,000,000 "
  "vertices.\n"
  "- CGAL relax: tangential_relaxation() with 10 iterations, without the conversion of the mesh; "
  "up\n"
  "  to 300,000 vertices.\n"
  "- CDF, LINEAR: Mode OPTIMIZE_TRIANGLES with this PositionWeighting and ScaleFactor 1.\n"
  "- planes: CDF with TangentPlaneConstraints.\n"
  "- again: CDF with another ScaleFactor, on the mesh that the filter has just worked on.\n"
  "- U, C, K: Mode SMOOTH with LaplacianType UNIFORM, COTANGENT and MEAN_CURVATURE, with this\n"
  "  ScaleFactor, and with PositionWeighting CDF, or CONSTANT (c).\n";
}

double MicrosecondsPerVertex(const Result& result)
{
  return 1e6 * result.median.seconds / static_cast<double>(result.vertices);
}

std::string Format(double value, int decimals)
{
  char text[64] = "";
  if (!std::isnan(value))
  {
    std::snprintf(text, sizeof(text), "%.*f", decimals, value);
  }
  return text;
}

Report::Report(std::vector<Case> cases, int repeats, double budget, const std::string& machine)
  : Cases(std::move(cases))
  , Repeats(repeats)
  , Budget(budget)
  , Machine(machine)
{
}

void Report::Add(const Result& result)
{
  this->Results.push_back(result);
  AddOnce(this->Meshes, result.mesh);
  AddOnce(this->Threads, result.threads);
}

const Result* Report::Find(const std::string& mesh, int threads, const std::string& caseName) const
{
  const auto result = std::find_if(this->Results.begin(), this->Results.end(),
    [&](const Result& r)
    { return r.mesh == mesh && r.threads == threads && r.caseName == caseName; });
  return result == this->Results.end() ? nullptr : &*result;
}

double Report::Ratio(const Result& result) const
{
  const Result* reference = this->Find(result.mesh, result.threads, ReferenceCase);
  return reference ? result.median.seconds / reference->median.seconds : NoValue;
}

void Report::WriteCsv(std::ostream& out) const
{
  out << "mesh,vertices,threads,case,seconds,microseconds_per_vertex,ratio_to_windowed_sinc,"
         "iterations,";
  for (const Stage& stage : Stages)
  {
    out << stage.title << "_percent,";
  }
  out << "bytes_per_vertex,input_mean_radius_ratio,mean_radius_ratio\n";
  for (const Result& r : this->Results)
  {
    out << r.mesh << ',' << r.vertices << ',' << r.threads << ',' << r.caseName << ','
        << Format(r.median.seconds, 6) << ',' << Format(MicrosecondsPerVertex(r), 4) << ','
        << Format(this->Ratio(r), 4) << ',' << Format(r.median.iterations, 0) << ',';
    for (const double percent : r.median.stagePercents)
    {
      out << Format(percent, 2) << ',';
    }
    out << Format(r.bytesPerVertex, 1) << ',' << Format(r.median.inputMeanRadiusRatio, 6) << ','
        << Format(r.median.meanRadiusRatio, 6) << '\n';
  }
}

template <typename FormatResult>
std::vector<Report::Column> Report::CaseColumns(
  CaseTable table, int threads, const FormatResult& format) const
{
  std::vector<Column> columns;
  for (const Case& c : this->Cases)
  {
    if (c.table == table)
    {
      columns.push_back({ c.title, {} });
      for (const std::string& mesh : this->Meshes)
      {
        const Result* result = this->Find(mesh, threads, c.name);
        columns.back().cells.push_back(result ? format(*result) : "");
      }
    }
  }
  return columns;
}

void Report::WriteTable(
  std::ostream& out, const std::string& heading, const std::vector<Column>& columns) const
{
  std::vector<Column> used;
  std::copy_if(columns.begin(), columns.end(), std::back_inserter(used),
    [](const Column& column)
    {
      return std::any_of(column.cells.begin(), column.cells.end(),
        [](const std::string& cell) { return !cell.empty(); });
    });
  if (used.empty())
  {
    return;
  }
  out << '\n' << heading << "\n\n| mesh |";
  for (const Column& column : used)
  {
    out << ' ' << column.title << " |";
  }
  out << "\n|---|";
  for (std::size_t k = 0; k < used.size(); ++k)
  {
    out << "--:|";
  }
  out << '\n';
  for (std::size_t row = 0; row < this->Meshes.size(); ++row)
  {
    out << "| " << this->Meshes[row] << " |";
    for (const Column& column : used)
    {
      out << ' ' << column.cells[row] << " |";
    }
    out << '\n';
  }
}

template <typename FormatResult>
void Report::WriteCaseTables(std::ostream& out, int threads, const FormatResult& format,
  std::vector<Column> firstColumns) const
{
  std::vector<Column> columns = this->CaseColumns(CaseTable::Triangles, threads, format);
  columns.insert(columns.begin(), firstColumns.begin(), firstColumns.end());
  this->WriteTable(out, "Better triangles, and other filters:", columns);
  this->WriteTable(out, "Smoothing:", this->CaseColumns(CaseTable::Smoothing, threads, format));
}

void Report::WriteTimes(std::ostream& out, int threads) const
{
  Column vertices{ "vertices", {} };
  Column reference{ "VTK sinc, µs / vertex", {} };
  for (const std::string& mesh : this->Meshes)
  {
    const Result* result = this->Find(mesh, threads, ReferenceCase);
    vertices.cells.push_back(result ? std::to_string(result->vertices) : "");
    reference.cells.push_back(result ? Format(MicrosecondsPerVertex(*result), 2) : "");
  }
  const auto ratio = [this](const Result& r)
  {
    const double value = r.caseName == ReferenceCase ? NoValue : this->Ratio(r);
    return Format(value, value < 10 ? 2 : 1);
  };
  this->WriteCaseTables(out, threads, ratio, { vertices, reference });
}

void Report::WriteStages(std::ostream& out, int threads) const
{
  std::vector<Column> columns;
  for (std::size_t k = 0; k < Stages.size(); ++k)
  {
    columns.push_back({ Stages[k].title, {} });
    for (const std::string& mesh : this->Meshes)
    {
      const Result* result = this->Find(mesh, threads, "triangles-cdf");
      columns.back().cells.push_back(result ? Format(result->median.stagePercents[k], 0) : "");
    }
  }
  this->WriteTable(out, "Stages of CDF, percent:", columns);
}

void Report::WriteMarkdown(std::ostream& out) const
{
  const std::string cgal = CgalVersion().empty() ? "" : ", CGAL " + CgalVersion();
  out << "# Benchmark\n\n";
  out << (this->Machine.empty() ? "" : "Machine: " + this->Machine + "; ") << "VTK "
      << vtkVersion::GetVTKVersion() << cgal << ".\n\n";
  out << Legend << "\nAll times are medians. Rounds: " << this->Repeats
      << "; fewer where a column took more than " << Format(this->Budget, 0) << " s.\n";
  for (const int threads : this->Threads)
  {
    out << "\n## Time on " << threads << (threads == 1 ? " thread\n" : " threads\n");
    this->WriteTimes(out, threads);
    this->WriteStages(out, threads);
  }
  if (!this->Threads.empty())
  {
    // The iterations do not depend on the number of threads, the memory hardly does.
    const int threads = this->Threads.back();
    out << "\n## Iterations\n";
    this->WriteCaseTables(
      out, threads, [](const Result& r) { return Format(r.median.iterations, 0); });
    out << "\n## Memory beyond input and output, bytes / vertex\n";
    this->WriteCaseTables(
      out, threads, [](const Result& r) { return Format(r.bytesPerVertex, 0); });
  }
}
