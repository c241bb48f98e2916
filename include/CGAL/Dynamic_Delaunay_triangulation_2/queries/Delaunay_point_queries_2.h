// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_POINT_QUERIES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_POINT_QUERIES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Query_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Site_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Site_set_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_point_queries_base.h>
#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Finds the points that are nearest to a *query point*, which may be anywhere, or to one of the
points, or within a radius of it, in the plane, in a periodic cell or in a slab. It uses the
triangulation as it is, without another search structure and without a copy. The answers are exact,
and do not depend on which diagonals the triangulation has where points are cocircular.

In the plane an answer is the id of a point. In periodic space it is an image of a point: its id and
a shift. The image is at `point(id)` plus `shift[0]` times the cell's first vector plus `shift[1]`
times its second one, relative to the query point as it is given, wrapped or not. Answers are exact
for these images, which are never rounded. One point can have several images in a circle, or none.

Points that coincide have the same distance, and each of them counts. The ids are those of the
triangulation. For a `Dynamic_population_2`, `population.id(user_id)` and `population.user_id(id)`
convert between these and the user's ids.

An object refers to the triangulation, which must keep its address, but may change. Queries change
nothing visible, but they share memory of the object: several threads must not use the same object
at once, even if it is constant. Threads that query at the same time need one object each. Queries
for many query points at once need only one call, whose work threads share if the triangulation has
the `Parallel_tag`.

The manual proves that the answers are right, \ref DynamicDelaunaySubsection_Queries.

\tparam Dynamic a `Dynamic_Delaunay_triangulation_2`, whose `Geom_traits` have `Compare_distance_2`
  and `Compare_squared_distance_2`, as CGAL's kernels do, or a
  `Dynamic_periodic_Delaunay_triangulation_2`.

