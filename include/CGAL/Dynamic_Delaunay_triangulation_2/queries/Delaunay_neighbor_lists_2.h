// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_NEIGHBOR_LISTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_NEIGHBOR_LISTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Site_geometry_2.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Neighbor lists of all points, as two plain arrays (compressed sparse rows): `neighbors()` holds the
neighbors of all points, one list after the other, and `offsets()` tells where each list begins. In
periodic space a third one, `shifts()`, tells which image each neighbor is. A loop over all
neighbors touches no triangulation, and the arrays can be passed to other programs as they are.

- The list of a point holds the other ends of its finite edges, counterclockwise around it,
  beginning with any of them.
- Points that coincide share the vertex of the one that was there first, the *representative*; the
  others are its *duplicates*. The list of a duplicate holds only its representative. The list of a
  representative ends with its duplicates, smaller ids first. In periodic space their shifts say
  which images coincide.
- The list of a removed id is empty.

So the lists are symmetric, and there are at most six times as many entries as points. Their ids are
those of the triangulation. For a `Dynamic_population_2`, `population.id(user_id)` and
`population.user_id(id)` convert between these and the user's ids.

The triangulation need not be certified: the lists follow its current edges.

An object keeps its memory. `compute()` allocates nothing if the triangulation had as many ids,
vertices and duplicates before.

\cgalExample{Dynamic_Delaunay_triangulation_2/neighbors_in_a_flock.cpp}

\sa `Delaunay_point_queries_2`
*/
class Delaunay_neighbor_lists_2
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
  /// Cost: linear, one pass over the edges and one walk around every vertex; with g duplicates,
  /// O(g log g) more. If memory runs out, there are no lists.
  /// \tparam Dynamic a `Dynamic_Delaunay_triangulation_2` or a
  /// `Dynamic_periodic_Delaunay_triangulation_2`.
  /// \post `number_of_ids() == dt.number_of_ids()`
  template <class Dynamic>
  void compute(const Dynamic& dt)
  {
    reserve_extra(dt);
    note_duplicates(dt);
    find_offsets(dt);
    m_neighbors.resize(m_offsets.back());
    m_shifts.resize(Geometry<Dynamic>::shown_shifts * m_offsets.back());
    write_neighbors(dt.frame());
    write_duplicates();
  }

  /// @}
  /// \name Access
  /// @{

  /// one more than the largest id ever in use.
  size_type number_of_ids() const { return m_offsets.size() - 1; }

  /// where the list of each id begins in `neighbors()`, and where the last list ends:
  /// `number_of_ids() + 1` numbers.
  const std::vector<size_type>& offsets() const { return m_offsets; }

  /// all lists. The list of `id` is from `offsets()[id]` to before `offsets()[id + 1]`.
  const std::vector<Id>& neighbors() const { return m_neighbors; }

  /// in periodic space, the shift of each entry of `neighbors()`: which image it is, as
  /// `Dynamic_triangulation_base_2::for_each_neighbor()` says. Empty in the plane.
  const std::vector<Periodic_shift_2>& shifts() const { return m_shifts; }

  /// the list of a point. It is valid until the next `compute()`. \pre `id < number_of_ids()`
  Neighbors neighbors(size_type id) const
  {
    CGAL_precondition(id < number_of_ids());
    const auto begin = [&](size_type i) {
      return m_neighbors.begin() + std::vector<Id>::difference_type(m_offsets[i]);
    };
    return Neighbors(begin(id), begin(id + 1));
  }

  /// the number of neighbors of a point. \pre `id < number_of_ids()`
  size_type degree(size_type id) const
  {
    CGAL_precondition(id < number_of_ids());
    return m_offsets[id + 1] - m_offsets[id];
  }

  /// @}

