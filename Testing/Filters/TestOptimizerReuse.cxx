// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
// The optimizer is kept as long as the mesh is the same. ParaView touches it before each execution.
#include "Checks.h"
#include "FilterTesting.h"
#include "MeshFixtures.h"

#include "Private/OptimizerSession.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

using namespace lmo;

namespace
{
/// Shows which mesh its optimizer has.
class WatchedOptimizer : public vtkLaplacianMeshOptimizer
{
public:
  static WatchedOptimizer* New();
  vtkTypeMacro(WatchedOptimizer, vtkLaplacianMeshOptimizer);

  /// \return where the points of the optimizer's mesh are
  const double* Execute()
  {
    this->Modified();
    this->Update();
    return this->Watched->GetPoints();
  }

protected:
  class WatchedSession : public Session
  {
  public:
    using Session::Session;
    const double* GetPoints() const { return this->Optimizer->GetMesh().GetPoints().data(); }
  };

  std::unique_ptr<Session> MakeSession() override
  {
    auto session = std::make_unique<WatchedSession>(this);
    this->Watched = session.get();
    return session;
  }

  WatchedSession* Watched = nullptr;
};
vtkStandardNewMacro(WatchedOptimizer);
}

int TestOptimizerReuse(int, char*[])
{
  Checks c;
  const auto input = MakePolyData(Irregular(Icosphere(2), 0.02));
  vtkNew<WatchedOptimizer> filter;
  filter->SetInputData(input);
  const double* first = filter->Execute();
  input->Modified();
  input->GetPoints()->Modified();
  c.True("an input that was only touched keeps the optimizer", filter->Execute() == first);
  const auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(input);
  filter->SetInputData(copy);
  c.True("so does another input with the same mesh", filter->Execute() == first);

  Vector3 point;
  copy->GetPoint(5, point.data());
  copy->GetPoints()->SetPoint(5, 1.001 * point[0], point[1], point[2]);
  copy->Modified();
  const double* moved = filter->Execute();
  c.True("a point that was moved in place makes a new optimizer", moved != first);

  vtkNew<vtkIdList> corners;
  copy->GetPolys()->GetCellAtId(0, corners);
  const vtkIdType turned[3]{ corners->GetId(1), corners->GetId(2), corners->GetId(0) };
  copy->GetPolys()->ReplaceCellAtId(0, 3, turned);
  copy->Modified();
  const double* renamed = filter->Execute();
  c.True("so do corners of a triangle in another order", renamed != moved);
  filter->SetWeldCoincidentPoints(false);
  c.True("points that are not welded and would not have been do not", filter->Execute() == renamed);
  return c.Result();
}