\sa `Delaunay_neighbor_lists_2`
*/
template <class Dynamic>
class Delaunay_point_queries_2
  : public Delaunay_point_queries_base<
        Delaunay_point_queries_2<Dynamic>, Dynamic,
        Dynamic_Delaunay_triangulations_2::internal::Query_2<
            Dynamic_Delaunay_triangulations_2::internal::State_of_2<Dynamic>>,
        typename Dynamic::Frame::Parts>
{
  using State = Dynamic_Delaunay_triangulations_2::internal::State_of_2<Dynamic>;
  using Query = Dynamic_Delaunay_triangulations_2::internal::Query_2<State>;
  using Base = Delaunay_point_queries_base<Delaunay_point_queries_2, Dynamic, Query,
                                           typename Dynamic::Frame::Parts>;
  friend Base;
  using Index = Dynamic_Delaunay_triangulations_2::Index;
  using Vertex_index = Dynamic_Delaunay_triangulations_2::Vertex_index;
  using Point_id = Dynamic_Delaunay_triangulations_2::Point_id;
  using Geometry = typename Query::Geometry;
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point;
  using Site = typename State::Site;

public:
  /// \name Types
  /// @{

  using typename Base::Answer;
  using typename Base::FT;
  using typename Base::Point;
  using typename Base::size_type;

  /// @}
  /// \name Creation
  /// @{

  /// creates queries for a triangulation, which need not have any points yet.
  explicit Delaunay_point_queries_2(const Dynamic& dt)
    : m_dt(&dt)
  {
  }

  /// @}
  /// \name Queries for Points
  /// As queries for query points, these throw `Uncertified_triangulation_error_2` unless the
  /// triangulation is certified, and `Parameter_error_2` for a squared radius that is not allowed.
  /// @{

  /// the point other than `id` that is nearest to the point `id`; if several are equally near, the
  /// smallest answer. No value if there is no other point. In periodic space the answer can be
  /// another image of the same point, so there always is one.
  ///
  /// Cost: proportional to the number of its neighbors.
  /// \throws Unknown_id_error_2 if no point has this id.
  std::optional<Answer> nearest_neighbor(size_type id) const
  {
    const Point& p = m_dt->point(id);
    const Floating_point floating_point;
    const Query query = query_at(p, 0);
    const Site v = query.site(m_dt->frame().vertex(id));
    const Answer asking = answer(id, Dynamic_Delaunay_triangulations_2::internal::no_shift);
    start_with(query, v);
    if (const std::optional<Answer> other = this->smallest_found(query, asking))
      return other;
    m_found.clear(query.state());
    typename Query::Measured nearest = query.measured(v);
    for_each_neighbor(query.geometry(), v, [&](const Site& w) {
      const typename Query::Measured other = query.measured(w);
      const Comparison_result result = m_found.empty() ? SMALLER : query.compare(other, nearest);
      if (result == SMALLER) {
        m_found.clear(query.state());
        nearest = other;
      }
      if (result != LARGER)
        m_found.insert(w);
    });
    return this->smallest_found(query, asking);
  }

  /// writes all points within a radius of the point `id`, except `id` itself, to `answers`, in no
  /// particular order. In periodic space other images of that point are written.
  ///
  /// Cost: proportional to the number of points found and of their neighbors; in periodic space
  /// O(k log k) for k images found.
  /// \throws Unknown_id_error_2 if no point has this id.
  template <class OutputIterator>
  OutputIterator neighbors_within(size_type id, const FT& squared_radius,
                                  OutputIterator answers) const
  {
    const Point& p = m_dt->point(id);
    const Floating_point floating_point;
    const Query query = query_at(p, 0);
    check(squared_radius);
    return this->write_within(query, query.site(m_dt->frame().vertex(id)), squared_radius,
                              answer(id, Dynamic_Delaunay_triangulations_2::internal::no_shift),
                              answers);
  }

  /// @}

private:
  static void check(const FT& squared_radius)
  {
    Dynamic_Delaunay_triangulations_2::internal::check_extent("the squared radius",
                                                              CGAL::to_double(squared_radius));
  }

  static void check_for(const Query&, const FT& squared_radius) { check(squared_radius); }

  // Errors call p `number`, its number in a range.
  Query query_at(const Point& p, size_type number) const
  {
    return {Dynamic_Delaunay_triangulations_2::internal::certified_state(*m_dt), p, number};
  }

  static Answer answer(size_type id, const Periodic_shift_2& shift)
  {
    return Geometry::show(shift, [&](const auto&... its) { return Answer{id, its...}; });
  }

  std::optional<Answer> find_nearest(const Point& p, size_type number) const
  {
    const Floating_point floating_point;
    const Query query = query_at(p, number);
    if (m_dt->number_of_vertices() == 0)
      return std::nullopt;
    const typename Query::Measured v = walk(query);
    flood(query, v.site,
          [&](const Site& w) { return query.compare(query.measured(w), v) == EQUAL; });
    return this->smallest_found(query, std::nullopt);
  }

  // Returns a nearest site: moves to the nearest neighbor until none is nearer.
  typename Query::Measured walk(const Query& query) const
  {
    typename Query::Measured nearest = query.measured(query.site(start_of_walk(query)));
    Site last;
    do {
      last = nearest.site;
      for_each_neighbor(query.geometry(), last, [&](const Site& w) {
        const typename Query::Measured other = query.measured(w);
        if (query.compare(other, nearest) == SMALLER)
          nearest = other;
      });
    } while (!(nearest.site == last));
    m_last = State::vertex_of(nearest.site);
    return nearest;
  }

  // The nearest of the last answer and a few evenly spread vertices, whose numbers follow a spatial
  // order.
  Vertex_index start_of_walk(const Query& query) const
  {
    const Index bound = query.state().number_of_vertices() + 1;
    const Index step = Index(std::cbrt(double(bound) * bound)); // visits about n^(1/3)
    Vertex_index nearest = m_last < bound ? m_last : Vertex_index(1);
    double square = query.rounded_squared_distance(nearest);
    for (Vertex_index v(1); v < bound; v += step)
      if (const double other = query.rounded_squared_distance(v); other < square) {
        nearest = v;
        square = other;
      }
    return nearest;
  }

  void start_with(const Query& query, const Site& v) const
  {
    m_found.clear(query.state());
    m_found.insert(v);
  }

  // Finds all sites w with `belongs(w)` that are connected with v by such sites.
  template <class Predicate>
  void flood(const Query& query, const Site& v, const Predicate& belongs) const
  {
    start_with(query, v);
    m_open.assign(1, v);
    while (!m_open.empty()) {
      const Site from = m_open.back();
      m_open.pop_back();
      for_each_neighbor(query.geometry(), from, [&](const Site& w) {
        if (!m_found.contains(w) && belongs(w)) {
          m_found.insert(w);
          m_open.push_back(w);
        }
      });
    }
  }

  // Calls f(answer) for every point at the sites that were found, except for `asking`. The point of
  // a covered id may be another image than that of its representative.
  template <class Function>
  void for_each_found(const Query& query, const std::optional<Answer>& asking,
                      const Function& f) const
  {
    using Dynamic_Delaunay_triangulations_2::internal::operator+;
    using Dynamic_Delaunay_triangulations_2::internal::make_distinct;
    const auto call = [&](size_type id, const Periodic_shift_2& shift) {
      const Answer found = answer(id, shift);
      if (found != asking)
        f(found);
    };
    const auto& geometry = query.geometry();
    const auto& ids = query.state().ids();
    for (const Site& site : m_found)
      call(ids.representative(State::vertex_of(site)), geometry.shift(site));
    m_covered.clear();
    for (const Site& site : m_found)
      ids.for_each_covered_at(State::vertex_of(site),
                              [&](Point_id id, const auto&) { m_covered.push_back(id); });
    make_distinct(m_covered); // a vertex may have been found at several sites
    for (const auto id : m_covered) {
      const auto v = ids.vertex(id);
      m_found.for_each_at(v, [&](const Site& site) {
        call(id, geometry.shift(site) + geometry.shift_to(v, ids.covered_point(id)));
      });
    }
  }

  const Dynamic* m_dt;
  mutable Vertex_index m_last{1}; // the vertex found by the last walk
  mutable Dynamic_Delaunay_triangulations_2::internal::Site_set_2<Site> m_found;
  mutable std::vector<Site> m_open;        // sites whose neighbors flood() has still to visit
  mutable std::vector<Point_id> m_covered; // at the vertices that were found
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_POINT_QUERIES_2_H
