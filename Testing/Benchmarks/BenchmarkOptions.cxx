// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkOptions.h"

#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <thread>

const char* const HelpText = R"(LaplacianMeshBenchmark [OPTION]...
Times vtkLaplacianMeshOptimizer, and filters of others in the same run.

  --meshes A,B,...   these meshes; 'horse*' are all that begin with horse (default: all)
  --cases A,B,...    these settings and other filters, likewise (default: all); windowed-sinc, to
                     which all times are compared, always runs
  --threads 1,2,...  once with each of these numbers (default: 1 and one for each processor)
  --repeats N        rounds, of which the median is reported (default: 5)
  --budget SECONDS   a column that has taken this long is not repeated (default: 10)
  --data DIR         the .ply, .obj, .stl and .vtp files in this folder are meshes, too
  --csv FILE         write the results as CSV
  --markdown FILE    write the results as tables
  --machine TEXT     the machine, for the tables
  --list             print the names of the meshes and cases
  --help             print this
)";

namespace
{
std::vector<std::string> Split(const std::string& list)
{
  std::vector<std::string> items;
  std::istringstream stream(list);
  for (std::string item; std::getline(stream, item, ',');)
  {
    items.push_back(item);
  }
  return items;
}

int PositiveNumber(const std::string& text)
{
  int number = 0;
  std::istringstream stream(text);
  if (!(stream >> number) || !stream.eof() || number < 1)
  {
    throw std::invalid_argument("'" + text + "' is no positive number.");
  }
  return number;
}

std::vector<int> PositiveNumbers(const std::string& list)
{
  std::vector<int> numbers;
  for (const std::string& text : Split(list))
  {
    numbers.push_back(PositiveNumber(text));
  }
  return numbers;
}

std::vector<int> DefaultThreads()
{
  const auto processors = static_cast<int>(std::thread::hardware_concurrency());
  return processors > 1 ? std::vector<int>{ 1, processors } : std::vector<int>{ 1 };
}
}

BenchmarkOptions ReadOptions(const std::vector<std::string>& arguments)
{
  BenchmarkOptions options;
  options.threads = DefaultThreads();
  const std::map<std::string, std::function<void(const std::string&)>> setters = {
    { "--meshes", [&](const std::string& value) { options.meshes = Split(value); } },
    { "--cases", [&](const std::string& value) { options.cases = Split(value); } },
    { "--threads", [&](const std::string& value) { options.threads = PositiveNumbers(value); } },
    { "--repeats", [&](const std::string& value) { options.repeats = PositiveNumber(value); } },
    { "--budget", [&](const std::string& value) { options.budget = PositiveNumber(value); } },
    { "--data", [&](const std::string& value) { options.dataFolder = value; } },
    { "--csv", [&](const std::string& value) { options.csvFile = value; } },
    { "--markdown", [&](const std::string& value) { options.markdownFile = value; } },
    { "--machine", [&](const std::string& value) { options.machine = value; } },
  };
  const std::map<std::string, bool*> switches = {
    { "--list", &options.isList },
    { "--help", &options.isHelp },
  };
  for (auto argument = arguments.begin(); argument != arguments.end(); ++argument)
  {
    if (const auto found = switches.find(*argument); found != switches.end())
    {
      *found->second = true;
      continue;
    }
    const auto setter = setters.find(*argument);
    if (setter == setters.end())
    {
      throw std::invalid_argument("There is no option '" + *argument + "'; see --help.");
    }
    if (++argument == arguments.end())
    {
      throw std::invalid_argument(setter->first + " needs a value; see --help.");
    }
    setter->second(*argument);
  }
  return options;
}

bool Matches(const std::string& name, const std::string& pattern)
{
  if (!pattern.empty() && pattern.back() == '*')
  {
    const std::size_t length = pattern.size() - 1;
    return name.compare(0, length, pattern, 0, length) == 0;
  }
  return name == pattern;
}
