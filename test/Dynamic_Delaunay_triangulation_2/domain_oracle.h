// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The parts of a domain in a Voronoi cell, found without a Delaunay triangulation and without
// triangles: by CGAL's Boolean operations on polygons with arcs, in exact numbers; and, for the
// part that is visible from the point, by a sweep around the point in long double.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_DOMAIN_ORACLE_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_DOMAIN_ORACLE_H

#include "oracle.h"

#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_circle_segment_traits_2.h>
#include <CGAL/Object.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <variant>
#include <vector>

namespace domain_oracle {

using Real = long double;
using Polygon = CGAL::Polygon_2<Epick>;
using Domain = CGAL::Polygon_with_holes_2<Epick>;
using Points = std::vector<Epick::Point_2>;

const Real pi = std::acos(Real(-1));

struct Vector
{
  Real x, y;
};
inline Vector operator-(const Vector& u, const Vector& v)
{
  return {u.x - v.x, u.y - v.y};
}
inline Real cross(const Vector& u, const Vector& v)
{
  return u.x * v.y - u.y * v.x;
}
inline Real dot(const Vector& u, const Vector& v)
{
  return u.x * v.x + u.y * v.y;
}
inline Vector vector(const Epick::Point_2& p)
{
  return {p.x(), p.y()};
}

// A wall, or the bisector with another point; `other` is the wall's number or that point's id.
struct Line
{
  Vector from, to; // of a bisector: two places of it
  std::size_t other;
  bool is_wall;

  Real distance(const Vector& p) const
  {
    return std::abs(cross(to - from, p - from)) / std::hypot(to.x - from.x, to.y - from.y);
  }
};

inline std::vector<Line> walls(const Domain& domain)
{
  std::vector<Line> lines;
  const auto add = [&](const Polygon& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      lines.push_back({vector(ring[i]), vector(ring[(i + 1) % ring.size()]), lines.size(), true});
  };
  add(domain.outer_boundary());
  for (const Polygon& hole : domain.holes())
    add(hole);
  return lines;
}

// The walls of the domain, and the bisectors of a point with all others.
inline std::vector<Line> lines_around(const Points& points, std::size_t id, const Domain& domain)
{
  std::vector<Line> lines = walls(domain);
  const Vector p = vector(points[id]);
  for (std::size_t j = 0; j < points.size(); ++j)
    if (points[j] != points[id]) {
      const Vector q = vector(points[j]);
      const Vector middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
      lines.push_back({middle, {middle.x - (q.y - p.y), middle.y + (q.x - p.x)}, j, false});
    }
  return lines;
}

struct Measured
{
  Real area = 0, perimeter = 0, wall = 0, free = 0;
  Real moment_x = 0, moment_y = 0; // areas times centroids, from the point
  std::size_t components = 0, holes = 0;
  bool is_pinched = false; // parts of a component have no more than a point in common
  std::map<std::size_t, Real> contacts{};
};

// BY BOOLEAN OPERATIONS ---------------------------------------------------------------------------

class Boolean_cell
{
  using Traits = CGAL::Gps_circle_segment_traits_2<Epeck>;
  using Set = CGAL::General_polygon_set_2<Traits>;
  using Curve = Traits::X_monotone_curve_2;
  using General_polygon = Traits::Polygon_2;

public:
  Boolean_cell(const Points& points, std::size_t id, const Domain& domain, double radius)
    : m_p(points[id])
    , m_lines(lines_around(points, id, domain))
  {
    m_set.insert(polygon(voronoi_cell(points, id, domain)));
    Set of_domain(polygon(exact(domain.outer_boundary())));
    for (const Polygon& hole : domain.holes())
      of_domain.difference(polygon(exact(hole)));
    m_set.intersection(of_domain);
    if (std::isfinite(radius))
      m_set.intersection(disc(radius));
  }

