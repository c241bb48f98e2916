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
  using FT = typename Geometry::Coordinate; // of a squared distance
  using Answer = typename Geometry::Answer;
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

  static bool is_before(const Answer& a, const Answer& b) { return a < b; }

  // A site, and an interval of its squared distance.
  struct Measured
  {
    Site site;
    double least, most;
  };

  // Without an error of coordinates, that of the square is at most 20u times the square, where
  // u = 2^-53. Taken twice, the bound covers the sum or difference that makes an end.
  Measured measured(const Site& a) const
  {
    double e = 0;
    const Position_2 v = m_geometry.rough_vector(m_point, a, e);
    const double square = dot(v, v);
    const double error = e == 0 ? 0x1p-48 * square + 1e-300 : 2 * error_of_product(v, v, e);
    return {a, square - error, square + error};
  }

  Comparison_result compare(const Measured& a, const Measured& b) const
  {
    const Comparison_result result = filtered(a, b.least, b.most);
    return result != EQUAL ? result : m_geometry.compare_distances(m_point, a.site, b.site);
  }

  template <class FT>
  Comparison_result compare_square(const Measured& a, const FT& other) const
  {
    const auto [lower, upper] = CGAL::to_interval(other);
    const Comparison_result result = lower == upper ? filtered(a, lower, upper) : EQUAL;
    return result != EQUAL ? result : m_geometry.compare_squared_distance(m_point, a.site, other);
  }

private:
  // EQUAL if undecided, as where something overflows.
  static Comparison_result filtered(const Measured& a, double least, double most)
  {
    return a.most < least ? SMALLER : most < a.least ? LARGER : EQUAL;
  }

  const Geometry m_geometry;
  const typename Geometry::Query_point m_point;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_QUERY_2_H
