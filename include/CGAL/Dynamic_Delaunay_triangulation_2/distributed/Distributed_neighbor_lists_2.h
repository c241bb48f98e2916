// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_NEIGHBOR_LISTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_NEIGHBOR_LISTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The neighbors of the points that a rank of a `Distributed_dynamic_Delaunay_triangulation_2` or of a
`Distributed_dynamic_periodic_Delaunay_triangulation_2` owns, as two arrays: what
`Delaunay_neighbor_lists_2` is for one process. In periodic space a third array has their shifts.

The list of a point holds the ids of the other ends of its edges, ascending; images of one point are
in the order of their shifts. Of points that coincide the one with the smallest id has the edges,
and its list ends with the ids of the others, ascending. The list of each of the others holds that
smallest id alone. So over all ranks the lists are symmetric, and they do not depend on the number
of ranks.
*/
class Distributed_neighbor_lists_2
{
public:
  /// an id.
  using Id = std::int64_t;
  /// the type of counts.
  using size_type = std::size_t;
  /// the list of one point.
  using Neighbors = Iterator_range<std::vector<Id>::const_iterator>;

  /// replaces the lists by those of the points that this rank owns. Not collective. Cost: linear,
  /// and each list is sorted.
  /// \tparam Distributed a `Distributed_dynamic_Delaunay_triangulation_2` or a
  /// `Distributed_dynamic_periodic_Delaunay_triangulation_2`.
  template <class Distributed>
  void compute(const Distributed& dt)
  {
    m_offsets.assign(dt.number_of_owned_points() + 1, 0);
    const auto count = [&](size_type k, Id, const auto&...) { ++m_offsets[k + 1]; };
    dt.for_each_neighbor(count);
    dt.for_each_duplicate(count);
    for (size_type k = 1; k < m_offsets.size(); ++k)
      m_offsets[k] += m_offsets[k - 1];
    std::vector<Neighbor> all(m_offsets.back());
    std::vector<size_type> next(m_offsets.begin(), m_offsets.end() - 1);
    bool have_shifts = false;
    const auto write = [&](size_type k, Id j, const auto&... shift) {
      all[next[k]++] = {j, Periodic_shift_2{shift...}};
      have_shifts = sizeof...(shift) > 0;
    };
    const auto sort = [&](const std::vector<size_type>& first) {
      for (size_type k = 0; k < next.size(); ++k)
        std::sort(all.begin() + difference(first[k]), all.begin() + difference(next[k]));
    };
    dt.for_each_neighbor(write);
    sort(m_offsets);
    const std::vector<size_type> duplicates = next;
    dt.for_each_duplicate(write);
    sort(duplicates);
    m_neighbors.clear();
    m_shifts.clear();
    for (const Neighbor& neighbor : all) {
      m_neighbors.push_back(neighbor.first);
      if (have_shifts)
        m_shifts.push_back(neighbor.second);
    }
  }

  /// where the list of each owned point, in the order of `owned_ids()`, begins in `neighbors()`,
  /// and where the last list ends.
  const std::vector<size_type>& offsets() const { return m_offsets; }
  /// all lists.
  const std::vector<Id>& neighbors() const { return m_neighbors; }
  /// in periodic space, the shift of each entry of `neighbors()`: which image it is, as
  /// `Distributed_triangulation_base_2::for_each_neighbor()` says. Empty in the plane.
  const std::vector<Periodic_shift_2>& shifts() const { return m_shifts; }
  /// the list of the `k`-th owned point. It is valid until the next `compute()`.
  /// \pre `k + 1 < offsets().size()`
  Neighbors neighbors(size_type k) const
  {
    CGAL_precondition(k + 1 < m_offsets.size());
    return Neighbors(m_neighbors.begin() + difference(m_offsets[k]),
                     m_neighbors.begin() + difference(m_offsets[k + 1]));
  }

private:
  using Neighbor = std::pair<Id, Periodic_shift_2>;

  static std::ptrdiff_t difference(size_type place) { return std::ptrdiff_t(place); }

  std::vector<size_type> m_offsets = {0};
  std::vector<Id> m_neighbors;
  std::vector<Periodic_shift_2> m_shifts;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_NEIGHBOR_LISTS_2_H
