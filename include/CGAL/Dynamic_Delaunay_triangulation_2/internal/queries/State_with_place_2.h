// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_STATE_WITH_PLACE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_STATE_WITH_PLACE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Edge_filter_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Exact_number_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A certified triangulation with a place in it, if one is set. The place is one more corner, whose
// vertex has the number `null_index`: so Point_location_2 takes this class for a state, and the
// vectors from the place to vertices are computed like those between vertices. The functions have
// the same names in the plane and in periodic space.
template <class Dynamic, bool = Dynamic::Frame::is_periodic>
class State_with_place_2;

template <class Dynamic>
using State_of_2 = std::decay_t<decltype(std::declval<const Dynamic&>().frame().state())>;

// THE PLANE ---------------------------------------------------------------------------------------

template <class Dynamic>
class State_with_place_2<Dynamic, false>
{
  using State = State_of_2<Dynamic>;
  using Traits = typename Dynamic::Geom_traits;
  static_assert(Has_euclidean_circles_2<Traits>::value,
                "these traits have circles of their own, and areas are those of Euclidean ones");

public:
  using Point = typename Dynamic::Point;
  using Site = typename State::Site;
  using Chart = typename State::Chart;
  using Predicates = const State_with_place_2&;
  using Coordinate = std::decay_t<decltype(std::declval<const Point&>().x())>;
  using Exact = typename Exact_number_2<Coordinate>::Type;

  static constexpr bool is_periodic = false, can_locate_anywhere = false;

  // Throws unless the triangulation is certified.
  explicit State_with_place_2(const Dynamic& dt)
    : m_state(&dt.frame().state())
    , m_traits(&dt.triangulation().geom_traits())
    , m_is_exact(m_state->positions_are_exact())
  {
  }

  // Throws unless the place is a valid point: the error calls it `number`. The place must live as
  // long as functions are called for it.
  void set_place(const Point& place, std::size_t number)
  {
    bool is_exact = true;
    m_position = checked_position(place, number, is_exact);
    m_place = &place;
    m_is_exact = is_exact && m_state->positions_are_exact();
  }

  const Halfedge_arrays_2& arrays() const { return m_state->arrays(); }
  Index number_of_vertices() const { return m_state->number_of_vertices(); }
  std::pair<Index, Periodic_shift_2> id_and_shift(Site corner) const
  {
    return {m_state->ids().representative(corner), no_shift};
  }

  // Whether a face is outside of the hull.
  bool is_outside(Face_index f) const
  {
    const auto corners = arrays().face(f);
    return std::find(corners.begin(), corners.end(), infinite_index) != corners.end();
  }
  // Whether an edge goes outside of the hull.
  bool is_outside_at(Halfedge_index h) const
  {
    return arrays().source(h) == infinite_index || arrays().target(h) == infinite_index;
  }

  static Site site_of(Vertex_index v) { return v; }
  Site site_in(Halfedge_index h, Chart chart) const { return m_state->site_in(h, chart); }
  static Chart chart_at(Index) { return {}; }
  static Chart chart_seen_from(Index, Index) { return {}; }
  static Chart chart_beyond(Index, Chart) { return {}; }
  double rounded_squared_distance(Index, Vertex_index w) const
  {
    return squared_distance(m_position, position(w));
  }

  Orientation orientation(Site a, Site b, Site c) const
  {
    if (m_is_exact)
      if (const int sign = filtered_orientation(position(a), position(b), position(c)))
        return sign > 0 ? LEFT_TURN : RIGHT_TURN;
    return m_traits->orientation_2_object()(point(a), point(b), point(c));
  }
  // The side of d of the circle through a, b and c, which must be counterclockwise.
  Oriented_side side_of_circle(Site a, Site b, Site c, Site d) const
  {
    if (m_is_exact)
      if (const int sign = filtered_in_circle(position(a), position(b), position(c), position(d)))
        return sign > 0 ? ON_POSITIVE_SIDE : ON_NEGATIVE_SIDE;
    return m_traits->side_of_oriented_circle_2_object()(point(a), point(b), point(c), point(d));
  }
  bool coincide(Site a, Site b) const { return internal::coincide(*m_traits, point(a), point(b)); }

  // The vector between two corners, rounded. Raises `error` to a bound on the error of coordinates,
  // besides the rounding of one subtraction: infinite if nothing is known.
  Position_2 vector(Site from, Site to, double& error) const
  {
    if (!m_is_exact)
      error = std::numeric_limits<double>::infinity();
    return position(to) - position(from);
  }
  Exact_vector_2<Exact> exact_vector(Site from, Site to) const
  {
    const auto exact = [](const Coordinate& x) { return Exact_number_2<Coordinate>::of(x); };
    const auto& p = point(from);
    const auto& q = point(to);
    return {exact(q.x()) - exact(p.x()), exact(q.y()) - exact(p.y())};
  }

private:
  const Position_2& position(Site corner) const
  {
    return corner == null_index ? m_position : m_state->positions()[corner];
  }
  Point point(Site corner) const
  {
    return corner == null_index ? *m_place : m_state->point(corner);
  }

  const State* m_state;
  const Traits* m_traits;
  const Point* m_place = nullptr;
  Position_2 m_position{0, 0};
  bool m_is_exact;
};

// PERIODIC SPACE ----------------------------------------------------------------------------------

