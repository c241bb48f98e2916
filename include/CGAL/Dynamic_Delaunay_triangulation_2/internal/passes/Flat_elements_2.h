// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_FLAT_ELEMENTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_FLAT_ELEMENTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>

namespace CGAL::Dynamic_Delaunay_triangulations_2 {

/// The coordinates of a vertex in the flat arrays: exact where the kernel's coordinates are
/// doubles, the nearest doubles elsewhere.
#ifdef __GNUC__
// The same memory may be accessed as a kernel's point of two doubles.
struct __attribute__((may_alias)) Position_2
#else
struct Position_2
#endif
{
  double x, y;
};

/// Positions, by the numbers of their vertices. A `std::vector` whose `resize()` sets no new ones,
/// so that threads that set them get their memory from the operating system, too.
using Position_vector = internal::Uninitialized_vector<Position_2>;

/// An edge with its two opposite vertices: (left, source, target) and (right, target, source) are
/// the two faces at the edge, both counterclockwise.
struct Edge_2
{
  /// sets nothing, so that no thread writes an array of edges before all threads do.
  Edge_2() {}
  /// sets all four vertices.
  Edge_2(Vertex_index s, Vertex_index t, Vertex_index l, Vertex_index r)
    : source(s)
    , target(t)
    , left(l)
    , right(r)
  {
  }

  Vertex_index source, target, left, right;
};

/// The positions of the four vertices of an edge, as seen from the edge. `left` and `right` are the
/// vertices opposite to it.
struct Edge_corners_2
{
  Position_2 left, source, target, right;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_FLAT_ELEMENTS_2_H
