// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_LATTICE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_LATTICE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Decimal_number.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/enum.h>
#include <CGAL/Periodic_cell_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// `max_shift` limits points and reduced bases, in multiples of the cell's vectors; `max_multiple`
// limits the multiples by which one cell is exchanged for another. The shifts of a face are
// differences of numbers below max_shift, of points and of basis vectors, and so below 2^22.
constexpr double max_shift = 0x1p20, max_multiple = 0x1p8, max_shift_in_face = 4 * max_shift;

constexpr std::array<Periodic_shift_2, 2> unit_multiples{{{1, 0}, {0, 1}}};
constexpr std::array<Periodic_shift_2, 2> exchanged_multiples{{{0, 1}, {1, 0}}};

// Returns a point's position. Throws as in the plane, and if the point is beyond `max_shift`.
template <class Point>
Position_2 checked_position(const Point& p, std::size_t id, const Torus_2& torus)
{
  const Position_2 position = checked_position(p, id);
  const Position_2 multiples = torus.periodic(torus.multiples(position));
  if (!(std::abs(multiples.x) < max_shift && std::abs(multiples.y) < max_shift))
    throw Periodic_range_error_2(id, position.x, position.y, max_shift);
  return position;
}

// Returns a short counterclockwise basis of the cell's lattice, by Lagrange's reduction in rounded
// arithmetic. Any basis is correct; triangulations start faster from a short one.
inline std::array<Periodic_shift_2, 2> short_basis(const Torus_2& torus)
{
  const Periodic_cell_2& cell = torus.cell();
  if (cell.is_slab())
    return unit_multiples;
  std::array<Position_2, 2> v{{{cell.ax(), cell.ay()}, {cell.bx(), cell.by()}}};
  std::array<std::array<double, 2>, 2> basis{{{1, 0}, {0, 1}}};
  const auto product = [](const Position_2& p, const Position_2& q) {
    return p.x * q.x + p.y * q.y;
  };
  for (int steps = 0; steps < 64; ++steps) {
    if (product(v[0], v[0]) > product(v[1], v[1])) {
      std::swap(v[0], v[1]);
      std::swap(basis[0], basis[1]);
    }
    const double k = std::round(product(v[0], v[1]) / product(v[0], v[0]));
    if (!(std::abs(k) >= 1))
      break;
    for (std::size_t i = 0; i < 2; ++i)
      basis[1][i] -= k * basis[0][i];
    if (!(std::abs(basis[1][0]) < max_shift && std::abs(basis[1][1]) < max_shift))
      throw Periodic_cell_error_2(cell.ax(), cell.ay(), cell.bx(), cell.by(),
                                  "a reduced basis needs too large multiples of them");
    v[1] = {v[1].x - k * v[0].x, v[1].y - k * v[0].y};
  }
  std::array<Periodic_shift_2, 2> shifts;
  for (std::size_t i = 0; i < 2; ++i)
    shifts[i] = {int(basis[i][0]), int(basis[i][1])};
  const Position_2 origin{0, 0};
  if (torus.orientation({origin, no_shift}, {origin, shifts[0]}, {origin, shifts[1]}) != LEFT_TURN)
    std::swap(shifts[0], shifts[1]);
  return shifts;
}

inline int determinant(const std::array<Periodic_shift_2, 2>& m)
{
  return m[0][0] * m[1][1] - m[0][1] * m[1][0];
}

inline bool is_counterclockwise(const Torus_2& torus)
{
  const Position_2 origin{0, 0};
  return torus.orientation({origin, no_shift}, {origin, {1, 0}}, {origin, {0, 1}}) == LEFT_TURN;
}

// Returns what is s times the old cell's vectors in multiples of the new ones, moved with the cell.
inline Position_2 in_new_multiples(const Position_2& s,
                                   const std::array<Periodic_shift_2, 2>& multiples)
{
  return {s.x * multiples[0][0] + s.y * multiples[1][0],
          s.x * multiples[0][1] + s.y * multiples[1][1]};
}

// Returns the old cell's vectors in multiples of the new ones, for a cell that is only deformed. If
// the cells have different orientations, exchanges the vectors: faces stay counterclockwise.
inline std::array<Periodic_shift_2, 2> multiples_in_deformed_cell(const Torus_2& old_torus,
                                                                  const Torus_2& new_torus)
{
  return is_counterclockwise(old_torus) == is_counterclockwise(new_torus) ? unit_multiples
                                                                          : exchanged_multiples;
}

// Throws Periodic_cell_error_2 for a cell in which nothing can be triangulated.
inline void check_cell(const Periodic_cell_2& cell)
{
  const Torus_2 torus(cell);
  if (!torus.is_measurable())
    throw Periodic_cell_error_2(cell.ax(), cell.ay(), cell.bx(), cell.by(),
                                "doubles cannot tell how far points are apart in it");
  short_basis(torus); // throws if there is none
}

