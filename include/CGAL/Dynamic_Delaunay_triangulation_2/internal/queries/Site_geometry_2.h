// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_SITE_GEOMETRY_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_SITE_GEOMETRY_2_H

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
#include <CGAL/number_utils.h>
#include <CGAL/Periodic_cell_2.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

template <class Dynamic>
using State_of_2 = std::decay_t<decltype(std::declval<const Dynamic&>().frame().state())>;

// Returns what queries read. Throws unless the triangulation is certified.
template <class Dynamic>
const State_of_2<Dynamic>& certified_state(const Dynamic& dt)
{
  check_certified(dt);
  return dt.frame().state();
}

// Bounds the error of a dot or cross product if coordinates are off by up to e besides the rounding
// of one subtraction. With u = 2^-53 each of two products of coordinates has three roundings, and
// their sum is one more. Underflow takes less than 1e-300.
inline double error_of_product(const Position_2& v, const Position_2& w, double e)
{
  const double a = std::abs(v.x) + std::abs(v.y), b = std::abs(w.x) + std::abs(w.y);
  return 5 * 0x1p-53 * a * b + 2 * e * (a + b + e) + 1e-300;
}

template <class Number>
Number dot(const Exact_vector_2<Number>& v, const Exact_vector_2<Number>& w)
{
  return v.x * w.x + v.y * w.y;
}
template <class Number>
Number cross(const Exact_vector_2<Number>& v, const Exact_vector_2<Number>& w)
{
  return v.x * w.y - v.y * w.x;
}

// The exact geometry of a state's sites and of *query points*, which are at no vertex. Functions
// take either where they are templates. This is all that differs for queries between spaces whose
// sites are vertices, as in the plane, and those whose sites are images of vertices.

// VERTICES ----------------------------------------------------------------------------------------

template <class State, class Site_ = typename State::Site>
class Site_geometry_2
{
public:
  using Point = typename State::Point;
  using Site = typename State::Site;
  using Chart = typename State::Chart;
  using Coordinate = std::decay_t<decltype(std::declval<const Point&>().x())>;
  using Exact = typename Exact_number_2<Coordinate>::Type;
  using Answer = std::size_t; // what users know a site by: an id

  static constexpr bool has_euclidean_circles =
      Has_euclidean_circles_2<typename State::Traits>::value;
  static constexpr std::size_t shown_shifts = 0; // that users are told with an id
  static constexpr bool can_have_walls = true;   // which are where they are, and have no images

  // The point must live as long as functions are called for it.
  struct Query_point
  {
    const Point* point = nullptr;
    Position_2 position{0, 0};
    bool is_exact = false; // whether signs may be concluded from positions
  };

  explicit Site_geometry_2(const State& state)
    : m_state(&state)
    , m_positions_are_exact(state.positions_are_exact())
  {
  }

  const State& state() const { return *m_state; }

  // Throws unless p is a valid point: the error calls it `number`.
  Query_point query_point(const Point& p, std::size_t number) const
  {
    bool is_exact = true;
    const Position_2 position = checked_position(p, number, is_exact);
    return {&p, position, is_exact && m_positions_are_exact};
  }

  // How a query point sees vertices and faces.
  static Site site_near(const Query_point&, Vertex_index v) { return v; }
  static Chart chart_near(const Query_point&, Halfedge_index) { return {}; }
  // The site of a neighbor of a site's vertex.
  static Site neighbor(Site, Vertex_index w, const Periodic_shift_2& = no_shift) { return w; }
  static Periodic_shift_2 shift(Site) { return no_shift; }
  // Calls f with the shift if users are told shifts, and else with nothing.
  template <class Function>
  static decltype(auto) show(const Periodic_shift_2&, const Function& f)
  {
    return f();
  }
  // By how much a point that is covered at v must be shifted to be where v is.
  static Periodic_shift_2 shift_to(Vertex_index, const Point&) { return no_shift; }
  // Where a point is, as it was given.
  const Position_2& given_position(Point_id id) const
  {
    return position(m_state->ids().vertex(id));
  }

  // Whether no edge between these sites goes outside of the hull.
  static bool are_inside(Site a, Site b) { return a != infinite_index && b != infinite_index; }
  // Calls f(v) for the vertices at which edges have a single face, or none; for some more than
  // once.
  template <class Function>
  void for_each_vertex_at_border(const Function& f) const
  {
    if (m_state->spans_plane())
      return m_state->arrays().for_each_neighbor(infinite_index, f);
    for (Vertex_index v(1); v <= m_state->number_of_vertices(); ++v)
      f(v);
  }

