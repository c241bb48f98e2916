// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The part of a Voronoi cell that is visible from its point, found without a Delaunay
// triangulation: by a sweep around the point in long double.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_CELL_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_CELL_H

#include "oracle.h"

#include <CGAL/Polygon_with_holes_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
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

// The bisector with a point, or an image of it, at a place.
inline Line bisector(const Epick::Point_2& point, Real x, Real y, std::size_t other)
{
  const Vector p = vector(point), middle{(p.x + x) / 2, (p.y + y) / 2};
  return {middle, {middle.x - (y - p.y), middle.y + (x - p.x)}, other, false};
}

// The walls of the domain, and the bisectors of a point with all others.
inline std::vector<Line> lines_around(const Points& points, std::size_t id, const Domain& domain)
{
  std::vector<Line> lines = walls(domain);
  for (std::size_t j = 0; j < points.size(); ++j)
    if (points[j] != points[id])
      lines.push_back(bisector(points[id], points[j].x(), points[j].y(), j));
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

// The visible part of a cell that walls, bisectors and a radius bound, summed over sectors: only at
// their borders may another line become the nearest one. Walls that are seen edge-on are left out.
class Visible_cell
{
public:
  Visible_cell(const Epick::Point_2& point, std::vector<Line> lines, double radius)
    : m_lines(std::move(lines))
    , m_radius(radius)
  {
    const Vector p = vector(point);
    for (Line& line : m_lines)
      line = {line.from - p, line.to - p, line.other, line.is_wall};
    const auto is_no_bound = [&](const Line& line) { // a wall's end counts for the next wall, too
      return cross(line.from, line.to) == 0 || (!line.is_wall && line_distance(line) >= m_radius);
    };
    m_lines.erase(std::remove_if(m_lines.begin(), m_lines.end(), is_no_bound), m_lines.end());
  }

  // With the radii of all points, contacts are where both points reach.
  Measured measure(const std::vector<double>& radii = {}) const
  {
    Measured measured;
    const std::vector<Real> turns = directions();
    std::vector<Real> reaches; // at the beginning and at the end of each sector
    for (std::size_t i = 0; i + 1 < turns.size(); ++i)
      if (turns[i + 1] - turns[i] > 1e-17L) // or else both are one direction
        add(turns[i], turns[i + 1], radii, measured, reaches);
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

  // The length of the piece from q to r of a bisector, counterclockwise, that is within `radius`.
  static Real contact(const Line& line, const Vector& q, const Vector& r, Real radius)
  {
    const Real h = line_distance(line);
    const Real half = radius > h ? std::sqrt(radius * radius - h * h) : 0;
    const Vector way = line.to - line.from;
    const Real unit = std::hypot(way.x, way.y); // from here on, lengths from the foot of the point
    return (std::max)((std::min)(dot(r, way) / unit, half) - (std::max)(dot(q, way) / unit, -half),
                      Real(0));
  }

  void add(Real from, Real to, const std::vector<double>& radii, Measured& measured,
           std::vector<Real>& reaches) const
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
      measured.free += m_radius * (to - from);
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
    if (nearest->is_wall) {
      measured.wall += length;
      return;
    }
    const Real touching = radii.empty() ? length : contact(*nearest, q, r, radii[nearest->other]);
    measured.contacts[nearest->other] += touching;
    measured.free += length - touching;
  }

  std::vector<Line> m_lines;
  const Real m_radius;
};

} // namespace domain_oracle

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_CELL_H
