// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DELAUNAY_NEIGHBOR_LISTS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DELAUNAY_NEIGHBOR_LISTS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/certified_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Flat_neighbors_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Rows_by_id_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Vertex_star_3.h>
#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Neighbor lists of all points in space, as two plain arrays (compressed sparse rows): `neighbors()`
holds the neighbors of all points, one list after the other, and `offsets()` tells where each list
begins. A loop over all neighbors touches no triangulation, and the arrays can be passed to other
programs as they are.

- The list of a point holds the other ends of its finite edges, smaller ids first.
- Points that coincide share the vertex of the one that was there first, the *representative*; the
  others are its *duplicates*. The list of a duplicate holds only its representative. The list of a
  representative ends with its duplicates, smaller ids first.
- The list of a removed id is empty.

So the lists are symmetric. Where points are cospherical, several Delaunay triangulations are right,
and the lists follow the one that is there; those of `Voronoi_cell_measures_3` do not depend on it.
Without cells, for points in a plane or on a line, the lists are those of a Delaunay triangulation
in their plane.

\cgalExample{Dynamic_Delaunay_triangulation_2/space_volumes.cpp}

\sa `Voronoi_cell_measures_3`
*/
class Delaunay_neighbor_lists_3
{
public:
  /// \name Types
  /// @{

  /// an id in the arrays: 32 bits, as inside the triangulation.
  using Id = std::uint32_t;
  /// the type of ids and counts.
  using size_type = std::size_t;
  /// the list of one point.
  using Neighbors = Iterator_range<std::vector<Id>::const_iterator>;

  /// @}
  /// \name Computation
  /// @{

  /// replaces the lists by those of a triangulation.
  ///
  /// Cost: one walk around each edge, some 1.5 microseconds a point, which threads share if the
  /// triangulation has the `Parallel_tag`. The result does not depend on their number. If memory
  /// runs out, there are no lists.
  /// \tparam Dynamic a `Dynamic_Delaunay_triangulation_3`.
  /// \throws Uncertified_triangulation_error_2 unless `dt.is_certified()`; nothing changes.
  /// \post `number_of_ids() == dt.number_of_ids()`
  template <class Dynamic>
  void compute(const Dynamic& dt)
  {
    const Dynamic_Delaunay_triangulations_2::internal::Default_floating_point floating_point;
    const auto& state = Dynamic_Delaunay_triangulations_3::internal::certified_state(dt);
    try {
      list(state);
    } catch (...) {
      clear();
      throw;
    }
  }

  /// @}
  /// \name Access
  /// @{

  /// one more than the largest id ever in use.
  size_type number_of_ids() const { return offsets().size() - 1; }

  /// where the list of each id begins in `neighbors()`, and where the last list ends:
  /// `number_of_ids() + 1` numbers.
  const std::vector<size_type>& offsets() const { return m_rows.offsets(); }

  /// all lists. The list of `id` is from `offsets()[id]` to before `offsets()[id + 1]`.
  const std::vector<Id>& neighbors() const { return m_neighbors; }

  /// the list of a point. It is valid until the next `compute()`. \pre `id < number_of_ids()`
  Neighbors neighbors(size_type id) const
  {
    CGAL_precondition(id < number_of_ids());
    const auto begin = [&](size_type i) {
      return m_neighbors.begin() + std::vector<Id>::difference_type(offsets()[i]);
    };
    return Neighbors(begin(id), begin(id + 1));
  }

  /// the number of neighbors of a point. \pre `id < number_of_ids()`
  size_type degree(size_type id) const
  {
    CGAL_precondition(id < number_of_ids());
    return offsets()[id + 1] - offsets()[id];
  }

  /// @}

private:
  using Vertex_index = Dynamic_Delaunay_triangulations_3::Vertex_index;

  void clear()
  {
    m_rows.clear();
    m_neighbors.clear();
  }

  template <class State>
  void list(const State& state)
  {
    using namespace Dynamic_Delaunay_triangulations_3::internal;
    using Parts = typename State::Parts;
    Flat_neighbors_3 flat;
    if (!state.spans_space)
      flat.list_ends(state);
    std::vector<Vertex_star_3> stars(Parts::number(state.number_of_vertices(), least_stars<Parts>));
    m_rows.compute(
        state, 1,
        [&](Vertex_index v, size_type part, std::vector<Id>& ids) {
          const auto begin = std::ptrdiff_t(ids.size());
          const auto add = [&](Vertex_index w, const auto&...) {
            ids.push_back(state.ids.representative(w));
          };
          if (state.spans_space)
            stars[part].for_each_neighbor(state.arrays, v, add);
          else
            flat.for_each_neighbor(v, add);
          const auto middle = std::ptrdiff_t(ids.size());
          state.ids.for_each_covered_at(v, [&](Id id, const auto&) { ids.push_back(id); });
          std::sort(ids.begin() + begin, ids.begin() + middle);
          std::sort(ids.begin() + middle, ids.end());
        },
        [&](size_type number) { m_neighbors.resize(number); },
        [&](size_type entry, Id id) { m_neighbors[entry] = id; });
    state.ids.for_each_covered([&](size_type id, Vertex_index v, const auto&) {
      m_neighbors[offsets()[id]] = state.ids.representative(v);
    });
  }

  Dynamic_Delaunay_triangulations_3::internal::Rows_by_id_3<Id> m_rows;
  std::vector<Id> m_neighbors;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DELAUNAY_NEIGHBOR_LISTS_3_H
