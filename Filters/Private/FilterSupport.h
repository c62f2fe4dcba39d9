// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FilterSupport_h
#define FilterSupport_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Base/ThreadPool.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkOutputWindow.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <new>

namespace lmo
{
/// True if the user asked the filter to stop.
inline bool IsAborted(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220000)
  return filter->CheckAbort();
#else
  return filter->GetAbortExecute() != 0;
#endif
}

/// Keeps the output of a filter that was asked to stop, which VTK would empty otherwise.
inline void KeepOutput(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220000)
  filter->SetAbortOutput(false);
#else
  static_cast<void>(filter);
#endif
}

/// Passes progress to a filter's observers, and their wish to stop back.
class FilterMonitor : public ProgressMonitor
{
public:
  explicit FilterMonitor(vtkAlgorithm* filter)
    : Filter(filter)
  {
  }

protected:
  void ShowStage(const char* stage) override
  {
    this->Filter->SetProgressText(stage);
    this->Filter->UpdateProgress(std::max(this->Shown, 0.0));
  }

  void ShowProgress(double fraction) override
  {
    constexpr double step = 0.01;
    constexpr std::chrono::milliseconds longestSilence(100);
    const auto now = Clock::now();
    // Observers can ask to stop only when they hear something.
    if (fraction >= this->Shown + step || now >= this->ShownAt + longestSilence)
    {
      this->Shown = std::max(this->Shown, fraction);
      this->ShownAt = now;
      this->Filter->UpdateProgress(this->Shown);
    }
  }

  bool IsCancelled() override { return IsAborted(this->Filter); }

private:
  using Clock = std::chrono::steady_clock;

  vtkAlgorithm* Filter;
  double Shown = -1;
  Clock::time_point ShownAt = Clock::now();
};

/// True if the user chose a backend of vtkSMPTools; VTK's default is often the sequential one.
inline bool IsBackendChosen()
{
  return std::getenv("VTK_SMP_BACKEND_IN_USE") ||
         std::strcmp(vtkSMPTools::GetBackend(), "Sequential") != 0;
}

/// Calls body() with the backend of vtkSMPTools that the user chose, otherwise with threads.
/// \param threads their number if the user chose no backend; 0 stands for one for each processor
template <typename Body>
void WithBackend(int threads, const Body& body)
{
  if (IsBackendChosen())
  {
    body();
    return;
  }
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false }, body);
}

/// Calls body() with the threads that vtkSMPTools provides: as the user chose, otherwise one for
/// each processor.
template <typename Body>
void RunOnThreads(const Body& body)
{
  WithBackend(0,
    [&body]
    {
      if (std::strcmp(vtkSMPTools::GetBackend(), "STDThread") == 0)
      {
        const ThreadPool team(vtkSMPTools::GetEstimatedNumberOfThreads());
        body();
        return;
      }
      body();
    });
}

/// The share of one of several surfaces in the progress of a filter.
class ProgressShare
{
public:
  ProgressShare(vtkAlgorithm* filter, std::size_t surface, std::size_t surfaces)
    : Filter(filter)
  {
    const double share = 1.0 / static_cast<double>(surfaces);
    filter->SetProgressShiftScale(share * static_cast<double>(surface), share);
  }
  ~ProgressShare() { this->Filter->SetProgressShiftScale(0, 1); }
  ProgressShare(const ProgressShare&) = delete;
  void operator=(const ProgressShare&) = delete;

private:
  vtkAlgorithm* const Filter;
};

/// The next error of a filter's executive: dropped if it only says that the filter failed, which
/// the filter has said already, with the reason.
class FailureObserver : public vtkCommand
{
public:
  static FailureObserver* New() { return new FailureObserver; }

  void Execute(vtkObject* executive, unsigned long, void* text) override
  {
    const auto* message = static_cast<const char*>(text);
    executive->RemoveObserver(this);
    if (!std::strstr(message, "returned failure for request"))
    {
      vtkOutputWindowDisplayErrorText(message);
    }
  }
};

/// Makes the error that a filter has just reported the only one of this failure.
inline void DropErrorOfExecutive(vtkAlgorithm* filter)
{
  if (vtkObject::GetGlobalWarningDisplay())
  {
    const auto observer = vtk::TakeSmartPointer(FailureObserver::New());
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  }
}

/// RequestData() of all filters: calls body() on threads and turns exceptions into vtkErrorMacro.
/// Does nothing if \a input is null, which happens for blocks that are not vtkDataSet. The output
/// is empty after an error or a cancellation.
/// \param afterError called after an error, when the output is empty
/// \return what RequestData() returns
template <typename Filter, typename Body>
int RunFilter(
  Filter* filter, vtkDataObject* input, vtkDataObject* output, const Body& body,
  const std::function<void()>& afterError = [] {})
{
  if (!input || !output)
  {
    return 1;
  }
  try
  {
    RunOnThreads(body);
    return 1;
  }
  catch (const Cancelled&)
  {
    output->Initialize();
    return 1;
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorWithObjectMacro(filter, "Not enough memory for this mesh.");
  }
  catch (const std::exception& error)
  {
    vtkErrorWithObjectMacro(filter, << error.what());
  }
  output->Initialize();
  afterError();
  DropErrorOfExecutive(filter);
  return 0;
}
}

#endif