  // Measures the whole cell, or only the component that has the point in its interior.
  Measured measure(bool is_connected) const
  {
    std::vector<Traits::Polygon_with_holes_2> components;
    if (is_connected) {
      components.emplace_back();
      const Traits::Point_2 p(exact(m_p).x(), exact(m_p).y());
      if (!m_set.locate(p, components.back()))
        components.clear();
    } else
      m_set.polygons_with_holes(std::back_inserter(components));
    Measured measured;
    for (const auto& component : components) {
      ++measured.components;
      std::set<std::pair<Real, Real>> corners;
      add(component.outer_boundary(), measured, corners);
      for (auto hole = component.holes_begin(); hole != component.holes_end(); ++hole) {
        ++measured.holes;
        add(*hole, measured, corners);
      }
    }
    return measured;
  }

private:
  static Epeck::Point_2 exact(const Epick::Point_2& p) { return {p.x(), p.y()}; }
  static std::vector<Epeck::Point_2> exact(const Polygon& ring)
  {
    std::vector<Epeck::Point_2> corners;
    for (auto p = ring.vertices_begin(); p != ring.vertices_end(); ++p)
      corners.push_back(exact(*p));
    return corners;
  }

  static General_polygon polygon(std::vector<Epeck::Point_2> corners)
  {
    Epeck::FT area = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      area += CGAL::area(corners[0], corners[i], corners[i + 1]);
    if (area < 0)
      std::reverse(corners.begin(), corners.end());
    General_polygon result;
    for (std::size_t i = 0; i < corners.size(); ++i)
      result.push_back(Curve(corners[i], corners[(i + 1) % corners.size()]));
    return result;
  }

  // A large box, cut by all bisectors.
  static std::vector<Epeck::Point_2> voronoi_cell(const Points& points, std::size_t id,
                                                  const Domain& domain)
  {
    const Epeck::Point_2 p = exact(points[id]);
    const CGAL::Bbox_2 box = domain.outer_boundary().bbox();
    const double size = 1 + (box.xmax() - box.xmin()) + (box.ymax() - box.ymin());
    std::vector<Epeck::Point_2> cell{{box.xmin() - size, box.ymin() - size},
                                     {box.xmax() + size, box.ymin() - size},
                                     {box.xmax() + size, box.ymax() + size},
                                     {box.xmin() - size, box.ymax() + size}};
    for (const Epick::Point_2& other : points) {
      if (other == points[id])
        continue;
      const Epeck::Line_2 line = CGAL::bisector(p, exact(other)); // p is on its left
      std::vector<Epeck::Point_2> rest;
      for (std::size_t i = 0; i < cell.size(); ++i) {
        const Epeck::Point_2 &q = cell[i], &r = cell[(i + 1) % cell.size()];
        const auto side = line.oriented_side(q), next_side = line.oriented_side(r);
        if (side != CGAL::ON_NEGATIVE_SIDE)
          rest.push_back(q);
        if (side * next_side < 0) {
          const Epeck::FT u = line.a() * q.x() + line.b() * q.y() + line.c(),
                          v = line.a() * r.x() + line.b() * r.y() + line.c();
          rest.push_back(q + (u / (u - v)) * (r - q));
        }
      }
      cell.swap(rest);
    }
    return cell;
  }

  General_polygon disc(double radius) const
  {
    const Epeck::FT r = radius;
    Traits traits;
    const Traits::Curve_2 circle(exact(m_p), r);
    General_polygon result;
    traits.make_x_monotone_2_object()(circle, boost::make_function_output_iterator(Halves{result}));
    return result;
  }

  // Appends the halves of a circle, which CGAL 5, 6.1 and 6.2 give in different types.
  struct Halves
  {
    void operator()(const CGAL::Object& half) const
    {
      Curve curve;
      CGAL::assign(curve, half);
      polygon.push_back(curve);
    }
    template <class... Types>
    void operator()(const std::variant<Types...>& half) const
    {
      polygon.push_back(std::get<Curve>(half));
    }
    void operator()(const Curve& half) const { polygon.push_back(half); }
    void operator()(const Traits::Point_2&) const {}

