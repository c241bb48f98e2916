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

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

The cell of a periodic space: a parallelepiped, given by three vectors that are not in a plane, of
any lengths, at any angles, in any order. Translations by integer combinations of these vectors map
that space to itself.

A cell can also be a slab, given by two vectors along which everything is repeated. Space is open
across them, as between two walls, or around a film or a membrane. Or it is a wire, given by one
vector: space is open across it, as around a nanowire, a tube or a fiber, or inside of a pipe.
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

  /// the slab that is repeated by these vectors, each given by its coordinates, and open across
  /// them.
  /// \throws Periodic_cell_error_3 if a number is not finite, or the vectors are parallel, or so
  /// nearly that no double is the sine of their angle.
  Periodic_cell_3(const Coordinates& a, const Coordinates& b)
    : m_vectors{a, b, normal(a, b)}
    , m_dimension(2)
  {
  }

  /// the wire that is repeated by this vector, given by its coordinates, and open across it.
  /// \throws Periodic_cell_error_3 if a number is not finite, or all are 0.
  explicit Periodic_cell_3(const Coordinates& a)
    : m_vectors{a, across(a), {0, 0, 0}}
    , m_dimension(1)
  {
    m_vectors[2] = normal(a, m_vectors[1]);
  }

  /// the cell with these vectors, of any type with `x()`, `y()` and `z()`.
  /// \throws Periodic_cell_error_3 if a number is not finite, or the vectors are in a plane.
  template <class Vector, class = decltype(std::declval<const Vector&>().x())>
  Periodic_cell_3(const Vector& a, const Vector& b, const Vector& c)
    : Periodic_cell_3(Coordinates{a.x(), a.y(), a.z()}, Coordinates{b.x(), b.y(), b.z()},
                      Coordinates{c.x(), c.y(), c.z()})
  {
  }

  /// the slab with these vectors, of any type with `x()`, `y()` and `z()`.
  /// \throws Periodic_cell_error_3 as above.
  template <class Vector, class = decltype(std::declval<const Vector&>().x())>
  Periodic_cell_3(const Vector& a, const Vector& b)
    : Periodic_cell_3(Coordinates{a.x(), a.y(), a.z()}, Coordinates{b.x(), b.y(), b.z()})
  {
  }

  /// the wire with this vector, of any type with `x()`, `y()` and `z()`.
  /// \throws Periodic_cell_error_3 as above.
  template <class Vector, class = decltype(std::declval<const Vector&>().x())>
  explicit Periodic_cell_3(const Vector& a)
    : Periodic_cell_3(Coordinates{a.x(), a.y(), a.z()})
  {
  }

  /// whether there are two vectors, across which space is open.
  bool is_slab() const { return m_dimension == 2; }
  /// whether there is one vector, across which space is open.
  bool is_wire() const { return m_dimension == 1; }
  /// the number of vectors along which everything is repeated: 3, 2 of a slab, or 1 of a wire.
  int dimension() const { return m_dimension; }

  const Coordinates& a() const { return m_vectors[0]; } ///< the first vector.
  /// the second vector, which in a wire is about a unit vector across the first one.
  const Coordinates& b() const { return m_vectors[1]; }
  /// the third vector, which in a slab or a wire is about a unit vector along the cross product of
  /// the others.
  const Coordinates& c() const { return m_vectors[2]; }
  /// the vector with this number, which is 0, 1 or 2.
  const Coordinates& vector(std::size_t number) const { return m_vectors[number]; }

  /// the volume of the cell, rounded; that of a slab or a wire is infinite.
  double volume() const
  {
    if (m_dimension < 3)
      return std::numeric_limits<double>::infinity();
    const auto minor = [this](std::size_t i, std::size_t j) {
      return b()[i] * c()[j] - b()[j] * c()[i];
    };
    return std::abs(a()[0] * minor(1, 2) + a()[1] * minor(2, 0) + a()[2] * minor(0, 1));
  }

  /// whether both cells are repeated by the same vectors.
  friend bool operator==(const Periodic_cell_3& c, const Periodic_cell_3& d)
  {
    return c.m_vectors == d.m_vectors && c.m_dimension == d.m_dimension;
  }
  /// whether the cells differ.
  friend bool operator!=(const Periodic_cell_3& c, const Periodic_cell_3& d) { return !(c == d); }

private:
  // About a unit vector along a x b.
  static Coordinates normal(const Coordinates& a, const Coordinates& b)
  {
    const Dynamic_Delaunay_triangulations_2::internal::Default_floating_point arithmetic;
    for (const Coordinates* const v : {&a, &b})
      for (const double x : *v)
        if (!std::isfinite(x))
          throw Periodic_cell_error_3(a, b, "its numbers must be finite");
    using Exact = internal::Exact_ring_selector<double>::Type;
    const Coordinates p = scaled(a), q = scaled(b);
    const auto minor = [&](std::size_t i, std::size_t j) {
      return CGAL::to_double(Exact(p[i]) * Exact(q[j]) - Exact(p[j]) * Exact(q[i]));
    };
    const Coordinates cross = scaled({minor(1, 2), minor(2, 0), minor(0, 1)});
    const double length = std::hypot(cross[0], cross[1], cross[2]);
    if (!(length > 0))
      throw Periodic_cell_error_3(a, b, "its vectors must not be parallel");
    return {cross[0] / length, cross[1] / length, cross[2] / length};
  }
  // A unit vector across a: along the cross product of a and the axis that is farthest from it.
  static Coordinates across(const Coordinates& a)
  {
    const Dynamic_Delaunay_triangulations_2::internal::Default_floating_point arithmetic;
    for (const double x : a)
      if (!std::isfinite(x))
        throw Periodic_cell_error_3(a, "its numbers must be finite");
    const auto smallest = std::min_element(
        a.begin(), a.end(), [](double x, double y) { return std::abs(x) < std::abs(y); });
    Coordinates axis{0, 0, 0};
    axis[std::size_t(smallest - a.begin())] = 1;
    if (a == Coordinates{0, 0, 0})
      throw Periodic_cell_error_3(a, "its vector must not be 0");
    return normal(a, axis);
  }
  // A vector in units of a power of two that is about as large as its largest coordinate.
  static Coordinates scaled(const Coordinates& v)
  {
    const double largest = (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    if (!(largest > 0))
      return v;
    const int exponent = std::ilogb(largest);
    return {std::scalbn(v[0], -exponent), std::scalbn(v[1], -exponent),
            std::scalbn(v[2], -exponent)};
  }

  std::array<Coordinates, 3> m_vectors;
  int m_dimension = 3;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_PERIODIC_CELL_3_H