template <class Dynamic>
class State_with_place_2<Dynamic, true>
{
  using State = State_of_2<Dynamic>;

public:
  using Point = typename Dynamic::Point;
  using Site = typename State::Site;
  using Chart = typename State::Chart;
  using Predicates = const State_with_place_2&;
  using Exact = typename Exact_number_2<double>::Type;

  static constexpr bool is_periodic = true, can_locate_anywhere = false;

  explicit State_with_place_2(const Dynamic& dt)
    : m_state(&dt.frame().state())
  {
    check_certified(dt);
  }

  void set_place(const Point& place, std::size_t number)
  {
    m_position = checked_position(place, number, torus());
  }

  const Halfedge_arrays_2& arrays() const { return m_state->arrays(); }
  Index number_of_vertices() const { return m_state->number_of_vertices(); }
  std::pair<Index, Periodic_shift_2> id_and_shift(const Site& corner) const
  {
    return {m_state->ids().representative(corner.vertex), corner.shift};
  }

  // Whether a face is outside of a slab.
  bool is_outside(Face_index f) const { return m_state->is_in_gap(f); }
  bool is_outside_at(Halfedge_index h) const
  {
    return m_state->are_across(Halfedge_arrays_2::next(h), Halfedge_arrays_2::previous(h));
  }

  static Site site_of(Vertex_index v) { return {v, no_shift}; }
  Site site_in(Halfedge_index h, const Chart& chart) const { return m_state->site_in(h, chart); }
  Chart chart_at(Halfedge_index h) const { return m_state->chart_at(h); }
  Chart chart_seen_from(Index, Halfedge_index h) const
  {
    return m_state->chart_at(h) + shift_to_place(arrays().apex(h));
  }
  Chart chart_beyond(Halfedge_index h, const Chart& chart) const
  {
    return m_state->chart_beyond(h, chart);
  }
  double rounded_squared_distance(Index, Vertex_index w) const
  {
    double ignored = 0;
    const Position_2 v = vector(site_of(null_index), {w, shift_to_place(w)}, ignored);
    return dot(v, v);
  }

  Orientation orientation(const Site& a, const Site& b, const Site& c) const
  {
    return torus().orientation(image(a), image(b), image(c));
  }
  Oriented_side side_of_circle(const Site& a, const Site& b, const Site& c, const Site& d) const
  {
    return torus().side_of_circle(image(a), image(b), image(c), image(d));
  }
  bool coincide(const Site& a, const Site& b) const { return torus().coincide(image(a), image(b)); }

  // As in the plane. Across the border of the cell, adds two coordinates, two multiples of the
  // cell's vectors, and what rounding takes from each step. The result is as good as rounded once
  // (Ogita, Rump and Oishi, 2005): a further error is below 2^-98 times the sum of all absolute
  // values.
  Position_2 vector(const Site& from, const Site& to, double& error) const
  {
    const Image_2 p = image(from), q = image(to);
    if (are_equal(from.shift, to.shift))
      return q.position - p.position;
    const double i = to.shift[0] - from.shift[0], j = to.shift[1] - from.shift[1];
    const auto sum = [&](double start, double end, double a, double b) {
      const double ia = i * a, jb = j == 0 ? 0 : j * b;
      double rounding = std::fma(i, a, -ia) + (j == 0 ? 0 : std::fma(j, b, -jb));
      const double way = add(end, -start, rounding);
      const double v = add(add(ia, jb, rounding), way, rounding);
      error = (std::max)(error,
                         0x1p-98 * (std::abs(start) + std::abs(end) + std::abs(ia) + std::abs(jb)));
      return v + rounding;
    };
    const Periodic_cell_2& cell = torus().cell();
    return {sum(p.position.x, q.position.x, cell.ax(), cell.bx()),
            sum(p.position.y, q.position.y, cell.ay(), cell.by())};
  }
  // Between corners on the same side of the gap beside a slab.
  Exact_vector_2<Exact> exact_vector(const Site& from, const Site& to) const
  {
    const Periodic_cell_2& cell = torus().cell();
    const Exact i(to.shift[0] - from.shift[0]), j(to.shift[1] - from.shift[1]);
    const auto exact = [&](double p, double q, double a, double b) {
      const Exact open = Exact(q) - Exact(p) + i * Exact(a);
      return j == 0 ? open : Exact(open + j * Exact(b));
    };
    const Position_2 p = image(from).position, q = image(to).position;
    return {exact(p.x, q.x, cell.ax(), cell.bx()), exact(p.y, q.y, cell.ay(), cell.by())};
  }

private:
  // Returns the sum, and adds to `rounding` by how much the sum is too small.
  static double add(double a, double b, double& rounding)
  {
    const double sum = a + b, part = sum - a;
    rounding += (a - (sum - part)) + (b - part);
    return sum;
  }

  const Torus_2& torus() const { return m_state->torus(); }
  Periodic_shift_2 shift_to_place(Vertex_index v) const
  {
    return m_state->shift_of_step(m_state->positions()[v], m_position);
  }
  Image_2 image(const Site& corner) const
  {
    return {corner.vertex == null_index ? m_position : m_state->positions()[corner.vertex],
            corner.shift};
  }

  const State* m_state;
  Position_2 m_position{0, 0};
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_STATE_WITH_PLACE_2_H
