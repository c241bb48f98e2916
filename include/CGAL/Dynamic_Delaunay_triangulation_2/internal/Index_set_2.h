// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INDEX_SET_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INDEX_SET_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// A set of indices below a bound, in the order of their insertion. Clearing costs nothing, and
// after the first frames nothing is allocated.
class Index_set_2
{
public:
  void clear(std::size_t bound)
  {
    m_members.clear();
    if (m_stamps.size() < bound)
      m_stamps.resize(bound, 0);
    if (++m_stamp == 0) { // wrapped around: the old stamps mean nothing any more
      std::fill(m_stamps.begin(), m_stamps.end(), 0);
      m_stamp = 1;
    }
  }

  bool contains(Index i) const { return m_stamps[i] == m_stamp; }

  bool insert(Index i)
  {
    if (contains(i))
      return false;
    m_stamps[i] = m_stamp;
    m_members.push_back(i);
    return true;
  }

  std::size_t size() const { return m_members.size(); }
  bool empty() const { return m_members.empty(); }
  Index operator[](std::size_t i) const { return m_members[i]; }
  const std::vector<Index>& members() const { return m_members; }
  auto begin() const { return m_members.begin(); }
  auto end() const { return m_members.end(); }

private:
  std::vector<Index> m_members;
  std::vector<std::uint32_t> m_stamps;
  std::uint32_t m_stamp = 0;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INDEX_SET_2_H
