// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_DISTANCE_QUERY_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_DISTANCE_QUERY_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_Delaunay_triangulation_errors_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_cells_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_shift_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_shift_3.h>
#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <tuple>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// A site, and an interval of its squared distance from a query point.
template <class Site_>
struct Measured_site_3
{
  Site_ site;
  double least, most;

  // EQUAL if undecided, as where something overflows.
  Comparison_result compare_with(double other_least, double other_most) const
  {
    return most < other_least ? SMALLER : other_most < least ? LARGER : EQUAL;
  }
};

// Compares the distances of sites from a query point exactly: in doubles, and without rounding
// where these leave it undecided. Says what answers users get for sites: in open space ids.
template <class State, class Arrays = typename State::Arrays>
class Distance_query_3
{
public:
  using Point = typename State::Point;
  using FT = typename State::Traits::FT; // of a squared distance
  using Measured = Measured_site_3<Vertex_index>;
  using Answer = std::size_t;

  // Throws unless p is a valid point: the error calls it `number`. Both must outlive this object.
  Distance_query_3(const State& state, const Point& p, std::size_t number)
    : m_state(state)
    , m_point(p)
    , m_position(checked_position(p, number))
    , m_is_exact(state.positions_are_exact && has_exact_position(p))
  {
  }

  const State& state() const { return m_state; }

  // The site of a vertex that is next to the query point: exactly there if one of them is.
  static Vertex_index site(Vertex_index v) { return v; }
  static Few<Vertex_index, 1> sites_beside(const State&, Vertex_index, Vertex_index v)
  {
    return {v};
  }
  static Answer answer(std::size_t id) { return id; }
  static bool is_before(const Answer& a, const Answer& b) { return a < b; }
  // Calls f(answer) for every point at a site.
  template <class Function>
  void for_each_answer(Vertex_index v, const Function& f) const
  {
    f(Answer(m_state.ids.representative(v)));
    m_state.ids.for_each_covered_at(v, [&](Point_id id, const auto&) { f(Answer(id)); });
  }

  // Of balls in which all sites can be told.
  static double largest_squared_radius() { return (std::numeric_limits<double>::max)(); }

  double rounded_squared_distance(Vertex_index v) const
  {
    return squared_length(m_state.positions.position(v) - m_position);
  }

  double rounded_squared_length(Vertex_index v, Vertex_index w) const
  {
    return squared_length(m_state.positions.position(w) - m_state.positions.position(v));
  }

  // The square is off by at most 3u times the sum of the squares, where u = 2^-53, and by what
  // underflows. Taken twice, the bound covers the sum or difference that makes an end.
  Measured measured(Vertex_index v) const
  {
    if (!m_is_exact)
      return {v, 0, std::numeric_limits<double>::infinity()};
    const double square = rounded_squared_distance(v), error = 0x1p-48 * square + 1e-300;
    return {v, square - error, square + error};
  }

  Comparison_result compare(const Measured& a, const Measured& b) const
  {
    const Comparison_result result = a.compare_with(b.least, b.most);
    return result != EQUAL ? result
                           : m_state.traits.compare_distance_3_object()(
                                 m_point, m_state.point(a.site), m_state.point(b.site));
  }

  Comparison_result compare_square(const Measured& a, const FT& other) const
  {
    const auto [lower, upper] = CGAL::to_interval(other);
    const Comparison_result result = lower == upper ? a.compare_with(lower, upper) : EQUAL;
    return result != EQUAL ? result
                           : m_state.traits.compare_squared_distance_3_object()(
                                 m_point, m_state.point(a.site), other);
  }

private:
  const State& m_state;
  const Point& m_point;
  const Position_3 m_position;
  const bool m_is_exact;
};

// On a torus sites are images. The query point is seen at its image in the basis' parallelepiped,
// where the vertices are; answers are ids with shifts from where it was given.
template <class State>
class Distance_query_3<State, Torus_cells_3>
{
public:
  using Point = typename State::Point;
  using FT = typename State::Traits::FT; // of a squared distance
  using Site = Torus_site_3;
  using Measured = Measured_site_3<Site>;
  using Answer = std::pair<std::size_t, Periodic_shift_3>;

  Distance_query_3(const State& state, const Point& p, std::size_t number)
    : m_state(state)
    , m_point(image_of(p, number))
    , m_error(std::sqrt((std::max)(state.squared_error, error_of(m_point))))
  {
  }

  const State& state() const { return m_state; }

