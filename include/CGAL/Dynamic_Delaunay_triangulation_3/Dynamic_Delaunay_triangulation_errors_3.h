// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DYNAMIC_DELAUNAY_TRIANGULATION_ERRORS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DYNAMIC_DELAUNAY_TRIANGULATION_ERRORS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <array>
#include <cstddef>
#include <string>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

The coordinates of a point in space are refused: the base of `Non_finite_coordinate_error_3` and
`Coordinate_range_error_3`. Other errors are those of the plane, such as `Point_count_error_2` and
`Unknown_id_error_2`.
*/
class Coordinate_error_3
  : public Dynamic_Delaunay_triangulations_2::internal::Error_with<std::size_t, double, double,
                                                                   double>
{
public:
  /// \cond
  template <class... Parts>
  Coordinate_error_3(std::size_t id, double x, double y, double z, const Parts&... demand)
    : Error({id, x, y, z}, "point ", id, " has the coordinates (", x, ", ", y, ", ", z,
            "): ", demand...)
  {
  }
  /// \endcond

  /// the id of the point.
  std::size_t id() const { return value<0>(); }
  /// its first coordinate, as a double.
  double x() const { return value<1>(); }
  /// its second coordinate, as a double.
  double y() const { return value<2>(); }
  /// its third coordinate, as a double.
  double z() const { return value<3>(); }
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

A coordinate of a point in space is NaN or infinite, or too large for a double.
*/
class Non_finite_coordinate_error_3 : public Coordinate_error_3
{
public:
  /// \cond
  Non_finite_coordinate_error_3(std::size_t id, double x, double y, double z)
    : Coordinate_error_3(id, x, y, z, "all three must be finite numbers")
  {
  }
  /// \endcond
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

A coordinate of a point in space is so large that the kernel's predicates are not exact. Only
programs that are compiled for SSE4.1 or AVX have such a limit, 2^250 or 1.8e75; without these
instructions all finite doubles are allowed (see `Coordinate_range_error_2`).
*/
class Coordinate_range_error_3 : public Coordinate_error_3
{
public:
  /// \cond
  Coordinate_range_error_3(std::size_t id, double x, double y, double z, double limit)
    : Coordinate_error_3(id, x, y, z, "all three must be smaller than ", limit,
                         " in absolute value where CGAL is compiled for SSE4.1 or AVX")
    , m_limit(limit)
  {
  }
  /// \endcond

  /// the limit: absolute values of coordinates must be smaller.
  double limit() const { return m_limit; }

private:
  double m_limit;
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

The vectors of a periodic cell in space are not finite, or in a plane, those of a slab parallel, or
doubles cannot tell how far points are apart in the cell; or a cell cannot take the place of another
one, since only one of them is a slab.
*/
class Periodic_cell_error_3
  : public Dynamic_Delaunay_triangulations_2::internal::Error_with<
        std::array<double, 3>, std::array<double, 3>, std::array<double, 3>>
{
public:
  /// \cond
  Periodic_cell_error_3(const std::array<double, 3>& a, const std::array<double, 3>& b,
                        const std::array<double, 3>& c, const std::string& demand)
    : Error({a, b, c}, "a periodic cell has the vectors (", a[0], ", ", a[1], ", ", a[2], "), (",
            b[0], ", ", b[1], ", ", b[2], ") and (", c[0], ", ", c[1], ", ", c[2], "): ", demand)
  {
  }
  // Of a slab.
  Periodic_cell_error_3(const std::array<double, 3>& a, const std::array<double, 3>& b,
                        const std::string& demand)
    : Error({a, b, std::array<double, 3>{0, 0, 0}}, "a slab has the vectors (", a[0], ", ", a[1],
            ", ", a[2], ") and (", b[0], ", ", b[1], ", ", b[2], "): ", demand)
  {
  }
  // Of a wire.
  Periodic_cell_error_3(const std::array<double, 3>& a, const std::string& demand)
    : Error({a, std::array<double, 3>{0, 0, 0}, std::array<double, 3>{0, 0, 0}},
            "a wire has the vector (", a[0], ", ", a[1], ", ", a[2], "): ", demand)
  {
  }
  /// \endcond

  const std::array<double, 3>& a() const { return value<0>(); } ///< the first vector.
  const std::array<double, 3>& b() const { return value<1>(); } ///< the second one, 0 of a wire.
  /// the third one, 0 of a slab or a wire.
  const std::array<double, 3>& c() const { return value<2>(); }
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

A point in periodic space is so many cells away from the origin that the translations between
neighbors could not be counted.
*/
class Periodic_range_error_3 : public Coordinate_error_3
{
public:
  /// \cond
  Periodic_range_error_3(std::size_t id, double x, double y, double z, double limit)
    : Coordinate_error_3(id, x, y, z, "all of its multiples of the cell's vectors must be below ",
                         limit, " in absolute value")
  {
  }
  /// \endcond
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DYNAMIC_DELAUNAY_TRIANGULATION_ERRORS_3_H
