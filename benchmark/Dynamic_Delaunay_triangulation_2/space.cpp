// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What an update costs in space, and what CGAL's insertion costs on the same frames. Each frame
// goes in turn to the dynamic triangulation, to CGAL's insertion of the range (`insert`), and to
// its insertion one by one with the last cell as hint, in an order that CGAL has sorted once
// (`sorted`). Time is that of the thread, in nanoseconds a point; `worst` is the slowest update,
// `/fastest` the median of the ratios of the faster of both to the update. `flips` a point, `held`
// in percent of the points, `relocated` a frame, `rebuilds` in percent of the frames.
//
// Kinds: `poisson`, `lattice` (jittered by 0.2 spacings) and `ball` take Gaussian steps, of `step`
// spacings in r.m.s.; `exact lattice` likewise; `slab` is 10 : 10 : 1. With a drift, all points
// move 0.7 spacings besides; `streams` are two, each by a step in its direction; in `jumps` five
// points go anywhere.
//
// `out of it` are nanoseconds a point of what comes out of a triangulation, beside the same by
// CGAL's Delaunay triangulation: lists of all neighbors, volumes of all Voronoi cells (of CGAL's
// from the circumcenters around each edge; it clips none to a box), and the nearest points of as
// many random places along a curve, each found from the last. `bytes` are those a point that the
// dynamic triangulation has allocated, after its construction and after a frame of 0.01 spacings,
// and those of CGAL's.
//
// `construction` is the ratio of the constructor's time to that of CGAL's insertion of the range.
// After the last frame every triangulation has to be valid, by exact predicates, and to have as
// many vertices as CGAL's. The first fault ends the program.

#include "common/Counted_heap.h"
#include "common/Program.h"
#include "common/Statistics.h"
#include "common/Table.h"
#include "common/Thread_time.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_neighbor_lists_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_point_queries_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/spatial_sort.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Points = std::vector<Point>;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<Kernel>;
using Static = CGAL::Delaunay_triangulation_3<Kernel>;

struct Options
{
  std::vector<std::size_t> points{10000, 100000};
  std::vector<double> steps{0.0001, 0.001, 0.01, 0.03, 0.1};
  std::vector<std::string> kinds{"poisson", "lattice", "ball",    "exact_lattice",
                                 "slab",    "drift",   "streams", "jumps"};
  int frames = 0;

  int frames_of(std::size_t n) const
  {
    return frames > 0 ? frames : n < 50000 ? 20 : n < 500000 ? 8 : 4;
  }
};

template <class Work>
double nanoseconds(std::size_t points, const Work& work)
{
  return common::thread_nanoseconds_of(work) / double(points);
}

// Points of density 1: the mean spacing is 1.
Points points_of(const std::string& kind, std::size_t n, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> share(0, 1);
  std::normal_distribution<double> jitter(0, kind == "lattice" ? 0.2 : 1);
  const double side = std::cbrt(double(n));
  Points points;
  if (kind == "lattice" || kind == "exact_lattice") {
    const int edge = int(std::lround(side));
    const double scale = kind == "lattice" ? 1 : 0;
    for (int i = 0; i != edge * edge * edge; ++i) {
      const double x = i / edge / edge + scale * jitter(random);
      const double y = i / edge % edge + scale * jitter(random);
      points.emplace_back(x, y, i % edge + scale * jitter(random));
    }
  } else {
    const double radius = std::cbrt(3 * double(n) / (4 * std::acos(-1.0)));
    const double height = std::cbrt(double(n) / 100);
    while (points.size() < n) {
      const double x = share(random), y = share(random), z = share(random);
      if (kind == "slab") {
        points.emplace_back(10 * height * x, 10 * height * y, height * z);
      } else if (kind != "ball") {
        points.emplace_back(side * x, side * y, side * z);
      } else if (std::hypot(2 * x - 1, 2 * y - 1, 2 * z - 1) < 1) {
        points.emplace_back(radius * (2 * x - 1), radius * (2 * y - 1), radius * (2 * z - 1));
      }
    }
  }
  CGAL::spatial_sort(points.begin(), points.end());
  return points;
}

void move(const std::string& kind, double step, Points& points, std::mt19937_64& random)
{
  std::normal_distribution<double> way(0, step / std::sqrt(3.0));
  const double drift = kind == "drift" ? 0.7 : 0, side = std::cbrt(double(points.size()));
  std::uniform_real_distribution<double> place(0, side);
  for (std::size_t i = 0; i != points.size(); ++i) {
    const Point& p = points[i];
    const double stream = kind == "streams" ? (i % 2 == 0 ? step : -step) : 0;
    const double share = kind == "streams" ? 0.1 : 1;
    const double x = p.x() + drift + stream + share * way(random);
    const double y = p.y() + drift / 3 + share * way(random);
    points[i] = Point(x, y, p.z() + share * way(random));
  }
  for (int i = 0; kind == "jumps" && i != 5; ++i) {
    const double x = place(random), y = place(random);
    points[random() % points.size()] = Point(x, y, place(random));
  }
}

void insert_sorted(const Points& points)
{
  Static fresh;
  Static::Cell_handle hint;
  for (const Point& p : points) {
    hint = fresh.insert(p, hint)->cell();
  }
}

void check(const Dynamic& dt, const Points& points)
{
  const Static fresh(points.begin(), points.end());
  if (!dt.is_valid(true) || dt.number_of_vertices() != fresh.number_of_vertices()) {
    throw std::runtime_error("a triangulation is wrong");
  }
}

