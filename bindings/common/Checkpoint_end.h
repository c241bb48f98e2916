// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_CHECKPOINT_END_H
#define BINDINGS_CHECKPOINT_END_H

#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace bindings {

// A stream may go on after a checkpoint, but not what is one as a whole. The checksum is its last
// line, and no other line begins so.
inline void check_end(const std::string& checkpoint)
{
  const std::size_t last_line = checkpoint.find("\nchecksum ");
  const std::size_t end = checkpoint.find('\n', last_line + (last_line != checkpoint.npos));
  if (last_line == checkpoint.npos || end == checkpoint.npos || end + 1 == checkpoint.size()) {
    return;
  }
  const auto beyond = checkpoint.begin() + std::ptrdiff_t(end) + 1;
  throw CGAL::Checkpoint_error_2(std::size_t(std::count(checkpoint.begin(), beyond, '\n')) + 1,
                                 "there is more after the end of the checkpoint");
}

} // namespace bindings

#endif // BINDINGS_CHECKPOINT_END_H
