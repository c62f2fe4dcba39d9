// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadTeam.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace lmo
{
namespace
{
thread_local ThreadTeam* CurrentTeam = nullptr;

/// Looks at a condition a while before sleeping: the next loop often follows within microseconds.
template <typename Condition>
bool Poll(const Condition& condition)
{
  constexpr int looks = 2000;
  for (int k = 0; k < looks; ++k)
  {
    if (condition())
    {
      return true;
    }
    if (k % 64 == 63)
    {
      std::this_thread::yield();
    }
  }
  return false;
}
}

/// A job is a number of tasks. Its generation is part of the counter from which tasks are taken, so
/// that a thread which wakes up late takes none of the next job for its own.
class ThreadTeam::Implementation
{
public:
  explicit Implementation(int threads)
  {
    for (int k = 1; k < threads; ++k)
    {
      this->Threads.emplace_back([this] { this->Work(); });
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
      this->Next = std::uint64_t(generation) << 32;
      this->Generation = generation;
    }
    this->Wake.notify_all();
    this->TakeTasks(generation, count, task);
    const auto isDone = [&] { return this->Done == count; };
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
  void Work()
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
      this->TakeTasks(seen, count, *task);
    }
  }

  /// \param task is not touched unless a task of this generation is left, and then it is alive.
  void TakeTasks(std::uint32_t generation, Index count, const std::function<void(Index)>& task)
  {
    std::uint64_t next = this->Next;
    while (next >> 32 == generation && Index(next & 0xffffffffu) < count)
    {
      if (!this->Next.compare_exchange_weak(next, next + 1))
      {
        continue;
      }
      try
      {
        task(Index(next & 0xffffffffu));
      }
      catch (...)
      {
        std::lock_guard<std::mutex> lock(this->Mutex);
        this->Error = this->Error ? this->Error : std::current_exception();
      }
      if (++this->Done == count)
      {
        std::lock_guard<std::mutex> lock(this->Mutex);
        this->AllDone.notify_one();
      }
      next = this->Next;
    }
  }

  std::vector<std::thread> Threads;
  std::mutex Mutex;
  std::condition_variable Wake;
  std::condition_variable AllDone;
  std::atomic<std::uint32_t> Generation{ 0 };
  std::atomic<std::uint64_t> Next{ 0 }; ///< generation and number of the next task
  std::atomic<Index> Done{ 0 };
  const std::function<void(Index)>* Task = nullptr;
  Index Count = 0;
  bool IsFinished = false;
  std::exception_ptr Error;
};

ThreadTeam::ThreadTeam(int threads)
  : Members(new Implementation(threads))
  , Previous(CurrentTeam)
{
  CurrentTeam = this;
}

ThreadTeam::~ThreadTeam()
{
  CurrentTeam = this->Previous;
}

ThreadTeam* ThreadTeam::Current()
{
  return CurrentTeam;
}

int ThreadTeam::Size() const
{
  return this->Members->Size();
}

void ThreadTeam::Run(Index count, const std::function<void(Index)>& task)
{
  this->Members->Run(count, task);
}
}
