// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OptimizerSession.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkLaplacianMeshOptimizer::Session::TimeSteps* vtkLaplacianMeshOptimizer::Session::StepsOf(
  const Job& job)
{
  if (this->Filter->StartFromPreviousTimeStep && this->Filter->Mode == OPTIMIZE_WITHIN_DEVIATION)
  {
    return &this->Steps[job.path];
  }
  this->Steps.clear();
  return nullptr;
}

std::shared_ptr<const lmo::EarlierStep> vtkLaplacianMeshOptimizer::Session::FindEarlierStep(
  const Job& job)
{
  TimeSteps* steps = this->StepsOf(job);
  if (!steps)
  {
    return nullptr;
  }
  const lmo::MeshQuantities& mesh = this->Optimizer->GetMesh();
  const auto isSame = [](const auto& a, const auto& b) { return a.rows() == b.rows() && a == b; };
  if (!steps->last || !isSame(steps->last->triangles, mesh.GetTriangles()) ||
      steps->last->before.rows() != mesh.GetPoints().rows())
  {
    steps->start.reset();
  }
  else if (!isSame(steps->last->before, mesh.GetPoints()))
  {
    steps->start = steps->last;
  } // else it is the last step once more, which starts as it did before
  return steps->start;
}

void vtkLaplacianMeshOptimizer::Session::KeepStep(
  const Job& job, const lmo::OptimizerResult& result)
{
  TimeSteps* steps = this->StepsOf(job);
  if (steps && !result.isCancelled)
  {
    const lmo::MeshQuantities& mesh = this->Optimizer->GetMesh();
    steps->last = std::make_shared<lmo::EarlierStep>(lmo::EarlierStep{
      mesh.GetPoints(), result.positions, result.deviation.gain, mesh.GetTriangles() });
  }
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
