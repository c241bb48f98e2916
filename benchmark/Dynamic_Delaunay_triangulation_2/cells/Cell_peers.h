// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi cells in a domain by other libraries, which triangulate the points anew in each call.
// Each function returns the sum of the areas.

#ifndef CELLS_CELL_PEERS_H
#define CELLS_CELL_PEERS_H

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include <array>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cells {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Points = std::vector<Point>;
using Domain = CGAL::Polygon_with_holes_2<Kernel>;

// Calls f(corners) for each bounded cell. Points far away around all others make theirs bounded.
template <class Function>
void for_each_cell(const Points& points, const Domain& domain, const Function& f)
{
  const CGAL::Bbox_2 box = domain.outer_boundary().bbox();
  const double x = (box.xmin() + box.xmax()) / 2, y = (box.ymin() + box.ymax()) / 2;
  const double far = 5 * (box.xmax() - box.xmin() + box.ymax() - box.ymin());
  CGAL::Delaunay_triangulation_2<Kernel> dt(points.begin(), points.end());
  std::vector<decltype(dt)::Vertex_handle> vertices;
  for (const auto v : dt.finite_vertex_handles())
    vertices.push_back(v);
  for (const Point& p :
       {Point(x - far, y), Point(x + far, y), Point(x, y - far), Point(x, y + far)})
    dt.insert(p);
  Points corners;
  for (const auto v : vertices) {
    corners.clear();
    auto face = dt.incident_faces(v);
    const auto first = face;
    do
      corners.push_back(dt.dual(face));
    while (++face != first);
    f(corners);
  }
}

// By the Boolean operations of CGAL, in exact numbers.
inline double sum_by_cgal(const Points& points, const Domain& domain)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Polygon = CGAL::Polygon_2<Exact>;
  const auto exact = [](const auto& corners) {
    Polygon polygon;
    for (const Point& p : corners) {
      const Exact::Point_2 q(p.x(), p.y());
      if (polygon.is_empty() || (q != polygon[polygon.size() - 1] && q != polygon[0]))
        polygon.push_back(q);
    }
    return polygon;
  };
  CGAL::Polygon_with_holes_2<Exact> exact_domain(exact(domain.outer_boundary()));
  for (const auto& hole : domain.holes())
    exact_domain.add_hole(exact(hole));
  double sum = 0;
  std::vector<CGAL::Polygon_with_holes_2<Exact>> pieces;
  for_each_cell(points, domain, [&](const Points& corners) {
    pieces.clear();
    CGAL::intersection(exact(corners), exact_domain, std::back_inserter(pieces));
    for (const auto& piece : pieces) {
      sum += CGAL::to_double(piece.outer_boundary().area());
      for (const auto& hole : piece.holes())
        sum += CGAL::to_double(hole.area());
    }
  });
  return sum;
}

// By Boost.Geometry, in doubles.
inline double sum_by_boost(const Points& points, const Domain& domain)
{
  namespace bg = boost::geometry;
  using Place = bg::model::d2::point_xy<double>;
  using Polygon = bg::model::polygon<Place, false, false>; // counterclockwise and open
  const auto append = [](const auto& corners, auto& ring) {
    for (const Point& p : corners)
      ring.push_back(Place(p.x(), p.y()));
  };
  Polygon bounds;
  append(domain.outer_boundary(), bounds.outer());
  for (const auto& hole : domain.holes()) {
    bounds.inners().emplace_back();
    append(hole, bounds.inners().back());
  }
  double sum = 0;
  bg::model::multi_polygon<Polygon> pieces;
  for_each_cell(points, domain, [&](const Points& corners) {
    Polygon cell;
    append(corners, cell.outer());
    pieces.clear();
    bg::intersection(cell, bounds, pieces);
    sum += bg::area(pieces);
  });
  return sum;
}

// By SciPy and Shapely, in a process of their own: the sum, and the seconds that it took.
inline std::pair<double, double> sum_by_python(const std::string& script, std::size_t points,
                                               std::size_t pillars)
{
  const std::string command = "/usr/bin/python3 -B '" + script + "' " + std::to_string(points) +
                              ' ' + std::to_string(pillars);
  std::FILE* const output = popen(command.c_str(), "r");
  std::pair<double, double> result{0, 0};
  const bool is_read =
      output != nullptr && std::fscanf(output, "%lf %lf", &result.first, &result.second) == 2;
  if (output == nullptr || pclose(output) != 0 || !is_read)
    throw std::runtime_error("without SciPy and Shapely");
  return result;
}

} // namespace cells

#endif // CELLS_CELL_PEERS_H
