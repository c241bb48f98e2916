// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_SCALED_IMAGES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_SCALED_IMAGES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_cells_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_predicates_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_shift_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Scaled_sites_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_shift_3.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// A sum, and apart from it what rounding takes from each step. The result is as good as rounded
// once (Ogita, Rump and Oishi, 2005): a further error is below 2^-98 times the sum of all absolute
// values.
class Compensated_sum_3
{
public:
  void add(double a)
  {
    const double sum = m_sum + a, part = sum - m_sum;
    m_rest += (m_sum - (sum - part)) + (a - part);
    m_size += std::abs(a);
    m_sum = sum;
  }
  void add(double factor, double a)
  {
    const double product = factor * a;
    add(product);
    if (std::abs(factor) > 1)
      m_rest += std::fma(factor, a, -product);
  }
  // What is so small that its rounding does not matter.
  void add_little(double a) { m_rest += a; }

  double value() const { return m_sum + m_rest; }
  double error() const { return 0x1p-98 * m_size; }

private:
  double m_sum = 0, m_rest = 0, m_size = 0;
};

// The geometry of images of vertices on a torus. The unit is about the size of its basis.
//
// A vector is the difference of two points as they were given, plus a combination of the basis. A
// vector of the basis is no double in general: what is left of it after rounding is added, too.
template <class State>
class Scaled_sites_3<State, Torus_cells_3>
  : public Scaled_vectors_3<typename Exact_coordinate_3<typename State::Point>::Type>
{
  using Point = typename State::Point;
  using Base = Scaled_vectors_3<typename Exact_coordinate_3<Point>::Type>;
  using Site = Torus_site_3;

public:
  using typename Base::Exact_vector;
  using typename Base::Number;

  explicit Scaled_sites_3(const State& state)
    : Base(size_of_basis(state.torus))
    , m_state(state)
  {
    for (int i = 0; i < state.torus.dimension(); ++i) {
      const Position_3& rounded = state.torus.vector(i);
      const Exact_vector_3& exact = state.torus.exact_vector(i);
      m_rests[i] = {CGAL::to_double(exact.x - Exact_number_3(rounded.x)),
                    CGAL::to_double(exact.y - Exact_number_3(rounded.y)),
                    CGAL::to_double(exact.z - Exact_number_3(rounded.z))};
      m_size_of_rests = (std::max)(m_size_of_rests, largest_coordinate(m_rests[i]));
    }
  }

  const State& state() const { return m_state; }

  // Rounded once, but for an error of 2^-60 of its largest coordinate.
  Position_3 vector(const Site& from, const Site& to) const
  {
    const Position_3 p = m_state.positions.base(from.vertex), q = m_state.positions.base(to.vertex);
    const Multiples_3 m = multiples(from, to);
    if (m == no_multiples)
      return this->scaled(q - p);
    Compensated_sum_3 x, y, z;
    double number = 0;
    for (int i = 0; i < 3; ++i)
      if (m[i] != 0) {
        const double factor = m[i];
        const Position_3& v = m_state.torus.vector(i);
        x.add(factor, v.x);
        y.add(factor, v.y);
        z.add(factor, v.z);
        x.add_little(factor * m_rests[i].x);
        y.add_little(factor * m_rests[i].y);
        z.add_little(factor * m_rests[i].z);
        number += std::abs(factor);
      }
    x.add(q.x);
    x.add(-p.x);
    y.add(q.y);
    y.add(-p.y);
    z.add(q.z);
    z.add(-p.z);
    const Position_3 sum{x.value(), y.value(), z.value()};
    const double error = x.error() + y.error() + z.error() + 0x1p-50 * number * m_size_of_rests;
    if (error <= 0x1p-60 * largest_coordinate(sum))
      return this->scaled(sum);
    return this->rounded(exact_vector(from, to));
  }

  Exact_vector exact_vector(const Site& from, const Site& to) const
  {
    const Position_3 p = m_state.positions.base(from.vertex), q = m_state.positions.base(to.vertex);
    const Periodic_shift_3 n = shift(from, to);
    const auto exact = [&](double start, double end, std::size_t k) {
      Number sum(Number(end) - Number(start));
      for (std::size_t i = 0; i < 3; ++i)
        if (n[i] != 0)
          sum += Number(n[i]) * Number(m_state.torus.cell().vector(i)[k]);
      return sum;
    };
    return {exact(p.x, q.x, 0), exact(p.y, q.y, 1), exact(p.z, q.z, 2)};
  }

  // The shift of the second site's point where that of the first one is not shifted.
  Periodic_shift_3 shift(const Site& from, const Site& to) const
  {
    const Multiples_3 m = multiples(from, to);
    return m == no_multiples ? Periodic_shift_3{0, 0, 0} : m_state.torus.in_vectors_of_cell(m);
  }

  // Whether a site is exactly on the sphere of a cell. No perturbation breaks ties here. For an
  // infinite cell, whether it is on the circle of its hull facet; in a slab it has to be in the
  // plane of that.
  bool are_on_a_sphere(const Torus_sites_3& cell, const Site& other) const
  {
    const int first = cell[0].is_infinite() ? 1 : 0;
    const Torus_point_3 origin = m_state.image(cell[first]);
    Few<Torus_point_3, 4> ends;
    for (int i = 0; i < 3; ++i)
      ends[i] = m_state.image(cell[(first + 1 + i) % 4]);
    ends[3] = m_state.image(other);
    const auto way = [&](int i) -> Points_in_lanes_3<double> {
      const Position_3 v = ends[i].rounded - origin.rounded;
      return {v.x, v.y, v.z};
    };
    const Torus_filter_in_lanes_3<double> filter(way(0), way(1), way(2), m_state.squared_error);
    if (filter.side_of_sphere(way(3)) != 0)
      return false;
    const auto exact = [&](int i) {
      return m_state.torus.end_of_space(ends[i]) == 0 ? m_state.torus.exact_vector(origin, ends[i])
             : m_state.torus.is_slab()
                 ? m_state.torus.exact_vector(2)
                 : cross(m_state.torus.exact_vector(origin, ends[(i + 1) % 3]),
                         m_state.torus.exact_vector(origin, ends[(i + 2) % 3]));
    };
    const Exact_vector_3 b = exact(0), c = exact(1), d = exact(2), e = exact(3);
    if (m_state.torus.is_wire())
      for (int i = 0; i < 3; ++i) // the plane of a hull facet
        if (m_state.torus.end_of_space(ends[i]) != 0 && !CGAL::is_zero(dot(exact(i), e)))
          return false;
    const Exact_vector_3 cd = cross(c, d), db = cross(d, b), bc = cross(b, c);
    return CGAL::is_zero(dot(b, cd) * dot(e, e) - dot(cd, e) * dot(b, b) - dot(db, e) * dot(c, c) -
                         dot(bc, e) * dot(d, d));
  }

  // Relative to the first site.
  Plane_3 bisector(const Site& v, const Site& w) const
  {
    return this->bisector_of(vector(v, w), [&] { return exact_vector(v, w); });
  }

  // FOR ROWS BY ID --------------------------------------------------------------------------------

  static constexpr std::size_t shown_shifts = 1;

  static Site site(Vertex_index v) { return {v, {}}; }
  Neighbor_entry_3 entry(const Site& w) const
  {
    return {m_state.ids.representative(w.vertex), w.shift.code};
  }
  // By ids, then by shifts.
  bool is_before(Vertex_index v, const Neighbor_entry_3& a, const Neighbor_entry_3& b) const
  {
    return a.id != b.id ? a.id < b.id : shift(site(v), site(a)) < shift(site(v), site(b));
  }
  template <class Function>
  void show_shift(Vertex_index v, const Neighbor_entry_3& entry, const Function& f) const
  {
    f(m_state.ids.is_representative(entry.id) ? shift(site(v), site(entry))
                                              : shift_to(v, m_state.ids.covered_point(entry.id)));
  }
  Position_3 vector(Vertex_index v, const Neighbor_entry_3& entry) const
  {
    return this->unit() * vector(site(v), site(entry));
  }

  // Where the point of a vertex, or one that it covers, is as it was given.
  Position_3 given_position(Vertex_index v) const { return m_state.positions.base(v); }
  Position_3 given_position(Vertex_index, const Point& covered) const
  {
    return approximation(covered);
  }

private:
  static double size_of_basis(const Torus_3& torus)
  {
    double size = 0;
    for (int i = 0; i < torus.dimension(); ++i)
      size = (std::max)(size, largest_coordinate(torus.vector(i)));
    return size;
  }

  static constexpr Multiples_3 no_multiples = {0, 0, 0};

  Site site(const Neighbor_entry_3& entry) const
  {
    return {m_state.ids.vertex(entry.id), {entry.code}};
  }

  Multiples_3 multiples(const Site& from, const Site& to) const
  {
    return m_state.positions.multiples(to.vertex) - m_state.positions.multiples(from.vertex) +
           (to.shift - from.shift).multiples();
  }
  // By how much a point that is covered at v must be shifted to be where the point of v is.
  Periodic_shift_3 shift_to(Vertex_index v, const typename State::Point& p) const
  {
    const auto place = m_state.place_near(p, v);
    return m_state.torus.in_vectors_of_cell(place.multiples - m_state.positions.multiples(v));
  }

  const State& m_state;
  Few<Position_3, 3> m_rests{}; // of the basis: exact minus rounded
  double m_size_of_rests = 0;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_SCALED_IMAGES_3_H
