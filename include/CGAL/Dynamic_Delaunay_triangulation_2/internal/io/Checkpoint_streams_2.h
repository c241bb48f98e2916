// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_STREAMS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_STREAMS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <ios>
#include <istream>
#include <ostream>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// `operator<<` and `operator>>` for everything that has checkpoints. Users of streams test the
// stream's state, so these set `failbit` where the functions throw.

template <class Written>
std::ostream& write_to_stream(std::ostream& out, const Written& written)
{
  try {
    written.write_checkpoint(out);
  } catch (const Checkpoint_error_2&) {
    out.setstate(std::ios_base::failbit);
  }
  return out;
}

template <class Read>
std::istream& read_from_stream(std::istream& in, Read& target)
{
  const std::istream::sentry has_text(in); // skips white space, as every operator>> does
  if (!has_text)
    return in;
  try {
    target.read_checkpoint(in);
  } catch (const Checkpoint_error_2&) {
    in.setstate(std::ios_base::failbit);
  }
  return in;
}

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_STREAMS_2_H
