// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResultArrays_h
#define ResultArrays_h

#include <string>

class vtkAbstractArray;
class vtkAlgorithm;
class vtkFieldData;

namespace lmo
{
/// Adds the results of a filter to its output, which starts as a copy of the input. Results of
/// filters of this module, which a key in their information marks, are replaced by new ones of the
/// same name. Any other array of that name is kept, and the result is named <name>Optimized.
class ResultArrays
{
public:
  /// Adds a result to point, cell or field data.
  void Add(vtkFieldData* data, vtkAbstractArray* result);

  /// Removes the result of an earlier filter.
  static void Remove(vtkFieldData* data, const char* name);

  /// Adds the arrays of \a more that \a data has not, and that are no results of our filters.
  static void AddMissing(vtkFieldData* more, vtkFieldData* data);

  /// Warns of the results that did not get their names.
  void Warn(vtkAlgorithm* filter) const;

private:
  int NumberOfRenamed = 0;
  std::string Renamed;
};
}

#endif
