// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_MEMORY_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_MEMORY_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// What an update of a periodic triangulation remembers of those before, as far as that has an
// influence on the result: which of several equally good ones it is, and which points count as
// jumping.
struct Periodic_memory_2
{
  Index hint = 1;            // the vertex from which the next walk starts, if there is one
  Position_2 mean_way{0, 0}; // of the points in the last frame
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_MEMORY_2_H
