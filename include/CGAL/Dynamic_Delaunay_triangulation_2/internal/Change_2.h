// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CHANGE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CHANGE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>

#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// What a call asks for, read and checked.
template <class Point>
struct Change_2
{
  bool is_frame = false; // every point that stays has a new position, which is staged
  bool is_mending = false;
  std::vector<Index> gone;  // ids of points that go, each once
  std::vector<Index> moved; // ids of points that move alone, each once, and where to
  std::vector<Point> moved_points;
  std::vector<Index> coming; // the ids that points get that come, and where these are
  std::vector<Point> coming_points;
  bool are_exact = true; // none of these coordinates has to be rounded for the flat arrays

  bool has_population() const { return !gone.empty() || !coming.empty(); }

  bool is_empty() const
  {
    return !is_frame && !is_mending && gone.empty() && moved.empty() && coming.empty();
  }
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CHANGE_2_H