  Orientation orientation(Site a, Site b, const Query_point& q) const
  {
    if (q.is_exact)
      if (const int sign = filtered_orientation(position(a), position(b), q.position))
        return sign > 0 ? LEFT_TURN : RIGHT_TURN;
    return traits().orientation_2_object()(point(a), point(b), *q.point);
  }
  // The side of q of the circle through a, b and c, which must be counterclockwise.
  Oriented_side side_of_circle(Site a, Site b, Site c, const Query_point& q) const
  {
    if (q.is_exact)
      if (const int sign = filtered_in_circle(position(a), position(b), position(c), q.position))
        return sign > 0 ? ON_POSITIVE_SIDE : ON_NEGATIVE_SIDE;
    return traits().side_of_oriented_circle_2_object()(point(a), point(b), point(c), *q.point);
  }
  bool coincide(Site a, const Query_point& q) const
  {
    return internal::coincide(traits(), point(a), *q.point);
  }

  // Compare distances from q.
  Comparison_result compare_distances(const Query_point& q, Site a, Site b) const
  {
    return traits().compare_distance_2_object()(*q.point, point(a), point(b));
  }
  template <class FT>
  Comparison_result compare_squared_distance(const Query_point& q, Site a, const FT& square) const
  {
    return traits().compare_squared_distance_2_object()(*q.point, point(a), square);
  }

  // The vector between sites or query points, rounded once. Raises `error` to a bound on the error
  // of coordinates besides: infinite if nothing is known.
  template <class From, class To>
  Position_2 vector(const From& from, const To& to, double& error) const
  {
    if (!(is_exact(from) && is_exact(to)))
      error = std::numeric_limits<double>::infinity();
    return position(to) - position(from);
  }
  Position_2 rough_vector(const Query_point& from, Site to, double& error) const
  {
    if (!from.is_exact)
      error = std::numeric_limits<double>::infinity();
    return position(to) - from.position;
  }
  // The vector as Voronoi cells take it. Rounded positions are not subtracted, because points that
  // an exact kernel distinguishes may have equal doubles as coordinates. Passes over faces are much
  // slower where compilers do not inline this.
  BOOST_FORCEINLINE Position_2 cell_vector(Site from, Site to, double&) const
  {
    if (m_positions_are_exact)
      return position(to) - position(from);
    const auto &p = point(from), &q = point(to);
    return {CGAL::to_double(q.x() - p.x()), CGAL::to_double(q.y() - p.y())};
  }
  template <class From, class To>
  Exact_vector_2<Exact> exact_vector(const From& from, const To& to) const
  {
    const auto exact = [](const Coordinate& x) { return Exact_number_2<Coordinate>::of(x); };
    const auto& p = point(from);
    const auto& q = point(to);
    return {exact(q.x()) - exact(p.x()), exact(q.y()) - exact(p.y())};
  }

private:
  const auto& traits() const { return m_state->traits(); }
  const Position_2& position(Site site) const { return m_state->positions()[site]; }
  decltype(auto) point(Site site) const { return m_state->point(site); }
  bool is_exact(Site) const { return m_positions_are_exact; }

  static const Position_2& position(const Query_point& q) { return q.position; }
  static const Point& point(const Query_point& q) { return *q.point; }
  static bool is_exact(const Query_point& q) { return q.is_exact; }

  const State* m_state;
  bool m_positions_are_exact;
};

// IMAGES ------------------------------------------------------------------------------------------

template <class State>
class Site_geometry_2<State, Periodic_site_2>
{
public:
  using Point = typename State::Point;
  using Site = typename State::Site;
  using Chart = typename State::Chart;
  using Query_point = Image_2;
  using Coordinate = double;
  using Exact = typename Exact_number_2<double>::Type;
  using Answer = std::pair<std::size_t, Periodic_shift_2>;

  static constexpr bool has_euclidean_circles = true;
  static constexpr std::size_t shown_shifts = 1;
  static constexpr bool can_have_walls = false;

  explicit Site_geometry_2(const State& state)
    : m_state(&state)
  {
  }

  const State& state() const { return *m_state; }

  Query_point query_point(const Point& p, std::size_t number) const
  {
    return {checked_position(p, number, torus()), no_shift};
  }

  // The image of v near q: exactly at q if one of them is there.
  Site site_near(const Query_point& q, Vertex_index v) const
  {
    return {v, m_state->shift_of_step(m_state->positions()[v], q.position)};
  }
  Chart chart_near(const Query_point& q, Halfedge_index h) const
  {
    return m_state->chart_at(h) + site_near(q, m_state->arrays().apex(h)).shift;
  }
  static Site neighbor(const Site& v, Vertex_index w, const Periodic_shift_2& way)
  {
    return {w, v.shift + way};
  }
  static const Periodic_shift_2& shift(const Site& site) { return site.shift; }
  template <class Function>
  static decltype(auto) show(const Periodic_shift_2& shift, const Function& f)
  {
    return f(shift);
  }
  Periodic_shift_2 shift_to(Vertex_index v, const Point& p) const
  {
    return m_state->shift_of_step(approximation(p), m_state->positions()[v]);
  }
  Position_2 given_position(Point_id id) const { return approximation(m_state->point_of_id(id)); }

