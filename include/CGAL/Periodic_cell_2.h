// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PERIODIC_CELL_2_H
#define CGAL_PERIODIC_CELL_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/Number_types/internal/Exact_type_selector.h>
#include <CGAL/Periodic_shift_2.h>

#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

The cell of a periodic space: a parallelogram, given by two vectors that are not parallel, of any
lengths, at any angle, in any order. Translations by integer combinations of these vectors map that
space to itself.

A cell can also be a slab: a strip without ends, given by one vector along which everything is
repeated. Space is open across that vector, as in a channel or between two walls.
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
    const Dynamic_Delaunay_triangulations_2::internal::Default_floating_point arithmetic;
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

  /// the slab that is repeated by this vector, of any type with `x()` and `y()`, and open across
  /// it.
  /// \throws Periodic_cell_error_2 if the vector's length is 0 or not finite.
  template <class Vector, class = decltype(std::declval<const Vector&>().x())>
  explicit Periodic_cell_2(const Vector& a)
    : Periodic_cell_2(slab(a.x(), a.y()))
  {
  }

  /// the slab that is repeated by the vector (ax, ay).
  /// \throws Periodic_cell_error_2 if the vector's length is 0 or not finite.
  static Periodic_cell_2 slab(double ax, double ay)
  {
    const double length = std::hypot(ax, ay);
    if (!(length > 0 && std::isfinite(length)))
      throw Periodic_cell_error_2(ax, ay, 0, 0,
                                  "the length of a slab's vector must be finite and not 0");
    Periodic_cell_2 cell(ax, ay, -ay / length, ax / length);
    cell.m_is_slab = true;
    return cell;
  }

  /// whether space is open across the first vector.
  bool is_slab() const { return m_is_slab; }

  /// the x-coordinate of the first vector.
  double ax() const { return m_ax; }
  /// the y-coordinate of the first vector.
  double ay() const { return m_ay; }
  /// the x-coordinate of the second vector, which in a slab is about a unit vector to the left of
  /// the first one.
  double bx() const { return m_bx; }
  /// the y-coordinate of the second vector.
  double by() const { return m_by; }

  /// the area of the cell, rounded; that of a slab is infinite.
  double area() const
  {
    return m_is_slab ? std::numeric_limits<double>::infinity()
                     : std::abs(m_ax * m_by - m_ay * m_bx);
  }

  /// whether both cells have the same vectors, and both or neither of them is a slab.
  friend bool operator==(const Periodic_cell_2& c, const Periodic_cell_2& d)
  {
    return c.m_ax == d.m_ax && c.m_ay == d.m_ay && c.m_bx == d.m_bx && c.m_by == d.m_by &&
           c.m_is_slab == d.m_is_slab;
  }
  /// whether the cells differ.
  friend bool operator!=(const Periodic_cell_2& c, const Periodic_cell_2& d) { return !(c == d); }

private:
  double m_ax, m_ay, m_bx, m_by;
  bool m_is_slab = false;
};

} // namespace CGAL

#endif // CGAL_PERIODIC_CELL_2_H
