// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResultArrays_h
#define ResultArrays_h

#include "vtkFiltersLaplacianMeshModule.h" // for export macro

#include <string>

class vtkAbstractArray;
class vtkAlgorithm;
class vtkFieldData;
class vtkPolyData;

namespace lmo
{
/// Adds the results of a filter to its output, which starts as a copy of the input. Results of
/// filters of this module, which a key in their information marks, are replaced by new ones of the
/// same name. Any other array of that name is kept, and the result is named <name>Optimized.
class VTKFILTERSLAPLACIANMESH_EXPORT ResultArrays
{
public:
  /// True for results of filters of this module.
  static bool IsResult(vtkAbstractArray* array);

  /// Adds a result to point, cell or field data.
  void Add(vtkFieldData* data, vtkAbstractArray* result);

  /// Removes the result of an earlier filter.
  static void Remove(vtkFieldData* data, const char* name);

  /// Adds the arrays of \a more that \a data has not.
  /// \param withResults also those that are results of our filters
  static void AddMissing(vtkFieldData* more, vtkFieldData* data, bool withResults = false);

  /// Adds the arrays of a piece of an optimized surface to the data of the piece: results as Add()
  /// does, other arrays in the place of those of the same name.
  void HandOn(vtkFieldData* optimized, vtkFieldData* data);

  /// The same for field data, which pieces do not share.
  /// \param before the field data before the optimization
  void Renew(vtkFieldData* before, vtkFieldData* optimized, vtkFieldData* data);

  /// Adds a list of the results among a surface's arrays to its field data, for a journey on which
  /// arrays lose their marks.
  static void ListResults(vtkPolyData* surface);

  /// Marks the results that are listed, and removes the list.
  static void MarkListed(vtkPolyData* surface);

  /// Warns of the results that did not get their names.
  void Warn(vtkAlgorithm* filter) const;

private:
  int NumberOfRenamed = 0;
  std::string Renamed;
};
}

#endif