  // Whether the sites are on the same side of the gap beside a slab.
  bool are_inside(const Site& a, const Site& b) const
  {
    return !torus().are_across(a.shift, b.shift);
  }
  template <class Function>
  void for_each_vertex_at_border(const Function& f) const
  {
    if (m_state->has_gap())
      for (Face_index i(0); i < m_state->arrays().number_of_faces(); ++i)
        if (m_state->is_in_gap(i))
          for (const Vertex_index v : m_state->face(i))
            f(v);
  }

  Orientation orientation(const Site& a, const Site& b, const Query_point& q) const
  {
    return torus().orientation(image(a), image(b), q);
  }
  Oriented_side side_of_circle(const Site& a, const Site& b, const Site& c,
                               const Query_point& q) const
  {
    return torus().side_of_circle(image(a), image(b), image(c), q);
  }
  bool coincide(const Site& a, const Query_point& q) const { return torus().coincide(image(a), q); }

  Comparison_result compare_distances(const Query_point& q, const Site& a, const Site& b) const
  {
    return CGAL::compare(exact_square(q, a), exact_square(q, b));
  }
  Comparison_result compare_squared_distance(const Query_point& q, const Site& a,
                                             double square) const
  {
    return CGAL::compare(exact_square(q, a), Torus_2::Exact(square));
  }

  // As in the plane. Across the border of the cell, adds two coordinates, two multiples of the
  // cell's vectors, and what rounding takes from each step. The result is as good as rounded once
  // (Ogita, Rump and Oishi, 2005): a further error is below 2^-98 times the sum of all absolute
  // values.
  template <class From, class To>
  Position_2 vector(const From& from, const To& to, double& error) const
  {
    const Image_2 p = image(from), q = image(to);
    if (are_equal(p.shift, q.shift))
      return q.position - p.position;
    const double i = q.shift[0] - p.shift[0], j = q.shift[1] - p.shift[1];
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
  // Faster, with a larger bound, which covers the rounding of all steps.
  template <class From>
  BOOST_FORCEINLINE Position_2 rough_vector(const From& from, const Site& to, double& error) const
  {
    double m = 0;
    const Position_2 v = torus().vector(image(from), image(to), m);
    error = (std::max)(error, Torus_2::error_factor * m);
    return v;
  }
  BOOST_FORCEINLINE Position_2 cell_vector(const Site& from, const Site& to, double& error) const
  {
    return rough_vector(from, to, error);
  }
  // Both must be on the same side of the gap beside a slab.
  template <class From, class To>
  Exact_vector_2<Exact> exact_vector(const From& from, const To& to) const
  {
    const Image_2 p = image(from), q = image(to);
    const Periodic_cell_2& cell = torus().cell();
    const Exact i(q.shift[0] - p.shift[0]), j(q.shift[1] - p.shift[1]);
    const auto exact = [&](double start, double end, double a, double b) {
      const Exact open = Exact(end) - Exact(start) + i * Exact(a);
      return j == 0 ? open : Exact(open + j * Exact(b));
    };
    return {exact(p.position.x, q.position.x, cell.ax(), cell.bx()),
            exact(p.position.y, q.position.y, cell.ay(), cell.by())};
  }

private:
  // Returns the sum, and adds to `rounding` by how much the sum is too small.
  static double add(double a, double b, double& rounding)
  {
    const double sum = a + b, part = sum - a;
    rounding += (a - (sum - part)) + (b - part);
    return sum;
  }

  BOOST_NOINLINE Torus_2::Exact exact_square(const Query_point& q, const Site& a) const
  {
    const Torus_2::Exact_vector v(torus(), q, image(a));
    return v.x * v.x + v.y * v.y;
  }

  const Torus_2& torus() const { return m_state->torus(); }
  Image_2 image(const Site& site) const { return m_state->image(site); }
  static const Image_2& image(const Query_point& q) { return q; }

  const State* m_state;
};

// IN BOTH -----------------------------------------------------------------------------------------

// Whether a face is outside of the hull, or of a slab.
template <class State>
bool is_outside(const Site_geometry_2<State>& geometry, Face_index f)
{
  const auto corner = [&](Index i) {
    return geometry.state().site_in(Halfedge_arrays_2::halfedge_in(f, i), typename State::Chart{});
  };
  return !geometry.are_inside(corner(0), corner(1)) || !geometry.are_inside(corner(0), corner(2));
}

// Calls f(site) for the finite neighbors of a site.
template <class State, class Function>
void for_each_neighbor(const Site_geometry_2<State>& geometry, const typename State::Site& site,
                       const Function& f)
{
  geometry.state().for_each_finite_neighbor(
      State::vertex_of(site),
      [&](Vertex_index w, const auto&... way) { f(geometry.neighbor(site, w, way...)); });
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_SITE_GEOMETRY_2_H
