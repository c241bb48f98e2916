// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_ERRORS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_ERRORS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Decimal_number.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <tuple>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

The base of every exception that the package throws for bad input or wrong use. Each is thrown
before anything changes.
*/
class Dynamic_Delaunay_triangulation_error_2 : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

namespace Dynamic_Delaunay_triangulations_2::internal {

// An error with values, which its accessors name, and a message joined from texts and numbers.
template <class... Values>
class Error_with : public Dynamic_Delaunay_triangulation_error_2
{
protected:
  using Error = Error_with;

  template <class... Parts>
  explicit Error_with(const std::tuple<Values...>& values, const Parts&... parts)
    : Dynamic_Delaunay_triangulation_error_2(message_text(parts...))
    , m_values(values)
  {
  }

  template <std::size_t i>
  const auto& value() const
  {
    return std::get<i>(m_values);
  }

private:
  std::tuple<Values...> m_values;
};

} // namespace Dynamic_Delaunay_triangulations_2::internal

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

The coordinates of a point are refused: the base of `Non_finite_coordinate_error_2`,
`Coordinate_range_error_2` and `Periodic_range_error_2`.
*/
class Coordinate_error_2
  : public Dynamic_Delaunay_triangulations_2::internal::Error_with<std::size_t, double, double>
{
public:
  /// \cond
  template <class... Parts>
  Coordinate_error_2(std::size_t id, double x, double y, const char* name, const Parts&... demand)
    : Error({id, x, y}, name, " ", id, " has the coordinates (", x, ", ", y, "): ", demand...)
  {
  }
  /// \endcond

  /// the id of the point; a place in the range, from 0 on, if a `Dynamic_population_2`, a
  /// distributed triangulation or a query for places throws it.
  std::size_t id() const { return value<0>(); }
  /// its first coordinate, as a double.
  double x() const { return value<1>(); }
  /// its second coordinate, as a double.
  double y() const { return value<2>(); }
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

A coordinate is NaN or infinite, or too large for a double. A number of an exact kernel that is not
a double itself may count as too large from half of the largest double on.
*/
class Non_finite_coordinate_error_2 : public Coordinate_error_2
{
public:
  /// \cond
  Non_finite_coordinate_error_2(std::size_t id, double x, double y, const char* name = "point")
    : Coordinate_error_2(id, x, y, name, "both must be finite numbers")
  {
  }
  /// \endcond
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

A coordinate is so large that the kernel's predicates are not exact. Only programs that are compiled
for SSE4.1 or AVX (`-march=native`) have such a limit, 2^510 or 3.35e153: CGAL's interval arithmetic
gives wrong results there when it overflows. Without these instructions all finite doubles are
allowed.
*/
class Coordinate_range_error_2 : public Coordinate_error_2
{
public:
  /// \cond
  Coordinate_range_error_2(std::size_t id, double x, double y, double limit,
                           const char* name = "point")
    : Coordinate_error_2(id, x, y, name, "both must be smaller than ", limit,
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

A frame has too few or too many points, or a list, such as one of radii, weights or data, has too
few or too many entries. Points of a random-access range are counted before any of them is read.
*/
class Point_count_error_2
  : public Dynamic_Delaunay_triangulations_2::internal::Error_with<std::size_t, std::size_t>
{
public:
  /// \cond
  Point_count_error_2(std::size_t expected, std::size_t given,
                      const char* due = "in a frame one position for each id from 0 to the last, "
                                        "any one for those of removed points")
    : Error({expected, given}, "given are ", given, given == expected + 1 ? " or more" : "",
            " entries, and ", expected, " are due: ", due)
  {
  }
  /// \endcond

  /// the required number: of ids, of pieces of boundaries, or of points that the rank owns.
  std::size_t expected() const { return value<0>(); }
  /// the number that was given; `expected() + 1` means that many or more.
  std::size_t given() const { return value<1>(); }
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

There would be more points than the indices of 32 bits allow: 536,870,911. Points of a random-access
range are counted before any of them is read.
*/
class Point_limit_error_2
  : public Dynamic_Delaunay_triangulations_2::internal::Error_with<std::size_t, std::size_t>
{
public:
  /// \cond
  Point_limit_error_2(std::size_t number, std::size_t limit)
    : Error({number, limit}, "there would be ", number, number == limit + 1 ? " or more" : "",
            " points: a triangulation holds at most ", limit)
  {
  }
  /// \endcond

  /// the number of points that there would be; `limit() + 1` means that many or more.
  std::size_t number() const { return value<0>(); }
  /// the largest number of points that is allowed.
  std::size_t limit() const { return value<1>(); }
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

No point has this id.
*/
class Unknown_id_error_2
  : public Dynamic_Delaunay_triangulations_2::internal::Error_with<std::size_t, std::size_t>
{
public:
  /// \cond
  Unknown_id_error_2(std::size_t id, std::size_t number_of_ids)
    : Error({id, number_of_ids}, "there is no point with id ", id, ": ", reason(id, number_of_ids))
  {
  }
  /// \endcond

  /// the id that was asked for.
  std::size_t id() const { return value<0>(); }
  /// one more than the largest id ever in use.
  std::size_t number_of_ids() const { return value<1>(); }

private:
  static std::string reason(std::size_t id, std::size_t number_of_ids)
  {
    if (id < number_of_ids)
      return "it was removed";
    if (number_of_ids == 0)
      return "the triangulation never had any points";
    return "ids run from 0 to " + std::to_string(number_of_ids - 1);
  }
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

A classifier has named a vertex or an edge that does not exist.
*/
class Unknown_index_error_2
  : public Dynamic_Delaunay_triangulations_2::internal::Error_with<std::size_t, std::size_t>
{
public:
  /// \cond
  Unknown_index_error_2(const std::string& what, std::size_t index, std::size_t bound)
    : Error({index, bound}, "there is no ", what, " ", index, ": their indices are smaller than ",
            bound)
  {
  }
  /// \endcond

  /// the index.
  std::size_t index() const { return value<0>(); }
  /// one more than the largest valid index.
  std::size_t bound() const { return value<1>(); }
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

No point of a `Dynamic_population_2` or a distributed triangulation has this id.
*/
class Unknown_user_id_error_2
  : public Dynamic_Delaunay_triangulations_2::internal::Error_with<std::string>
{
public:
  /// \cond
  template <class Id>
  explicit Unknown_user_id_error_2(const Id& id)
    : Error({std::to_string(id)}, "there is no point with id ", std::to_string(id))
  {
  }
  /// \endcond

  /// the id that was asked for, in decimal digits, since user ids may be integers of any type.
  const std::string& id() const { return value<0>(); }
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

An id is given more than once in one call, or belongs to a point already.
*/
class Repeated_id_error_2
  : public Dynamic_Delaunay_triangulations_2::internal::Error_with<std::string>
{
public:
  /// \cond
  template <class Id>
  explicit Repeated_id_error_2(const Id& id)
    : Error({std::to_string(id)}, "the id ", std::to_string(id),
            " is there more than once: each may name one point only")
  {
  }
  /// \endcond

  /// the id, in decimal digits, since user ids may be integers of any type.
  const std::string& id() const { return value<0>(); }
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

The CGAL triangulation, or anything computed from it such as cells and nearest points, was asked for
while the triangulation is not proved Delaunay. Access is refused because CGAL's point location and
insertion may loop or abort on inverted faces.
*/
class Uncertified_triangulation_error_2 : public Dynamic_Delaunay_triangulation_error_2
{
public:
  /// \cond
  explicit Uncertified_triangulation_error_2(
      const std::string& what =
          "the triangulation is not certified after a heuristic update: call mend() to make it "
          "Delaunay, or certify() to find out whether it is; tds() and frame() can be read as it "
          "is")
    : Dynamic_Delaunay_triangulation_error_2(what)
  {
  }
  /// \endcond
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

A number is out of range: a parameter of a classifier or a policy, a radius, the size of a box, a
number of weights, or a load factor; or a load factor is not the same on all ranks.
*/
class Parameter_error_2 : public Dynamic_Delaunay_triangulations_2::internal::Error_with<double>
{
public:
  /// \cond
  Parameter_error_2(const std::string& name, double value, double lowest, double highest)
    : Error({value}, name, " is ", value, ": it must be from ", lowest, " to ", highest)
  {
  }
  Parameter_error_2(const std::string& name, double value, const std::string& demand)
    : Error({value}, name, " is ", value, ": it must be ", demand)
  {
  }
  /// \endcond

  /// the value that was given.
  double value() const { return Error::value<0>(); }
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

The corners of a domain are not those of a convex polygon, counterclockwise, or not those of a
simple polygon with holes where that is allowed; or the points are in periodic space, where no
domain may be set.
*/
class Domain_error_2 : public Dynamic_Delaunay_triangulations_2::internal::Error_with<std::size_t>
{
public:
  /// \cond
  Domain_error_2(std::size_t corner, const std::string& demand)
    : Error({corner}, "corner ", corner, " of the domain: ", demand)
  {
  }
  /// \endcond

  /// the number of the corner; corners of holes follow those of the outer boundary.
  std::size_t corner() const { return value<0>(); }
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

A periodic cell has parallel vectors, a number that is not finite, or proportions so extreme that
distances or translations cannot be computed; or it is not of the kind that is needed: a slab in
place of a cell with two vectors or the reverse, not a square for a conversion, or not the same on
all ranks.
*/
class Periodic_cell_error_2
  : public Dynamic_Delaunay_triangulations_2::internal::Error_with<double, double, double, double>
{
public:
  /// \cond
  Periodic_cell_error_2(double ax, double ay, double bx, double by, const std::string& demand)
    : Error({ax, ay, bx, by}, "a periodic cell has the vectors (", ax, ", ", ay, ") and (", bx,
            ", ", by, "): ", demand)
  {
  }
  /// \endcond

  double ax() const { return value<0>(); } ///< of the first vector.
  double ay() const { return value<1>(); } ///< of the first vector.
  double bx() const { return value<2>(); } ///< of the second vector, 0 in a slab.
  double by() const { return value<3>(); } ///< of the second vector, 0 in a slab.
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

A point or a place in periodic space is so many cells away from the origin that the translations
between neighbors could not be counted.
*/
class Periodic_range_error_2 : public Coordinate_error_2
{
public:
  /// \cond
  Periodic_range_error_2(std::size_t id, double x, double y, double limit,
                         const char* name = "point")
    : Coordinate_error_2(id, x, y, name,
                         "both of its multiples of the cell's vectors must be below ", limit,
                         " in absolute value")
  {
  }
  /// \endcond
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

A periodic triangulation cannot be converted: a point has no image in the domain without rounding,
or, in the plane, one sheet is not enough.
*/
class Periodic_conversion_error_2 : public Dynamic_Delaunay_triangulation_error_2
{
public:
  using Dynamic_Delaunay_triangulation_error_2::Dynamic_Delaunay_triangulation_error_2;
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

A checkpoint cannot be written, or is refused because it is incomplete, was changed or damaged, or
is not a checkpoint.
*/
class Checkpoint_error_2
  : public Dynamic_Delaunay_triangulations_2::internal::Error_with<std::size_t>
{
public:
  /// \cond
  Checkpoint_error_2(std::size_t line, const std::string& what)
    : Error({line}, "checkpoint", line > 0 ? ", line " + std::to_string(line) : "", ": ", what)
  {
  }
  /// \endcond

  /// the line, counted from 1 at the beginning of the checkpoint; 0 if the error concerns no line.
  std::size_t line() const { return value<0>(); }
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Errors

Another rank of a distributed triangulation was given bad input, and throws its own error; or ranks
have called different functions, which all of them throw. Nothing changes on any rank.
*/
class Distributed_input_error_2
  : public Dynamic_Delaunay_triangulations_2::internal::Error_with<int>
{
public:
  /// \cond
  explicit Distributed_input_error_2(int rank)
    : Error({rank}, "rank ", rank, " was given bad input, and says which")
  {
  }
  Distributed_input_error_2(int rank, const std::string& call_of_first, const std::string& call)
    : Error({rank}, "rank 0 calls ", call_of_first, ", and rank ", rank, " calls ", call,
            ": all ranks must call the same function")
  {
  }
  /// \endcond

  /// the first rank with bad input, or that has called another function than rank 0.
  int rank() const { return value<0>(); }
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_ERRORS_2_H
