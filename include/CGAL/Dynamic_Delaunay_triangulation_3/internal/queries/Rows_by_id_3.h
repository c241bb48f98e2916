// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_ROWS_BY_ID_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_ROWS_BY_ID_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The least number of vertices in a part. The star of a vertex takes about a microsecond.
template <class Parts>
constexpr std::size_t least_stars = (std::max)(Parts::usual_size / 16, std::size_t(1));

// Makes compressed rows, one for each id, of lists that threads make, one for each vertex. These
// take the vertices in their order, in which close ones are close in memory; ids may be anywhere.
template <class Entry>
class Rows_by_id_3
{
public:
  // Calls list(v, part, entries), which appends those of a vertex, for all vertices, then
  // resize(number), with the number of all entries, then write(v, i, entry), which stores the i-th
  // of all, one of v. The row of each covered point has so many more entries, which are not
  // written.
  template <class State, class List, class Resize, class Write>
  void compute(const State& state, std::size_t entries_of_covered, const List& list,
               const Resize& resize, const Write& write)
  {
    using Parts = typename State::Parts;
    const std::size_t least = least_stars<Parts>, vertices = state.number_of_vertices();
    const auto row = [&](Vertex_index v) { return std::size_t(state.ids.representative(v)); };
    m_offsets.assign(state.ids.number_of_ids() + std::size_t(1), 0);
    m_lists.resize((std::max)(Parts::number(vertices, least), m_lists.size()));
    Parts::for_each(vertices, least, [&](std::size_t part, std::size_t first, std::size_t beyond) {
      std::vector<Entry>& entries = m_lists[part];
      entries.clear();
      for (Vertex_index v(first + 1); v <= beyond; ++v) {
        const std::size_t before = entries.size();
        list(v, part, entries);
        m_offsets[row(v) + 1] = entries.size() - before;
      }
    });
    state.ids.for_each_covered(
        [&](std::size_t id, const auto&...) { m_offsets[id + 1] = entries_of_covered; });
    std::partial_sum(m_offsets.begin(), m_offsets.end(), m_offsets.begin());
    resize(m_offsets.back());
    Parts::for_each(vertices, least, [&](std::size_t part, std::size_t first, std::size_t beyond) {
      auto entry = m_lists[part].begin();
      for (Vertex_index v(first + 1); v <= beyond; ++v)
        for (std::size_t i = m_offsets[row(v)]; i < m_offsets[row(v) + 1]; ++i)
          write(v, i, *entry++);
    });
  }

  void clear() { m_offsets.assign(1, 0); }
  // Where each row begins, and where the last one ends.
  const std::vector<std::size_t>& offsets() const { return m_offsets; }

private:
  std::vector<std::size_t> m_offsets = {0};
  std::vector<std::vector<Entry>> m_lists; // of each part
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_ROWS_BY_ID_3_H
