// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_BackgroundTask_h
#define lmo_BackgroundTask_h

#include "Core/Base/ProgressMonitor.h"
#include "Core/Base/ThreadPool.h"

#include <chrono>
#include <future>
#include <thread>
#include <utility>

namespace lmo
{
/// Calls work() on a thread of its own and asks the monitor meanwhile: for long work in which the
/// monitor cannot be asked, as that of a library. After a cancellation the work goes on unseen to
/// its end; it must own all that it uses.
/// \return what work() returns
/// \throw Cancelled if the monitor says so; what work() throws.
template <typename Work>
auto RunInBackground(ProgressMonitor& monitor, Work work)
{
  constexpr std::chrono::milliseconds pause(50);
  std::packaged_task<decltype(work())()> task(
    [work = std::move(work)]() mutable
    {
      const SerialScope scope;
      return work();
    });
  auto result = task.get_future();
  std::thread thread(std::move(task));
  try
  {
    while (result.wait_for(pause) != std::future_status::ready)
    {
      monitor.Report(0);
    }
  }
  catch (...)
  {
    thread.detach();
    throw;
  }
  thread.join(); // it frees what work() owns
  return result.get();
}
}

#endif
