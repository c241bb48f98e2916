// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DELAUNAY_POINT_QUERIES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DELAUNAY_POINT_QUERIES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_point_queries_base.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/certified_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Distance_query_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Site_charts_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Vertex_star_3.h>
#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Finds the points in space that are nearest to a *query point*, which may be anywhere, or to one of
the points, or within a radius of it, in open or in periodic space. It uses the triangulation as it
is, without another search structure and without a copy. The answers are exact, and do not depend on
which of several triangulations of cospherical points is there.

In open space an answer is the id of a point. In periodic space it is an image of a point: its id
and a shift. The image is at `point(id)` plus `shift[0]`, `shift[1]` and `shift[2]` times the cell's
vectors, relative to the query point as it is given, wrapped or not. Answers are exact for these
images, which are never rounded. One point can have several images in a ball, or none.

Points that coincide have the same distance, and each of them counts.

An object refers to the triangulation, which must keep its address, but may change. Queries change
nothing visible, but they share memory of the object: several threads must not use the same object
at once, even if it is constant. Threads that query at the same time need one object each. Queries
for many query points at once need only one call, whose work threads share if the triangulation has
the `Parallel_tag`.

The answers are right for the reasons that hold in the plane (\ref
DynamicDelaunaySubsection_Queries). Whoever is not nearest has a neighbor that is nearer. Without
cells, for points in a plane or on a line in open space, each query looks at all points.

\tparam Dynamic a `Dynamic_Delaunay_triangulation_3`, whose `Geom_traits` have `Compare_distance_3`
  and `Compare_squared_distance_3`, as CGAL's kernels do, or a
  `Dynamic_periodic_Delaunay_triangulation_3`.

\sa `Delaunay_neighbor_lists_3`
*/
template <class Dynamic>
class Delaunay_point_queries_3
  : public Delaunay_point_queries_base<
        Delaunay_point_queries_3<Dynamic>, Dynamic,
        Dynamic_Delaunay_triangulations_3::internal::Distance_query_3<
            Dynamic_Delaunay_triangulations_3::internal::State_of_3<Dynamic>>,
        typename Dynamic_Delaunay_triangulations_3::internal::State_of_3<Dynamic>::Parts>
{
  using Point_id = Dynamic_Delaunay_triangulations_3::Point_id;
  using Vertex_index = Dynamic_Delaunay_triangulations_3::Vertex_index;
  using Index = Dynamic_Delaunay_triangulations_3::Index;
  using State = Dynamic_Delaunay_triangulations_3::internal::State_of_3<Dynamic>;
  using Charts = Dynamic_Delaunay_triangulations_3::internal::Site_charts_3<typename State::Arrays>;
  using Site = typename Charts::Site;
  using Seen_cell = typename Charts::Seen_cell;
  using Query = Dynamic_Delaunay_triangulations_3::internal::Distance_query_3<State>;
  using Measured = typename Query::Measured;
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point;
  using Base =
      Delaunay_point_queries_base<Delaunay_point_queries_3, Dynamic, Query, typename State::Parts>;
  friend Base;

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
  explicit Delaunay_point_queries_3(const Dynamic& dt)
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
    const Point p = m_dt->point(id);
    const Floating_point floating_point;
    const Query query = query_at(p, 0);
    const Site v = query.site(query.state().ids.vertex(Point_id(id)));
    const Answer asking = Query::answer(id);
    m_found.assign(1, v);
    if (!query.state().ids.is_alone(Point_id(id)))
      return this->smallest_found(query, asking);
    m_found.clear();
    std::optional<Measured> nearest;
    for_each_neighbor(query.state(), v, [&](const Site& w) {
      const Measured other = query.measured(w);
      const Comparison_result result = nearest ? query.compare(other, *nearest) : SMALLER;
      if (result == SMALLER) {
        m_found.clear();
        nearest = other;
      }
      if (result != LARGER)
        m_found.push_back(w);
    });
    return this->smallest_found(query, asking);
  }

  /// writes all points within a radius of the point `id`, except `id` itself, to `answers`, in no
  /// particular order. In periodic space other images of that point are written.
  ///
  /// Cost: proportional to the number of points found and of their neighbors.
  /// \throws Unknown_id_error_2 if no point has this id.
  template <class OutputIterator>
  OutputIterator neighbors_within(size_type id, const FT& squared_radius,
                                  OutputIterator answers) const
  {
    const Point p = m_dt->point(id);
    const Floating_point floating_point;
    const Query query = query_at(p, 0);
    check_for(query, squared_radius);
    return this->write_within(query, query.site(query.state().ids.vertex(Point_id(id))),
                              squared_radius, Query::answer(id), answers);
  }

  /// @}

