// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_QUERY_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_QUERY_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Site_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>

#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// What a query asks about its point: a target of Point_location_2 that also compares the distances
// of sites exactly, in doubles, and without rounding where that is undecided.
template <class State>
class Query_2
{
public:
  using Geometry = Site_geometry_2<State>;
  using Point = typename Geometry::Point;
  using Site = typename Geometry::Site;

  // Throws unless p is a valid point: the error calls it `number`. Both must outlive this object.
  Query_2(const State& state, const Point& p, std::size_t number)
    : m_geometry(state)
    , m_point(m_geometry.query_point(p, number))
  {
  }

  const Geometry& geometry() const { return m_geometry; }
  const State& state() const { return m_geometry.state(); }
  const typename Geometry::Query_point& point() const { return m_point; }

  // How the query point sees a face, and a vertex.
  typename State::Chart chart_at(Halfedge_index h) const
  {
    return m_geometry.chart_near(m_point, h);
  }
  Site site(Vertex_index v) const { return m_geometry.site_near(m_point, v); }

  double rounded_squared_distance(Vertex_index v) const
  {
    return state().rounded_squared_distance(state().positions()[v], m_point.position);
  }
  Orientation orientation(const Site& a, const Site& b) const
  {
    return m_geometry.orientation(a, b, m_point);
  }
  bool is_at(const Site& site) const { return m_geometry.coincide(site, m_point); }

  // A site with its squared distance, rounded, and twice a bound on the error of that, which covers
  // the sum or difference that makes an end of the interval.
  struct Measured
  {
    Site site;
    double square, error;
  };

  // Without an error of coordinates, the bound is at most 20u times the square, where u = 2^-53.
  Measured measured(const Site& a) const
  {
    double e = 0;
    const Position_2 v = m_geometry.rough_vector(m_point, a, e);
    const double square = dot(v, v);
    return {a, square, e == 0 ? 0x1p-48 * square + 1e-300 : 2 * error_of_product(v, v, e)};
  }

  Comparison_result compare(const Measured& a, const Measured& b) const
  {
    const Comparison_result result = filtered(a.square, a.error, b.square, b.error);
    return result != EQUAL ? result : m_geometry.compare_distances(m_point, a.site, b.site);
  }

  template <class FT>
  Comparison_result compare_square(const Measured& a, const FT& other) const
  {
    const auto [lower, upper] = CGAL::to_interval(other);
    const Comparison_result result = lower == upper ? filtered(a.square, a.error, lower, 0) : EQUAL;
    return result != EQUAL ? result : m_geometry.compare_squared_distance(m_point, a.site, other);
  }

private:
  // EQUAL if undecided, as where something overflows.
  static Comparison_result filtered(double s, double error_of_s, double t, double error_of_t)
  {
    return s + error_of_s < t - error_of_t   ? SMALLER
           : t + error_of_t < s - error_of_s ? LARGER
                                             : EQUAL;
  }

  const Geometry m_geometry;
  const typename Geometry::Query_point m_point;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_QUERY_2_H
