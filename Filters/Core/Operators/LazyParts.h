// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_LazyParts_h
#define lmo_LazyParts_h

#include <optional>

namespace lmo
{
/// Base of classes whose parts are computed when they are first asked for, and kept. What such an
/// object returns never changes.
class LazyParts
{
public:
  LazyParts(const LazyParts&) = delete;
  void operator=(const LazyParts&) = delete;

  /// How many parts have been computed so far.
  int GetNumberOfParts() const { return this->NumberOfParts; }

protected:
  LazyParts() = default;
  ~LazyParts() = default;

  /// The part, computed by compute() if that has not been done.
  template <typename Part, typename Compute>
  const Part& Get(std::optional<Part>& part, const Compute& compute) const
  {
    if (!part)
    {
      part = compute();
      this->CountPart();
    }
    return *part;
  }

  void CountPart() const { ++this->NumberOfParts; }

private:
  mutable int NumberOfParts = 0;
};
}

#endif