// Returns the old cell's vectors in multiples of the new ones, rounded to integers: these may be
// other vectors of about the same lattice, as after a Lees-Edwards flip. The determinant is 1 if
// both cells have the same orientation, and else -1. If rounding gives another determinant, or too
// large integers, the cell counts as only deformed.
inline std::array<Periodic_shift_2, 2> multiples_in_new_cell(const Torus_2& old_torus,
                                                             const Torus_2& new_torus)
{
  const Periodic_cell_2& old_cell = old_torus.cell();
  const Position_2 a = new_torus.multiples({old_cell.ax(), old_cell.ay()});
  if (old_cell.is_slab())
    return a.x < 0 ? std::array<Periodic_shift_2, 2>{{{-1, 0}, {0, -1}}} : unit_multiples;
  const Position_2 b = new_torus.multiples({old_cell.bx(), old_cell.by()});
  const auto deformed = multiples_in_deformed_cell(old_torus, new_torus);
  for (const double x : {a.x, a.y, b.x, b.y})
    if (!(std::abs(x) < max_multiple))
      return deformed;
  const std::array<Periodic_shift_2, 2> rounded{new_torus.nearest_shift(a),
                                                new_torus.nearest_shift(b)};
  return determinant(rounded) == determinant(deformed) ? rounded : deformed;
}

// std::round(t), which is a call of a library where processors without SSE4.1 are to be supported.
inline double nearest_integer(double t)
{
  if (!(std::abs(t) < 0x1p52)) // no fraction
    return t;
  const double truncated = double(std::int64_t(t)), rest = t - truncated;
  return std::copysign(truncated + double((rest >= 0.5) - (rest <= -0.5)), t);
}

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
  // points are apart in it, or that rounding makes its vectors parallel. Rounding a rounded cell
  // changes nothing, so that points can be given back as they are.
  explicit Lattice_grid_2(const Periodic_cell_2& given)
    : m_cell(given)
  {
    set_unit(unit_for(given));
    for (double last = 0; last != m_unit;) {
      last = m_unit;
      m_cell = rounded(given, m_cell);
      // The loop ends: on a finer grid the cell stays as it is, and few grids are coarser.
      set_unit(unit_for(m_cell));
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
    return {m_unit * nearest_integer(p.x * m_per_unit), m_unit * nearest_integer(p.y * m_per_unit)};
  }

  // p + i a + j b, for p on the grid, within 2^62 units.
  Position_2 sum(const Position_2& p, std::int64_t i, std::int64_t j) const
  {
    if ((i | j) == 0)
      return {p.x + 0.0, p.y + 0.0}; // without -0, as below
    const auto k = std::uint64_t(i), l = std::uint64_t(j);
    return {from_units(in_units(p.x) + k * m_ax + l * m_bx),
            from_units(in_units(p.y) + k * m_ay + l * m_by)};
  }

private:
  static constexpr double most_units = 0x1p61;
  // Limits of H. Within them, units cause no avoidable under- or overflow of products.
  static constexpr double least = 0x1p-400, most = 0x1p400;

  void set_unit(double unit)
  {
    m_unit = unit;
    m_per_unit = 1 / unit; // a power of 2 as well
  }

  [[noreturn]] static void refuse(const Periodic_cell_2& cell, const std::string& demand)
  {
    throw Periodic_cell_error_2(cell.ax(), cell.ay(), cell.bx(), cell.by(), demand);
  }

  Periodic_cell_2 rounded(const Periodic_cell_2& given, const Periodic_cell_2& cell) const
  {
    const Position_2 a = rounded({cell.ax(), cell.ay()}), b = rounded({cell.bx(), cell.by()});
    try {
      return Periodic_cell_2(a.x, a.y, b.x, b.y);
    } catch (const Periodic_cell_error_2&) {
      refuse(given, "it is so thin that its vectors would be parallel when points and vectors are "
                    "rounded to multiples of " +
                        message_text(m_unit));
    }
  }

  static double unit_for(const Periodic_cell_2& cell)
  {
    if (cell.is_slab())
      refuse(cell, "points on several ranks need two vectors");
    const Torus_2 torus(cell);
    if (!torus.is_measurable())
      refuse(cell, "doubles cannot tell how far points are apart in it");
    double sum = 0;
    for (const Periodic_shift_2& s : short_basis(torus)) {
      const Position_2 v = torus.vector({double(s[0]), double(s[1])});
      sum += std::hypot(v.x, v.y);
    }
    if (!(sum > least && sum < most))
      refuse(cell, "doubles cannot tell how far points are apart in it");
    return std::ldexp(1.0, std::ilogb(sum) + 1 - 45);
  }

  // Returns x in units, modulo 2^64. \pre `x` is a multiple of the unit.
  std::uint64_t in_units(double x) const
  {
    const double units = x * m_per_unit;
    if (std::abs(units) < 0x1p62)
      return std::uint64_t(std::int64_t(units));
    const double n = std::fmod(units, 0x1p64);
    return n < 0 ? -std::uint64_t(-n) : std::uint64_t(n);
  }
  double from_units(std::uint64_t n) const { return double(std::int64_t(n)) * m_unit; }

  Periodic_cell_2 m_cell;
  double m_unit, m_per_unit;
  std::uint64_t m_ax, m_ay, m_bx, m_by;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_LATTICE_2_H
