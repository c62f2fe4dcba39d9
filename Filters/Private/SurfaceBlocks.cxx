// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceBlocks.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataObjectTree.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

#include <cstring>
#include <utility>

namespace lmo
{
namespace
{
using Path = std::vector<unsigned int>;

/// Visits a tree, in the order of its flat indices.
class BlockCollector
{
public:
  std::vector<SurfaceBlock> Blocks;

  void Visit(vtkDataObject* node, const Path& path)
  {
    const unsigned int flatIndex = this->NextIndex++;
    if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(node))
    {
      this->AddPartitions(partitions, path);
    }
    else if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(node))
    {
      this->VisitChildren(
        blocks->GetNumberOfBlocks(), path, [&](unsigned int k) { return blocks->GetBlock(k); });
    }
    else if (auto* sets = vtkPartitionedDataSetCollection::SafeDownCast(node))
    {
      this->VisitChildren(sets->GetNumberOfPartitionedDataSets(), path,
        [&](unsigned int k) { return sets->GetPartitionedDataSet(k); });
    }
    else if (auto* data = vtkDataSet::SafeDownCast(node))
    {
      this->Blocks.push_back({ path, { { data, flatIndex } } });
    }
  }

private:
  void AddPartitions(vtkPartitionedDataSet* partitions, const Path& path)
  {
    SurfaceBlock block{ path, {}, true };
    for (unsigned int k = 0; k < partitions->GetNumberOfPartitions(); ++k)
    {
      const unsigned int flatIndex = this->NextIndex++;
      if (auto* data = vtkDataSet::SafeDownCast(partitions->GetPartitionAsDataObject(k)))
      {
        block.parts.push_back({ data, flatIndex });
      }
    }
    if (!block.parts.empty())
    {
      this->Blocks.push_back(std::move(block));
    }
  }

  template <typename ChildOf>
  void VisitChildren(unsigned int count, Path path, const ChildOf& childOf)
  {
    path.push_back(0);
    for (unsigned int k = 0; k < count; ++k)
    {
      path.back() = k;
      this->Visit(childOf(k), path);
    }
  }

  unsigned int NextIndex = 0;
};

vtkSmartPointer<vtkDataObject> NewOutputFor(vtkDataObject* input)
{
  if (vtkDataObjectTree::SafeDownCast(input))
  {
    return vtk::TakeSmartPointer(input->NewInstance());
  }
  if (vtkCompositeDataSet::SafeDownCast(input))
  {
    return vtkSmartPointer<vtkMultiBlockDataSet>::New();
  }
  return vtkSmartPointer<vtkPolyData>::New();
}

/// Of a composite data set that is no tree.
std::vector<SurfaceBlock> FindLeaves(vtkCompositeDataSet* data)
{
  std::vector<SurfaceBlock> blocks;
  const auto leaf = vtk::TakeSmartPointer(data->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    if (auto* block = vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject()))
    {
      const unsigned int flatIndex = leaf->GetCurrentFlatIndex();
      blocks.push_back({ { flatIndex }, { { block, flatIndex } } });
    }
  }
  return blocks;
}
}

std::vector<SurfaceBlock> FindBlocks(vtkDataObject* data)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (composite && !vtkDataObjectTree::SafeDownCast(data))
  {
    return FindLeaves(composite);
  }
  if (composite)
  {
    BlockCollector collector;
    collector.Visit(data, {});
    return std::move(collector.Blocks);
  }
  auto* single = vtkDataSet::SafeDownCast(data);
  return single ? std::vector<SurfaceBlock>{ { {}, { { single, std::nullopt } } } }
                : std::vector<SurfaceBlock>();
}

void SetOutputFor(vtkDataObject* input, vtkInformation* output)
{
  vtkDataObject* present = vtkDataObject::GetData(output);
  const auto fitting = NewOutputFor(input);
  if (!present || std::strcmp(present->GetClassName(), fitting->GetClassName()) != 0)
  {
    output->Set(vtkDataObject::DATA_OBJECT(), fitting);
  }
}

void SetParts(vtkDataObject* input, const std::vector<vtkSmartPointer<vtkPolyData>>& parts,
  vtkDataObject* output)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    output->ShallowCopy(parts.front());
    return;
  }
  auto* tree = vtkDataObjectTree::SafeDownCast(input);
  if (tree)
  {
    vtkDataObjectTree::SafeDownCast(output)->CopyStructure(tree);
  }
  auto part = parts.begin();
  const auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    if (!vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject()))
    {
      continue;
    }
    if (tree)
    {
      vtkDataObjectTree::SafeDownCast(output)->SetDataSet(leaf, *part++);
    }
    else
    {
      auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output);
      blocks->SetBlock(blocks->GetNumberOfBlocks(), *part++);
    }
  }
}
}
