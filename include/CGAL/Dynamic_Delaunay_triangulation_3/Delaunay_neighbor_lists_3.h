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
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Part_stars_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Rows_by_id_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Scaled_images_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Scaled_sites_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Site_charts_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_shift_3.h>
#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Neighbor lists of all points, in open or in periodic space, as two plain arrays (compressed sparse
rows): `neighbors()` holds the neighbors of all points, one list after the other, and `offsets()`
tells where each list begins. In periodic space a third one, `shifts()`, tells which image each
neighbor is. On request, `vectors()` has the ways to all neighbors. A loop over them touches no
triangulation, and the arrays can be passed to other programs as they are.

- The list of a point holds the other ends of its finite edges, smaller ids first. In periodic space
  it may hold the point itself, by its images, and others several times, smaller shifts first, as
  arrays are compared.
- Points that coincide share the vertex of the one that was there first, the *representative*; the
  others are its *duplicates*. The list of a duplicate holds only its representative. The list of a
  representative ends with its duplicates, smaller ids first. In periodic space their shifts say
  which images coincide.
- The list of a removed id is empty.

So the lists are symmetric; the shifts are opposite. Where points are cospherical, several Delaunay
triangulations are right, and the lists follow the one that is there; those of
`Voronoi_cell_measures_3` do not depend on it. Without cells, for points in a plane or on a line in
open space, the lists are those of a Delaunay triangulation in their plane.

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
  /// a vector: three doubles, `x`, `y` and `z`.
  using Vector = Dynamic_Delaunay_triangulations_3::Position_3;
  /// the list of one point.
  using Neighbors = Iterator_range<std::vector<Id>::const_iterator>;

  /// @}
  /// \name Computation
  /// @{

  /// replaces the lists by those of a triangulation.
  ///
  /// Cost: four passes over the cells, some microsecond a point, which threads share if the
  /// triangulation has the `Parallel_tag`. The result does not depend on their number. If memory
  /// runs out, there are no lists.
  /// \tparam Dynamic a `Dynamic_Delaunay_triangulation_3` or a
  ///   `Dynamic_periodic_Delaunay_triangulation_3`.
  /// \throws Uncertified_triangulation_error_2 unless `dt.is_certified()`; nothing changes.
  /// \post `number_of_ids() == dt.number_of_ids()`
  template <class Dynamic>
  void compute(const Dynamic& dt)
  {
    compute(dt, false);
  }

  /// does the same, and computes the vectors to all neighbors.
  template <class Dynamic>
  void compute_with_vectors(const Dynamic& dt)
  {
    compute(dt, true);
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

  /// in periodic space, the shift of each entry of `neighbors()`: which image it is, as
  /// `Dynamic_periodic_Delaunay_triangulation_3::for_each_neighbor()` says. Empty in open space.
  const std::vector<Periodic_shift_3>& shifts() const { return m_shifts; }

  /// after `compute_with_vectors()`, the vector from the point to each entry of `neighbors()`, in
  /// periodic space to that image: as if rounded once, 0 where points coincide. Else empty.
  const std::vector<Vector>& vectors() const { return m_vectors; }

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
  using Point_id = Dynamic_Delaunay_triangulations_3::Point_id;
  using Vertex_index = Dynamic_Delaunay_triangulations_3::Vertex_index;
  using Entry = Dynamic_Delaunay_triangulations_3::internal::Neighbor_entry_3;

  void clear()
  {
    m_rows.clear();
    m_neighbors.clear();
    m_shifts.clear();
    m_vectors.clear();
  }

  template <class Dynamic>
  void compute(const Dynamic& dt, bool has_vectors)
  {
    using namespace Dynamic_Delaunay_triangulations_3::internal;
    const Dynamic_Delaunay_triangulations_2::internal::Default_floating_point floating_point;
    const auto& state = certified_state(dt);
    try {
      list(state, Scaled_sites_3<State_of_3<Dynamic>>(state), has_vectors);
    } catch (...) {
      clear();
      throw;
    }
  }

  template <class State, class Sites>
  void list(const State& state, const Sites& sites, bool has_vectors)
  {
    using namespace Dynamic_Delaunay_triangulations_3::internal;
    using Arrays = typename State::Arrays;
    if (!state.spans_space) {
      if constexpr (Site_charts_3<Arrays>::is_periodic) {
        return write(state, sites, has_vectors, [](Vertex_index, size_type, const auto&) {});
      } else {
        Flat_neighbors_3 flat;
        flat.list_ends(state);
        return write(state, sites, has_vectors, [&](Vertex_index v, size_type, const auto& f) {
          flat.for_each_neighbor(v, f);
        });
      }
    }
    const Cells_of_parts_3<State> cells(state);
    std::vector<Part_stars_3<State>> stars;
    for (size_type part = 0; part < cells.number_of_parts(); ++part)
      stars.emplace_back(cells, part);
    write(state, sites, has_vectors, [&](Vertex_index v, size_type part, const auto& f) {
      stars[part].for_each_neighbor(v, f);
    });
  }

  // Writes all lists. `for_each_neighbor(v, part, f)` calls f with the neighbors of a vertex.
  template <class State, class Sites, class For_each_neighbor>
  void write(const State& state, const Sites& sites, bool has_vectors,
             const For_each_neighbor& for_each_neighbor)
  {
    m_rows.compute(
        state, 1,
        [&](Vertex_index v, size_type part, std::vector<Entry>& entries) {
          const auto begin = std::ptrdiff_t(entries.size());
          for_each_neighbor(
              v, part, [&](const auto& w, const auto&...) { entries.push_back(sites.entry(w)); });
          const auto middle = std::ptrdiff_t(entries.size());
          state.ids.for_each_covered_at(v, [&](Point_id id, const auto&) {
            entries.push_back({id, 0});
          });
          const auto is_before = [&](const Entry& a, const Entry& b) {
            return sites.is_before(v, a, b);
          };
          std::sort(entries.begin() + begin, entries.begin() + middle, is_before);
          std::sort(entries.begin() + middle, entries.end(), is_before);
        },
        [&](size_type number) {
          m_neighbors.resize(number);
          m_shifts.resize(sites.shown_shifts * number);
          m_vectors.assign(has_vectors ? number : 0, Vector{0, 0, 0});
        },
        [&](Vertex_index v, size_type i, const Entry& entry) {
          m_neighbors[i] = entry.id;
          sites.show_shift(v, entry, [&](const Periodic_shift_3& shift) { m_shifts[i] = shift; });
          if (has_vectors)
            m_vectors[i] = sites.vector(v, entry);
        });
    state.ids.for_each_covered([&](Point_id id, Vertex_index v, const auto&) {
      const size_type i = offsets()[id];
      m_neighbors[i] = state.ids.representative(v);
      sites.show_shift(v, {id, 0}, [&](const Periodic_shift_3& shift) {
        m_shifts[i] = {-shift[0], -shift[1], -shift[2]};
      });
    });
  }

  Dynamic_Delaunay_triangulations_3::internal::Rows_by_id_3<Entry> m_rows;
  std::vector<Id> m_neighbors;
  std::vector<Periodic_shift_3> m_shifts;
  std::vector<Vector> m_vectors;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DELAUNAY_NEIGHBOR_LISTS_3_H
