// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceBlocks_h
#define SurfaceBlocks_h

#include "vtkSmartPointer.h"

#include <optional>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkInformation;
class vtkPolyData;

namespace lmo
{
/// A data set that is a surface, or a piece of one.
struct SurfacePart
{
  vtkDataSet* data;
  std::optional<unsigned int> flatIndex; ///< in a composite data set
};

/// What is one surface: a data set, or all partitions of a vtkPartitionedDataSet.
struct SurfaceBlock
{
  /// The place in a composite data set: the index of the block after those of the blocks that it is
  /// in. Unlike the flat index it does not depend on how many partitions other blocks have.
  std::vector<unsigned int> path;
  std::vector<SurfacePart> parts;
  bool isPartitioned = false;
};

/// The surfaces of a data set or of a composite data set. Blocks without data are left out.
std::vector<SurfaceBlock> FindBlocks(vtkDataObject* data);

/// Makes an empty output for an input unless there is one of its type: vtkPolyData for a data set,
/// a composite data set for a composite one, for AMR a vtkMultiBlockDataSet.
/// \param output information of the output port
void SetOutputFor(vtkDataObject* input, vtkInformation* output);

/// Gives \a output the structure of \a input.
/// \param parts the surface of each part that FindBlocks() finds, in that order
void SetParts(vtkDataObject* input, const std::vector<vtkSmartPointer<vtkPolyData>>& parts,
  vtkDataObject* output);
}

#endif
