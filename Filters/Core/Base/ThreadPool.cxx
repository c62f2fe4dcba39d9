// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/ThreadPool.h"

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace lmo
{
namespace
{
thread_local ThreadPool* CurrentTeam = nullptr;
thread_local bool IsSerial = false;

/// Looks at a condition a while before sleeping: the next loop often follows within microseconds.
template <typename Condition>
bool Poll(const Condition& condition)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + std::chrono::microseconds(300);
  do
  {
    for (int k = 0; k < 256; ++k)
    {
      if (condition())
      {
        return true;
      }
    }
    std::this_thread::yield();
  } while (Clock::now() < end);
  return false;
}
}

/// A job is a number of tasks. Each thread begins with the same share of them every time, because
/// their data may still be in its cache, and then helps the others.
class ThreadPool::Implementation
{
public:
  explicit Implementation(int threads)
  {
    for (int k = 1; k < threads; ++k)
    {
      this->Threads.emplace_back([this, k] { this->Work(k); });
    }
  }

  ~Implementation()
  {
    {
      std::lock_guard<std::mutex> lock(this->Mutex);
      this->IsFinished = true;
      ++this->Generation;
    }
    this->Wake.notify_all();
    for (std::thread& thread : this->Threads)
    {
      thread.join();
    }
  }

  int Size() const { return static_cast<int>(this->Threads.size()) + 1; }

  void Run(Index count, const std::function<void(Index)>& task)
  {
    std::uint32_t generation = 0;
    {
      std::lock_guard<std::mutex> lock(this->Mutex);
      this->Task = &task;
      this->Count = count;
      this->Done = 0;
      generation = this->Generation + 1;
      this->Generation = generation;
    }
    this->Wake.notify_all();
    this->TakeTasks(0, generation, count, task);
    const auto isDone = [&] { return this->Done == std::min(count, LargestNumberOfShares); };
    if (!Poll(isDone))
    {
      std::unique_lock<std::mutex> lock(this->Mutex);
      this->AllDone.wait(lock, isDone);
    }
    if (this->Error)
    {
      std::rethrow_exception(std::exchange(this->Error, nullptr));
    }
  }

private:
  void Work(int member)
  {
    std::uint32_t seen = 0;
    while (true)
    {
      const auto isNew = [&] { return this->Generation != seen; };
      Poll(isNew);
      std::unique_lock<std::mutex> lock(this->Mutex);
      this->Wake.wait(lock, isNew);
      if (this->IsFinished)
      {
        return;
      }
      seen = this->Generation;
      const Index count = this->Count;
      const std::function<void(Index)>* task = this->Task;
      lock.unlock();
      this->TakeTasks(member, seen, count, *task);
    }
  }

  /// \param task is not touched unless a task of this generation is left, and then it is alive.
  void TakeTasks(
    int member, std::uint32_t generation, Index count, const std::function<void(Index)>& task)
  {
    const Index shares = std::min(count, LargestNumberOfShares);
    const auto bound = [&](Index share)
    { return static_cast<Index>(std::int64_t(count) * share / shares); };
    const Index first = shares * member / this->Size();
    for (Index k = 0; k < shares; ++k)
    {
      const Index share = (first + k) % shares;
      std::uint32_t last = this->Taken[share];
      if (last < generation && this->Taken[share].compare_exchange_strong(last, generation))
      {
        this->RunTasks(bound(share), bound(share + 1), task);
        if (++this->Done == shares)
        {
          std::lock_guard<std::mutex> lock(this->Mutex);
          this->AllDone.notify_one();
        }
      }
    }
  }

  void RunTasks(Index begin, Index end, const std::function<void(Index)>& task)
  {
    const SerialScope scope;
    try
    {
      for (Index k = begin; k < end; ++k)
      {
        task(k);
      }
    }
    catch (...)
    {
      std::lock_guard<std::mutex> lock(this->Mutex);
      this->Error = this->Error ? this->Error : std::current_exception();
    }
  }

  static constexpr Index LargestNumberOfShares = 64;

  std::vector<std::thread> Threads;
  std::mutex Mutex;
  std::condition_variable Wake;
  std::condition_variable AllDone;
  std::atomic<std::uint32_t> Generation{ 0 };
  std::array<std::atomic<std::uint32_t>, LargestNumberOfShares>
    Taken{}; ///< last generation of each
  std::atomic<Index> Done{ 0 };
  const std::function<void(Index)>* Task = nullptr;
  Index Count = 0;
  bool IsFinished = false;
  std::exception_ptr Error;
};

SerialScope::SerialScope()
  : Previous(std::exchange(IsSerial, true))
{
}

SerialScope::~SerialScope()
{
  IsSerial = this->Previous;
}

bool SerialScope::IsActive()
{
  return IsSerial;
}

ThreadPool::ThreadPool(int threads)
  : Members(new Implementation(threads))
  , Previous(CurrentTeam)
{
  CurrentTeam = this;
}

ThreadPool::~ThreadPool()
{
  CurrentTeam = this->Previous;
}

ThreadPool* ThreadPool::Current()
{
  return CurrentTeam;
}

int ThreadPool::Size() const
{
  return this->Members->Size();
}

void ThreadPool::Run(Index count, const std::function<void(Index)>& task)
{
  this->Members->Run(count, task);
}
}
