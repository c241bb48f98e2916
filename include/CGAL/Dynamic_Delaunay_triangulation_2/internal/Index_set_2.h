// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INDEX_SET_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INDEX_SET_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// A set of indices below a bound, in the order of their insertion: a bit each, so that what is
// asked for at random stays in the cache. Clearing costs as much as there are members, and after
// the first frames nothing is allocated.
class Index_set_2
{
public:
  void clear(std::size_t bound)
  {
    for (const Index i : m_members)
      m_words[i / bits] = 0;
    m_members.clear();
    m_words.resize((bound + bits - 1) / bits, 0);
  }

  bool contains(Index i) const { return m_words[i / bits] >> i % bits & 1; }

  bool insert(Index i)
  {
    if (contains(i))
      return false;
    m_members.push_back(i); // may throw
    m_words[i / bits] |= std::uint64_t(1) << i % bits;
    return true;
  }

  // Inserts all from `first` to below `bound`, in place of what is there.
  void fill(Index first, Index bound)
  {
    clear(bound);
    m_members.resize(bound - first);
    std::iota(m_members.begin(), m_members.end(), first);
    for (const Index i : m_members)
      m_words[i / bits] |= std::uint64_t(1) << i % bits;
  }

  std::size_t size() const { return m_members.size(); }
  bool empty() const { return m_members.empty(); }
  Index operator[](std::size_t i) const { return m_members[i]; }
  const std::vector<Index>& members() const { return m_members; }
  auto begin() const { return m_members.begin(); }
  auto end() const { return m_members.end(); }

private:
  static constexpr Index bits = 64;

  std::vector<Index> m_members;
  std::vector<std::uint64_t> m_words;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INDEX_SET_2_H