    General_polygon& polygon;
  };

  void add(const General_polygon& ring, Measured& measured,
           std::set<std::pair<Real, Real>>& corners) const
  {
    for (auto curve = ring.curves_begin(); curve != ring.curves_end(); ++curve) {
      add(*curve, measured);
      const Vector corner = from_point(curve->source());
      measured.is_pinched = measured.is_pinched || !corners.emplace(corner.x, corner.y).second;
    }
  }

  Vector from_point(const Traits::Point_2& q) const
  {
    return {Real(CGAL::to_double(q.x() - Traits::CoordNT(exact(m_p).x()))),
            Real(CGAL::to_double(q.y() - Traits::CoordNT(exact(m_p).y())))};
  }

  void add(const Curve& curve, Measured& measured) const
  {
    const Vector from = from_point(curve.source()), to = from_point(curve.target());
    const Real doubled = cross(from, to);
    if (curve.is_circular()) {
      const Real radius = std::hypot(from.x, from.y);
      const Real angle = std::atan2(doubled, dot(from, to)); // at most half a turn
      const Real turn = angle < -1 ? angle + 2 * pi : angle; // a short arc may round to below 0
      measured.area += radius * radius * turn / 2;
      measured.moment_x += radius * radius * (to.y - from.y) / 3;
      measured.moment_y -= radius * radius * (to.x - from.x) / 3;
      measured.perimeter += radius * turn;
      measured.free += radius * turn;
      return;
    }
    const Real length = std::hypot(to.x - from.x, to.y - from.y);
    measured.area += doubled / 2;
    measured.moment_x += doubled * (from.x + to.x) / 6;
    measured.moment_y += doubled * (from.y + to.y) / 6;
    measured.perimeter += length;
    const Line& line = nearest_line(from, to);
    (line.is_wall ? measured.wall : measured.contacts[line.other]) += length;
  }

  // The line on which a segment lies.
  const Line& nearest_line(const Vector& from, const Vector& to) const
  {
    const Vector p = vector(m_p);
    const auto distance = [&](const Line& line) {
      const Vector q{p.x + from.x, p.y + from.y}, r{p.x + to.x, p.y + to.y};
      const Vector middle{(q.x + r.x) / 2, (q.y + r.y) / 2};
      const bool is_off = line.is_wall && dot(middle - line.from, middle - line.to) > 0;
      return is_off ? std::numeric_limits<Real>::infinity() : line.distance(q) + line.distance(r);
    };
    return *std::min_element(
        m_lines.begin(), m_lines.end(),
        [&](const Line& line, const Line& other) { return distance(line) < distance(other); });
  }

  const Epick::Point_2 m_p;
  const std::vector<Line> m_lines;
  Set m_set;
};

// BY A SWEEP --------------------------------------------------------------------------------------

// The visible part of a cell, summed over sectors: only at their borders may another line become
// the nearest one. Walls that are seen edge-on are left out.
class Visible_cell
{
public:
  Visible_cell(const Points& points, std::size_t id, const Domain& domain, double radius)
    : m_p(vector(points[id]))
    , m_lines(lines_around(points, id, domain))
    , m_radius(radius)
  {
    for (Line& line : m_lines)
      line = {line.from - m_p, line.to - m_p, line.other, line.is_wall};
    const auto is_edge_on = [](const Line& line) { return cross(line.from, line.to) == 0; };
    m_lines.erase(std::remove_if(m_lines.begin(), m_lines.end(), is_edge_on), m_lines.end());
  }

