// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OptimizerSession.h"

#include "FilterSupport.h"

#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkLaplacianMeshOptimizer::Session::Session(vtkLaplacianMeshOptimizer* filter)
  : Filter(filter)
{
}

vtkLaplacianMeshOptimizer::Session::~Session() = default;

namespace
{
/// The surfaces of all parts of a data object, one after the other.
lmo::SurfacePieces SurfacesOf(
  const std::vector<lmo::SurfaceBlock>& blocks, std::vector<lmo::CachedSurface>& cache)
{
  lmo::SurfacePieces surfaces;
  for (const lmo::SurfaceBlock& block : blocks)
  {
    for (const lmo::SurfacePart& part : block.parts)
    {
      cache.resize(std::max(cache.size(), surfaces.size() + 1));
      surfaces.push_back(cache[surfaces.size()].Of(part.data));
    }
  }
  return surfaces;
}

/// Calls body(); an error names the block if there are several.
template <typename Body>
auto InBlock(
  const lmo::SurfaceBlock& block, const std::vector<lmo::SurfaceBlock>& blocks, const Body& body)
{
  try
  {
    return body();
  }
  catch (const lmo::InputError& error)
  {
    std::string name;
    for (const unsigned int index : block.path)
    {
      name += (name.empty() ? "" : "/") + std::to_string(index);
    }
    throw lmo::InputError((blocks.size() > 1 ? "Block " + name + ": " : "") + error.what());
  }
}
}

void vtkLaplacianMeshOptimizer::Session::Execute(
  const Inputs& inputs, vtkDataObject* output, int pieces)
{
  this->CheckPieces(pieces);
  this->Totals.clear();
  this->TotalTriangles = 0;
  const std::vector<lmo::SurfaceBlock> blocks = this->FindBlocks(inputs.data);
  lmo::SurfacePieces surfaces;
  lmo::SurfacePieces reference;
  this->Try(
    [&]
    {
      surfaces = SurfacesOf(blocks, this->Surfaces);
      reference = SurfacesOf(lmo::FindBlocks(inputs.reference), this->SurfacesOfReference);
    });
  if (inputs.reference && reference.empty())
  {
    reference.push_back(vtkSmartPointer<vtkPolyData>::New()); // which is an error
  }
  lmo::SurfacePieces optimized;
  for (const lmo::SurfaceBlock& block : blocks)
  {
    const lmo::ProgressShare share(this->Filter, &block - blocks.data(), blocks.size());
    const auto first = surfaces.begin() + static_cast<std::ptrdiff_t>(optimized.size());
    const lmo::SurfacePieces ofBlock(
      first, first + static_cast<std::ptrdiff_t>(block.parts.size()));
    const lmo::SurfacePieces results = InBlock(block, blocks,
      [&]
      {
        Job job;
        this->Try([&] { job = this->MakeJob(block, ofBlock, inputs.selection); });
        job.reference = reference;
        return this->Optimize(job);
      });
    optimized.insert(optimized.end(), results.begin(), results.end());
  }
  lmo::SetParts(inputs.data, optimized, output);
  this->HasResult = pieces == 1;
}

void vtkLaplacianMeshOptimizer::Session::ReturnInput(const Inputs& inputs, vtkDataObject* output)
{
  const lmo::SurfacePieces surfaces = SurfacesOf(this->FindBlocks(inputs.data), this->Surfaces);
  if (this->HasResult && surfaces.size() == 1 && this->IsStill(surfaces.front()))
  {
    lmo::SetParts(inputs.data, surfaces, output);
  }
}

vtkLaplacianMeshOptimizer::Session::Job vtkLaplacianMeshOptimizer::Session::MakeJob(
  const lmo::SurfaceBlock& block, const lmo::SurfacePieces& surfaces, vtkSelection* selection) const
{
  Job job{ surfaces, block.path, block.isPartitioned, std::nullopt, {} };
  if (!selection)
  {
    return job;
  }
  std::vector<double> isSelected;
  for (std::size_t k = 0; k < surfaces.size(); ++k)
  {
    const lmo::Vector ofPart = this->SelectedPointsOf(block.parts[k], selection, surfaces[k]);
    isSelected.insert(isSelected.end(), ofPart.begin(), ofPart.end());
  }
  job.isSelected =
    Eigen::Map<const lmo::Vector>(isSelected.data(), static_cast<Eigen::Index>(isSelected.size()));
  return job;
}

