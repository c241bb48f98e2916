// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_POINT_QUERIES_BASE_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_POINT_QUERIES_BASE_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Query_parts.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

What `Delaunay_point_queries_2` and `Delaunay_point_queries_3` have in common: queries for query
points, one or many. Programs use it as a part of these classes alone.

\tparam Derived the class of queries.
\tparam Dynamic the class of triangulations.
\tparam Query, Parts internal types: a query, and how threads share many.
*/
template <class Derived, class Dynamic, class Query, class Parts>
class Delaunay_point_queries_base
{
public:
  /// \name Types
  /// @{

  /// the triangulation.
  using Triangulation = Dynamic;
  /// a point.
  using Point = typename Dynamic::Point;
  /// a squared distance: the number type of `Geom_traits`; in a periodic cell or a slab of the
  /// plane `double`.
  using FT = typename Query::FT;
  /// the type of ids.
  using size_type = std::size_t;
  /// what is found: an id; in periodic space an image, which is a pair of an id and a
  /// `Periodic_shift_2` or a `Periodic_shift_3`. Images are in the order of ids, then of their
  /// shifts, as arrays are compared.
  using Answer = typename Query::Answer;

  /// @}
  /// \name Queries for Query Points
  /// They throw `Uncertified_triangulation_error_2` unless the triangulation is certified; only an
  /// empty range of query points needs no certificate. If points coincide, each query also takes
  /// time proportional to the number of points that share the vertices it finds.
  ///
  /// They throw `Non_finite_coordinate_error_2` if a coordinate is NaN or infinite,
  /// `Coordinate_range_error_2` if it is too large for this program, and in periodic space
  /// `Periodic_range_error_2` if the query point is 2<sup>20</sup> cells or more from the origin;
  /// in space the errors of the same names that end with `_3`. For a range of query points, `id()`
  /// of these errors is the number of the query point.
  ///
  /// Queries within a radius take its square, which can be exact where the radius is not, and throw
  /// `Parameter_error_2` if that is negative or not a finite number. In periodic cells in space
  /// they also throw it if the radius is larger than 256 times the thickness of the cell, or of a
  /// shorter one of the same lattice. Queries with an `OutputIterator`, which takes values of
  /// `Answer` if nothing else is said, return where the next answer would be written.
  /// @{

  /// the point that is nearest to `p`; if several are equally near, the smallest answer. No value
  /// if there are no points.
  ///
  /// Cost: O(n<sup>1/3</sup>) expected for evenly spread points, in space O(n<sup>1/4</sup>), in
  /// periodic space in a cell that is not thin; less if the answer is near the last one.
  std::optional<Answer> nearest(const Point& p) const { return derived().find_nearest(p, 0); }

  /// writes `nearest(p)` for each query point p of a range, in their order.
  ///
  /// Cost: that of the queries, which threads share, but those for points that follow each other in
  /// space are faster.
  /// \param first, beyond the range of query points.
  /// \param answers where to write; nothing is written if this throws.
  /// \tparam ForwardIterator has the value type `Point`.
  /// \tparam OutputIterator takes values of `std::optional<Answer>`.
  /// \return where the next answer would be written.
  template <class ForwardIterator, class OutputIterator>
  OutputIterator nearest(ForwardIterator first, ForwardIterator beyond,
                         OutputIterator answers) const
  {
    const std::vector<Point> points(first, beyond);
    std::vector<std::optional<Answer>> found(points.size());
    Dynamic_Delaunay_triangulations_2::internal::query_in_parts<Parts>(
        derived(), points.size(), [&](const Derived& queries, size_type i, size_type) {
          found[i] = queries.find_nearest(points[i], i);
        });
    return std::copy(found.begin(), found.end(), answers);
  }

  /// writes all points within a radius of `p`, including those on the circle or sphere, to
  /// `answers`, in no particular order.
  ///
  /// Cost: that of `nearest()`, plus time proportional to the number of points found and of their
  /// neighbors; in a periodic cell or a slab of the plane O(k log k) for k images found.
  template <class OutputIterator>
  OutputIterator within(const Point& p, const FT& squared_radius, OutputIterator answers) const
  {
    return derived().find_within(p, 0, squared_radius, answers);
  }

  /// lists all points within a radius of each query point of a range. Those of the i-th are
  /// `answers[begins[i]]` to `answers[begins[i + 1] - 1]`, in ascending order.
  ///
  /// Cost: that of the queries, which threads share, and O(k log k) for k points found.
  /// \param first, beyond the range of query points.
  /// \param squared_radius the square of the radius.
  /// \param answers receives the answers for all query points; does not change if this throws.
  /// \param begins receives where the answers for each query point begin, and at its end the number
  /// of all answers; does not change if this throws.
  /// \tparam ForwardIterator has the value type `Point`.
  template <class ForwardIterator>
  void within(ForwardIterator first, ForwardIterator beyond, const FT& squared_radius,
              std::vector<Answer>& answers, std::vector<size_type>& begins) const
  {
    Derived::check(squared_radius);
    const std::vector<Point> points(first, beyond);
    Dynamic_Delaunay_triangulations_2::internal::list_in_parts<Parts>(
        derived(), points.size(), answers, begins,
        [&](const Derived& queries, size_type i, auto found) {
          queries.find_within(points[i], i, squared_radius, found);
        });
  }

  /// @}

protected:
  /// \cond
  template <class OutputIterator>
  OutputIterator find_within(const Point& p, size_type number, const FT& squared_radius,
                             OutputIterator answers) const
  {
    const Dynamic_Delaunay_triangulations_2::internal::Default_floating_point floating_point;
    const Query query = derived().query_at(p, number);
    derived().check_for(query, squared_radius);
    if (query.state().number_of_vertices() == 0)
      return answers;
    const auto v = derived().walk(query);
    if (query.compare_square(v, squared_radius) == LARGER)
      return answers;
    return write_within(query, v.site, squared_radius, std::nullopt, answers);
  }

  // Writes the points at sites that are within the radius and connected with `v` by such sites,
  // except for `asking`.
  template <class Site, class OutputIterator>
  OutputIterator write_within(const Query& query, const Site& v, const FT& squared_radius,
                              const std::optional<Answer>& asking, OutputIterator answers) const
  {
    derived().flood(query, v, [&](const Site& w) {
      return query.compare_square(query.measured(w), squared_radius) != LARGER;
    });
    derived().for_each_found(query, asking, [&](const Answer& found) { *answers++ = found; });
    return answers;
  }

  std::optional<Answer> smallest_found(const Query& query,
                                       const std::optional<Answer>& asking) const
  {
    std::optional<Answer> smallest;
    derived().for_each_found(query, asking, [&](const Answer& found) {
      if (!smallest || Query::is_before(found, *smallest))
        smallest = found;
    });
    return smallest;
  }
  /// \endcond

private:
  const Derived& derived() const { return static_cast<const Derived&>(*this); }
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_POINT_QUERIES_BASE_H
