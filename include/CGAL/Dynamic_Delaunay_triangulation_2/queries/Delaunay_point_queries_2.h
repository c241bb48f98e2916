// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_POINT_QUERIES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_POINT_QUERIES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Query_parts_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Vertex_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Finds the points that are nearest to a place or to a point, or within a radius of it. It uses the
triangulation as it is, without another search structure and without a copy. The answers are exact,
and do not depend on which diagonals the triangulation has where points are cocircular.

Points that coincide have the same distance, and each of them counts. The ids are those of the
triangulation. For a `Dynamic_population_2`, `population.id(user_id)` and `population.user_id(id)`
convert between these and the user's ids.

An object refers to the triangulation, which must keep its address, but may change. Queries change
nothing visible, but they share memory of the object: several threads must not use the same object
at once, even if it is constant. Threads that query at the same time need one object each. Queries
for many places at once need only one call, whose work threads share if the triangulation has the
`Parallel_tag`.

<b>Correctness.</b> The Voronoi cell of a point \f$v\f$ is the intersection of half-planes, one for
each of its sides: the places that are no nearer to \f$w\f$ than to \f$v\f$, where \f$w\f$ is the
point beyond that side. Such a \f$w\f$ is a neighbor of \f$v\f$ in every Delaunay triangulation,
because circles around inner places of the side pass through \f$v\f$ and \f$w\f$, and no other point
is on or in them. So if \f$v\f$ is not among the points nearest to a place \f$q\f$, then \f$q\f$ is
not in its cell, one of the half-planes does not contain \f$q\f$, and <em>a neighbor of \f$v\f$ is
nearer to \f$q\f$</em>.

Moving on to a nearer neighbor therefore ends at a nearest point, from every start. In reverse, the
same paths lead from the nearest points to all points within any radius of \f$q\f$. No path leaves
the disk, as distances to \f$q\f$ only decrease along it. There may be several nearest points. They
are on a circle around \f$q\f$ with no point inside, and the sides of the convex polygon that they
span are edges of every Delaunay triangulation. Hence *the points in a disk are connected by edges
between them*. A search from a nearest point that does not continue from points outside finds them
all (Dickerson, Drysdale: *Fixed-radius near neighbors search algorithms for points and segments*,
Information Processing Letters 35, 1990). The point nearest to a given point is one of its
neighbors: the disk around their midpoint with both on its boundary contains no other point.

\tparam Dynamic a `Dynamic_Delaunay_triangulation_2`, whose `Geom_traits` have `Compare_distance_2`
  and `Compare_squared_distance_2`, as CGAL's kernels do.

\sa `Delaunay_neighbor_lists_2`
*/
template <class Dynamic>
class Delaunay_point_queries_2
{
  using Index = Dynamic_Delaunay_triangulations_2::Index;
  using Distances = Dynamic_Delaunay_triangulations_2::internal::Distances_2<Dynamic>;
  using Neighbors = Dynamic_Delaunay_triangulations_2::internal::Finite_neighbors_2<Dynamic>;

public:
  /// \name Types
  /// @{

  /// the triangulation.
  using Triangulation = Dynamic;
  /// a point.
  using Point = typename Dynamic::Point;
  /// a squared distance.
  using FT = typename Dynamic::Geom_traits::FT;
  /// the type of ids.
  using size_type = std::size_t;

  /// @}
  /// \name Creation
  /// @{

  /// creates queries for a triangulation, which need not have any points yet.
  explicit Delaunay_point_queries_2(const Dynamic& dt)
    : m_dt(&dt)
  {
  }

  /// @}
  /// \name Queries
  /// All of them throw `Uncertified_triangulation_error_2` unless the triangulation is certified.
  /// If points coincide, each query also takes time proportional to the number of those.
  /// @{

  /// the id of the point that is nearest to `p`; of several, the smallest id. No value if there are
  /// no points.
  ///
  /// Cost: O(n<sup>1/3</sup>) expected for evenly spread points, less if the answer is near the
  /// last one. \throws Non_finite_coordinate_error_2 if a coordinate of `p` is NaN or infinite.
  /// \throws Coordinate_range_error_2 if a coordinate of `p` is too large for this program.
  std::optional<size_type> nearest(const Point& p) const { return find_nearest(p, 0); }

