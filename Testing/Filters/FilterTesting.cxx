// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkLaplacianMeshOptimizer.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkStringArray.h"
#include "vtkTestErrorObserver.h"

#include <limits>

using namespace lmo;

namespace
{
/// Grid of 12 x 12 cells on a cylinder.
TestMesh MixedMesh()
{
  return Irregular(CylinderPatch(2), 0.02);
}

void AddNumbers(vtkFieldData* fieldData, const char* name, vtkIdType tuples)
{
  vtkNew<vtkIntArray> numbers;
  numbers->SetName(name);
  numbers->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    numbers->SetValue(i, static_cast<int>(7 * i));
  }
  fieldData->AddArray(numbers);
}

void AddVerticesAndLines(vtkPolyData* mesh)
{
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  vertices->InsertNextCell({ 169, 5 });
  mesh->SetVerts(vertices);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 20, 169 });
  mesh->SetLines(lines);
}

void AddArrays(vtkPolyData* mesh)
{
  AddNumbers(mesh->GetPointData(), "PointNumber", mesh->GetNumberOfPoints());
  mesh->GetPointData()->SetActiveScalars("PointNumber");
  AddNumbers(mesh->GetCellData(), "CellNumber", mesh->GetNumberOfCells());
  AddNumbers(mesh->GetFieldData(), "FieldNumber", 3);
  vtkNew<vtkStringArray> text;
  text->SetName("Text");
  text->InsertNextValue("kept");
  mesh->GetFieldData()->AddArray(text);
}

vtkSmartPointer<vtkPolyData> MakeMixed(bool hasStrips)
{
  const TestMesh mesh = MixedMesh();
  TestMesh triangles{ Points(170, 3), hasStrips ? Triangles(mesh.T.topRows(144)) : mesh.T };
  triangles.V << mesh.V, Vector3(7, 8, 9);
  auto result = MakePolyData(triangles);
  AddVerticesAndLines(result);
  if (hasStrips)
  {
    vtkNew<vtkCellArray> strips;
    for (int row = 6; row < 12; ++row)
    {
      vtkNew<vtkIdList> strip;
      for (int i = 0; i <= 12; ++i)
      {
        strip->InsertNextId(13 * (row + 1) + i);
        strip->InsertNextId(13 * row + i);
      }
      strips->InsertNextCell(strip);
    }
    result->SetStrips(strips);
  }
  AddArrays(result);
  return result;
}

bool AreEqual(vtkAbstractArray* a, vtkAbstractArray* b)
{
  bool isEqual = a && b && a->GetDataType() == b->GetDataType() &&
                 a->GetNumberOfTuples() == b->GetNumberOfTuples() &&
                 a->GetNumberOfComponents() == b->GetNumberOfComponents();
  for (vtkIdType i = 0; isEqual && i < a->GetNumberOfValues(); ++i)
  {
    const vtkVariant valueOfA = a->GetVariantValue(i);
    const vtkVariant valueOfB = b->GetVariantValue(i);
    const bool areNaN = valueOfA != valueOfA && valueOfB != valueOfB;
    isEqual = valueOfA == valueOfB || areNaN;
  }
  return isEqual;
}

bool AreEqual(vtkPoints* a, vtkPoints* b)
{
  // A copy of no points is an empty vtkPoints.
  const auto isEmpty = [](vtkPoints* points)
  { return !points || points->GetNumberOfPoints() == 0; };
  return isEmpty(a) ? isEmpty(b) : b && AreEqual(a->GetData(), b->GetData());
}
}

vtkSmartPointer<vtkPolyData> MakePolyData(const TestMesh& mesh, int pointType)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  for (const auto& v : mesh.V.rowwise())
  {
    points->InsertNextPoint(v[0], v[1], v[2]);
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& T : mesh.T.rowwise())
  {
    polygons->InsertNextCell({ T[0], T[1], T[2] });
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(polygons);
  return result;
}

TestMesh Soup(const TestMesh& mesh)
{
  TestMesh soup;
  soup.V.resize(3 * mesh.T.rows(), 3);
  soup.T.resize(mesh.T.rows(), 3);
  for (Index corner = 0; corner < soup.V.rows(); ++corner)
  {
    soup.V.row(corner) = mesh.V.row(mesh.T.data()[corner]);
    soup.T.data()[corner] = corner;
  }
  return soup;
}

vtkSmartPointer<vtkPolyData> MakeMixedPolyData()
{
  return MakeMixed(true);
}

vtkSmartPointer<vtkPolyData> MakeMixedPolyDataWithoutStrips()
{
  return MakeMixed(false);
}

void AddPointArray(vtkPolyData* mesh, const char* name, const Eigen::MatrixXd& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.cols()));
  array->SetNumberOfTuples(values.rows());
  for (Eigen::Index i = 0; i < values.rows(); ++i)
  {
    for (int component = 0; component < values.cols(); ++component)
    {
      array->SetComponent(i, component, values(i, component));
    }
  }
  mesh->GetPointData()->AddArray(array);
}

Points PointsOf(vtkPolyData* mesh)
{
  return mesh->GetPoints() ? Points(ValuesOf(mesh->GetPoints()->GetData())) : Points(0, 3);
}

