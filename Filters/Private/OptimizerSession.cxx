// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OptimizerSession.h"

#include "FilterSupport.h"

#include "vtkPolyData.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkLaplacianMeshOptimizer::Session::Session(vtkLaplacianMeshOptimizer* filter)
  : Filter(filter)
{
}

vtkLaplacianMeshOptimizer::Session::~Session() = default;

void vtkLaplacianMeshOptimizer::Session::CheckPieces(int pieces) const
{
  if (pieces > 1)
  {
    throw lmo::InputError(
      "The surface comes in " + std::to_string(pieces) +
      " pieces, which one process cannot solve together. Run in one process, "
      "or build this module with PETSc (on Debian: libpetsc-real-dev) and MPI.");
  }
}

void vtkLaplacianMeshOptimizer::Session::Try(const std::function<void()>& body) const
{
  body();
}

std::unique_ptr<lmo::ProgressMonitor> vtkLaplacianMeshOptimizer::Session::MakeMonitor() const
{
  return std::make_unique<lmo::FilterMonitor>(this->Filter);
}

lmo::SurfaceMesh vtkLaplacianMeshOptimizer::Session::Read(vtkPolyData* input)
{
  return lmo::ReadMesh(input);
}

bool vtkLaplacianMeshOptimizer::Session::IsNew(vtkPolyData* input) const
{
  return !this->Optimizer || this->Input != input || this->InputTime != input->GetMTime() ||
         this->IsWelded != (this->Filter->WeldCoincidentPoints != 0);
}

void vtkLaplacianMeshOptimizer::Session::SetOptimizer(
  vtkPolyData* input, lmo::MeshNumbering numbering, std::unique_ptr<lmo::Optimizer> optimizer)
{
  this->Input = input;
  this->InputTime = input->GetMTime();
  this->IsWelded = this->Filter->WeldCoincidentPoints != 0;
  this->Numbering = std::move(numbering);
  this->Optimizer = std::move(optimizer);
}

void vtkLaplacianMeshOptimizer::Session::SetInput(vtkPolyData* input)
{
  if (this->IsNew(input))
  {
    this->Optimizer.reset(); // its memory serves for the next one
    lmo::SurfaceMesh mesh = Read(input);
    if (this->Filter->WeldCoincidentPoints)
    {
      lmo::WeldCoincidentPoints(mesh);
    }
    lmo::RenumberIfScattered(mesh);
    this->SetOptimizer(input, std::move(mesh.numbering),
      std::make_unique<lmo::Optimizer>(
        std::move(mesh.points), std::move(mesh.triangles), std::move(mesh.polygons)));
  }
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
