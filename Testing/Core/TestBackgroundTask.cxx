// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"

#include "Core/Base/BackgroundTask.h"
#include "Core/Base/Threading.h"

#include <atomic>
#include <memory>
#include <stdexcept>

using namespace lmo;

namespace
{
/// Remembers that it was asked, and cancels if it is told to.
class TestMonitor : public ProgressMonitor
{
public:
  explicit TestMonitor(bool cancels)
    : Cancels(cancels)
  {
  }

  std::shared_ptr<std::atomic<bool>> WasAsked = std::make_shared<std::atomic<bool>>(false);

protected:
  bool IsCancelled() override
  {
    *this->WasAsked = true;
    return this->Cancels;
  }

private:
  const bool Cancels;
};

void WaitFor(const std::atomic<bool>& flag)
{
  while (!flag)
  {
    std::this_thread::yield();
  }
}
void CheckResults(Checks& c)
{
  TestMonitor patient(false);
  c.Equal("the monitor is asked while the work is done, and the result is returned",
    RunInBackground(patient,
      [wasAsked = patient.WasAsked]
      {
        WaitFor(*wasAsked);
        return 42;
      }),
    42);
  c.Throws<std::domain_error>("what the work throws is thrown",
    [&] { RunInBackground(patient, []() -> int { throw std::domain_error("work"); }); });
}

void CheckLoops(Checks& c)
{
  TestMonitor patient(false);
  c.Equal("loops of the work run on its thread alone",
    RunInBackground(patient, [] { return NumberOfThreads(); }), 1);
  const ThreadPool team(3);
  const Index threads = ParallelSum(
    Index(3 * ParallelBlock), Index(0), [](Index& sum, Index) { sum += NumberOfThreads(); });
  c.True("loops inside a loop of a team run on its thread alone",
    threads == 3 * ParallelBlock && NumberOfThreads() == 3);
}

void CheckCancellation(Checks& c)
{
  TestMonitor impatient(true);
  const auto mayEnd = std::make_shared<std::atomic<bool>>(false);
  const auto hasEnded = std::make_shared<std::atomic<bool>>(false);
  c.Throws<Cancelled>("a cancellation does not wait for the work",
    [&]
    {
      RunInBackground(impatient,
        [mayEnd, hasEnded]
        {
          WaitFor(*mayEnd);
          *hasEnded = true;
          return 0;
        });
    });
  c.True("the work goes on after a cancellation", !*hasEnded);
  *mayEnd = true;
  WaitFor(*hasEnded);
}
}

int TestBackgroundTask(int argc, char* argv[])
{
  Groups groups(argc, argv);
  groups.Run("Results", CheckResults);
  groups.Run("Loops", CheckLoops);
  groups.Run("Cancellation", CheckCancellation);
  return groups.Result();
}
