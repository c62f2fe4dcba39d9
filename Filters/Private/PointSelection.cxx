// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PointSelection.h"

#include "Core/Base/Exceptions.h"

#include "vtkDataArrayRange.h"
#include "vtkDataSet.h"
#include "vtkExtractSelection.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

namespace lmo
{
namespace
{
bool NamesBlock(vtkSelectionNode* node)
{
  const int type = node->GetContentType();
  vtkInformation* properties = node->GetProperties();
  return type == vtkSelectionNode::BLOCKS || type == vtkSelectionNode::BLOCK_SELECTORS ||
         properties->Has(vtkSelectionNode::COMPOSITE_INDEX()) ||
         properties->Has(vtkSelectionNode::HIERARCHICAL_INDEX());
}

/// The nodes of a selection that are of one block, without its name.
vtkSmartPointer<vtkSelection> NodesOf(vtkSelection* selection, unsigned int block)
{
  auto ofBlock = vtkSmartPointer<vtkSelection>::New();
  for (unsigned int k = 0; k < selection->GetNumberOfNodes(); ++k)
  {
    vtkSelectionNode* node = selection->GetNode(k);
    vtkInformationIntegerKey* key = vtkSelectionNode::COMPOSITE_INDEX();
    const bool hasIndex = node->GetProperties()->Has(key);
    if (!hasIndex || node->GetProperties()->Get(key) == static_cast<int>(block))
    {
      vtkNew<vtkSelectionNode> copy;
      copy->ShallowCopy(node);
      copy->GetProperties()->Remove(key);
      ofBlock->AddNode(copy);
    }
  }
  return ofBlock;
}

/// \throw InputError for what vtkExtractSelection ignores or cannot do.
void CheckSelection(vtkSelection* selection)
{
  for (unsigned int k = 0; k < selection->GetNumberOfNodes(); ++k)
  {
    vtkSelectionNode* node = selection->GetNode(k);
    if (NamesBlock(node))
    {
      throw InputError("The selection names blocks in a way that is not known here. Select points "
                       "or cells, or extract the block and select in the result.");
    }
    const int type = node->GetContentType();
    if (type == vtkSelectionNode::QUERY || type == vtkSelectionNode::USER)
    {
      throw InputError("The selection is a query, which cannot be evaluated here. Freeze it (Find "
                       "Data in ParaView), or select points or cells by their ids.");
    }
    const int kind = node->GetFieldType();
    if ((kind != vtkSelectionNode::POINT && kind != vtkSelectionNode::CELL) ||
        kind != selection->GetNode(0)->GetFieldType())
    {
      throw InputError("The selection mixes points and cells, or has neither. Select points alone "
                       "or cells alone.");
    }
  }
}
}

Vector SelectedPoints(vtkDataSet* data, vtkSelection* whole, std::optional<unsigned int> block)
{
  vtkSmartPointer<vtkSelection> selection = whole;
  if (block)
  {
    selection = NodesOf(whole, *block);
  }
  CheckSelection(selection);
  Vector isSelected = Vector::Zero(data->GetNumberOfPoints());
  if (selection->GetNumberOfNodes() == 0)
  {
    return isSelected; // VTK 9.1's filter takes that for a mixture
  }
  const auto copy = vtk::TakeSmartPointer(data->NewInstance());
  copy->ShallowCopy(data);
  vtkNew<vtkExtractSelection> extraction;
  extraction->SetInputData(0, copy);
  extraction->SetInputData(1, selection);
  extraction->Update();
  auto* extract = vtkDataSet::SafeDownCast(extraction->GetOutputDataObject(0));
  auto* ids =
    extract ? vtkIdTypeArray::SafeDownCast(extract->GetPointData()->GetArray("vtkOriginalPointIds"))
            : nullptr;
  if (ids)
  {
    for (const vtkIdType id : vtk::DataArrayValueRange<1>(ids))
    {
      isSelected[id] = 1;
    }
  }
  return isSelected;
}
}
