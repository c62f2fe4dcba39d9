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
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <array>

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

void Mark(vtkAbstractArray* array)
{
  array->GetInformation()->Set(ResultKey(), vtkNew<vtkObject>());
}

/// The field data of a surface's own list of results.
constexpr const char* ListName = "vtkLaplacianMeshOptimizerResults";

std::array<vtkFieldData*, 3> AllData(vtkPolyData* surface)
{
  return { surface->GetPointData(), surface->GetCellData(), surface->GetFieldData() };
}

const char* KindOf(vtkFieldData* data)
{
  return vtkPointData::SafeDownCast(data)  ? "point array"
         : vtkCellData::SafeDownCast(data) ? "cell array"
                                           : "field array";
}
}

bool ResultArrays::IsResult(vtkAbstractArray* array)
{
  return array->HasInformation() && array->GetInformation()->Has(ResultKey());
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
  Mark(result);
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

void ResultArrays::AddMissing(vtkFieldData* more, vtkFieldData* data, bool withResults)
{
  for (int k = 0; k < more->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = more->GetAbstractArray(k);
    if (array->GetName() && !data->HasArray(array->GetName()) && (withResults || !IsResult(array)))
    {
      data->AddArray(array);
    }
  }
}

void ResultArrays::HandOn(vtkFieldData* optimized, vtkFieldData* data)
{
  for (int k = 0; k < optimized->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = optimized->GetAbstractArray(k);
    if (IsResult(array))
    {
      this->Add(data, array);
    }
    else if (array->GetName())
    {
      data->AddArray(array);
    }
  }
}

void ResultArrays::Renew(vtkFieldData* before, vtkFieldData* optimized, vtkFieldData* data)
{
  for (int k = 0; k < before->GetNumberOfArrays(); ++k)
  {
    const char* name = before->GetArrayName(k);
    if (name && !optimized->HasArray(name))
    {
      Remove(data, name);
    }
  }
  for (int k = 0; k < optimized->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = optimized->GetAbstractArray(k);
    const char* name = array->GetName();
    if (IsResult(array))
    {
      const auto copy = vtk::TakeSmartPointer(array->NewInstance()); // each piece may rename it
      copy->DeepCopy(array);
      this->Add(data, copy);
    }
    else if (name && !before->HasArray(name) && !data->HasArray(name))
    {
      data->AddArray(array);
    }
  }
}

void ResultArrays::ListResults(vtkPolyData* surface)
{
  vtkNew<vtkStringArray> list;
  list->SetName(ListName);
  for (vtkFieldData* data : AllData(surface))
  {
    for (int k = 0; k < data->GetNumberOfArrays(); ++k)
    {
      if (IsResult(data->GetAbstractArray(k)))
      {
        list->InsertNextValue(data->GetArrayName(k));
      }
    }
    list->InsertNextValue(""); // ends the list of the point, cell or field data
  }
  surface->GetFieldData()->AddArray(list);
}

void ResultArrays::MarkListed(vtkPolyData* surface)
{
  auto* list = vtkStringArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray(ListName));
  vtkIdType next = 0;
  for (vtkFieldData* data : AllData(surface))
  {
    for (; list && next < list->GetNumberOfValues() && !list->GetValue(next).empty(); ++next)
    {
      if (vtkAbstractArray* array = data->GetAbstractArray(list->GetValue(next).c_str()))
      {
        Mark(array);
      }
    }
    ++next;
  }
  surface->GetFieldData()->RemoveArray(ListName);
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