  Measured measure() const
  {
    Measured measured;
    const std::vector<Real> turns = directions();
    std::vector<Real> reaches; // at the beginning and at the end of each sector
    for (std::size_t i = 0; i + 1 < turns.size(); ++i)
      if (turns[i + 1] - turns[i] > 1e-17L) // or else both are one direction
        add(turns[i], turns[i + 1], measured, reaches);
    measured.components = 1;
    for (std::size_t i = 1; i < reaches.size(); i += 2) // lines of sight, and walls seen edge-on
      measured.perimeter += std::abs(reaches[i] - reaches[(i + 1) % reaches.size()]);
    return measured;
  }

private:
  std::vector<Real> directions() const
  {
    std::vector<Real> result{0, 2 * pi};
    const auto add = [&](const Vector& v) {
      const Real turn = std::atan2(v.y, v.x);
      result.push_back(turn < 0 ? turn + 2 * pi : turn);
    };
    for (const Line& line : m_lines) {
      const Vector way = line.to - line.from;
      if (line.is_wall)
        add(line.from);
      if (std::isfinite(m_radius)) {
        const Real squared = dot(way, way), middle = -dot(line.from, way) / squared;
        const Real rest = m_radius * m_radius - line_distance(line) * line_distance(line);
        for (const int sign : {-1, 1})
          if (rest > 0) {
            const Real t = middle + sign * std::sqrt(rest / squared);
            add({line.from.x + t * way.x, line.from.y + t * way.y});
          }
      }
      for (const Line& other : m_lines) {
        const Vector other_way = other.to - other.from;
        const Real slope = cross(way, other_way);
        if (slope != 0) {
          const Real t = cross(other.from - line.from, other_way) / slope;
          add({line.from.x + t * way.x, line.from.y + t * way.y});
        }
      }
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  static Real line_distance(const Line& line) { return line.distance({0, 0}); }

  // The distance to a line along a direction; infinity if the ray misses the line.
  static Real reach(const Line& line, Real turn)
  {
    const Vector ray{std::cos(turn), std::sin(turn)}, way = line.to - line.from;
    const Real slope = cross(ray, way);
    const Real t = cross(line.from, way) / slope, u = cross(line.from, ray) / slope;
    const bool is_met = slope != 0 && t > 0 && (!line.is_wall || (u >= 0 && u <= 1));
    return is_met ? t : std::numeric_limits<Real>::infinity();
  }

  // Where the ray in a direction meets the line, a wall being extended beyond its ends.
  static Vector place(const Line& line, Real turn)
  {
    const Vector ray{std::cos(turn), std::sin(turn)}, way = line.to - line.from;
    const Real t = cross(line.from, way) / cross(ray, way);
    return {t * ray.x, t * ray.y};
  }

  void add(Real from, Real to, Measured& measured, std::vector<Real>& reaches) const
  {
    const Real middle = (from + to) / 2;
    const Line* nearest = nullptr;
    Real distance = m_radius;
    for (const Line& line : m_lines)
      if (reach(line, middle) < distance) {
        nearest = &line;
        distance = reach(line, middle);
      }
    if (nearest == nullptr) {
      reaches.insert(reaches.end(), {m_radius, m_radius});
      measured.perimeter += m_radius * (to - from);
      const Real squared = m_radius * m_radius;
      measured.area += squared * (to - from) / 2;
      measured.moment_x += squared * m_radius * (std::sin(to) - std::sin(from)) / 3;
      measured.moment_y -= squared * m_radius * (std::cos(to) - std::cos(from)) / 3;
      return;
    }
    const Vector q = place(*nearest, from), r = place(*nearest, to);
    const Real length = std::hypot(r.x - q.x, r.y - q.y);
    reaches.insert(reaches.end(), {std::hypot(q.x, q.y), std::hypot(r.x, r.y)});
    measured.perimeter += length;
    measured.area += cross(q, r) / 2;
    measured.moment_x += cross(q, r) * (q.x + r.x) / 6;
    measured.moment_y += cross(q, r) * (q.y + r.y) / 6;
    (nearest->is_wall ? measured.wall : measured.contacts[nearest->other]) += length;
  }

  const Vector m_p;
  std::vector<Line> m_lines;
  const Real m_radius;
};

} // namespace domain_oracle

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_DOMAIN_ORACLE_H
