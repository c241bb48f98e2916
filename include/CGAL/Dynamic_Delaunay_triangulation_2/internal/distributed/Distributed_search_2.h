// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_SEARCH_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_SEARCH_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_question_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Finds the own points in the regions of questions, by a grid of about two points a cell. Cost: the
// points are sorted into cells once; then a search is proportional to the cells around the boundary
// of a region and to the points in the region, with a logarithm for the way there.
template <class Points>
class Distributed_search_2
{
  using Kernel = typename Points::Kernel;
  using Question = Distributed_question_2;

public:
  explicit Distributed_search_2(const Points& points)
    : m_points(points)
  {
    for (const Index place : points.owned())
      m_box.add(points.position(place));
    if (m_box.is_empty())
      return;
    const double width = m_box.width(), height = m_box.height();
    const double coordinates = (std::max)(m_box.largest_x(), m_box.largest_y());
    const auto cells = (std::max)(1.0, double(points.owned().size()) / 2);
    // Cells are large enough for rounding to move their ends by far less than a cell. A row has no
    // more cells than there are points, however long the box is.
    m_size = (std::max)({std::sqrt(width / cells) * std::sqrt(height), m_box.longer_side() / cells,
                         0x1p-40 * coordinates, 0x1p-1000});
    m_columns = long(width / m_size) + 1;
    m_rows = long(height / m_size) + 1;
    sort_into_cells();
  }

  // The box around the own points.
  const Box_2& box() const { return m_box; }

  // About the distance between neighbors.
  double cell_size() const { return m_size; }

  // Calls f(place) for each own point that is in the region and in a box, and for some points of
  // the region that are near the box.
  template <class Function>
  void for_each_inside(const Question& question, const Box_2& box, const Function& f) const
  {
    if (!m_box.is_empty())
      search(question, box, {0, 0}, {m_columns - 1, m_rows - 1}, f);
  }

private:
  struct Cell
  {
    long column, row;
  };

  Cell cell_of(Index place) const
  {
    const Position_2 p = m_points.position(place);
    return {(std::min)(long((p.x - m_box.x_low) / m_size), m_columns - 1),
            (std::min)(long((p.y - m_box.y_low) / m_size), m_rows - 1)};
  }
  std::size_t number(Cell cell) const { return std::size_t(cell.row * m_columns + cell.column); }

  void sort_into_cells()
  {
    m_first.assign(std::size_t(m_columns * m_rows) + 1, 0);
    for (const Index place : m_points.owned())
      ++m_first[number(cell_of(place)) + 1];
    for (std::size_t k = 1; k < m_first.size(); ++k)
      m_first[k] += m_first[k - 1];
    std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
    m_sorted.resize(m_points.owned().size());
    for (const Index place : m_points.owned())
      m_sorted[next[number(cell_of(place))]++] = place;
  }

  // A box around all points of these cells, and a cell more on each side, for rounding.
  Box_2 box_around(Cell low, Cell high) const
  {
    return {m_box.x_low + double(low.column - 1) * m_size,
            m_box.y_low + double(low.row - 1) * m_size,
            m_box.x_low + double(high.column + 2) * m_size,
            m_box.y_low + double(high.row + 2) * m_size};
  }

  template <class Function>
  void search(const Question& question, const Box_2& box, Cell low, Cell high,
              const Function& f) const
  {
    const Box_2 around = box_around(low, high);
    if (!around.meets(box) || !question.may_meet<Kernel>(around))
      return;
    const long width = high.column - low.column, height = high.row - low.row;
    if (width == 0 && height == 0) {
      for (std::size_t k = m_first[number(low)]; k < m_first[number(low) + 1]; ++k) {
        const auto& p = m_points.point(m_sorted[k]);
        if (question.contains<Kernel>(p.x(), p.y()))
          f(m_sorted[k]);
      }
      return;
    }
    Cell end_of_first = high, begin_of_second = low;
    if (width > height)
      begin_of_second.column = (end_of_first.column = low.column + width / 2) + 1;
    else
      begin_of_second.row = (end_of_first.row = low.row + height / 2) + 1;
    search(question, box, low, end_of_first, f);
    search(question, box, begin_of_second, high, f);
  }

  const Points& m_points;
  Box_2 m_box;
  double m_size = 1;
  long m_columns = 0, m_rows = 0;
  std::vector<std::size_t> m_first; // by cells: where their points begin in `m_sorted`
  std::vector<Index> m_sorted;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_SEARCH_2_H
