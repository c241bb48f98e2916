// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_POINT_QUERIES_2_H
#define CGAL_DELAUNAY_POINT_QUERIES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Vertex_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Who is nearest to a place, or to a point, and who is within a radius of it: answered by the
triangulation as it is, without another search structure and without a copy. The answers are exact,
and do not depend on which diagonals the triangulation has where points are cocircular.

Points that coincide are as near as each other; each of them counts. The ids are those of the
triangulation. In a `Dynamic_population_2` these are `population.id(user_id)`, and
`population.user_id(id)` is the way back.

An object refers to the triangulation, which has to stay where it is, and may change. Queries change
nothing that shows, but share memory of the object's own: an object, also a constant one, is not to
be asked from several threads at once. Threads that ask at the same time need one each.

<b>Why it is right.</b> The Voronoi cell of a point \f$v\f$ is the intersection of half-planes, one
for each of its sides: those of the places that are no nearer to \f$w\f$ than to \f$v\f$, where
\f$w\f$ is the point beyond that side. Such a \f$w\f$ is a neighbor of \f$v\f$ in every Delaunay
triangulation, because circles around the inner places of the side pass through \f$v\f$ and \f$w\f$
and neither through nor around anybody else. So, if \f$v\f$ is not among the nearest to a place
\f$q\f$, then \f$q\f$ is not in its cell, one of the half-planes does not have it, and
<em>a neighbor of \f$v\f$ is nearer to \f$q\f$</em>.

Going on to a nearer neighbor therefore ends at a nearest point, from everywhere. Seen from there,
the same ways back lead to all points within any radius of \f$q\f$, and no way leaves the disc, as
its distances only decrease towards \f$q\f$. There may be several nearest points; they are on a
circle around \f$q\f$ with nobody inside, and the sides of the convex polygon that they are the
corners of are edges of every Delaunay triangulation. Hence *the points in a disc are connected by
edges between them*, and a search from a nearest one that does not go on from points outside finds
them all (Dickerson, Drysdale: *Fixed-radius near neighbors search algorithms for points and
segments*, Information Processing Letters 35, 1990). The nearest to a point is one of its neighbors:
the disc around the middle between both, with both on its boundary, has nobody else.

\tparam Dynamic a `Dynamic_Delaunay_triangulation_2`, whose `Geom_traits` have
`Compare_distance_2` and `Compare_squared_distance_2`, as CGAL's kernels do.

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

  /// asks a triangulation, which need not have any points yet.
  explicit Delaunay_point_queries_2(const Dynamic& dt)
    : m_dt(&dt)
  {
  }

  /// @}
  /// \name Queries
  /// All of them throw `Uncertified_triangulation_error_2` unless the triangulation is certified.
  /// Where points coincide, each takes time for all of those besides.
  /// @{

  /// the id of the point that is nearest to `p`; of several, the smallest id. Nobody, if there are
  /// no points.
  ///
  /// Cost: O(n<sup>1/3</sup>) expected for evenly spread points, less if the answer is near the
  /// last one. \throws Non_finite_coordinate_error_2 if a coordinate of `p` is NaN or infinite.
  /// \throws Coordinate_range_error_2 if a coordinate of `p` is too large for this program.
  std::optional<size_type> nearest(const Point& p) const
  {
    const Distances distances(*m_dt, p);
    if (m_dt->number_of_vertices() == 0)
      return std::nullopt;
    const Index v = walk(distances);
    flood(v, [&](Index w) { return distances.compare(w, v) == EQUAL; });
    return smallest_id(no_id);
  }

  /// the id of the point that is nearest to the point `id`, other than itself; of several, the
  /// smallest id. Nobody, if there is no other point.
  ///
  /// Cost: that of the number of its neighbors.
  /// \throws Unknown_id_error_2 if there is no such point.
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

  /// writes the ids of all points within a radius of `p`, those on the circle among them, to `ids`,
  /// in no particular order.
  ///
  /// Cost: that of `nearest()`, and that of the number of points that are found and of their
  /// neighbors.
  /// \param p the center of the circle.
  /// \param squared_radius the square of its radius: so it is a number that is known exactly.
  /// \param ids where to write.
  /// \tparam OutputIterator takes values of `size_type`.
  /// \return where the next id would be written.
  /// \throws Parameter_error_2 if the squared radius is negative, or no finite number.
  /// \throws Non_finite_coordinate_error_2 if a coordinate of `p` is NaN or infinite.
  /// \throws Coordinate_range_error_2 if a coordinate of `p` is too large for this program.
  template <class OutputIterator>
  OutputIterator within(const Point& p, const FT& squared_radius, OutputIterator ids) const
  {
    const Distances distances(*m_dt, p);
    check(squared_radius);
    if (m_dt->number_of_vertices() == 0)
      return ids;
    const Index v = walk(distances);
    if (distances.compare_square(v, squared_radius) == LARGER)
      return ids;
    return write_within(v, distances, squared_radius, no_id, ids);
  }

  /// the same around the point `id`, which is not written itself.
  ///
  /// Cost: that of the number of points that are found and of their neighbors.
  /// \param id whose place is the center.
  /// \param squared_radius the square of the radius.
  /// \param ids where to write.
  /// \tparam OutputIterator takes values of `size_type`.
  /// \return where the next id would be written.
  /// \throws Unknown_id_error_2 if there is no such point.
  /// \throws Parameter_error_2 if the squared radius is negative, or no finite number.
  template <class OutputIterator>
  OutputIterator neighbors_within(size_type id, const FT& squared_radius, OutputIterator ids) const
  {
    const Distances distances(*m_dt, m_dt->point(id));
    check(squared_radius);
    return write_within(vertex(id), distances, squared_radius, id, ids);
  }

  /// @}

private:
  static constexpr size_type no_id = size_type(-1);

  static void check(const FT& squared_radius)
  {
    constexpr double largest = (std::numeric_limits<double>::max)();
    const double value = CGAL::to_double(squared_radius);
    if (!(value >= 0 && value <= largest))
      throw Parameter_error_2("the squared radius", value, 0, largest);
  }

  Index vertex(size_type id) const { return m_dt->frame().vertex(Index(id)); }
  Index bound() const { return m_dt->frame().number_of_vertices() + 1; }

  // A nearest vertex: from the nearest one of a few that are spread evenly, which are numbered
  // along the plane, and the last one that was found, to the nearest of all neighbors, and so on.
  Index walk(const Distances& distances) const
  {
    const Neighbors around(*m_dt);
    const Index step = Index(std::cbrt(double(bound()) * bound())); // about n^(1/3) of them
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

  // Finds all vertices that `belongs(w)` and that are connected with v by such.
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

  // Calls f(id) for every point at the vertices that were found, but for the one that asks.
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
  mutable Index m_last = 1; // vertex that was nearest
  mutable Dynamic_Delaunay_triangulations_2::internal::Index_set_2 m_found;
};

} // namespace CGAL

#endif // CGAL_DELAUNAY_POINT_QUERIES_2_H
