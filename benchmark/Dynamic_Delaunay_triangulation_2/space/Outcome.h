// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPACE_OUTCOME_H
#define SPACE_OUTCOME_H

#include "../common/Counted_heap.h"
#include "../common/Statistics.h"
#include "../common/Table.h"
#include "Space_points.h"
#include "Static_ways.h"
#include "Voro_cells.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_neighbor_lists_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_point_queries_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_volumes_3.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace space {

// The neighbors of all vertices, one vertex after the other.
inline std::size_t count_neighbors(const Static& fresh)
{
  std::vector<Static::Vertex_handle> neighbors;
  for (const Static::Vertex_handle v : fresh.finite_vertex_handles()) {
    fresh.finite_adjacent_vertices(v, std::back_inserter(neighbors));
  }
  return neighbors.size();
}

// Sixfold volume of the two pyramids over the Voronoi facet of an edge; 0 if it is unbounded.
inline double volume_at(const Static& fresh, const Static::Edge& edge)
{
  const Point p = edge.first->vertex(edge.second)->point();
  const Point q = edge.first->vertex(edge.third)->point();
  std::vector<Point> corners;
  Static::Cell_circulator c = fresh.incident_cells(edge), end = c;
  do {
    if (fresh.is_infinite(c)) {
      return 0;
    }
    corners.push_back(c->circumcenter());
  } while (++c != end);
  Kernel::Vector_3 area(0, 0, 0);
  for (std::size_t i = 2; i < corners.size(); ++i) {
    area += CGAL::cross_product(corners[i - 1] - corners[0], corners[i] - corners[0]);
  }
  return std::abs(area * (q - p));
}

inline double sum_of_volumes(const Static& fresh)
{
  double sum = 0;
  for (const Static::Edge& edge : fresh.finite_edges()) {
    sum += volume_at(fresh, edge) / 6;
  }
  return sum;
}

// In random clouds cells near the hull may have corners some thousand spacings away.
inline void compare_volumes(const std::vector<double>& alone, const std::vector<double>& measured)
{
  for (std::size_t i = 0; i != alone.size(); ++i) {
    const bool are_close = std::isinf(measured[i])
                               ? std::isinf(alone[i])
                               : std::abs(alone[i] - measured[i]) <= 1e-4 * (1 + measured[i]);
    if (!are_close) {
      throw std::runtime_error("a Voronoi cell has two volumes");
    }
  }
}

inline common::Table outcome_table()
{
  return common::Table(std::cout, 26, {{"own", 9, 0}, {"other", 9, 0}, {"/other", 9, 2}});
}

template <class Own, class Other>
void write_pair(common::Table& table, const std::string& name, std::size_t n, const Own& own,
                const Other& other)
{
  std::vector<double> owns, others;
  for (int i = 0; i != 5; ++i) {
    owns.push_back(nanoseconds(n, own));
    others.push_back(nanoseconds(n, other));
  }
  table.write_row("  " + name, common::median(owns), common::median(others),
                  common::median_ratio(others, owns));
}

inline void write_bytes(common::Table& table, Points& points, std::mt19937_64& random)
{
  const std::size_t n = points.size();
  const auto bytes_since = [n](std::size_t before) {
    return double(common::live_heap_bytes() - before) / double(n);
  };
  const std::size_t before = common::live_heap_bytes();
  Dynamic dt(points);
  const double constructed = bytes_since(before);
  move("poisson", 0.01, points, random);
  dt.update(points);
  const double moved = bytes_since(before);
  const std::size_t beside = common::live_heap_bytes();
  const Static fresh(points.begin(), points.end());
  const double others = bytes_since(beside);
  table.write_row("  bytes, constructed", constructed, others, others / constructed);
  table.write_row("  bytes, moved", moved, others, others / moved);
}

#ifdef HAS_VORO

