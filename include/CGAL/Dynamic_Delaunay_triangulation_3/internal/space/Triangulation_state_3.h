// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_TRIANGULATION_STATE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_TRIANGULATION_STATE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Parallel_parts.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Point_ids_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Positions_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <array>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Points, their ids, their cells, and the origin.
//
// The origin is a point strictly inside of the hull. An infinite cell is seen from there as a cone:
// it is positive if the origin lies strictly beneath its hull facet. So finite and infinite cells
// are tested and flipped in the same way, and a frame whose cells are all positive is a
// triangulation if one ray from the origin meets a single hull facet.
template <class GeomTraits, class ConcurrencyTag>
class Triangulation_state_3
{
public:
  using Traits = GeomTraits;
  using Point = typename Traits::Point_3;
  using Place = Place_3<Point>;
  using Positions = Positions_3<Point>;
  using Arrays = Tetrahedra_arrays_3;
  using Ids = Dynamic_Delaunay_triangulations_2::internal::Point_ids_2<Point>;
  using Parts = Dynamic_Delaunay_triangulations_2::internal::Parallel_parts<ConcurrencyTag>;

  explicit Triangulation_state_3(const Traits& geometry = Traits())
    : traits(geometry)
  {
    ids.reset(0);
    positions.resize(1);
    arrays.resize_vertices(1);
  }

  Index number_of_vertices() const { return ids.number_of_representatives(); } // finite ones
  // -1 without points, 0 if all coincide, 1 if they are on a line, 2 in a plane, else 3. After an
  // exception, -1 or 0.
  int dimension() const
  {
    if (spans_space)
      return 3;
    if (!flat_triangles.empty())
      return 2;
    return !flat_edges.empty() ? 1 : ids.number_of_points() > 0 ? 0 : -1;
  }
  decltype(auto) point(Vertex_index v) const { return positions.point(v); }
  bool coincide(const Point& p, const Point& q) const
  {
    return p.x() == q.x() && p.y() == q.y() && p.z() == q.z();
  }

  // Gives up all cells. Points of the ids that are taken keep their places; the last vertices take
  // the numbers of those that have no point. For use after an exception: allocates nothing, if
  // there is memory for all free ids.
  void drop_cells()
  {
    spans_space = false;
    flat_edges.clear();
    flat_triangles.clear();
    arrays.clear_cells();
    for (Vertex_index v(1); v <= ids.number_of_representatives();) {
      const Vertex_index last(ids.number_of_representatives());
      if (ids.has_representative(v)) {
        ++v;
        continue;
      }
      if (ids.has_representative(last)) {
        positions.set(v, positions.place(last));
        ids.move_points(last, v);
      }
      ids.resize(last - 1);
    }
    positions.resize(ids.number_of_representatives() + 1);
    ids.find_free_ids();
  }

  Traits traits;
  Ids ids;
  Positions_3<Point> positions;
  bool positions_are_exact = true; // no point is rounded in the array of positions
  Tetrahedra_arrays_3 arrays;
  Cell_marks_3 marks; // of these cells; each tool clears them before it uses them
  // Whether there are cells. Else the points are coplanar, and the edges and triangles of a
  // Delaunay triangulation of their plane are in these lists.
  bool spans_space = false;
  std::vector<Few<Vertex_index, 2>> flat_edges;
  std::vector<Few<Vertex_index, 3>> flat_triangles;
  bool has_origin = false;
  Position_3 origin{0, 0, 0};
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_TRIANGULATION_STATE_3_H
