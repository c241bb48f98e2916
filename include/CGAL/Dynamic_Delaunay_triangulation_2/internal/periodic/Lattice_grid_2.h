// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_LATTICE_GRID_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_LATTICE_GRID_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <cmath>
#include <cstdint>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A square grid on which a cell's vectors, points and their images near the origin are exact
// doubles: the multiples of a unit u, a power of 2.
//
// Let 2^s be the least power of 2 above H, the sum of the lengths of the lattice's shortest basis,
// but for rounding. With u = 2^(s - 45) rounding to the grid moves a coordinate by at most
// 2^(s - 46), which is at most H / 2^45. A multiple of u of at most 2^53 u = 2^8 2^s is a double;
// so images with coordinates of up to 2^7 2^s, and vectors between them, are exact, and so are sums
// and differences of these. Larger doubles are multiples of u already, and are not rounded.
//
// A sum p + i a + j b may have terms that are too large for doubles. It is computed in units, as
// integers modulo 2^64: a result that is a double below 2^62 units is exact, for any terms.
class Lattice_grid_2
{
public:
  // Rounds the cell. Throws if it is a slab, or so thin or extreme that doubles cannot tell how far
  // points are apart in it. Rounding a rounded cell changes nothing, so that points can be given
  // back as they are.
  explicit Lattice_grid_2(const Periodic_cell_2& given)
    : m_cell(given)
    , m_unit(unit_for(given))
  {
    for (double last = 0; last != m_unit;) {
      last = m_unit;
      const Position_2 a = rounded({m_cell.ax(), m_cell.ay()}),
                       b = rounded({m_cell.bx(), m_cell.by()});
      m_cell = Periodic_cell_2(a.x, a.y, b.x, b.y);
      // The loop ends: on a finer grid the cell stays as it is, and few grids are coarser.
      m_unit = unit_for(m_cell);
    }
    m_ax = in_units(m_cell.ax()), m_ay = in_units(m_cell.ay());
    m_bx = in_units(m_cell.bx()), m_by = in_units(m_cell.by());
  }

  const Periodic_cell_2& cell() const { return m_cell; }

  // Whether sums with this position are exact.
  bool has_room(const Position_2& p) const
  {
    return std::abs(p.x) < most_units * m_unit && std::abs(p.y) < most_units * m_unit;
  }
  Position_2 rounded(const Position_2& p) const
  {
    return {m_unit * std::round(p.x / m_unit), m_unit * std::round(p.y / m_unit)};
  }

  // p + i a + j b, for p on the grid.
  Position_2 sum(const Position_2& p, std::int64_t i, std::int64_t j) const
  {
    const auto k = std::uint64_t(i), l = std::uint64_t(j);
    return {from_units(in_units(p.x) + k * m_ax + l * m_bx),
            from_units(in_units(p.y) + k * m_ay + l * m_by)};
  }

private:
  static constexpr double most_units = 0x1p61;
  // Limits of H. Within them, units cause no avoidable under- or overflow of products.
  static constexpr double least = 0x1p-400, most = 0x1p400;

  static double unit_for(const Periodic_cell_2& cell)
  {
    const auto refuse = [&](const char* demand) {
      throw Periodic_cell_error_2(cell.ax(), cell.ay(), cell.bx(), cell.by(), demand);
    };
    if (cell.is_slab())
      refuse("points on several ranks need two vectors");
    const Torus_2 torus(cell);
    if (!torus.is_measurable())
      refuse("doubles cannot tell how far points are apart in it");
    double sum = 0;
    for (const Periodic_shift_2& s : short_basis(torus)) {
      const Position_2 v = torus.vector({double(s[0]), double(s[1])});
      sum += std::hypot(v.x, v.y);
    }
    if (!(sum > least && sum < most))
      refuse("doubles cannot tell how far points are apart in it");
    return std::ldexp(1.0, std::ilogb(sum) + 1 - 45);
  }

  // Returns x in units, modulo 2^64. \pre `x` is a multiple of the unit.
  std::uint64_t in_units(double x) const
  {
    const double n = std::fmod(x / m_unit, 0x1p64);
    return n < 0 ? -std::uint64_t(-n) : std::uint64_t(n);
  }
  double from_units(std::uint64_t n) const { return double(std::int64_t(n)) * m_unit; }

  Periodic_cell_2 m_cell;
  double m_unit;
  std::uint64_t m_ax, m_ay, m_bx, m_by;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_LATTICE_GRID_2_H
