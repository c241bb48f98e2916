// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_RENUMBERING_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_RENUMBERING_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The new numbers of the last elements of a kind, which take the numbers of removed ones: as many
// as were removed, in their order.
template <class Index_of_kind>
class Filled_gaps
{
public:
  // Reserves memory for so many removed elements. Then assign() throws nothing.
  void reserve(std::size_t number) { m_new.reserve(number); }

  // There were `size` elements; `gaps` are the removed ones, ascending. Threads share the work.
  template <class Parts>
  void assign(Index size, const std::vector<Index_of_kind>& gaps)
  {
    m_kept = size - Index(gaps.size());
    m_new.resize(gaps.size());
    const auto first_removed = std::lower_bound(gaps.begin(), gaps.end(), m_kept);
    Parts::for_each(gaps.size(), Parts::size_for(8),
                    [&](std::size_t, std::size_t i, std::size_t beyond) {
                      auto removed = std::lower_bound(first_removed, gaps.end(), m_kept + i);
                      auto filled = gaps.begin() + (std::ptrdiff_t(i) - (removed - first_removed));
                      for (; i < beyond; ++i)
                        if (removed != gaps.end() && *removed == m_kept + i) {
                          ++removed;
                          m_new[i] = null_index;
                        } else
                          m_new[i] = *filled++;
                    });
  }

  // The elements that are left have smaller numbers.
  Index number_kept() const { return m_kept; }

  // The new number of an element, `null_index` if it was removed. That of a gap is the gap's own.
  Index_of_kind operator()(Index_of_kind i) const
  {
    const Index place = i - m_kept; // large if i is smaller: unsigned, it wraps around
    return place < m_new.size() ? m_new[place] : i;
  }

  // Calls f(from, to) for the last elements that stay: element `from` takes the number `to`.
  // Threads share the calls.
  template <class Parts, class Function>
  void for_each_move(const Function& f) const
  {
    Parts::for_each_element(m_new.size(), Parts::size_for(8), [&](std::size_t i) {
      if (m_new[i] != null_index)
        f(Index_of_kind(m_kept + Index(i)), m_new[i]);
    });
  }

  // Calls f(last, to) for the last elements, from the last one on: element `last` takes the number
  // `to`, its own if it was removed.
  template <class Function>
  void for_each_from_last(const Function& f) const
  {
    for (std::size_t i = m_new.size(); i > 0; --i) {
      const Index_of_kind last(m_kept + Index(i) - 1), to = m_new[i - 1];
      f(last, to == null_index ? last : to);
    }
  }

private:
  Index m_kept = 0;
  std::vector<Index_of_kind> m_new; // of the elements from m_kept on
};

// How the numbers of vertices, edges or faces have changed in a call. The last element takes the
// number of a removed one. An added element takes the number of a removed one, or the next number.
template <class Index_of_kind>
class Renumbering
{
public:
  bool is_none() const { return m_kept == null_index && m_moves.empty(); }

  // Reserves memory to note so many removals. Then only follow() can throw.
  void reserve_extra(std::size_t number) { m_moves.reserve(m_moves.size() + number); }

  void clear()
  {
    m_moves.clear();
    m_kept = null_index;
  }

  // The last element takes the number of a removed one.
  void note_move(Index_of_kind last, Index_of_kind to)
  {
    const bool has_come = last >= m_kept;
    m_kept = (std::min)(m_kept, last);
    if (to < m_kept)
      m_moves.emplace_back(has_come ? null_index : last, to);
  }

  // An added element takes the number of a removed one.
  void note_replacement(Index_of_kind i)
  {
    if (i < m_kept)
      m_moves.emplace_back(null_index, i);
  }

  // Added elements get the numbers from `first` on.
  void note_appended(Index_of_kind first) { m_kept = (std::min)(m_kept, first); }

  // Renumbers `data`, one entry per element, in the same way. `make(i)` makes the entry of an added
  // element, whose number is i.
  template <class T, class Allocator, class Make>
  void follow(std::vector<T, Allocator>& data, std::size_t size, const Make& make) const
  {
    std::unordered_set<Index> come; // added elements that have the number of a removed one
    for (const auto& [from, to] : m_moves) {
      come.erase(to);
      if (from == null_index || come.erase(from) > 0)
        come.insert(to);
      else if (from < data.size())
        data[to] = data[from];
    }
    if (m_kept < data.size())
      data.erase(data.begin() + std::ptrdiff_t(m_kept), data.end());
    while (data.size() < size)
      data.push_back(make(Index_of_kind(data.size())));
    for (const Index i : come)
      if (i < m_kept)
        data[i] = make(Index_of_kind(i));
  }

private:
  // Moves in order, from number to number; from `null_index` if the element was added in this call.
  std::vector<std::pair<Index_of_kind, Index_of_kind>> m_moves;
  Index_of_kind m_kept = null_index; // elements that existed before the call have smaller numbers
};

struct Renumberings
{
  Renumbering<Vertex_index> vertices;
  Renumbering<Edge_index> edges;
  Renumbering<Face_index> faces;

  bool are_none() const { return vertices.is_none() && edges.is_none() && faces.is_none(); }

  void reserve_for_removals(std::size_t number)
  {
    vertices.reserve_extra(number);
    edges.reserve_extra(3 * number);
    faces.reserve_extra(2 * number);
  }

  void clear()
  {
    vertices.clear();
    edges.clear();
    faces.clear();
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_RENUMBERING_H
