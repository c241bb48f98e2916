// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CELL_SET_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CELL_SET_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// A set of few cells, such as a star, in a small table with open addressing. Each thread can have
// one, where marks of all cells would take too much memory; and it stays in the cache. All are
// forgotten in constant time.
class Cell_set_3
{
public:
  Cell_set_3()
    : m_entries(std::size_t(1) << first_bits)
  {
  }

  void clear(Index) // of all cells, as marks of these have it
  {
    m_size = 0;
    if (++m_age == 0) { // all numbers are used up
      m_entries.assign(m_entries.size(), Entry());
      m_age = 1;
    }
  }
  bool has(Cell_index c) const { return m_entries[find(c)].age == m_age; }
  // Whether the cell was not in it before.
  bool insert(Cell_index c)
  {
    const std::size_t i = find(c);
    if (m_entries[i].age == m_age)
      return false;
    m_entries[i] = {c, m_age};
    if (2 * ++m_size > m_entries.size())
      grow();
    return true;
  }

private:
  struct Entry
  {
    Cell_index cell{0};
    std::uint32_t age = 0;
  };

  std::size_t place_of(Cell_index c) const { return std::uint32_t(c * 0x9e3779b1u) >> m_shift; }

  // The entry of a cell, or that which it would get.
  std::size_t find(Cell_index c) const
  {
    std::size_t i = place_of(c);
    while (m_entries[i].age == m_age && m_entries[i].cell != c)
      i = (i + 1) & (m_entries.size() - 1);
    return i;
  }

  void grow()
  {
    std::vector<Entry> entries(2 * m_entries.size());
    m_entries.swap(entries);
    --m_shift;
    m_size = 0;
    for (const Entry& entry : entries)
      if (entry.age == m_age)
        insert(entry.cell);
  }

  static constexpr unsigned first_bits = 8;

  std::vector<Entry> m_entries; // as many as a power of two; those of this age count
  unsigned m_shift = 32 - first_bits;
  std::size_t m_size = 0;
  std::uint32_t m_age = 1;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CELL_SET_3_H
