// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "ParallelTesting.h"

#include "vtkCleanPolyData.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkOBJReader.h"
#include "vtkPolyData.h"

#include <cstdlib>
#include <filesystem>

using namespace lmo;

namespace
{
using Optimizer = vtkLaplacianMeshOptimizer;

/// The surface with each point once, in double precision.
vtkSmartPointer<vtkPolyData> Read(const std::filesystem::path& file)
{
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(file.c_str());
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(reader->GetOutputPort());
  clean->SetTolerance(0);
  clean->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  clean->Update();
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(clean->GetOutput()->GetPoints());
  surface->SetPolys(clean->GetOutput()->GetPolys());
  return surface;
}

/// Blocks of triangles in the order of the file.
Cut Blocks(vtkIdType triangles)
{
  return [=](Index t, int processes)
  { return static_cast<int>(std::int64_t(t) * processes / triangles); };
}

double DifferenceOf(MpiJob& job, vtkPolyData* whole, const SetUp& setUp)
{
  const auto precise = [&](Optimizer* filter)
  {
    filter->SetTolerance(1e-12);
    setUp(filter);
  };
  const PieceOfMesh piece =
    TakePiece(whole, Blocks(whole->GetNumberOfPolys()), job.Rank(), job.Size());
  const Points pieces = PointsOf(Optimized(piece.surface, precise));
  const Points alone = PointsOf(OptimizedAlone(whole, precise));
  const Points expected = alone(piece.points, Eigen::indexing::all);
  return job.Largest((pieces - expected).cwiseAbs().maxCoeff() / whole->GetLength());
}
}

int TestDistributedRealMeshes(int argc, char* argv[])
{
  MpiJob job(argc, argv);
  Checks c;
  const std::filesystem::path folder = std::getenv("LMO_REAL_MESHES");
  for (const std::filesystem::directory_entry& file : std::filesystem::directory_iterator(folder))
  {
    if (file.path().extension() == ".obj")
    {
      const auto whole = Read(file.path());
      const std::string name = file.path().stem().string();
      c.Error(name + ": better triangles are those of the whole surface",
        DifferenceOf(
          job, whole, [](Optimizer* filter) { filter->SetPositionWeighting(Optimizer::CDF); }),
        1e-9);
      c.Error(name + ": features that are held are those of the whole surface",
        DifferenceOf(job, whole,
          [](Optimizer* filter)
          {
            filter->SetPositionWeighting(Optimizer::LINEAR);
            filter->SetLaplacianWeighting(Optimizer::LINEAR_COMPLEMENT);
          }),
        1e-9);
      c.Error(name + ": the smooth surface is that of the whole surface",
        DifferenceOf(job, whole,
          [](Optimizer* filter)
          {
            filter->SetMode(Optimizer::SMOOTH);
            filter->SetScaleFactor(0.3);
            filter->SetPositionWeighting(Optimizer::CONSTANT);
          }),
        1e-9);
    }
  }
  return c.Result();
}
