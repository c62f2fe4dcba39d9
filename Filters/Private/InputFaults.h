// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef InputFaults_h
#define InputFaults_h

#include "Core/Base/Exceptions.h"

#include <cstdint>
#include <sstream>
#include <string>

namespace lmo
{
/// Counts what is wrong and remembers where it was seen first.
struct Faults
{
  std::int64_t count = 0;
  std::int64_t first = -1;

  void Add(std::int64_t id) { this->first = this->count++ ? this->first : id; }

  /// \param one what is wrong if there is one, after the number; \a many if there are several
  /// \throw InputError "<count> <what>; the first is <kind> <id>. <remedy>" if there are any.
  void ThrowIfAny(
    const std::string& one, const std::string& many, const char* kind, const char* remedy) const
  {
    if (this->count > 0)
    {
      std::ostringstream text;
      text << this->count << ' ' << (this->count == 1 ? one : many) << "; the first is " << kind
           << ' ' << this->first << ". " << remedy;
      throw InputError(text.str());
    }
  }
};
}

#endif
