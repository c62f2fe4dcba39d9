// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
// How long a surface over several processes takes, and how much memory. Prints one line of a table:
//   mpirun -n 2 LaplacianMeshScaling <number of vertices> [weight | within]
#include "Parallel/DistributedOptimizer.h"

#include "vtkGenerateGlobalIds.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>

#include <sys/resource.h>

using namespace lmo;

namespace
{
double Seconds()
{
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

/// Of this process so far, in MiB.
double PeakMemory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;
}

/// Processor time of this process: on a busy machine close to what a stage takes on a quiet one.
double ProcessorSeconds()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

/// How long each stage takes.
class StageTimes : public ProgressMonitor
{
public:
  double operator[](const std::string& stage) { return this->Times[stage]; }
  void End() { this->ShowStage(""); }

  /// Of all stages between the set-up of the equations and the comparison of the surfaces.
  double Solving() const { return Sum(this->Times); }
  double ProcessorTimeOfSolving() const { return Sum(this->ProcessorTimes); }

protected:
  void ShowStage(const char* stage) override
  {
    const double now = Seconds();
    const double processor = ProcessorSeconds();
    this->Times[this->Current] += now - this->Since;
    this->ProcessorTimes[this->Current] += processor - this->ProcessorSince;
    this->Current = stage;
    this->Since = now;
    this->ProcessorSince = processor;
  }

private:
  static double Sum(const std::map<std::string, double>& times)
  {
    double sum = 0;
    for (const auto& [stage, time] : times)
    {
      const bool isOther =
        stage.empty() || stage == "Setting up the equations" || stage == "Comparing the surfaces";
      sum += isOther ? 0 : time;
    }
    return sum;
  }

  std::map<std::string, double> Times;
  std::map<std::string, double> ProcessorTimes;
  std::string Current;
  double Since = Seconds();
  double ProcessorSince = ProcessorSeconds();
};

/// A number from -1 to 1 that depends on the point alone.
double Noise(std::uint64_t point)
{
  point = (point ^ (point >> 31)) * 0x7fb5d329728ea185ULL;
  point = (point ^ (point >> 27)) * 0x81dadef4bc2dd44dULL;
  return double((point ^ (point >> 33)) >> 11) / double(1ULL << 52) - 1;
}

/// The rows of a bumpy torus of size x size points that lie in one process.
Piece MakePiece(Index size, int rank, int processes)
{
  const auto firstOf = [&](int k) { return Index(std::int64_t(size) * k / processes); };
  const Index first = firstOf(rank);
  const Index rows = firstOf(rank + 1) - first;
  constexpr double pi = 3.14159265358979323846;
  Piece piece;
  piece.points.resize((rows + 1) * size, 3);
  for (Index row = 0; row <= rows; ++row)
  {
    for (Index column = 0; column < size; ++column)
    {
      const Index i = (first + row) % size;
      const std::uint64_t point = std::uint64_t(i) * size + column;
      const double u = 2 * pi * (i + 0.3 * Noise(3 * point)) / size;
      const double v = 2 * pi * (column + 0.3 * Noise(3 * point + 1)) / size;
      const double r = 1 + 0.15 * std::sin(5 * u) * std::cos(3 * v);
      piece.points.row(row * size + column) << (2 + r * std::cos(v)) * std::cos(u),
        (2 + r * std::cos(v)) * std::sin(u), r * std::sin(v);
    }
  }
  piece.triangles.resize(2 * rows * size, 3);
  for (Index square = 0; square < rows * size; ++square)
  {
    const Index next = square % size == size - 1 ? square + 1 - size : square + 1;
    piece.triangles.row(2 * square) << square, square + size, next;
    piece.triangles.row(2 * square + 1) << next, square + size, next + size;
  }
  return piece;
}

void GenerateIds(Piece& piece, vtkMPIController* controller)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(piece.points.rows());
  for (Index i = 0; i < piece.points.rows(); ++i)
  {
    points->SetPoint(i, piece.points.row(i).data());
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  vtkNew<vtkGenerateGlobalIds> generator;
  generator->SetController(controller);
  generator->SetInputData(surface);
  generator->Update();
  vtkDataArray* ids =
    vtkPolyData::SafeDownCast(generator->GetOutput())->GetPointData()->GetGlobalIds();
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    piece.ids.push_back(static_cast<GlobalId>(ids->GetTuple1(i)));
  }
}

OptimizerOptions ChooseOptions(const std::string& choice)
{
  OptimizerOptions options;
  if (choice == "within")
  {
    return options;
  }
  options.mode = Mode::OPTIMIZE_TRIANGLES;
  options.solverType = SolverType::ITERATIVE;
  if (!choice.empty())
  {
    options.mode = Mode::SMOOTH;
    options.positionWeighting = PositionWeighting::CONSTANT;
    options.scaleFactor = std::atof(choice.c_str());
  }
  return options;
}

/// Prints what a torus of size x size points takes.
void Measure(Index size, const OptimizerOptions& options, vtkMPIController* controller)
{
  const Communicator comm(MPI_COMM_WORLD);
  const double base = comm.Maximum(PeakMemory());
  Piece piece = MakePiece(size, comm.Rank(), comm.Size());
  const double start = Seconds();
  GenerateIds(piece, controller);
  const double ids = comm.Maximum(Seconds() - start);
  const double afterIds = Seconds();
  Triangles triangles = piece.triangles;
  DistributedOptimizer optimizer(comm, std::move(piece), std::move(triangles));
  const double mesh = comm.Maximum(Seconds() - afterIds);
  StageTimes times;
  const OptimizerResult result = optimizer.Run(options, {}, times);
  times.End();
  const double equations = comm.Maximum(times["Setting up the equations"]);
  const double solve = comm.Maximum(times.Solving());
  const double processor = comm.Maximum(times.ProcessorTimeOfSolving());
  const double peak = comm.Maximum(PeakMemory());
  if (comm.Rank() == 0)
  {
    std::cout << std::fixed << std::setprecision(2) << "| " << comm.Size() << " | "
              << std::int64_t(size) * size << " | " << ids << " | " << mesh << " | " << equations
              << " | " << solve << " | " << processor << " | " << result.iterations << " | "
              << std::setprecision(0) << peak << " | " << base << " |" << std::endl;
  }
}
}

int main(int argc, char* argv[])
{
  const double vertices = argc > 1 ? std::atof(argv[1]) : 0;
  if (!(vertices >= 9))
  {
    std::cerr << "Usage: LaplacianMeshScaling <number of vertices, at least 9> [weight | within]\n"
                 "With a position weight it smooths, with 'within' it optimizes within the default "
                 "deviation; else it makes better triangles.\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  Measure(
    static_cast<Index>(std::sqrt(vertices)), ChooseOptions(argc > 2 ? argv[2] : ""), controller);
  controller->Finalize();
  return EXIT_SUCCESS;
}