  Site site(Vertex_index v) const { return {v, Torus_shift_3::of(multiples_at(v))}; }
  // In a wire, images of a vertex that are as high along it as a site, or up to one and a half
  // vectors higher or lower: those in a ball, and those nearest to a place, are connected by steps
  // between such sites.
  static Few<Site, 5> sites_beside(const State& state, const Site& s, Vertex_index v)
  {
    // not from the position of s, which is NaN where its shift is large
    const Position_3 way = state.positions.position(s.vertex) - state.positions.position(v);
    const int nearest = s.shift.multiples()[0] + Torus_3::nearest(state.torus.fractions(way))[0];
    Few<Site, 5> sites;
    for (int i = 0; i < 5; ++i)
      sites[i] = {v, Torus_shift_3::of({nearest + i - 2, 0, 0})};
    return sites;
  }
  static Answer answer(std::size_t id) { return {id, Periodic_shift_3{0, 0, 0}}; }
  // That of the pairs. (g++ 12 warns that their arrays, when compared, may be uninitialized.)
  static bool is_before(const Answer& a, const Answer& b)
  {
    return std::tie(a.first, a.second[0], a.second[1], a.second[2]) <
           std::tie(b.first, b.second[0], b.second[1], b.second[2]);
  }
  template <class Function>
  void for_each_answer(const Site& site, const Function& f) const
  {
    const auto call = [&](std::size_t id, const Multiples_3& of_point) {
      const Multiples_3 m = of_point + site.shift.multiples() - m_point.multiples;
      f(Answer(id, m_state.torus.in_vectors_of_cell(m)));
    };
    const Vertex_index v = site.vertex;
    call(m_state.ids.representative(v), m_state.positions.multiples(v));
    m_state.ids.for_each_covered_at(
        v, [&](Point_id id, const Point& p) { call(id, m_state.place_near(p, v).multiples); });
  }

  // Shifts have multiples below 2^9. Those of an edge are few.
  double largest_squared_radius() const
  {
    const Torus_3& torus = m_state.torus;
    const double thickness = (std::min)({torus.height(0), torus.height(1), torus.height(2)});
    return 0x1p16 * thickness * thickness;
  }

  double rounded_squared_distance(Vertex_index v) const
  {
    return squared_length(m_state.positions.position(v) +
                          m_state.torus.combination(multiples_at(v)) - m_point.rounded);
  }
  double rounded_squared_length(const Site& v, const Site& w) const
  {
    return squared_length(m_state.position(w) - m_state.position(v));
  }

  // As in open space, where the length is off by `m_error` besides: a NaN, where that does not
  // hold, leaves everything undecided.
  Measured measured(const Site& s) const
  {
    const double square = squared_length(m_state.position(s) - m_point.rounded);
    const double error =
        0x1p-48 * square + m_error * (2.01 * std::sqrt(square) + 1.01 * m_error) + 1e-300;
    return {s, square - error, square + error};
  }

  Comparison_result compare(const Measured& a, const Measured& b) const
  {
    const Comparison_result result = a.compare_with(b.least, b.most);
    return result != EQUAL ? result : CGAL::compare(exact_square(a.site), exact_square(b.site));
  }
  Comparison_result compare_square(const Measured& a, double other) const
  {
    const Comparison_result result = a.compare_with(other, other);
    return result != EQUAL ? result : CGAL::compare(exact_square(a.site), Exact_number_3(other));
  }

private:
  Torus_point_3 image_of(const Point& p, std::size_t number) const
  {
    const Position_3 base = approximation(p);
    if (!is_finite(base))
      throw Non_finite_coordinate_error_3(number, base.x, base.y, base.z);
    if (!m_state.torus.is_in_range(base))
      throw Periodic_range_error_3(number, base.x, base.y, base.z, Torus_3::max_multiple);
    const Multiples_3 m = Multiples_3{0, 0, 0} - Torus_3::floor(m_state.torus.fractions(base));
    return {base, m, base + m_state.torus.combination(m)};
  }

  // The square of a bound on the length by which rounding moves vectors from such a point. Those of
  // the state hold for images of vertices; of both, half the bound is for each end.
  double error_of(const Torus_point_3& p) const
  {
    const auto largest = [](const Position_3& q) {
      return (std::max)({std::abs(q.x), std::abs(q.y), std::abs(q.z)});
    };
    const Multiples_3& m = p.multiples;
    return m_state.torus.squared_error((std::max)(largest(p.base), largest(p.rounded)),
                                       double(std::abs(m[0])) + std::abs(m[1]) + std::abs(m[2]));
  }

  // By which v must be shifted to be next to the query point.
  Multiples_3 multiples_at(Vertex_index v) const
  {
    return Torus_3::nearest(
        m_state.torus.fractions(m_point.rounded - m_state.positions.position(v)));
  }

  Exact_number_3 exact_square(const Site& s) const
  {
    const Exact_vector_3 v = m_state.torus.exact_vector(m_point, m_state.image(s));
    return dot(v, v);
  }

  const State& m_state;
  const Torus_point_3 m_point;
  const double m_error;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_DISTANCE_QUERY_3_H