Eigen::MatrixXd ValuesOf(vtkDataArray* array)
{
  Eigen::MatrixXd values(
    array ? array->GetNumberOfTuples() : 0, array ? array->GetNumberOfComponents() : 0);
  for (Eigen::Index i = 0; i < values.rows(); ++i)
  {
    for (int component = 0; component < values.cols(); ++component)
    {
      values(i, component) = array->GetComponent(i, component);
    }
  }
  return values;
}

Eigen::MatrixXd PointValues(vtkPolyData* mesh, const char* name)
{
  return ValuesOf(mesh->GetPointData()->GetArray(name));
}

Eigen::MatrixXd CellValues(vtkPolyData* mesh, const char* name)
{
  return ValuesOf(mesh->GetCellData()->GetArray(name));
}

double FieldValue(vtkPolyData* mesh, const char* name)
{
  const Eigen::MatrixXd values = ValuesOf(mesh->GetFieldData()->GetArray(name));
  return values.size() == 1 ? values(0, 0) : std::numeric_limits<double>::quiet_NaN();
}

bool AreEqual(vtkCellArray* a, vtkCellArray* b)
{
  return AreEqual(a->GetOffsetsArray(), b->GetOffsetsArray()) &&
         AreEqual(a->GetConnectivityArray(), b->GetConnectivityArray());
}

bool AreEqual(vtkPolyData* a, vtkPolyData* b)
{
  return AreEqual(a->GetPoints(), b->GetPoints()) && AreEqual(a->GetVerts(), b->GetVerts()) &&
         AreEqual(a->GetLines(), b->GetLines()) && AreEqual(a->GetPolys(), b->GetPolys()) &&
         AreEqual(a->GetStrips(), b->GetStrips()) &&
         Contains(a->GetPointData(), b->GetPointData()) &&
         Contains(b->GetPointData(), a->GetPointData()) &&
         Contains(a->GetCellData(), b->GetCellData()) &&
         Contains(b->GetCellData(), a->GetCellData()) &&
         Contains(a->GetFieldData(), b->GetFieldData()) &&
         Contains(b->GetFieldData(), a->GetFieldData());
}

bool Contains(vtkFieldData* all, vtkFieldData* some)
{
  bool isContained = true;
  for (int k = 0; k < some->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = some->GetAbstractArray(k);
    isContained = isContained && AreEqual(all->GetAbstractArray(array->GetName()), array);
  }
  return isContained;
}

bool IsEmpty(vtkPolyData* mesh)
{
  return mesh->GetNumberOfPoints() == 0 && mesh->GetNumberOfCells() == 0 &&
         mesh->GetPointData()->GetNumberOfArrays() == 0 &&
         mesh->GetCellData()->GetNumberOfArrays() == 0 &&
         mesh->GetFieldData()->GetNumberOfArrays() == 0;
}

namespace
{
/// Keeps all errors and warnings.
class MessageObserver : public vtkCommand
{
public:
  static MessageObserver* New() { return new MessageObserver; }

  void Execute(vtkObject*, unsigned long event, void* text) override
  {
    std::string& all = event == vtkCommand::ErrorEvent ? this->Heard.errors : this->Heard.warnings;
    all += static_cast<const char*>(text);
  }

  Messages Heard;
};
}

Messages Update(vtkAlgorithm* filter)
{
  vtkNew<MessageObserver> observer;
  vtkNew<vtkTest::ErrorObserver> executiveObserver;
  const unsigned long tags[] = { filter->AddObserver(vtkCommand::ErrorEvent, observer),
    filter->AddObserver(vtkCommand::WarningEvent, observer) };
  // The pipeline reports the failure of its filter once more.
  const unsigned long tag =
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executiveObserver);
  filter->Update();
  for (const unsigned long filterTag : tags)
  {
    filter->RemoveObserver(filterTag);
  }
  filter->GetExecutive()->RemoveObserver(tag);
  return observer->Heard;
}

vtkSmartPointer<vtkSelectionNode> SelectionNode(int fieldType, const std::set<vtkIdType>& ids)
{
  vtkNew<vtkIdTypeArray> list;
  for (const vtkIdType id : ids)
  {
    list->InsertNextValue(id);
  }
  auto node = vtkSmartPointer<vtkSelectionNode>::New();
  node->SetFieldType(fieldType);
  node->SetContentType(vtkSelectionNode::INDICES);
  node->SetSelectionList(list);
  return node;
}

vtkSmartPointer<vtkSelection> Selection(const std::vector<vtkSmartPointer<vtkSelectionNode>>& nodes)
{
  auto selection = vtkSmartPointer<vtkSelection>::New();
  for (const auto& node : nodes)
  {
    selection->AddNode(node);
  }
  return selection;
}

vtkSmartPointer<vtkPolyData> Optimized(
  vtkPolyData* input, const std::function<void(vtkLaplacianMeshOptimizer*)>& setUp)
{
  vtkNew<vtkLaplacianMeshOptimizer> filter;
  filter->SetInputData(input);
  filter->SetMode(vtkLaplacianMeshOptimizer::OPTIMIZE_TRIANGLES);
  setUp(filter);
  filter->Update();
  return filter->GetOutput();
}
