// SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef lmo_Exceptions_h
#define lmo_Exceptions_h

#include <stdexcept>
#include <string>

namespace lmo
{
/// The mesh, an array or a parameter cannot be worked with; what() says what, how many,
/// the first id and the remedy.
class InputError : public std::invalid_argument
{
public:
  using std::invalid_argument::invalid_argument;
};

/// The linear system could not be solved.
class SolverError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The caller's ProgressMonitor asked to stop.
class Cancelled : public std::exception
{
public:
  const char* what() const noexcept override { return "cancelled"; }
};
}

#endif
