// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_RENUMBERING_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_RENUMBERING_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// How the numbers of vertices, edges or faces have changed in a call. Where some go, the last ones
// take their numbers; where others come, they get these, or the next numbers.
class Renumbering_2
{
public:
  bool is_none() const { return m_kept == no_index && m_moves.empty(); }

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
    const bool has_come = last >= m_kept;
    m_kept = (std::min)(m_kept, last);
    if (to < m_kept)
      m_moves.emplace_back(has_come ? no_index : last, to);
  }

  // One that comes takes the number of one that goes.
  void note_replacement(Index i)
  {
    if (i < m_kept)
      m_moves.emplace_back(no_index, i);
  }

  // Others come, and get this number and the next ones.
  void note_appended(Index first) { m_kept = (std::min)(m_kept, first); }

  // Brings data of each in step. `make(i)` makes those of the one with the new number i.
  template <class T, class Make>
  void follow(std::vector<T>& data, std::size_t size, const Make& make) const
  {
    std::unordered_set<Index> come; // who has come, and taken the number of another one
    for (const auto& [from, to] : m_moves) {
      come.erase(to);
      if (from == no_index || come.erase(from) > 0)
        come.insert(to);
      else if (from < data.size())
        data[to] = data[from];
    }
    if (m_kept < data.size())
      data.erase(data.begin() + std::ptrdiff_t(m_kept), data.end());
    while (data.size() < size)
      data.push_back(make(Index(data.size())));
    for (const Index i : come)
      if (i < m_kept)
        data[i] = make(i);
  }

private:
  // In this order, from where to where; from nowhere, if it has come in this call.
  std::vector<std::pair<Index, Index>> m_moves;
  Index m_kept = no_index; // all of those that were there at first have smaller numbers now
};

struct Renumberings_2
{
  Renumbering_2 vertices, edges, faces;

  bool are_none() const { return vertices.is_none() && edges.is_none() && faces.is_none(); }

  void provide_for_removals(std::size_t number)
  {
    vertices.provide(number);
    edges.provide(3 * number);
    faces.provide(2 * number);
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
