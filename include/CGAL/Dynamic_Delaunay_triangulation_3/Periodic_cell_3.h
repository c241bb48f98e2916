// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_PERIODIC_CELL_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_PERIODIC_CELL_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_Delaunay_triangulation_errors_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_shift_3.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/Number_types/internal/Exact_type_selector.h>

#include <array>
#include <cmath>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

The cell of a periodic space: a parallelepiped, given by three vectors that are not in a plane, of
any lengths, at any angles, in any order. Translations by integer combinations of these vectors map
that space to itself.
*/
class Periodic_cell_3
{
public:
  /// three coordinates.
  using Coordinates = std::array<double, 3>;

  /// the box with these sides.
  /// \throws Periodic_cell_error_3 if a side is 0 or not finite.
  Periodic_cell_3(double width, double depth, double height)
    : Periodic_cell_3(Coordinates{width, 0, 0}, Coordinates{0, depth, 0}, Coordinates{0, 0, height})
  {
  }

  /// the cell with these vectors, each given by its coordinates.
  /// \throws Periodic_cell_error_3 if a number is not finite, or the vectors are in a plane.
  Periodic_cell_3(const Coordinates& a, const Coordinates& b, const Coordinates& c)
    : m_vectors{a, b, c}
  {
    const Dynamic_Delaunay_triangulations_2::internal::Default_floating_point arithmetic;
    for (const Coordinates& v : m_vectors)
      for (const double x : v)
        if (!std::isfinite(x))
          throw Periodic_cell_error_3(a, b, c, "its numbers must be finite");
    using Exact = internal::Exact_ring_selector<double>::Type;
    const auto minor = [&](std::size_t i, std::size_t j) {
      return Exact(b[i]) * Exact(c[j]) - Exact(b[j]) * Exact(c[i]);
    };
    if (CGAL::is_zero(Exact(a[0]) * minor(1, 2) + Exact(a[1]) * minor(2, 0) +
                      Exact(a[2]) * minor(0, 1)))
      throw Periodic_cell_error_3(a, b, c, "its vectors must not be in a plane");
  }

  /// the cell with these vectors, of any type with `x()`, `y()` and `z()`.
  /// \throws Periodic_cell_error_3 if a number is not finite, or the vectors are in a plane.
  template <class Vector, class = decltype(std::declval<const Vector&>().x())>
  Periodic_cell_3(const Vector& a, const Vector& b, const Vector& c)
    : Periodic_cell_3(Coordinates{a.x(), a.y(), a.z()}, Coordinates{b.x(), b.y(), b.z()},
                      Coordinates{c.x(), c.y(), c.z()})
  {
  }

  const Coordinates& a() const { return m_vectors[0]; } ///< the first vector.
  const Coordinates& b() const { return m_vectors[1]; } ///< the second vector.
  const Coordinates& c() const { return m_vectors[2]; } ///< the third vector.
  /// the vector with this number, which is 0, 1 or 2.
  const Coordinates& vector(std::size_t number) const { return m_vectors[number]; }

  /// the volume of the cell, rounded.
  double volume() const
  {
    const auto minor = [this](std::size_t i, std::size_t j) {
      return b()[i] * c()[j] - b()[j] * c()[i];
    };
    return std::abs(a()[0] * minor(1, 2) + a()[1] * minor(2, 0) + a()[2] * minor(0, 1));
  }

  /// whether both cells have the same vectors.
  friend bool operator==(const Periodic_cell_3& c, const Periodic_cell_3& d)
  {
    return c.m_vectors == d.m_vectors;
  }
  /// whether the cells differ.
  friend bool operator!=(const Periodic_cell_3& c, const Periodic_cell_3& d) { return !(c == d); }

private:
  std::array<Coordinates, 3> m_vectors;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_PERIODIC_CELL_3_H
