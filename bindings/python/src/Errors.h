// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_ERRORS_H
#define PYTHON_ERRORS_H

#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace python {

// An object is used when it cannot be used.
class Use_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// What is asked for in space is not there after a call for which memory did not suffice.
class Untold_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// Cells in space are asked for after a call that has left none.
class No_cells_error : public Untold_error
{
public:
  No_cells_error()
    : Untold_error("there are no cells, since memory did not suffice for the last call: call "
                   "mend(); points, ids and duplicates can be read as they are")
  {
  }
};

// Translates the package's exceptions to those of errors.py, with the same data.
void register_errors();

// A negative id, which the package's exceptions cannot hold.
[[noreturn]] void throw_unknown_id(std::int64_t id, std::size_t number_of_ids);

} // namespace python

#endif // PYTHON_ERRORS_H