  /// writes `nearest(p)` for each place p of a range, in their order.
  ///
  /// Cost: that of the queries, which threads share, but those for places that follow each other in
  /// space are faster.
  /// \param first, beyond the range of places.
  /// \param ids where to write; nothing is written if this throws.
  /// \tparam ForwardIterator has the value type `Point`.
  /// \tparam OutputIterator takes values of `std::optional<size_type>`.
  /// \return where the next id would be written.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  /// \throws Coordinate_range_error_2 if a coordinate is too large for this program. Both say which
  /// place of the range that is.
  template <class ForwardIterator, class OutputIterator>
  OutputIterator nearest(ForwardIterator first, ForwardIterator beyond, OutputIterator ids) const
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const std::vector<Point> places(first, beyond);
    std::vector<std::optional<size_type>> found(places.size());
    query_in_parts<Parts>(*this, places.size(),
                          [&](const Delaunay_point_queries_2& queries, std::size_t i) {
                            found[i] = queries.find_nearest(places[i], i);
                          });
    return std::copy(found.begin(), found.end(), ids);
  }

  /// the id of the point that is nearest to the point `id`, other than itself; of several, the
  /// smallest id. No value if there is no other point.
  ///
  /// Cost: proportional to the number of its neighbors.
  /// \throws Unknown_id_error_2 if no point has this id.
  std::optional<size_type> nearest_neighbor(size_type id) const
  {
    const Distances distances(*m_dt, m_dt->point(id));
    const Neighbors around(*m_dt);
    const Index v = vertex(id);
    start_with(v);
    if (const std::optional<size_type> other = smallest_id(id))
      return other;
    m_found.clear(bound());
    around.for_each(v, [&](Index w) {
      const Comparison_result result = m_found.empty() ? EQUAL : distances.compare(w, m_found[0]);
      if (result == SMALLER)
        m_found.clear(bound());
      if (result != LARGER)
        m_found.insert(w);
    });
    return smallest_id(id);
  }

  /// writes the ids of all points within a radius of `p`, including those on the circle, to `ids`,
  /// in no particular order.
  ///
  /// Cost: that of `nearest()`, plus time proportional to the number of points found and of their
  /// neighbors.
  /// \param p the center of the circle.
  /// \param squared_radius the square of its radius, which makes it an exact number.
  /// \param ids where to write.
  /// \tparam OutputIterator takes values of `size_type`.
  /// \return where the next id would be written.
  /// \throws Parameter_error_2 if the squared radius is negative or not a finite number.
  /// \throws Non_finite_coordinate_error_2 if a coordinate of `p` is NaN or infinite.
  /// \throws Coordinate_range_error_2 if a coordinate of `p` is too large for this program.
  template <class OutputIterator>
  OutputIterator within(const Point& p, const FT& squared_radius, OutputIterator ids) const
  {
    return find_within(p, 0, squared_radius, ids);
  }

  /// lists the ids of all points within a radius of each place of a range. Those of the i-th place
  /// are `ids[begins[i]]` to `ids[begins[i + 1] - 1]`, in ascending order.
  ///
  /// Cost: that of the queries, which threads share, and O(k log k) for k points found.
  /// \param first, beyond the range of places.
  /// \param squared_radius the square of the radius.
  /// \param ids the ids for all places; replaced, and not changed if this throws.
  /// \param begins where those of each place begin, and in the end the number of all of them;
  /// replaced, and not changed if this throws.
  /// \tparam ForwardIterator has the value type `Point`.
  /// \throws Parameter_error_2 if the squared radius is negative or not a finite number.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  /// \throws Coordinate_range_error_2 if a coordinate is too large for this program. Both say which
  /// place of the range that is.
  template <class ForwardIterator>
  void within(ForwardIterator first, ForwardIterator beyond, const FT& squared_radius,
              std::vector<size_type>& ids, std::vector<size_type>& begins) const
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    check(squared_radius);
    const std::vector<Point> places(first, beyond);
    list_in_parts<Parts>(*this, places.size(), ids, begins,
                         [&](const Delaunay_point_queries_2& queries, std::size_t i, auto found) {
                           queries.find_within(places[i], i, squared_radius, found);
                         });
  }

  /// the same, but around the point `id`, which is not written itself.
  ///
  /// Cost: proportional to the number of points found and of their neighbors.
  /// \param id the id of the point at the center.
  /// \param squared_radius the square of the radius.
  /// \param ids where to write.
  /// \tparam OutputIterator takes values of `size_type`.
  /// \return where the next id would be written.
  /// \throws Unknown_id_error_2 if no point has this id.
  /// \throws Parameter_error_2 if the squared radius is negative or not a finite number.
  template <class OutputIterator>
  OutputIterator neighbors_within(size_type id, const FT& squared_radius, OutputIterator ids) const
  {
    const Distances distances(*m_dt, m_dt->point(id));
    check(squared_radius);
    return write_within(vertex(id), distances, squared_radius, id, ids);
  }

  /// @}

