// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchmarkReport_h
#define BenchmarkReport_h

#include "BenchmarkCases.h"
#include "BenchmarkMeasurement.h"

#include <iosfwd>
#include <string>
#include <vector>

/// What one case did with one mesh on some threads.
struct Result
{
  std::string mesh;
  vtkIdType vertices = 0;
  int threads = 0;
  std::string caseName;
  Measurement median;
  double bytesPerVertex = NoValue;
};

double MicrosecondsPerVertex(const Result& result);

/// With so many decimals; empty for NoValue.
std::string Format(double value, int decimals);

/// All results, as tables.
class Report
{
public:
  /// \param machine in words; may be empty
  Report(std::vector<Case> cases, int repeats, double budget, const std::string& machine);

  void Add(const Result& result);

  /// Time divided by that of ReferenceCase; NoValue without that.
  double Ratio(const Result& result) const;

  void WriteCsv(std::ostream& out) const;
  void WriteMarkdown(std::ostream& out) const;

private:
  struct Column
  {
    std::string title;
    std::vector<std::string> cells; ///< one for each mesh
  };

  const Result* Find(const std::string& mesh, int threads, const std::string& caseName) const;

  /// One column for each case of the table.
  /// \param format const Result& -> std::string
  template <typename FormatResult>
  std::vector<Column> CaseColumns(CaseTable table, int threads, const FormatResult& format) const;

  /// Leaves out empty columns, and a table of them.
  void WriteTable(
    std::ostream& out, const std::string& heading, const std::vector<Column>& columns) const;

  template <typename FormatResult>
  void WriteCaseTables(std::ostream& out, int threads, const FormatResult& format,
    std::vector<Column> firstColumns = {}) const;
  void WriteTimes(std::ostream& out, int threads) const;
  void WriteStages(std::ostream& out, int threads) const;

  std::vector<Case> Cases;
  int Repeats;
  double Budget;
  std::string Machine;
  std::vector<Result> Results;
  std::vector<std::string> Meshes; ///< in the order of their results
  std::vector<int> Threads;        ///< in the order of their results
};

#endif