private:
  static void check(const FT& squared_radius, double largest = (std::numeric_limits<double>::max)())
  {
    Dynamic_Delaunay_triangulations_2::internal::check_extent(
        "the squared radius", CGAL::to_double(squared_radius), largest);
  }

  static void check_for(const Query& query, const FT& squared_radius)
  {
    check(squared_radius, query.largest_squared_radius());
  }

  // Errors call p `number`, its number in a range.
  Query query_at(const Point& p, size_type number) const
  {
    return {Dynamic_Delaunay_triangulations_3::internal::certified_state(*m_dt), p, number};
  }

  std::optional<Answer> find_nearest(const Point& p, size_type number) const
  {
    const Floating_point floating_point;
    const Query query = query_at(p, number);
    if (query.state().number_of_vertices() == 0)
      return std::nullopt;
    const Measured v = walk(query);
    if (!m_found.empty()) // others are as near
      flood(query, v.site,
            [&](const Site& w) { return query.compare(query.measured(w), v) == EQUAL; });
    else
      m_found.assign(1, v.site);
    return this->smallest_found(query, std::nullopt);
  }

  static bool has_cells(const State& state) { return state.spans_space; }

  // Calls f(w, cell) for each neighbor w of a site, with a cell of both, until f returns false; a
  // neighbor may come twice. `first` is a cell of the site. Without cells, all other vertices are
  // neighbors, or their images beside the site.
  template <class Function>
  void visit_neighbors(const State& state, const Site& v, const Seen_cell& first,
                       const Function& f) const
  {
    if (has_cells(state))
      return m_star.for_each_neighbor(state.arrays, v, first, f);
    for (Vertex_index n(1); n <= state.number_of_vertices(); ++n)
      for (const Site& w : Query::sites_beside(state, v, n))
        if (!(w == v) && !f(w, first))
          return;
  }
  template <class Function>
  void for_each_neighbor(const State& state, const Site& v, const Function& f) const
  {
    visit_neighbors(state, v, cell_of(state, v), [&](const Site& w, const Seen_cell&) {
      f(w);
      return true;
    });
  }

  static Seen_cell cell_of(const State& state, const Site& v)
  {
    return has_cells(state) ? Charts::first_cell(state.arrays, v) : Seen_cell();
  }

  // Returns a nearest site: moves on to the next neighbor that is nearer until there is none.
  // `m_found` then has neighbors that are as near.
  Measured walk(const Query& query) const
  {
    Measured nearest = query.measured(query.site(start_of_walk(query)));
    Seen_cell cell = cell_of(query.state(), nearest.site);
    Site last;
    do {
      last = nearest.site;
      m_found.clear();
      visit_neighbors(query.state(), last, cell, [&](const Site& w, const Seen_cell& of_both) {
        const Measured other = query.measured(w);
        const Comparison_result result = query.compare(other, nearest);
        if (result == EQUAL)
          m_found.push_back(w);
        if (result != SMALLER)
          return true;
        nearest = other;
        cell = of_both;
        return false;
      });
    } while (!(nearest.site == last));
    m_last = Charts::vertex_of(last);
    return nearest;
  }

  // The last answer, if it is near; otherwise the nearest of it and a few evenly spread vertices,
  // whose numbers follow a spatial order.
  Vertex_index start_of_walk(const Query& query) const
  {
    const Index bound = query.state().number_of_vertices() + 1;
    Vertex_index nearest = m_last < bound ? m_last : Vertex_index(1);
    double square = query.rounded_squared_distance(nearest);
    if (square <= 16 * squared_edge_length(query, nearest))
      return nearest; // some four steps away
    // if a visit takes about a sixtieth of the time of a step: some 10 n^(1/4) visits
    const Index step = 1 + Index(std::pow(double(bound), 0.75) / 10);
    for (Vertex_index v(1); v < bound; v += step)
      if (const double other = query.rounded_squared_distance(v); other < square) {
        nearest = v;
        square = other;
      }
    return nearest;
  }

  // Of the shortest edge of a vertex in one of its cells; 0 without cells.
  static double squared_edge_length(const Query& query, Vertex_index number)
  {
    const State& state = query.state();
    if (!has_cells(state))
      return 0;
    const Site v = Charts::site(number);
    const Seen_cell cell = Charts::first_cell(state.arrays, v);
    double shortest = std::numeric_limits<double>::infinity();
    for (int place = 0; place < 4; ++place)
      if (const Site w = Charts::site(state.arrays, cell, place);
          !(w == v) && !Charts::is_infinite(w))
        shortest = (std::min)(shortest, query.rounded_squared_length(v, w));
    return shortest;
  }

  // Finds all sites w with `belongs(w)` that are connected with v by such sites.
  template <class Predicate>
  void flood(const Query& query, const Site& v, const Predicate& belongs) const
  {
    m_found.assign(1, v);
    m_visited.clear();
    m_visited.insert(Charts::key(v));
    for (size_type n = 0; n < m_found.size(); ++n)
      for_each_neighbor(query.state(), Site(m_found[n]), [&](const Site& w) {
        if (m_visited.insert(Charts::key(w)) && belongs(w))
          m_found.push_back(w);
      });
  }

  // Calls f(answer) for every point at the sites that were found, except for `asking`.
  template <class Function>
  void for_each_found(const Query& query, const std::optional<Answer>& asking,
                      const Function& f) const
  {
    for (const Site& v : m_found)
      query.for_each_answer(v, [&](const Answer& answer) {
        if (answer != asking)
          f(answer);
      });
  }

  const Dynamic* m_dt;
  mutable Vertex_index m_last{1}; // the vertex found by the last walk
  mutable Dynamic_Delaunay_triangulations_3::internal::Star_cells_3<typename State::Arrays> m_star;
  mutable Dynamic_Delaunay_triangulations_3::internal::Sparse_set_3<typename Charts::Key> m_visited;
  mutable std::vector<Site> m_found;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DELAUNAY_POINT_QUERIES_3_H
