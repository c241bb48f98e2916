// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the thesis's point distance classifier (4.2.2) finds and misses in space, and what it costs
// beside the exact pass; and what it does in the plane on the same kind of motion. Points of
// density 1 in a cube or square take Gaussian steps, of `step` spacings in r.m.s. Every frame
// begins with the Delaunay triangulation of the last one. Before it is updated, classifiers look at
// the new positions and the old cells; and so does the truth, by exact predicates: broken are the
// vertices of each finite cell that is not positive, and of both cells at each facet that is not
// locally Delaunay, that is, all whose neighbors a flip would change.
//
// `point_distance:x` picks both ends of an edge whose length has left the range
// from x Lt to (2 - x) Lt, with the length Lt that it had when its neighborhood was last
// triangulated. That is, when the edge came up, or when an end was among the vertices that this
// classifier had picked or among their neighbors, its padding, whose edges the thesis would
// triangulate anew. `refined:x` (7.2.1) keeps of these picks those that are broken, as a
// circumsphere classifier at the picks would find; `ns` is without that.
//
//   broken %   broken vertices of all
//   picked %   picked vertices of all
//   precision  share of the picked vertices that are broken
//   recall     share of the broken vertices that are picked
//   padded     share of them that are picked or padding
//   valid %    frames in which all are
//   ns         the classifier, in nanoseconds a point, without what keeps its lengths
//   pass ns    in space, the exact pass on the same frames: the filter on all cells, and exact
//              predicates where it proves nothing
//
// Time is that of the thread, medians over all frames.

#include "common/Program.h"
#include "common/Statistics.h"
#include "common/Table.h"
#include "common/Thread_time.h"
#include "space_classifiers/Broken_vertices_2.h"
#include "space_classifiers/Broken_vertices_3.h"
#include "space_classifiers/Point_distance.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/spatial_sort.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace space_classifiers;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// `make()` calls a function of the axis for each coordinate, in their order.
struct In_plane
{
  static constexpr int dimension = 2;
  using Point = Kernel::Point_2;
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
  using Broken_vertices = Broken_vertices_2;

  template <class Coordinate>
  static Point make(const Coordinate& coordinate)
  {
    const double x = coordinate(0);
    return Point(x, coordinate(1));
  }
};
struct In_space
{
  static constexpr int dimension = 3;
  using Point = Kernel::Point_3;
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<Kernel>;
  using Broken_vertices = Broken_vertices_3;

  template <class Coordinate>
  static Point make(const Coordinate& coordinate)
  {
    const double x = coordinate(0), y = coordinate(1);
    return Point(x, y, coordinate(2));
  }
};

struct Options
{
  std::size_t points = 10000;
  int frames = 100;
  std::vector<double> steps{0.0001, 0.001, 0.01, 0.03, 0.1};
  std::vector<double> parameters{0.7, 0.9, 0.99, 0.999};
};

// A classifier, and what it has found in all frames, in vertices.
template <class Point>
struct Method
{
  std::string name;
  Point_distance<Point> classifier;
  bool is_refined;
  double picked = 0, picked_broken = 0, covered_broken = 0;
  int valid_frames = 0;
  std::vector<double> nanoseconds{};
};

template <class Work>
double nanoseconds(std::size_t points, const Work& work)
{
  return common::thread_nanoseconds_of(work) / double(points);
}

template <class Space>
std::vector<typename Space::Point> poisson_points(std::size_t n, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> place(0, std::pow(double(n), 1.0 / Space::dimension));
  std::vector<typename Space::Point> points;
  while (points.size() < n) {
    points.push_back(Space::make([&](int) { return place(random); }));
  }
  CGAL::spatial_sort(points.begin(), points.end());
  return points;
}

template <class Space>
void move(double step, std::vector<typename Space::Point>& points, std::mt19937_64& random)
{
  std::normal_distribution<double> way(0, step / std::sqrt(double(Space::dimension)));
  for (auto& p : points) {
    p = Space::make([&](int axis) { return p[axis] + way(random); });
  }
}

// Follows one motion with all classifiers.
template <class Space>
class Study
{
  static constexpr bool has_pass = Space::dimension == 3;
  using Classifier = Point_distance<typename Space::Point>;

public:
  Study(const Options& options, double step)
    : m_options(options)
    , m_step(step)
    , m_points(poisson_points<Space>(options.points, m_random))
    , m_dt(m_points)
  {
    m_edges.read(m_dt);
    for (const bool is_refined : {false, true}) {
      for (const double x : options.parameters) {
        const std::string name = is_refined ? " refined:" : " point_distance:";
        m_methods.push_back(
            {common::cell(step, 4) + name + common::cell(x, 3), Classifier(x), is_refined});
        m_methods.back().classifier.start(m_edges, m_points);
      }
    }
  }