// Each cell has to have the same volume, and all together that of the box.
inline void compare(const std::vector<double>& own, const std::vector<double>& others,
                    const CGAL::Bbox_3& box)
{
  const double all = box.x_span() * box.y_span() * box.z_span(), tolerance = 1e-9;
  for (const double sum : {common::sum(own), common::sum(others)}) {
    if (!(std::abs(sum - all) <= tolerance * all)) {
      throw std::runtime_error("volumes do not add up to that of the box");
    }
  }
  for (std::size_t i = 0; i != own.size(); ++i) {
    if (!(std::abs(own[i] - others[i]) <= tolerance * (1 + own[i]))) {
      throw std::runtime_error("a cell has another volume");
    }
  }
}

inline void write_voro_cells(common::Table& table, const Points& points, const Dynamic& dt,
                             const CGAL::Bbox_3& box)
{
  const std::size_t n = points.size();
  CGAL::Voronoi_cell_measures_3 measures;
  std::vector<double> volumes;
  write_pair(
      table, "volumes in a box, voro++", n, [&] { measures.compute(dt, box); },
      [&] { volumes = Voro_cells(points, box).volumes(); });
  compare(measures.volumes(), volumes, box);
  write_pair(
      table, "cells in a box, voro++", n, [&] { measures.compute(dt, box); },
      [&] { Voro_cells(points, box).measure(); });
  write_pair(
      table, "from points, voro++", n, [&] { measures.compute(Dynamic(points), box); },
      [&] { Voro_cells(points, box).measure(); });
}

#else

inline void write_voro_cells(common::Table& table, const Points& points, const Dynamic& dt,
                             const CGAL::Bbox_3& box)
{
  const double own =
      nanoseconds(points.size(), [&] { CGAL::Voronoi_cell_measures_3().compute(dt, box); });
  table.write_cells("  cells in a box", {common::cell(own, 0)},
                    "  voro++ was not there when CMake ran");
}

#endif // HAS_VORO

inline void write_nearest_points(common::Table& table, const Points& places, const Dynamic& dt,
                                 const Static& fresh)
{
  const CGAL::Delaunay_point_queries_3<Dynamic> queries(dt);
  std::vector<std::optional<std::size_t>> nearest;
  write_pair(
      table, "nearest points", places.size(),
      [&] {
        nearest.clear();
        queries.nearest(places.begin(), places.end(), std::back_inserter(nearest));
      },
      [&] {
        Static::Cell_handle hint;
        for (const Point& p : places) {
          hint = fresh.nearest_vertex(p, hint)->cell();
        }
      });
  if (nearest.size() != places.size()) {
    throw std::runtime_error("a nearest point is missing");
  }
}

inline void write_out_of_it(common::Table& table, std::size_t n)
{
  std::mt19937_64 random(1);
  Points points = points_of("poisson", n, random);
  const Points places = points_of("poisson", n, random);
  const double side = std::cbrt(double(n));
  const Dynamic dt(points);
  const Static fresh(points.begin(), points.end());
  std::size_t found = 0;
  double volume = 0;
  write_pair(
      table, "neighbor lists", n, [&] { CGAL::Delaunay_neighbor_lists_3().compute(dt); },
      [&] { found += count_neighbors(fresh); });
  CGAL::Voronoi_cell_volumes_3 volumes;
  write_pair(
      table, "Voronoi volumes", n, [&] { volumes.compute(dt); },
      [&] { volume += sum_of_volumes(fresh); });
  CGAL::Voronoi_cell_measures_3 measures;
  write_pair(
      table, "Voronoi cells", n, [&] { measures.compute(dt); },
      [&] { volume += sum_of_volumes(fresh); });
  if (found == 0 || !(volume > 0)) {
    throw std::runtime_error("something is missing");
  }
  compare_volumes(volumes.volumes(), measures.volumes());
  write_voro_cells(table, points, dt, CGAL::Bbox_3(0, 0, 0, side, side, side));
  write_nearest_points(table, places, dt, fresh);
  write_bytes(table, points, random);
}

} // namespace space

#endif // SPACE_OUTCOME_H
