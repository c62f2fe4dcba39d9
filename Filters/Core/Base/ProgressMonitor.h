// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_ProgressMonitor_h
#define lmo_ProgressMonitor_h

#include "Core/Base/Exceptions.h"

#include <algorithm>

namespace lmo
{
/// How the numerics report progress and learn that the user wants to stop.
class ProgressMonitor
{
public:
  virtual ~ProgressMonitor() = default;

  /// Reports the stage that begins.
  /// \throw Cancelled if the user asked to stop.
  void Begin(const char* stage)
  {
    this->ShowStage(stage);
    this->Report(0);
  }

  /// Reports the finished fraction, 0 to 1. Never shows less than before.
  /// \throw Cancelled if the user asked to stop.
  void Report(double fraction)
  {
    this->Finished = std::max(this->Finished, fraction);
    this->ShowProgress(this->Finished);
    if (this->IsCancelled())
    {
      throw Cancelled();
    }
  }

  /// The monitor of what this process does on its own, while others do something else.
  virtual ProgressMonitor& OfThisProcess() { return *this; }

protected:
  virtual void ShowStage(const char*) {}
  virtual void ShowProgress(double) {}
  virtual bool IsCancelled() { return false; }

private:
  double Finished = 0;
};

/// Reports what is a part of a whole.
class PartialMonitor : public ProgressMonitor
{
public:
  /// \param begin, end fractions of the whole, 0 to 1
  PartialMonitor(ProgressMonitor& whole, double begin, double end)
    : Whole(whole)
    , First(begin)
    , Length(end - begin)
  {
  }

protected:
  void ShowStage(const char* stage) override { this->Whole.Begin(stage); }
  void ShowProgress(double fraction) override
  {
    this->Whole.Report(this->First + this->Length * fraction);
  }

private:
  ProgressMonitor& Whole;
  const double First;
  const double Length;
};
}

#endif
