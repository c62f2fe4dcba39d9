// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Communicator.h"

#include "Core/Base/Exceptions.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <numeric>
#include <thread>

namespace lmo
{
namespace
{
std::vector<int> Displacements(const std::vector<int>& counts)
{
  std::vector<int> displacements(counts.size(), 0);
  std::partial_sum(counts.begin(), counts.end() - 1, displacements.begin() + 1);
  return displacements;
}

template <typename T>
T Reduce(T value, MPI_Datatype type, MPI_Op operation, MPI_Comm comm)
{
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, type, operation, comm);
  return value;
}
}

Communicator::Communicator(MPI_Comm comm)
  : Comm(comm)
{
  MPI_Comm_rank(comm, &this->ThisRank);
  MPI_Comm_size(comm, &this->NumberOfRanks);
}

int Communicator::SizeOnComputer() const
{
  MPI_Comm computer;
  MPI_Comm_split_type(this->Comm, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &computer);
  int size = 1;
  MPI_Comm_size(computer, &size);
  MPI_Comm_free(&computer);
  return size;
}

double Communicator::Sum(double value) const
{
  return Reduce(value, MPI_DOUBLE, MPI_SUM, this->Comm);
}

double Communicator::Maximum(double value) const
{
  return Reduce(value, MPI_DOUBLE, MPI_MAX, this->Comm);
}

std::int64_t Communicator::Sum(std::int64_t value) const
{
  return Reduce(value, MPI_INT64_T, MPI_SUM, this->Comm);
}

std::int64_t Communicator::SumBefore(std::int64_t value) const
{
  std::int64_t sum = 0;
  MPI_Exscan(&value, &sum, 1, MPI_INT64_T, MPI_SUM, this->Comm);
  return this->ThisRank == 0 ? 0 : sum;
}

void Communicator::Sum(std::vector<std::int64_t>& counts) const
{
  MPI_Allreduce(
    MPI_IN_PLACE, counts.data(), static_cast<int>(counts.size()), MPI_INT64_T, MPI_SUM, this->Comm);
}

void Communicator::Sum(double* values, int size) const
{
  MPI_Allreduce(MPI_IN_PLACE, values, size, MPI_DOUBLE, MPI_SUM, this->Comm);
}

void Communicator::Try(const std::function<void()>& body) const
{
  std::string text;
  int failed = this->NumberOfRanks;
  try
  {
    body();
  }
  catch (const std::bad_alloc&)
  {
    failed = this->ThisRank;
    text = "Not enough memory for this mesh.";
  }
  catch (const std::exception& error)
  {
    failed = this->ThisRank;
    text = error.what();
  }
  const int first = Reduce(failed, MPI_INT, MPI_MIN, this->Comm);
  if (first == this->NumberOfRanks)
  {
    return;
  }
  int size = static_cast<int>(text.size());
  MPI_Bcast(&size, 1, MPI_INT, first, this->Comm);
  text.resize(size);
  MPI_Bcast(text.data(), size, MPI_CHAR, first, this->Comm);
  throw InputError("Process " + std::to_string(first) + ": " + text);
}

void Communicator::Wait() const
{
  MPI_Request arrival;
  MPI_Ibarrier(this->Comm, &arrival);
  int haveAllArrived = 0;
  MPI_Test(&arrival, &haveAllArrived, MPI_STATUS_IGNORE);
  while (!haveAllArrived)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    MPI_Test(&arrival, &haveAllArrived, MPI_STATUS_IGNORE);
  }
}

std::vector<int> Communicator::ExchangeCounts(const std::vector<int>& counts) const
{
  std::vector<int> received(this->NumberOfRanks);
  MPI_Alltoall(counts.data(), 1, MPI_INT, received.data(), 1, MPI_INT, this->Comm);
  return received;
}

void Communicator::ExchangeBytes(const std::vector<int>& sendCounts, const void* send,
  const std::vector<int>& receiveCounts, void* receive, int itemSize) const
{
  MPI_Datatype item;
  MPI_Type_contiguous(itemSize, MPI_BYTE, &item);
  MPI_Type_commit(&item);
  MPI_Alltoallv(send, sendCounts.data(), Displacements(sendCounts).data(), item, receive,
    receiveCounts.data(), Displacements(receiveCounts).data(), item, this->Comm);
  MPI_Type_free(&item);
}
}
