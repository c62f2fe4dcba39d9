// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchmarkOptions_h
#define BenchmarkOptions_h

#include <string>
#include <vector>

/// The command line.
struct BenchmarkOptions
{
  std::vector<std::string> meshes; ///< patterns; empty: all
  std::vector<std::string> cases;  ///< patterns; empty: all
  std::vector<int> threads;
  int repeats = 5;
  double budget = 10; ///< seconds
  std::string dataFolder;
  std::string csvFile;
  std::string markdownFile;
  std::string machine;
  bool isList = false;
  bool isHelp = false;
};

extern const char* const HelpText;

/// \throw std::invalid_argument that says what is wrong
BenchmarkOptions ReadOptions(const std::vector<std::string>& arguments);

/// \param pattern a name, or the beginning of one and a star
bool Matches(const std::string& name, const std::string& pattern);

#endif
