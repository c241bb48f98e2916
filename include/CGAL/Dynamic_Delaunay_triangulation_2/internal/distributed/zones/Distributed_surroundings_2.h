// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_SURROUNDINGS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_SURROUNDINGS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_question_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_ranks_2.h>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Replaces the outline in a periodic space: points are everywhere, but to a face only those in a
// box around its owned corner, the focus, matter. The box reaches |r| + |t| to each side, where r
// and t are two vectors of the lattice.
//
// For each place there is an image of the focus closer to it than R = (|r| + |t|) / 2: in the
// parallelogram of r and t around that image the place is x r + y t with |x| and |y| at most 1/2,
// and r and t are not parallel. So every open disk of radius R contains an image of the focus.
//
//   - A disk that has the focus p on its boundary, and a radius of R or more, contains the open
//     disk of radius R that touches it in p. The latter lies in the box, and contains an image of
//     p. So if no point in the box is inside of a face's disk, the radius of that disk is less than
//     R, and all of it is in the box.
//   - p is no corner of the hull, and on no edge of it, where p + r, p - r, p + t and p - t are
//     held, and these are in the box: of a line through p each open side has one of them.
template <class Points>
class Distributed_surroundings_2
{
public:
  void gather(Distributed_ranks_2&, const Points& points) { m_reach = points.space().reach(); }

  // A box around all points that matter to a question.
  Box_2 box_for(const Distributed_question_2& question) const
  {
    return Box_2{question.x, question.y, question.x, question.y}.enlarged(m_reach);
  }

  // Points are beyond every line, and no box is without points.
  template <class Point>
  bool is_any_beyond(const Point&, const Point&) const
  {
    return true;
  }
  bool excludes(const Box_2&) const { return false; }
  bool excludes_about(const Box_2&) const { return false; }

private:
  double m_reach = 0;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_SURROUNDINGS_2_H
