// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_BODY_LATTICE_H
#define SCENARIO_BODY_LATTICE_H

#include "Motion.h"
#include "Scenario_description.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace scenario {

// The first `number_of_points` places, row by row from below, of a lattice of touching discs.
class Body_lattice
{
public:
  Body_lattice(std::size_t number_of_points, std::size_t columns, Packing packing, double diameter,
               const Point& corner)
    : m_number_of_points(number_of_points)
    , m_columns(columns)
    , m_packing(packing)
    , m_diameter(diameter)
    , m_corner(corner)
  {
  }

  std::size_t number_of_points() const { return m_number_of_points; }

  Point point(std::size_t i) const
  {
    const std::size_t row = i / m_columns;
    const bool shifted = m_packing == Packing::hexagonal && row % 2 == 1;
    const double x = static_cast<double>(i % m_columns) + (shifted ? 1.0 : 0.5);
    const double y = 0.5 + static_cast<double>(row) * row_distance(m_packing);
    return {m_corner.x + m_diameter * x, m_corner.y + m_diameter * y};
  }

  Point center() const
  {
    Point sum{0.0, 0.0};
    for (std::size_t i = 0; i != m_number_of_points; ++i) {
      sum.x += point(i).x;
      sum.y += point(i).y;
    }
    const auto number = static_cast<double>(m_number_of_points);
    return {sum.x / number, sum.y / number};
  }

  // Calls visit(j) for every place j > i near place i. The diagonals of square cells are among
  // them: bonds there make the body resist shear.
  template <class Visit>
  void for_each_later_near_place(std::size_t i, Visit visit) const
  {
    const std::size_t end = (std::min)(m_number_of_points, i + m_columns + 2);
    for (std::size_t j = i + 1; j < end; j = next_candidate(i, j)) {
      if (distance(i, j) < 1.6 * m_diameter) {
        visit(j);
      }
    }
  }

private:
  // Near places follow i directly or are around the one above it.
  std::size_t next_candidate(std::size_t i, std::size_t j) const
  {
    return j == i + 1 ? (std::max)(i + 2, i + m_columns - 1) : j + 1;
  }

  double distance(std::size_t i, std::size_t j) const
  {
    return std::hypot(point(j).x - point(i).x, point(j).y - point(i).y);
  }

  std::size_t m_number_of_points;
  std::size_t m_columns;
  Packing m_packing;
  double m_diameter;
  Point m_corner;
};

} // namespace scenario

#endif // SCENARIO_BODY_LATTICE_H
