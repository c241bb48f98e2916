// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_LATTICE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_LATTICE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/enum.h>
#include <CGAL/Periodic_cell_2.h>

#include <array>
#include <cmath>
#include <cstddef>
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

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_LATTICE_2_H
