// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ResultArrays.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace lmo
{
namespace
{
/// Marks our results. Copies of an array have the mark too. Files do not, since writers leave out
/// keys of this type: readers without this module would warn of an unknown key.
vtkInformationObjectBaseKey* ResultKey()
{
  static vtkInformationObjectBaseKey* const key =
    vtkInformationObjectBaseKey::MakeKey("RESULT", "vtkLaplacianMeshOptimizer");
  return key;
}

bool IsResult(vtkAbstractArray* array)
{
  return array->HasInformation() && array->GetInformation()->Has(ResultKey());
}

const char* KindOf(vtkFieldData* data)
{
  return vtkPointData::SafeDownCast(data)  ? "point array"
         : vtkCellData::SafeDownCast(data) ? "cell array"
                                           : "field array";
}
}

void ResultArrays::Add(vtkFieldData* data, vtkAbstractArray* result)
{
  const std::string name = result->GetName();
  std::string newName = name;
  for (vtkAbstractArray* old = nullptr;
       (old = data->GetAbstractArray(newName.c_str())) && !IsResult(old);)
  {
    newName += "Optimized";
  }
  if (newName != name)
  {
    result->SetName(newName.c_str());
    this->Renamed += (this->NumberOfRenamed++ ? ", " : " ") + std::string(KindOf(data)) + " '" +
                     name + "' (result '" + newName + "')";
  }
  result->GetInformation()->Set(ResultKey(), vtkNew<vtkObject>());
  data->AddArray(result);
}

void ResultArrays::Remove(vtkFieldData* data, const char* name)
{
  vtkAbstractArray* old = data->GetAbstractArray(name);
  if (old && IsResult(old))
  {
    data->RemoveArray(name);
  }
}

void ResultArrays::AddMissing(vtkFieldData* more, vtkFieldData* data)
{
  for (int k = 0; k < more->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = more->GetAbstractArray(k);
    if (array->GetName() && !data->HasArray(array->GetName()) && !IsResult(array))
    {
      data->AddArray(array);
    }
  }
}

void ResultArrays::Warn(vtkAlgorithm* filter) const
{
  if (this->NumberOfRenamed > 0)
  {
    vtkWarningWithObjectMacro(filter,
      << this->NumberOfRenamed
      << (this->NumberOfRenamed == 1 ? " array of the input has the name of a result"
                                     : " arrays of the input have the names of results")
      << " and is kept:" << this->Renamed
      << ". Rename or remove the array of the input if the result is to have its own name.");
  }
}
}
