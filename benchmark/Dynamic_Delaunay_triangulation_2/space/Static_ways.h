// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPACE_STATIC_WAYS_H
#define SPACE_STATIC_WAYS_H

#include "../common/Thread_time.h"
#include "Space_points.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3.h>

#include <cstddef>
#include <stdexcept>

namespace space {

using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<Kernel>;
using Static = CGAL::Delaunay_triangulation_3<Kernel>;

// Of the thread, a point.
template <class Work>
double nanoseconds(std::size_t points, const Work& work)
{
  return common::thread_nanoseconds_of(work) / double(points);
}

inline void insert_range(const Points& points)
{
  const Static fresh(points.begin(), points.end());
}

inline void insert_one_by_one(const Points& points, Static& fresh, Static::Cell_handle& hint)
{
  for (const Point& p : points) {
    hint = fresh.insert(p, hint)->cell();
  }
}

inline void insert_sorted(const Points& points)
{
  Static fresh;
  Static::Cell_handle hint;
  insert_one_by_one(points, fresh, hint);
}

// Only those who were there before are sorted yet.
inline void insert_sorted(const Points& sorted, Points& newcomers)
{
  Static fresh;
  Static::Cell_handle hint;
  insert_one_by_one(sorted, fresh, hint);
  CGAL::spatial_sort(newcomers.begin(), newcomers.end());
  insert_one_by_one(newcomers, fresh, hint);
}

#ifdef CGAL_LINKED_WITH_TBB

// By the threads of the arena; a grid of locks is made as CGAL's manual has it.
inline void insert_range_by_threads(const Points& points)
{
  using Tds = CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_3<Kernel>,
                                                   CGAL::Delaunay_triangulation_cell_base_3<Kernel>,
                                                   CGAL::Parallel_tag>;
  using Parallel = CGAL::Delaunay_triangulation_3<Kernel, Tds>;
  Parallel::Lock_data_structure locks(CGAL::bbox_3(points.begin(), points.end()), 50);
  const Parallel fresh(points.begin(), points.end(), &locks);
}

#endif // CGAL_LINKED_WITH_TBB

template <class Triangulation>
void check(const Triangulation& dt, const Points& points)
{
  const Static fresh(points.begin(), points.end());
  if (!dt.is_valid(true) || dt.number_of_vertices() != fresh.number_of_vertices()) {
    throw std::runtime_error("a triangulation is wrong");
  }
}

} // namespace space

#endif // SPACE_STATIC_WAYS_H