private:
  template <class Dynamic>
  using Geometry = Dynamic_Delaunay_triangulations_2::internal::Site_geometry_2<
      Dynamic_Delaunay_triangulations_2::internal::State_of_2<Dynamic>>;

  struct Duplicate
  {
    Id representative, id;
    Periodic_shift_2 shift; // of the image of `id` that coincides with the representative
  };

  // Reserves memory for all that will be appended: a triangulation with n vertices has at most 3n
  // edges, however many of them are on its hull.
  template <class Dynamic>
  void reserve_extra(const Dynamic& dt)
  {
    m_offsets.resize(1);
    m_neighbors.clear();
    m_shifts.clear();
    m_duplicates.clear();
    const size_type vertices = dt.number_of_vertices();
    const size_type duplicates = dt.number_of_points() - vertices;
    reserve_extra(m_neighbors, 6 * vertices + 2 * duplicates);
    reserve_extra(m_shifts, Geometry<Dynamic>::shown_shifts * (6 * vertices + 2 * duplicates));
    reserve_extra(m_duplicates, duplicates);
    reserve_extra(m_offsets, dt.number_of_ids() + 1);
  }

  // Reserves slightly more than needed, so that a steadily growing population seldom allocates.
  template <class T>
  static void reserve_extra(std::vector<T>& data, size_type size)
  {
    if (data.capacity() < size)
      data.reserve(size + size / 8);
  }

  // Sorts the duplicates by their representatives, then by their ids.
  template <class Dynamic>
  void note_duplicates(const Dynamic& dt)
  {
    const auto& state = dt.frame().state();
    const Geometry<Dynamic> geometry(state);
    state.ids().for_each_covered([&](auto id, auto v, const auto& point) {
      m_duplicates.push_back({state.ids().representative(v), id, geometry.shift_to(v, point)});
    });
    std::sort(m_duplicates.begin(), m_duplicates.end(), [](const Duplicate& g, const Duplicate& h) {
      return g.representative != h.representative ? g.representative < h.representative
                                                  : g.id < h.id;
    });
  }

  template <class Dynamic>
  void find_offsets(const Dynamic& dt)
  {
    m_offsets.resize(dt.number_of_ids() + 1, 0);
    const auto count = [&](size_type i, size_type j, const auto&...) {
      ++m_offsets[i + 1];
      ++m_offsets[j + 1];
    };
    dt.for_each_edge(count);
    for (const Duplicate& duplicate : m_duplicates)
      count(duplicate.representative, duplicate.id);
    std::partial_sum(m_offsets.begin(), m_offsets.end(), m_offsets.begin());
  }

  // Takes the vertices in their order, in which close ones are close in memory, too; ids may be
  // anywhere.
  template <class Frame>
  void write_neighbors(const Frame& frame)
  {
    using Vertex_index = typename Frame::Vertex_index;
    Frame::Parts::for_each(
        frame.number_of_vertices(), [&](size_type, size_type first, size_type beyond) {
          for (Vertex_index v(first + 1); v <= beyond; ++v) {
            size_type entry = m_offsets[frame.id(v)];
            frame.state().for_each_finite_neighbor(v, [&](Vertex_index w, const auto&... shift) {
              write(entry++, frame.id(w), shift...);
            });
          }
        });
  }

  // Writes a neighbor, and in periodic space its shift.
  template <class... Shift>
  void write(size_type entry, Id neighbor, const Shift&... shift)
  {
    m_neighbors[entry] = neighbor;
    ((m_shifts[entry] = shift), ...);
  }

  void write_duplicates()
  {
    size_type entry = 0;
    for (auto duplicate = m_duplicates.rbegin(); duplicate != m_duplicates.rend(); ++duplicate) {
      if (duplicate == m_duplicates.rbegin() ||
          duplicate->representative != std::prev(duplicate)->representative)
        entry = m_offsets[duplicate->representative + size_type(1)];
      const size_type there = --entry, back = m_offsets[duplicate->id];
      m_neighbors[there] = duplicate->id;
      m_neighbors[back] = duplicate->representative;
      if (!m_shifts.empty()) {
        m_shifts[there] = duplicate->shift;
        m_shifts[back] = {-duplicate->shift[0], -duplicate->shift[1]};
      }
    }
  }

  std::vector<size_type> m_offsets = {0};
  std::vector<Id> m_neighbors;
  std::vector<Periodic_shift_2> m_shifts;
  std::vector<Duplicate> m_duplicates;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_NEIGHBOR_LISTS_2_H
