// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The parts of a domain in a Voronoi cell, found without a Delaunay triangulation and without
// triangles: by CGAL's Boolean operations on polygons with arcs, in exact numbers.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_DOMAIN_ORACLE_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_DOMAIN_ORACLE_H

#include "query_oracle.h"
#include "visible_cell.h"

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
#include <set>
#include <utility>
#include <variant>
#include <vector>

namespace domain_oracle {

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
    const CGAL::Bbox_2 box = domain.outer_boundary().bbox();
    const double size = 1 + (box.xmax() - box.xmin()) + (box.ymax() - box.ymin());
    const CGAL::Bbox_2 around(box.xmin() - size, box.ymin() - size, box.xmax() + size,
                              box.ymax() + size);
    m_set.insert(polygon(query_oracle::clipped_cell(points, points[id], around)));
    const auto of_ring = [](const Polygon& ring) {
      return polygon(query_oracle::exact_points(ring.container()));
    };
    Set of_domain(of_ring(domain.outer_boundary()));
    for (const Polygon& hole : domain.holes())
      of_domain.difference(of_ring(hole));
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
      const Traits::Point_2 p(query_oracle::exact(m_p).x(), query_oracle::exact(m_p).y());
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

  General_polygon disc(double radius) const
  {
    const Epeck::FT r = radius;
    Traits traits;
    const Traits::Curve_2 circle(query_oracle::exact(m_p), r);
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
    return {Real(CGAL::to_double(q.x() - Traits::CoordNT(query_oracle::exact(m_p).x()))),
            Real(CGAL::to_double(q.y() - Traits::CoordNT(query_oracle::exact(m_p).y())))};
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

} // namespace domain_oracle

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_DOMAIN_ORACLE_H
