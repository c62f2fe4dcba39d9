// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OptimizerEngine.h"

#include "FilterSupport.h"

#include "vtkPolyData.h"

vtkLaplacianMeshOptimizer::Engine::Engine(vtkLaplacianMeshOptimizer* filter)
  : Filter(filter)
{
}

vtkLaplacianMeshOptimizer::Engine::~Engine() = default;

void vtkLaplacianMeshOptimizer::Engine::CheckPieces(int pieces)
{
  if (pieces > 1)
  {
    throw lmo::InputError(
      "The surface comes in " + std::to_string(pieces) +
      " pieces, which one process cannot solve together. Run in one process, "
      "or build this module with PETSc (on Debian: libpetsc-real-dev) and MPI.");
  }
}

void vtkLaplacianMeshOptimizer::Engine::Try(const std::function<void()>& body)
{
  body();
}

std::unique_ptr<lmo::ProgressMonitor> vtkLaplacianMeshOptimizer::Engine::MakeMonitor()
{
  return std::make_unique<lmo::FilterMonitor>(this->Filter);
}

bool vtkLaplacianMeshOptimizer::Engine::IsNew(vtkPolyData* input) const
{
  return !this->Optimizer || this->Input != input || this->InputTime != input->GetMTime();
}

lmo::SurfaceMesh vtkLaplacianMeshOptimizer::Engine::Read(vtkPolyData* input)
{
  lmo::SurfaceMesh mesh = lmo::ReadMesh(input);
  this->TriangleCells = std::move(mesh.triangleCells);
  this->Input = input;
  this->InputTime = input->GetMTime();
  return mesh;
}

void vtkLaplacianMeshOptimizer::Engine::SetInput(vtkPolyData* input)
{
  if (this->IsNew(input))
  {
    this->Optimizer.reset();
    lmo::SurfaceMesh mesh = this->Read(input);
    this->Optimizer =
      std::make_unique<lmo::Optimizer>(std::move(mesh.points), std::move(mesh.triangles));
  }
}

lmo::OptimizerResult vtkLaplacianMeshOptimizer::Engine::Run(const lmo::OptimizerOptions& options,
  const lmo::VertexArrays& arrays, lmo::ProgressMonitor& monitor)
{
  if (!arrays.regions)
  {
    return this->Optimizer->Run(options, arrays, monitor);
  }
  lmo::VertexArrays ofTriangles = arrays;
  lmo::Vector& regions = *ofTriangles.regions;
  regions.resize(this->Optimizer->GetMesh().GetTriangles().rows());
  for (lmo::Index t = 0; t < regions.size(); ++t)
  {
    regions[t] = (*arrays.regions)[this->TriangleCells(t)];
  }
  return this->Optimizer->Run(options, ofTriangles, monitor);
}
