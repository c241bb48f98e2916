// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_SAFE_CELLS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_SAFE_CELLS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Room for a few more than so many: frames change the number of cells little.
inline std::size_t with_reserve(std::size_t cells)
{
  return cells + cells / 128 + 64;
}

// Up to which way of all vertices each cell is proved, while that is kept. The *travel* is the sum
// of the longest ways of vertices in each frame. A cell with a slack, when it is measured, is safe
// as long as the travel has not grown by more.
//
// Numbers are kept in a unit, in 16 bits, so that they take 14 bytes a point. They are rounded to
// the safe side.
class Safe_cells_3
{
public:
  bool is_on() const { return m_is_on; }

  // Keeps numbers for so many cells, none of which is safe. The unit is a thousandth of a typical
  // slack.
  void start(std::size_t cells, double typical_slack)
  {
    m_until.assign(cells, 0);
    m_unit = typical_slack / 1000;
    m_travel = 0;
    m_is_on = true;
  }
  void stop()
  {
    m_is_on = false;
    m_until = Column<Cell_index, Number>();
  }

  // All vertices have moved by at most this way, relative to each other and a common translation.
  void advance(double way)
  {
    m_travel = (m_travel + way / m_unit) * (1 + 0x1p-49);
    if (m_travel < rebased_from)
      return;
    const double travel = m_travel;
    m_travel = 0;
    for (Number& until : m_until)
      until = until > travel ? Number(until - travel) : Number(0);
  }

  // Lists the cells from `first` to before `beyond` that are not safe.
  void list_doubtful(std::size_t first, std::size_t beyond, std::vector<Cell_index>& cells) const
  {
    const Number* const until = m_until.data();
    const Number bound = Number(std::ceil(m_travel));
    cells.clear();
    std::array<Cell_index, 1024> some; // that stay in the first cache
    for (std::size_t begin = first; begin < beyond; begin += some.size()) {
      const std::size_t end = (std::min)(begin + some.size(), beyond);
      std::size_t number = 0;
      for (std::size_t c = begin; c < end; ++c) { // without branches, which would be mispredicted
        some[number] = Cell_index(c);
        number += until[c] <= bound;
      }
      cells.insert(cells.end(), some.begin(), some.begin() + std::ptrdiff_t(number));
    }
  }

  void set_slack(Cell_index c, double slack)
  {
    const double until = (m_travel + slack / m_unit) * (1 - 0x1p-49);
    m_until[c] = until > 0 ? Number((std::min)(until, largest)) : Number(0);
  }

  void learn_slack(Cell_index c, double slack)
  {
    if (m_is_on)
      set_slack(c, slack);
  }

  // What changes of the cells bring about.
  void forget(Cell_index c)
  {
    if (m_is_on)
      m_until[c] = 0;
  }
  void resize(std::size_t cells)
  {
    if (!m_is_on)
      return;
    if (m_until.capacity() < cells)
      m_until.reserve(with_reserve(cells)); // resize() alone may double it
    m_until.resize(cells, 0);
  }
  void move(Cell_index from, Cell_index to)
  {
    if (m_is_on)
      m_until[to] = m_until[from];
  }

private:
  using Number = std::uint16_t;

  static constexpr double rebased_from = 0x1p14;
  static constexpr double largest = (std::numeric_limits<Number>::max)();

  bool m_is_on = false;
  double m_unit = 1, m_travel = 0; // in units, and below `rebased_from`
  Column<Cell_index, Number> m_until;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_SAFE_CELLS_3_H