private:
  using Parts = typename Dynamic::Frame::Parts;

  static constexpr size_type no_id = size_type(-1);

  static void check(const FT& squared_radius)
  {
    constexpr double largest = (std::numeric_limits<double>::max)();
    const double value = CGAL::to_double(squared_radius);
    if (!(value >= 0 && value <= largest))
      throw Parameter_error_2("the squared radius", value, 0, largest);
  }

  // `number` is that of the place in its range, for errors.
  std::optional<size_type> find_nearest(const Point& p, size_type number) const
  {
    const Distances distances(*m_dt, p, number);
    if (m_dt->number_of_vertices() == 0)
      return std::nullopt;
    const Index v = walk(distances);
    flood(v, [&](Index w) { return distances.compare(w, v) == EQUAL; });
    return smallest_id(no_id);
  }

  template <class OutputIterator>
  OutputIterator find_within(const Point& p, size_type number, const FT& squared_radius,
                             OutputIterator ids) const
  {
    const Distances distances(*m_dt, p, number);
    check(squared_radius);
    if (m_dt->number_of_vertices() == 0)
      return ids;
    const Index v = walk(distances);
    if (distances.compare_square(v, squared_radius) == LARGER)
      return ids;
    return write_within(v, distances, squared_radius, no_id, ids);
  }

  Index vertex(size_type id) const { return m_dt->frame().vertex(Index(id)); }
  Index bound() const { return m_dt->frame().number_of_vertices() + 1; }

  // Returns a nearest vertex. Starts at the nearest of the last answer and a few evenly spread
  // vertices (their numbers follow a spatial order), and moves to the nearest neighbor until none
  // is nearer.
  Index walk(const Distances& distances) const
  {
    const Neighbors around(*m_dt);
    const Index step = Index(std::cbrt(double(bound()) * bound())); // visits about n^(1/3)
    Index nearest = m_last < bound() ? m_last : 1;
    double square = distances.approximate_square(nearest);
    for (Index v = 1; v < bound(); v += step)
      if (const double other = distances.approximate_square(v); other < square) {
        nearest = v;
        square = other;
      }
    do {
      m_last = nearest;
      around.for_each(m_last, [&](Index w) {
        if (distances.compare(w, nearest) == SMALLER)
          nearest = w;
      });
    } while (nearest != m_last);
    return nearest;
  }

  void start_with(Index v) const
  {
    m_found.clear(bound());
    m_found.insert(v);
  }

  // Finds all vertices w with `belongs(w)` that are connected with v by such vertices.
  template <class Predicate>
  void flood(Index v, const Predicate& belongs) const
  {
    const Neighbors around(*m_dt);
    start_with(v);
    for (std::size_t i = 0; i < m_found.size(); ++i)
      around.for_each(m_found[i], [&](Index w) {
        if (!m_found.contains(w) && belongs(w))
          m_found.insert(w);
      });
  }

  // Calls f(id) for every point at the vertices that were found, except the one that asks.
  template <class Function>
  void for_each_found(size_type asking, const Function& f) const
  {
    const auto frame = m_dt->frame();
    const auto call_if_other = [&](Index id) {
      if (id != asking)
        f(size_type(id));
    };
    for (const Index v : m_found)
      call_if_other(frame.id(v));
    frame.for_each_duplicate([&](Index id) {
      if (m_found.contains(frame.vertex(id)))
        call_if_other(id);
    });
  }

  std::optional<size_type> smallest_id(size_type asking) const
  {
    std::optional<size_type> smallest;
    for_each_found(asking, [&](size_type id) {
      if (!smallest || id < *smallest)
        smallest = id;
    });
    return smallest;
  }

  template <class OutputIterator>
  OutputIterator write_within(Index v, const Distances& distances, const FT& squared_radius,
                              size_type asking, OutputIterator ids) const
  {
    flood(v, [&](Index w) { return distances.compare_square(w, squared_radius) != LARGER; });
    for_each_found(asking, [&](size_type id) { *ids++ = id; });
    return ids;
  }

  const Dynamic* m_dt;
  mutable Index m_last = 1; // the vertex found by the last walk
  mutable Dynamic_Delaunay_triangulations_2::internal::Index_set_2 m_found;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_POINT_QUERIES_2_H
