// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_STATE_BASE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_STATE_BASE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Parallel_parts.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Point_ids_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Cell_arrays_3.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Points, their ids and their cells, in open space or on a torus.
//
// What the update, mending and rebuilds ask of a state, beside these:
//   Place, Staged                     a place has a `position`: it says, exactly, where a vertex is
//   Point point(v), point_at(place)   as it was given
//   Place place_of(point)             of a new point
//   Place place_near(point, v)        of the image of a point that is nearest to a vertex
//   Place place_anew(v)               of a vertex after begin_rebuild()
//   bool coincide(point, v)           whether an image of a point is exactly where a vertex is
//   void check(point, id)             throws if it is refused
//   void note_move(id, p, q, v)       for visitors: a point of v is about to move from p to q
//   void include(place)               a vertex has got this place: filters have to reckon with it
//   void include_all()                the same, of all vertices anew
//   bool begin_frame(mean, previous)  vertices have new positions; false if nothing can be mended
//   void end_change()                 before a call ends that has mended something
//   void begin_rebuild()              all points are about to get other vertices
//   renumber_vertices(numbers, n)     of the cells, as `Cell_arrays_3::renumber_all()`
//   double smallest_way()             share of its way by which a held vertex may move on
//   Position_3 along_hull(p, q, star) where a vertex of the hull waits instead of q, if held from p
//   Position_3 beneath_hull(v, star)  where a vertex of the hull would leave it
//   Position_3 on_wall(p, q, r)       the same instead of r, if a frame moves it from p to q
//   find_walls()                      before vertices are held, where all are at their targets
//   Position_3 between_walls(r, q)    where another vertex waits instead of r, if it belongs to q
//   bool has_levels(axis)             whether sites with equal coordinates of their rounded
//                                     positions along an axis have them exactly in common
//   bool repeats(axis)                whether space is repeated along an axis of these:
//   Position_3 coordinates_to_cut(v, shift)  by which parts are cut
//   bool goes_on_to_cover_once()      whether cells, infinite ones too, that are positive before
//                                     and after motion go on to cover space once
//   bool mends_by_cells               whether what is to be mended is taken up in the order of
//                                     cells, not infinite cells last
//   spans_space, positions_are_exact, has_origin, origin, most_broken
template <class GeomTraits, class ConcurrencyTag, class Positions_of_space, class Arrays_of_space>
class State_base_3
{
public:
  using Traits = GeomTraits;
  using Point = typename Traits::Point_3;
  using Positions = Positions_of_space;
  using Place = typename Positions::Place;
  using Arrays = Arrays_of_space;
  using Ids = Dynamic_Delaunay_triangulations_2::internal::Point_ids_2<Point>;
  using Parts = Dynamic_Delaunay_triangulations_2::internal::Parallel_parts<ConcurrencyTag>;
  using Phases = Dynamic_Delaunay_triangulations_2::internal::Phase_log<ConcurrencyTag>;
  // Of what exact predicates decide: other coordinates than doubles are computed when they are
  // needed, and points share them.
  using Exact_parts = Dynamic_Delaunay_triangulations_2::internal::Parallel_parts<
      std::conditional_t<is_three_doubles<Point>, ConcurrencyTag, Sequential_tag>>;

  State_base_3()
  {
    ids.reset(0);
    positions.resize(1);
    arrays.resize_vertices(1);
  }

  Index number_of_vertices() const { return ids.number_of_representatives(); } // finite ones

  // Gives up all cells. Points of the ids that are taken keep their places; the last vertices take
  // the numbers of those that have no point. For use after an exception: allocates nothing, if
  // there is memory for all free ids.
  void drop_cells()
  {
    spans_space = false;
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

  Ids ids;
  Positions positions;
  Arrays arrays;
  Cell_marks_3 marks;       // of these cells; each tool clears them before it uses them
  bool spans_space = false; // whether there are cells
};

// To be called for each element of a list from 0 on: fetches, of the n-th cell of those that come
// soon, first the cell, then its vertices' positions and, if these are wanted, its neighbors, and
// then what is beyond. cell_at(n) may be free, or, where cells have been dropped, not exist any
// more. At 100,000 points the exact tests of cells take half of the time then; at 10,000 nothing is
// gained.
template <bool with_neighbors = true, class State, class Cell_at>
void prefetch_around(const State& state, std::size_t i, std::size_t number, const Cell_at& cell_at)
{
  using Dynamic_Delaunay_triangulations_2::internal::prefetch;
  constexpr std::size_t far_ahead = 24, ahead = 16, near_ahead = 8, few_cells = 1 << 17;
  const auto& arrays = state.arrays;
  if (arrays.number_of_cells() < few_cells)
    return;
  const auto is_there = [&](Cell_index c) {
    return c < arrays.number_of_cells() && !arrays.is_free(c);
  };
  if (i + far_ahead < number)
    arrays.prefetch(cell_at(i + far_ahead));
  if (i + ahead < number)
    if (const Cell_index c = cell_at(i + ahead); is_there(c))
      for (int place = 0; place < 4; ++place) {
        if (with_neighbors)
          arrays.prefetch(arrays.neighbor(c, place));
        prefetch(&state.positions.position(arrays.vertices(c)[place]));
      }
  if (with_neighbors && i + near_ahead < number)
    if (const Cell_index c = cell_at(i + near_ahead); is_there(c))
      for (int place = 0; place < 4; ++place)
        prefetch(&state.positions.position(arrays.apex(arrays.corner(c, place))));
}
template <bool with_neighbors = true, class State>
void prefetch_around(const State& state, const std::vector<Cell_index>& cells, std::size_t i)
{
  prefetch_around<with_neighbors>(state, i, cells.size(), [&](std::size_t n) { return cells[n]; });
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_STATE_BASE_3_H
