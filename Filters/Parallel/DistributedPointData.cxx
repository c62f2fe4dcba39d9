// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause

// Point data that are interpolated over the borders of pieces.
#include "DistributedOptimizer.h"
#include "DistributedSession.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <sstream>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

namespace
{
/// The arrays that all pieces with points have, in one order.
/// \param own arrays of the piece of this process; do not count if it has no points
std::vector<lmo::MovingArray> AgreeOn(
  const lmo::Communicator& comm, std::vector<lmo::MovingArray> own, bool hasPoints)
{
  own.resize(hasPoints ? own.size() : 0);
  std::string texts;
  for (const lmo::MovingArray& array : own)
  {
    texts += std::to_string(static_cast<int>(array.how)) + ' ' + std::to_string(array.components) +
             ' ' + array.name + '\0';
  }
  const std::vector<char> joined = comm.Join(std::vector<char>(texts.begin(), texts.end()));
  std::map<std::string, std::int64_t> pieces; // that have the array
  for (auto begin = joined.begin(); begin != joined.end();)
  {
    const auto end = std::find(begin, joined.end(), '\0');
    ++pieces[std::string(begin, end)];
    begin = end + 1;
  }
  const std::int64_t all = comm.Sum(std::int64_t(hasPoints));
  std::vector<lmo::MovingArray> common;
  for (const auto& [text, count] : pieces)
  {
    if (count == all)
    {
      std::istringstream words(text);
      int how = 0;
      lmo::MovingArray array;
      words >> how >> array.components;
      words.get();
      std::getline(words, array.name, '\0');
      array.how = static_cast<lmo::Interpolation>(how);
      common.push_back(array);
    }
  }
  return common;
}
}

vtkSmartPointer<vtkPointData> vtkPLaplacianMeshOptimizer::DistributedSession::PointDataAtNewPlaces(
  vtkPolyData* input, const lmo::OptimizerResult& result) const
{
  if (!this->IsDistributed())
  {
    return this->Session::PointDataAtNewPlaces(input, result);
  }
  const lmo::Communicator comm = this->GetCommunicator();
  const std::vector<lmo::MovingArray> arrays =
    AgreeOn(comm, this->FindMovingArrays(input), input->GetNumberOfPoints() > 0);
  const auto& optimizer = static_cast<const lmo::DistributedOptimizer&>(*this->Optimizer);
  bool isTorn = false;
  const std::unique_ptr<const lmo::DistributedPlaces> places =
    arrays.empty() ? nullptr : optimizer.FindPlaces(result.positions);
  auto data = this->MoveArrays(input, arrays,
    [&](const lmo::Fields& fields, lmo::Interpolation how)
    {
      const bool hasSeam = how != lmo::Interpolation::NEAREST && places->HasSeam(fields);
      isTorn = isTorn || hasSeam;
      return hasSeam ? fields : places->Interpolate(fields, how);
    });
  if (isTorn)
  {
    vtkWarningWithObjectMacro(this->Filter,
      "Point arrays with several values at one place, such as texture coordinates at seams, stay "
      "with their points, which have slid along the surface: only in one process are they "
      "interpolated on each side.");
  }
  return data;
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
