// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CELL_HISTORY_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CELL_HISTORY_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// What cells were since begin(), of those that have changed; of all, once they are given up.
// A `Cell` has `sites()`, and says of these whether there is no cell.
template <class Cell>
class Cell_history_3
{
public:
  using Sites = typename Cell::Sites;
  using Cells = Dynamic_Delaunay_triangulations_2::internal::Uninitialized_column<Cell_index, Cell>;

  void begin()
  {
    m_former.clear();
    m_of_parts.clear();
    m_given_up.clear();
    m_are_given_up = false;
    m_is_on = true;
  }
  void end()
  {
    begin();
    m_is_on = false;
  }

  // Whether cells that are about to change are to be noted.
  bool is_on() const { return m_is_on && !m_are_given_up; }
  void note(Cell_index c, const Cell& cell) { m_former.push_back({c, cell.sites()}); }

  // The same from threads, each in parts of its own, up to join_parts().
  void begin_parts(std::size_t number) { m_of_parts.resize(number); }
  void note(Cell_index c, const Cell& cell, std::size_t part)
  {
    m_of_parts[part].former.push_back({c, cell.sites()});
  }
  // If it throws, it can be called again.
  void join_parts()
  {
    for (Part& part : m_of_parts) {
      m_former.insert(m_former.end(), part.former.begin(), part.former.end());
      part.former.clear();
    }
    m_of_parts.clear();
  }

  // All cells are given up. Takes them instead of copying, so that nothing is thrown.
  void give_up(Cells& cells)
  {
    m_given_up.swap(cells);
    m_are_given_up = true;
  }
  bool are_given_up() const { return m_are_given_up; }

  // To be called before the functions below: of what was noted of a cell, the first remains.
  void finish()
  {
    join_parts(); // which an exception may have left
    std::stable_sort(m_former.begin(), m_former.end(),
                     [](const Former& a, const Former& b) { return a.cell < b.cell; });
    m_former.erase(std::unique(m_former.begin(), m_former.end(),
                               [](const Former& a, const Former& b) { return a.cell == b.cell; }),
                   m_former.end());
  }

  // Calls f(sites) for each cell that there was, of those that have changed.
  template <class Function>
  void for_each_former(const Function& f) const
  {
    for_each_former(m_given_up, f);
  }
  // Calls it for each cell that there was. `present` are those that there are.
  template <class Function>
  void for_each_former_of_all(const Cells& present, const Function& f) const
  {
    for_each_former(m_are_given_up ? m_given_up : present, f);
  }

  // Calls f(c) for each number of which the cell has changed, unless all were given up.
  template <class Function>
  void for_each_changed(const Function& f) const
  {
    for (const Former& former : m_former)
      f(former.cell);
  }

private:
  struct Former
  {
    Cell_index cell;
    Sites sites;
  };

  struct alignas(64) Part // in a line of the cache of its own
  {
    std::vector<Former> former;
  };

  // Those that were noted, and of `others` those that were not.
  template <class Function>
  void for_each_former(const Cells& others, const Function& f) const
  {
    auto next = m_former.begin();
    for (Cell_index c(0); c < others.size(); ++c)
      if (next != m_former.end() && next->cell == c)
        call(f, (next++)->sites);
      else
        call(f, others[c].sites());
    for (; next != m_former.end(); ++next)
      call(f, next->sites);
  }

  template <class Function>
  static void call(const Function& f, const Sites& sites)
  {
    if (!Cell::is_free(sites))
      f(sites);
  }

  bool m_is_on = false, m_are_given_up = false;
  std::vector<Former> m_former;
  std::vector<Part> m_of_parts;
  Cells m_given_up; // as they were then
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CELL_HISTORY_3_H
