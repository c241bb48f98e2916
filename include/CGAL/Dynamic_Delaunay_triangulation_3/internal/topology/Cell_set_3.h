// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CELL_SET_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CELL_SET_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>

#include <boost/config.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// A set of few cells, such as a star, with a note on each, in a small table with open addressing.
// Each thread can have one, where marks of all cells would take too much memory; and it stays in
// the cache. All are forgotten in constant time.
template <class Note>
class Noted_cells_3
{
public:
  // One of some kinds, from 0 to 3, and the note.
  struct Noted
  {
    Index kind;
    Note note;
  };

  Noted_cells_3()
    : m_entries(std::size_t(1) << first_bits)
  {
  }

  void clear(Index) // of all cells, as marks of these have it
  {
    m_size = 0;
    m_age += kinds;
    if (m_age == 0) { // all numbers are used up
      m_entries.assign(m_entries.size(), Entry());
      m_age = kinds;
    }
  }
  bool has(Cell_index c) const { return is_present(m_entries[find(c)]); }
  // Whether the cell was not in it before.
  bool insert(Cell_index c)
  {
    const std::size_t i = find(c);
    if (is_present(m_entries[i]))
      return false;
    put(i, c, {0, Note()});
    return true;
  }
  // Of a cell that is not in it.
  void insert(Cell_index c, Index kind, const Note& note = Note())
  {
    put(find(c), c, {kind, note});
  }

  // What is noted of a cell, which is new_one() if it was not in it before.
  template <class New>
  Noted find_or_insert(Cell_index c, const New& new_one)
  {
    const std::size_t i = find(c);
    if (is_present(m_entries[i]))
      return {m_entries[i].age - m_age, m_entries[i]};
    const Noted noted = new_one();
    put(i, c, noted);
    return noted;
  }

private:
  struct Entry : Note // nothing takes no memory
  {
    Cell_index cell{0};
    std::uint32_t age = 0;
  };

  bool is_present(const Entry& entry) const { return entry.age >= m_age; }

  void put(std::size_t i, Cell_index c, const Noted& noted)
  {
    m_entries[i] = {noted.note, c, m_age + noted.kind};
    ++m_size;
    if (2 * m_size > m_entries.size())
      grow();
  }

  std::size_t place_of(Cell_index c) const { return std::uint32_t(c * 0x9e3779b1u) >> m_shift; }

  // The entry of a cell, or that which it would get.
  std::size_t find(Cell_index c) const
  {
    std::size_t i = place_of(c);
    while (is_present(m_entries[i]) && m_entries[i].cell != c)
      i = (i + 1) & (m_entries.size() - 1);
    return i;
  }

  BOOST_NOINLINE void grow()
  {
    std::vector<Entry> entries(2 * m_entries.size());
    m_entries.swap(entries);
    --m_shift;
    m_size = 0;
    for (const Entry& entry : entries)
      if (is_present(entry))
        insert(entry.cell, entry.age - m_age, entry);
  }

  static constexpr Index kinds = 4;
  static constexpr unsigned first_bits = 8;

  std::vector<Entry> m_entries; // as many as a power of two; those of this age count
  unsigned m_shift = 32 - first_bits;
  std::size_t m_size = 0;
  std::uint32_t m_age = kinds; // a multiple; that of an entry is larger by its kind
};

struct No_note_3
{
};
using Cell_set_3 = Noted_cells_3<No_note_3>;

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CELL_SET_3_H