lmo::SurfacePieces vtkLaplacianMeshOptimizer::Session::Optimize(const Job& job)
{
  return this->OptimizeJoined(job, lmo::Joining::ONE_SURFACE);
}

lmo::SurfacePieces vtkLaplacianMeshOptimizer::Session::OptimizeJoined(
  const Job& job, lmo::Joining joining)
{
  const auto join = [](const lmo::SurfacePieces& pieces, bool isPartitioned, lmo::Joining how,
                      lmo::CachedJoin& cache)
  {
    if (pieces.size() == 1 && !isPartitioned)
    {
      cache = lmo::CachedJoin();
      return Whole{ pieces.front(), {} };
    }
    const lmo::JoinedPieces& joined = cache.Of(pieces, how);
    return Whole{ joined.GetSurface(), joined.GetFirstPoints() };
  };
  Whole whole;
  Whole reference;
  this->Try(
    [&]
    {
      whole = join(job.pieces, job.isPartitioned, joining, this->Joined);
      if (!job.reference.empty())
      {
        reference = join(job.reference, false, lmo::Joining::ONE_SURFACE, this->JoinedReference);
      }
    });
  vtkNew<vtkPolyData> optimized;
  this->OptimizeWhole(whole, job, reference, optimized);
  if (job.pieces.size() == 1 && !job.isPartitioned)
  {
    return { optimized };
  }
  lmo::SurfacePieces pieces;
  lmo::ResultArrays results;
  for (std::size_t k = 0; k < job.pieces.size(); ++k)
  {
    pieces.push_back(
      this->Joined.Of(job.pieces, joining).HandBack(job.pieces[k], k, optimized, results));
  }
  results.Warn(this->Filter);
  return pieces;
}

std::vector<lmo::SurfaceBlock> vtkLaplacianMeshOptimizer::Session::FindBlocks(
  vtkDataObject* data) const
{
  return lmo::FindBlocks(data);
}

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

lmo::SurfaceMesh vtkLaplacianMeshOptimizer::Session::ReadWelded(
  vtkPolyData* data, const std::vector<lmo::Index>& firstPoints) const
{
  lmo::SurfaceMesh mesh = Read(data);
  lmo::MergeVertices(mesh, firstPoints);
  if (this->Filter->WeldCoincidentPoints)
  {
    lmo::WeldCoincidentPoints(mesh);
  }
  return mesh;
}

void vtkLaplacianMeshOptimizer::Session::SetInput(
  vtkPolyData* input, const std::vector<lmo::Index>& firstPoints)
{
  if (this->IsNew(input))
  {
    lmo::SurfaceMesh mesh = this->ReadWelded(input, firstPoints);
    const lmo::MeshFingerprint fingerprint = lmo::FingerprintOf(mesh);
    const bool isSame = this->Optimizer && fingerprint == this->Fingerprint;
    this->HasResult = this->HasResult && isSame && this->InputOrigin.data == input;
    if (isSame)
    {
      this->InputOrigin = this->OriginOf(input);
      return;
    }
    this->Optimizer.reset(); // its memory serves for the next one
    lmo::RenumberIfScattered(mesh);
    this->Fingerprint = fingerprint;
    this->SetOptimizer(input, std::move(mesh.numbering),
      std::make_unique<lmo::Optimizer>(
        std::move(mesh.points), std::move(mesh.triangles), std::move(mesh.polygons)));
  }
}

std::shared_ptr<const lmo::MeshQuantities> vtkLaplacianMeshOptimizer::Session::ReadReference(
  const Whole& reference)
{
  if (!reference.data || this->Filter->Mode != OPTIMIZE_WITHIN_DEVIATION)
  {
    this->Reference.reset();
    return nullptr;
  }
  if (!this->Reference || !(this->ReferenceOrigin == this->OriginOf(reference.data)))
  {
    this->Reference.reset();
    try
    {
      lmo::SurfaceMesh mesh = this->ReadWelded(reference.data, reference.firstPoints);
      this->ReferenceNumbering = std::move(mesh.numbering);
      this->Reference =
        std::make_shared<lmo::MeshQuantities>(std::move(mesh.points), std::move(mesh.triangles));
    }
    catch (const lmo::InputError& error)
    {
      throw lmo::InputError("The Reference cannot be used. " + std::string(error.what()));
    }
    this->ReferenceOrigin = this->OriginOf(reference.data);
  }
  if (this->Reference->GetBox().isEmpty())
  {
    throw lmo::InputError("The Reference has no triangles. Connect a surface, or nothing.");
  }
  return this->Reference;
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
