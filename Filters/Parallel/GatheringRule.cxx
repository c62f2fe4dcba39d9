// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "GatheringRule.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkSmartPointer.h"

#include <cstring>

namespace lmo
{
namespace
{
/// Points for each process, below which the seams between the pieces are too large a part of them
/// for OPTIMIZE_WITHIN_DEVIATION.
constexpr double FewPoints = 20000;

/// True if features lie between labels of cells, which only their own process knows.
bool HasLabels(vtkLaplacianMeshOptimizer* filter)
{
  vtkInformation* choice =
    filter->GetInputArrayInformation(vtkLaplacianMeshOptimizer::FEATURE_ARRAY);
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  const bool isNamed = name && *name && std::strcmp(name, "None") != 0;
  return isNamed &&
         choice->Get(vtkDataObject::FIELD_ASSOCIATION()) != vtkDataObject::FIELD_ASSOCIATION_POINTS;
}

/// True if a data set, or one that is in it, has cells of more than three points.
bool HasPolygons(vtkDataObject* data)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    auto* surface = vtkDataSet::SafeDownCast(data);
    return surface && surface->GetMaxCellSize() > 3;
  }
  const auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    if (HasPolygons(leaf->GetCurrentDataObject()))
    {
      return true;
    }
  }
  return false;
}

/// True if OPTIMIZE_WITHIN_DEVIATION can work on the pieces: on enough triangles, and without
/// another surface or an earlier one. Collective.
bool IsWithinPieces(vtkLaplacianMeshOptimizer* filter, const Communicator& comm)
{
  vtkDataObject* input = filter->GetInputDataObject(0, 0);
  const bool hasOther =
    filter->GetNumberOfInputConnections(2) > 0 || filter->GetStartFromPreviousTimeStep();
  const bool isExcluded = comm.Maximum(hasOther || HasPolygons(input)) > 0;
  const vtkIdType points = input ? input->GetNumberOfElements(vtkDataObject::POINT) : 0;
  return comm.Sum(double(points)) >= FewPoints * comm.Size() && !isExcluded;
}
}

bool NeedsOneProcess(vtkLaplacianMeshOptimizer* filter, const Communicator& comm)
{
  const bool isWithin = filter->GetMode() == vtkLaplacianMeshOptimizer::OPTIMIZE_WITHIN_DEVIATION;
  const bool isWhole = filter->GetMode() == vtkLaplacianMeshOptimizer::SMOOTH_GUIDED ||
                       filter->GetRobustLaplacian() ||
                       filter->GetBoundaryCondition() == vtkLaplacianMeshOptimizer::CURVE ||
                       filter->GetFeatureSmoothing() || filter->GetPreserveVolume() ||
                       filter->GetCheckSelfIntersections();
  const bool usesFeatures = isWithin || filter->GetFeatureConstraints();
  const bool isGathered = comm.Maximum(isWhole || (usesFeatures && HasLabels(filter))) > 0;
  const bool isOnPieces = comm.Maximum(isWithin) == 0 || IsWithinPieces(filter, comm);
  return isGathered || !isOnPieces;
}
}