void write_case(common::Table& table, const std::string& kind, std::size_t n, double step,
                int frames)
{
  std::mt19937_64 random(1);
  Points points = points_of(kind, n, random);
  n = points.size();
  Dynamic dt(points);
  std::vector<double> updates, ranges, sorted, fastest;
  double flips = 0, held = 0, relocated = 0, rebuilds = 0;
  for (int frame = 0; frame != frames; ++frame) {
    move(kind, step, points, random);
    CGAL::Update_report_3 report;
    updates.push_back(nanoseconds(n, [&] { report = dt.update(points); }));
    ranges.push_back(nanoseconds(n, [&] { const Static fresh(points.begin(), points.end()); }));
    sorted.push_back(nanoseconds(n, [&] { insert_sorted(points); }));
    fastest.push_back((std::min)(ranges.back(), sorted.back()));
    flips += double(report.flips);
    held += double(report.held);
    relocated += double(report.relocated);
    rebuilds += report.rebuilt();
  }
  check(dt, points);
  const double all = double(n) * frames;
  table.write_row("  " + kind + ' ' + common::cell(step, 4), common::median(updates),
                  common::largest(updates), common::median(ranges), common::median(sorted),
                  common::median_ratio(fastest, updates), flips / all, 100 * held / all,
                  relocated / frames, 100 * rebuilds / frames);
}

void write_construction(common::Table& table, std::size_t n)
{
  std::mt19937_64 random(1);
  Points points = points_of("poisson", n, random);
  std::shuffle(points.begin(), points.end(), random);
  std::vector<double> own, others;
  for (int i = 0; i != 5; ++i) {
    own.push_back(nanoseconds(n, [&] { const Dynamic dt(points); }));
    others.push_back(nanoseconds(n, [&] { const Static fresh(points.begin(), points.end()); }));
  }
  table.write_row("  construction", common::median(own), common::largest(own),
                  common::median(others), 0.0, common::median_ratio(others, own), 0.0, 0.0, 0.0,
                  0.0);
}

// The neighbors of all vertices, one vertex after the other.
std::size_t count_neighbors(const Static& fresh)
{
  std::vector<Static::Vertex_handle> neighbors;
  for (const Static::Vertex_handle v : fresh.finite_vertex_handles()) {
    fresh.finite_adjacent_vertices(v, std::back_inserter(neighbors));
  }
  return neighbors.size();
}

// Sixfold volume of the two pyramids over the Voronoi facet of an edge; 0 if it is unbounded.
double volume_at(const Static& fresh, const Static::Edge& edge)
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

double sum_of_volumes(const Static& fresh)
{
  double sum = 0;
  for (const Static::Edge& edge : fresh.finite_edges()) {
    sum += volume_at(fresh, edge) / 6;
  }
  return sum;
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
  table.write_row(name, common::median(owns), common::median(others),
                  common::median_ratio(others, owns));
}

void write_bytes(common::Table& table, Points& points, std::mt19937_64& random)
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

void write_out_of_it(common::Table& table, std::size_t n)
{
  std::mt19937_64 random(1);
  Points points = points_of("poisson", n, random);
  const Points places = points_of("poisson", n, random);
  const double side = std::cbrt(double(n));
  const CGAL::Bbox_3 box(0, 0, 0, side, side, side);
  const Dynamic dt(points);
  const Static fresh(points.begin(), points.end());
  std::size_t found = 0;
  double volume = 0;
  write_pair(
      table, "  neighbor lists", n, [&] { CGAL::Delaunay_neighbor_lists_3().compute(dt); },
      [&] { found += count_neighbors(fresh); });
  write_pair(
      table, "  Voronoi cells", n, [&] { CGAL::Voronoi_cell_measures_3().compute(dt); },
      [&] { volume += sum_of_volumes(fresh); });
  write_pair(
      table, "  cells in a box", n, [&] { CGAL::Voronoi_cell_measures_3().compute(dt, box); },
      [] {});
  const CGAL::Delaunay_point_queries_3<Dynamic> queries(dt);
  std::vector<std::optional<std::size_t>> nearest;
  write_pair(
      table, "  nearest points", n,
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
  write_bytes(table, points, random);
  if (found == 0 || !(volume > 0) || nearest.size() != n) {
    throw std::runtime_error("something is missing");
  }
}

void add_options(CLI::App& app, Options& options)
{
  app.description("Times updates in space against CGAL's insertion.");
  common::add_option(app, "--points", options.points, "N...", "how many; default 10000 100000",
                     CLI::Range(10, 100'000'000));
  common::add_option(app, "--steps", options.steps, "S...", "in spacings", CLI::Range(0.0, 1e3));
  common::add_option(app, "--kinds", options.kinds, "KIND...", "default: all",
                     CLI::IsMember(options.kinds));
  common::add_option(app, "--frames", options.frames, "N", "of each case; default 20 to 4",
                     CLI::Range(1, 100'000));
}

bool run_space(const Options& options, const std::string& command)
{
  common::Table table(std::cout, 24,
                      {{"update", 9, 0},
                       {"worst", 9, 0},
                       {"insert", 9, 0},
                       {"sorted", 9, 0},
                       {"/fastest", 10, 2},
                       {"flips", 8, 3},
                       {"held %", 8, 3},
                       {"relocated", 11, 2},
                       {"rebuilds %", 12, 0}});
  common::Table out(std::cout, 24, {{"own", 9, 0}, {"CGAL", 9, 0}, {"/CGAL", 9, 2}});
  for (const std::size_t n : options.points) {
    out.write_head("out of " + std::to_string(n) + " points");
    write_out_of_it(out, n);
    table.write_head(std::to_string(n) + " points");
    write_construction(table, n);
    for (const std::string& kind : options.kinds) {
      for (const double step : options.steps) {
        write_case(table, kind, n, step, options.frames_of(n));
      }
    }
  }
  std::cout << '\n' << command << std::endl;
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  return common::run_program<Options>("space", argc, argv, add_options, run_space);
}
