// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OptimizerSession.h"

#include "FilterSupport.h"
#include "PointDataInterpolation.h"

#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
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

vtkLaplacianMeshOptimizer::Session::Origin vtkLaplacianMeshOptimizer::Session::OriginOf(
  vtkPolyData* data) const
{
  return { data, data->GetMTime(), this->Filter->WeldCoincidentPoints != 0 };
}

bool vtkLaplacianMeshOptimizer::Session::IsNew(vtkPolyData* input) const
{
  return !this->Optimizer || !(this->InputOrigin == this->OriginOf(input));
}

void vtkLaplacianMeshOptimizer::Session::SetOptimizer(
  vtkPolyData* input, lmo::MeshNumbering numbering, std::unique_ptr<lmo::Optimizer> optimizer)
{
  this->InputOrigin = this->OriginOf(input);
  this->Numbering = std::move(numbering);
  this->Optimizer = std::move(optimizer);
}

bool vtkLaplacianMeshOptimizer::Session::IsStill(vtkPolyData* surface) const
{
  if (!this->Optimizer || this->InputOrigin.data != surface)
  {
    return false;
  }
  const lmo::Points points = this->Numbering.ToPoints(this->Optimizer->GetMesh().GetPoints());
  bool isSame = points.rows() == surface->GetNumberOfPoints();
  for (vtkIdType i = 0; isSame && i < surface->GetNumberOfPoints(); ++i)
  {
    lmo::Vector3 point;
    surface->GetPoint(i, point.data());
    isSame = point == points.row(i);
  }
  return isSame;
}

lmo::SurfaceMesh vtkLaplacianMeshOptimizer::Session::ReadWelded(vtkPolyData* data) const
{
  lmo::SurfaceMesh mesh = Read(data);
  if (this->Filter->WeldCoincidentPoints)
  {
    lmo::WeldCoincidentPoints(mesh);
  }
  return mesh;
}

void vtkLaplacianMeshOptimizer::Session::SetInput(vtkPolyData* input)
{
  if (this->IsNew(input))
  {
    this->HasResult = this->HasResult && this->IsStill(input);
    this->Optimizer.reset(); // its memory serves for the next one
    lmo::SurfaceMesh mesh = this->ReadWelded(input);
    lmo::RenumberIfScattered(mesh);
    this->SetOptimizer(input, std::move(mesh.numbering),
      std::make_unique<lmo::Optimizer>(
        std::move(mesh.points), std::move(mesh.triangles), std::move(mesh.polygons)));
  }
}

std::shared_ptr<const lmo::MeshQuantities> vtkLaplacianMeshOptimizer::Session::ReadReference(
  vtkPolyData* reference)
{
  if (!reference || this->Filter->Mode != OPTIMIZE_WITHIN_DEVIATION)
  {
    this->Reference.reset();
    return nullptr;
  }
  if (!this->Reference || !(this->ReferenceOrigin == this->OriginOf(reference)))
  {
    this->Reference.reset();
    try
    {
      lmo::SurfaceMesh mesh = this->ReadWelded(reference);
      this->ReferenceNumbering = std::move(mesh.numbering);
      this->Reference =
        std::make_shared<lmo::MeshQuantities>(std::move(mesh.points), std::move(mesh.triangles));
    }
    catch (const lmo::InputError& error)
    {
      throw lmo::InputError("The Reference cannot be used. " + std::string(error.what()));
    }
    this->ReferenceOrigin = this->OriginOf(reference);
  }
  if (this->Reference->GetBox().isEmpty())
  {
    throw lmo::InputError("The Reference has no triangles. Connect a surface, or nothing.");
  }
  return this->Reference;
}

vtkLaplacianMeshOptimizer::Session::TimeSteps* vtkLaplacianMeshOptimizer::Session::StepsOf(
  const Inputs& inputs)
{
  if (this->Filter->StartFromPreviousTimeStep && this->Filter->Mode == OPTIMIZE_WITHIN_DEVIATION)
  {
    return &this->Steps[this->CompositeIndexOf(inputs.data).value_or(0)];
  }
  this->Steps.clear();
  return nullptr;
}

std::shared_ptr<const lmo::EarlierStep> vtkLaplacianMeshOptimizer::Session::FindEarlierStep(
  const Inputs& inputs)
{
  TimeSteps* steps = this->StepsOf(inputs);
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
  const Inputs& inputs, const lmo::OptimizerResult& result)
{
  TimeSteps* steps = this->StepsOf(inputs);
  if (steps && !result.isCancelled)
  {
    const lmo::MeshQuantities& mesh = this->Optimizer->GetMesh();
    steps->last = std::make_shared<lmo::EarlierStep>(lmo::EarlierStep{
      mesh.GetPoints(), result.positions, result.deviation.gain, mesh.GetTriangles() });
  }
}

void vtkLaplacianMeshOptimizer::Session::AddDataOfReference(
  vtkPolyData* reference, const lmo::OptimizerResult& result, vtkPolyData* output) const
{
  if (this->Reference && this->InterpolatesPointData())
  {
    lmo::ResultArrays::AddMissing(reference->GetFieldData(), output->GetFieldData());
    const lmo::Points positions = this->Numbering.ToPoints(result.positions);
    lmo::ResultArrays::AddMissing(
      lmo::PointDataAt(reference, this->ReferenceNumbering, positions), output->GetPointData());
  }
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
