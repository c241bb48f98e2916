// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PERIODIC_CELL_2_H
#define CGAL_PERIODIC_CELL_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Floating_point_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/Number_types/internal/Exact_type_selector.h>

#include <array>
#include <cmath>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

A translation of the lattice: `shift[0]` times the cell's first vector plus `shift[1]` times its
second one.
*/
using Periodic_shift_2 = std::array<int, 2>;

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

The cell of a periodic space, a parallelogram: two vectors that are not parallel, of any lengths, at
any angle, in any order. Translations by their integer combinations change nothing in that space.
*/
class Periodic_cell_2
{
public:
  /// the rectangle with these sides.
  /// \throws Periodic_cell_error_2 if a side is 0 or not finite.
  Periodic_cell_2(double width, double height)
    : Periodic_cell_2(width, 0, 0, height)
  {
  }

  /// the cell with the vectors (ax, ay) and (bx, by).
  /// \throws Periodic_cell_error_2 if a number is not finite, or the vectors are parallel.
  Periodic_cell_2(double ax, double ay, double bx, double by)
    : m_ax(ax)
    , m_ay(ay)
    , m_bx(bx)
    , m_by(by)
  {
    const Dynamic_Delaunay_triangulations_2::internal::Default_floating_point_2 arithmetic;
    for (const double x : {ax, ay, bx, by})
      if (!std::isfinite(x))
        throw Periodic_cell_error_2(ax, ay, bx, by, "its numbers must be finite");
    using Exact = internal::Exact_ring_selector<double>::Type;
    if (Exact(ax) * Exact(by) == Exact(ay) * Exact(bx))
      throw Periodic_cell_error_2(ax, ay, bx, by, "its vectors must not be parallel");
  }

  /// the cell with these vectors, of any type with `x()` and `y()`.
  /// \throws Periodic_cell_error_2 if a number is not finite, or the vectors are parallel.
  template <class Vector, class = decltype(std::declval<const Vector&>().x())>
  Periodic_cell_2(const Vector& a, const Vector& b)
    : Periodic_cell_2(a.x(), a.y(), b.x(), b.y())
  {
  }

  /// the first vector.
  double ax() const { return m_ax; }
  /// the first vector.
  double ay() const { return m_ay; }
  /// the second vector.
  double bx() const { return m_bx; }
  /// the second vector.
  double by() const { return m_by; }

  /// the area of the cell, rounded.
  double area() const { return std::abs(m_ax * m_by - m_ay * m_bx); }

  /// whether both cells have the same vectors.
  friend bool operator==(const Periodic_cell_2& c, const Periodic_cell_2& d)
  {
    return c.m_ax == d.m_ax && c.m_ay == d.m_ay && c.m_bx == d.m_bx && c.m_by == d.m_by;
  }
  /// whether they differ.
  friend bool operator!=(const Periodic_cell_2& c, const Periodic_cell_2& d) { return !(c == d); }

private:
  double m_ax, m_ay, m_bx, m_by;
};

} // namespace CGAL

#endif // CGAL_PERIODIC_CELL_2_H
