// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Communicator_h
#define lmo_Communicator_h

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace lmo
{
/// A list for each process.
template <typename T>
using PerProcess = std::vector<std::vector<T>>;

/// The processes that hold a mesh together. All functions but the getters are collective: every
/// process calls them, in the same order.
class Communicator
{
public:
  explicit Communicator(MPI_Comm comm);

  MPI_Comm Get() const { return this->Comm; }
  int Rank() const { return this->ThisRank; }
  int Size() const { return this->NumberOfRanks; }

  /// Number of processes on the computer of this one.
  int SizeOnComputer() const;

  double Sum(double value) const;
  double Maximum(double value) const;
  std::int64_t Sum(std::int64_t value) const;

  /// Sum over the processes of lower rank.
  std::int64_t SumBefore(std::int64_t value) const;

  /// Replaces each value by its sum over the processes.
  void Sum(std::vector<std::int64_t>& counts) const;
  void Sum(double* values, int size) const;

  /// Calls body(), which is not collective.
  /// \throw InputError, in every process, with the text of the first one in which body() throws.
  void Try(const std::function<void()>& body) const;

  /// Sleeps until all processes have called this: the usual ways of waiting keep a processor busy,
  /// which another process may need.
  void Wait() const;

  /// The lists of all processes, one after the other.
  template <typename T>
  std::vector<T> Join(const std::vector<T>& list) const;

  /// The lists of all processes in process 0, one after the other; nothing in the others.
  template <typename T>
  std::vector<T> Gather(std::vector<T> list) const;

  /// Sends a list to each process.
  /// \return the lists that the processes sent to this one
  template <typename T>
  PerProcess<T> Exchange(const PerProcess<T>& lists) const;

private:
  void ExchangeBytes(const std::vector<int>& sendCounts, const void* send,
    const std::vector<int>& receiveCounts, void* receive, int itemSize) const;
  std::vector<int> ExchangeCounts(const std::vector<int>& counts) const;

  MPI_Comm Comm;
  int ThisRank = 0;
  int NumberOfRanks = 1;
};

/// At the end of its life, all processes meet; those that come early sleep.
class Meeting
{
public:
  explicit Meeting(const Communicator& comm)
    : Comm(comm)
  {
  }
  ~Meeting() { this->Comm.Wait(); }
  Meeting(const Meeting&) = delete;
  void operator=(const Meeting&) = delete;

private:
  const Communicator Comm;
};

template <typename T>
PerProcess<T> Communicator::Exchange(const PerProcess<T>& lists) const
{
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<int> sendCounts;
  std::vector<T> send;
  for (const std::vector<T>& list : lists)
  {
    sendCounts.push_back(static_cast<int>(list.size()));
    send.insert(send.end(), list.begin(), list.end());
  }
  const std::vector<int> receiveCounts = this->ExchangeCounts(sendCounts);
  std::size_t total = 0;
  for (const int count : receiveCounts)
  {
    total += count;
  }
  std::vector<T> receive(total);
  this->ExchangeBytes(sendCounts, send.data(), receiveCounts, receive.data(), sizeof(T));
  PerProcess<T> result(this->Size());
  auto begin = receive.begin();
  for (int rank = 0; rank < this->Size(); ++rank)
  {
    result[rank].assign(begin, begin + receiveCounts[rank]);
    begin += receiveCounts[rank];
  }
  return result;
}

template <typename T>
std::vector<T> Communicator::Gather(std::vector<T> list) const
{
  PerProcess<T> lists(this->Size());
  lists[0] = std::move(list);
  std::vector<T> gathered;
  for (const std::vector<T>& part : this->Exchange(lists))
  {
    gathered.insert(gathered.end(), part.begin(), part.end());
  }
  return gathered;
}

template <typename T>
std::vector<T> Communicator::Join(const std::vector<T>& list) const
{
  std::vector<T> joined;
  for (const std::vector<T>& part : this->Exchange(PerProcess<T>(this->Size(), list)))
  {
    joined.insert(joined.end(), part.begin(), part.end());
  }
  return joined;
}
}

#endif