  void run()
  {
    for (int frame = 0; frame != m_options.frames; ++frame) {
      move<Space>(m_step, m_points, m_random);
      m_truth.find(m_dt, m_points);
      if constexpr (has_pass) {
        time_pass();
      }
      m_broken += double(m_truth.number());
      for (auto& method : m_methods) {
        classify(method);
      }
      m_dt.update(m_points);
      m_edges.read(m_dt);
      for (auto& method : m_methods) {
        method.classifier.after_update(m_edges, m_points);
      }
    }
    if (!m_dt.is_valid(true)) {
      throw std::runtime_error("a triangulation is wrong");
    }
  }

  void write(common::Table& table) const
  {
    const double all = double(m_points.size()) * m_options.frames;
    for (const auto& its : m_methods) {
      std::vector<double> values{
          100 * m_broken / all,           100 * its.picked / all,
          its.picked_broken / its.picked, its.picked_broken / m_broken,
          its.covered_broken / m_broken,  100.0 * its.valid_frames / m_options.frames,
          common::median(its.nanoseconds)};
      if (has_pass) {
        values.push_back(common::median(m_pass));
      }
      std::vector<std::string> cells;
      for (const double value : values) { // 0 of 0 is no share
        const int decimals = table.columns()[cells.size()].decimals;
        cells.push_back(std::isfinite(value) ? common::cell(value, decimals) : "-");
      }
      table.write_cells(its.name, cells);
    }
  }

private:
  void time_pass()
  {
    std::size_t cells = 0;
    m_pass.push_back(nanoseconds(m_points.size(), [&] { cells = m_truth.classify(); }));
    if ((cells > 0) != (m_truth.number() > 0)) {
      throw std::runtime_error("the exact pass is wrong");
    }
  }

  void classify(Method<typename Space::Point>& method)
  {
    Classifier& classifier = method.classifier;
    method.nanoseconds.push_back(
        nanoseconds(m_points.size(), [&] { classifier.classify(m_edges, m_points); }));
    if (method.is_refined) {
      classifier.keep([this](std::size_t id) { return m_truth.is_broken(id); });
    }
    classifier.pad(m_edges);
    std::size_t picked_broken = 0, covered_broken = 0;
    for (std::size_t id = 0; id != m_points.size(); ++id) {
      if (m_truth.is_broken(id)) {
        picked_broken += classifier.is_picked(id);
        covered_broken += classifier.is_covered(id);
      }
    }
    method.picked += double(classifier.number_picked());
    method.picked_broken += double(picked_broken);
    method.covered_broken += double(covered_broken);
    method.valid_frames += covered_broken == m_truth.number();
  }

  const Options& m_options;
  double m_step;
  std::mt19937_64 m_random{1};
  std::vector<typename Space::Point> m_points;
  typename Space::Dynamic m_dt;
  Edge_list m_edges;
  std::vector<Method<typename Space::Point>> m_methods;
  typename Space::Broken_vertices m_truth;
  double m_broken = 0;
  std::vector<double> m_pass; // nanoseconds a point
};

void add_options(CLI::App& app, Options& options)
{
  app.description("Compares point distance in space with what motion has broken.");
  common::add_option(app, "--points", options.points, "N", "how many; default 10000",
                     CLI::Range(10, 100'000'000));
  common::add_option(app, "--frames", options.frames, "N", "of each step; default 100",
                     CLI::Range(1, 100'000));
  common::add_option(app, "--steps", options.steps, "S...", "in spacings", CLI::Range(0.0, 1e3));
  common::add_option(app, "--parameters", options.parameters, "X...", "of point distance",
                     CLI::Range(0.0, 1.0));
}

template <class Space>
void write_table(common::Table& table, const std::string& where, const Options& options)
{
  table.write_head(std::to_string(options.points) + " points " + where);
  for (const double step : options.steps) {
    Study<Space> study(options, step);
    study.run();
    study.write(table);
  }
}

bool run_study(const Options& options, const std::string& command)
{
  common::Table table(std::cout, 28,
                      {{"broken %", 9, 3},
                       {"picked %", 9, 2},
                       {"precision", 10, 3},
                       {"recall", 7, 3},
                       {"padded", 7, 3},
                       {"valid %", 8, 0},
                       {"ns", 7, 1},
                       {"pass ns", 8, 1}});
  write_table<In_space>(table, "in space", options);
  std::cout << '\n';
  write_table<In_plane>(table, "in the plane", options);
  std::cout << '\n' << command << std::endl;
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  return common::run_program<Options>("space_classifiers", argc, argv, add_options, run_study);
}
