// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_RENUMBERING_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_RENUMBERING_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// How the numbers of vertices, edges or faces have changed in a call. Where some go, the last ones
// take their numbers; where others come, they get the next numbers.
class Renumbering_2
{
public:
  bool is_none() const { return m_kept == no_index; }

  // Memory for so many that go: then nothing here throws, but follow().
  void provide(std::size_t number) { m_moves.reserve(m_moves.size() + number); }

  void clear()
  {
    m_moves.clear();
    m_kept = no_index;
  }

  // The last one takes the number of one that goes.
  void note_move(Index last, Index to)
  {
    if (last != to)
      m_moves.emplace_back(last, to);
    m_kept = (std::min)(m_kept, last);
  }

  // Others come, and get this number and the next ones.
  void note_growth(Index first) { m_kept = (std::min)(m_kept, first); }

  // Brings data of each in step. `make(i)` makes those of the one with the new number i.
  template <class T, class Make>
  void follow(std::vector<T>& data, std::size_t size, const Make& make) const
  {
    for (const auto& [from, to] : m_moves)
      if (from < data.size()) // it has not come in this call
        data[to] = data[from];
    if (m_kept < data.size())
      data.erase(data.begin() + std::ptrdiff_t(m_kept), data.end());
    while (data.size() < size)
      data.push_back(make(Index(data.size())));
  }

private:
  std::vector<std::pair<Index, Index>> m_moves; // in this order
  Index m_kept = no_index; // all of those that were there at first have smaller numbers now
};

struct Renumberings_2
{
  Renumbering_2 vertices, edges, faces;

  void provide_for_removals(std::size_t number)
  {
    vertices.provide(number);
    edges.provide(3 * number);
    faces.provide(2 * number);
  }

  // All that come get these numbers and the next ones.
  void note_growth(Index vertex, Index edge, Index face)
  {
    vertices.note_growth(vertex);
    edges.note_growth(edge);
    faces.note_growth(face);
  }

  void clear()
  {
    vertices.clear();
    edges.clear();
    faces.clear();
  }
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_RENUMBERING_2_H
