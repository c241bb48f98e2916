// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Lloyd's relaxation of a uniform cloud in a square, where every point moves to the centroid of its
// Voronoi cell in each iteration: what the triangulation costs if it is updated, and if it is made
// anew, in two ways. All three are timed in the same process on the same points, in turn, the order
// rotating. Only triangulating is timed; the cells and the motion are not.
//
//   update    Dynamic_Delaunay_triangulation_2::update()
//   insert    CGAL's insertion of the range
//   ordered   CGAL's insertion one by one along the last iteration's Hilbert curve, the fastest
//             static way that we know
//   q1, q3    quartiles of the column before
//   i/u, o/u  the times of the others as multiples of that of the update: medians of the ratios in
//             an iteration, or a relaxation
//   frames    iterations that were timed
//   flips     a point and iteration
//   rebuilds  iterations in which the update chose to triangulate everything anew
//   step      mean way of a point, in units of the mean spacing
//
// The first table has medians over single iterations, by their numbers; the second one medians over
// whole relaxations, whose times are the sums of all of their iterations. Each relaxation starts
// with another cloud.
//
// Every update has to be certified, the last one of a relaxation has to be valid and to agree with
// a fresh triangulation in every edge, and the steps have to become shorter. A case that fails says
// so in place of its figures, and the program ends with an error.

#include "common/Cases.h"
#include "common/Contest.h"
#include "common/Statistics.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Simulated_motion.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace common;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<run::Kernel>;

constexpr std::size_t iterations = 100;

// RELAXATION --------------------------------------------------------------------------------------

// In nanoseconds.
struct Times
{
  double update = 0.0;
  double insert = 0.0;
  double ordered = 0.0;
};

struct Iteration
{
  Times times{};
  CGAL::Update_report_2 report{};
  double step = 0.0;
};

using Iterations = std::vector<Iteration>;

// A relaxation of a cloud with one point to a unit of area.
class Relaxation
{
public:
  Relaxation(std::size_t points, scenario::Random_source& random)
    : m_side(std::sqrt(static_cast<double>(points)))
    , m_points(random_cloud<scenario::Point>(points, random))
  {
    m_dynamic = Dynamic(m_points.begin(), m_points.end(), run::Point_map());
    m_opponents.prepare(m_points, true); // for the spatial order
  }

  Iterations run()
  {
    Iterations results;
    for (std::size_t i = 0; i != iterations; ++i) {
      Iteration result;
      result.step = move();
      m_opponents.prepare(m_points, false);
      time_all(i, result);
      require(result.report.certified, "an update is not certified");
      results.push_back(result);
    }
    require_equal(m_dynamic, m_opponents.reference());
    require(results.back().step < results.front().step, "the steps do not become shorter");
    return results;
  }

private:
  // Moves points to centroids, and returns their mean way.
  double move()
  {
    m_cells.compute(m_dynamic, CGAL::Bbox_2(0.0, 0.0, m_side, m_side));
    double way = 0.0;
    for (std::size_t i = 0; i != m_points.size(); ++i) {
      const auto& centroid = m_cells.centroids()[i];
      way += std::hypot(centroid.x - m_points[i].x, centroid.y - m_points[i].y);
      m_points[i] = {centroid.x, centroid.y};
    }
    return way / static_cast<double>(m_points.size());
  }

  void time_all(std::size_t iteration, Iteration& result)
  {
    in_turn(iteration, 3, [&](std::size_t contestant) {
      if (contestant == 0) {
        result.times.update = run::nanoseconds_of([&] {
          result.report = m_dynamic.update(m_points.begin(), m_points.end(), run::Point_map());
        });
      } else if (contestant == 1) {
        result.times.insert = m_opponents.time_insert();
      } else {
        result.times.ordered = m_opponents.time_fastest();
      }
    });
  }

  double m_side;
  std::vector<scenario::Point> m_points;
  Dynamic m_dynamic;
  CGAL::Voronoi_cell_measures_2 m_cells;
  run::Static_opponents m_opponents;
};

// More relaxations of few points, whose times scatter.
std::size_t relaxations_of(std::size_t points)
{
  constexpr std::size_t fewest = 3, most = 30, all_points = 100'000;
  return std::clamp(all_points / points, fewest, most);
}

// The relaxations of each size, which all its cases share, and which are computed for the first.
class Relaxations
{
public:
  const std::vector<Iterations>& of(std::size_t points)
  {
    std::vector<Iterations>& results = m_results[points];
    scenario::Random_source random(points);
    while (results.size() != relaxations_of(points)) {
      results.push_back(Relaxation(points, random).run());
    }
    return results;
  }

private:
  std::map<std::size_t, std::vector<Iterations>> m_results;
};

// FIGURES -----------------------------------------------------------------------------------------

void add_contestant(Figures& figures, const std::string& name, const std::vector<Times>& times,
                    double Times::*time, double unit)
{
  const std::string letter = name.substr(0, 1);
  add_spread(figures, name, letter + '_',
             values_of(times, [&](const Times& one) { return one.*time / unit; }));
  figures[letter + "/u"] = median_ratio(values_of(times, time), values_of(times, &Times::update));
}

// `unit`: of the times, in nanoseconds.
void add_times(Figures& figures, const std::vector<Times>& times, double unit)
{
  add_contestant(figures, "update", times, &Times::update, unit);
  add_contestant(figures, "insert", times, &Times::insert, unit);
  add_contestant(figures, "ordered", times, &Times::ordered, unit);
}

double seconds_of(const std::vector<Times>& times)
{
  constexpr double nanosecond = 1e-9;
  return nanosecond * sum(values_of(times, [](const Times& one) {
           return one.update + one.insert + one.ordered;
         }));
}

// Iterations from `first` to `last`, which count from 1.
Case_result iterations_case(const std::vector<Iterations>& relaxations, std::size_t points,
                            std::size_t first, std::size_t last)
{
  std::vector<Times> times;
  double flips = 0.0, rebuilds = 0.0, steps = 0.0;
  for (const Iterations& relaxation : relaxations) {
    for (std::size_t i = first - 1; i != last; ++i) {
      times.push_back(relaxation[i].times);
      flips += static_cast<double>(relaxation[i].report.flips);
      rebuilds += relaxation[i].report.rebuilt() ? 1.0 : 0.0;
      steps += relaxation[i].step;
    }
  }
  const auto number = static_cast<double>(times.size());
  Case_result result;
  result.figures["frames"] = number;
  result.figures["flips"] = flips / number / static_cast<double>(points);
  result.figures["rebuilds"] = rebuilds;
  result.figures["step"] = steps / number;
  result.seconds = seconds_of(times);
  add_times(result.figures, times, static_cast<double>(points));
  return result;
}

Case_result whole_case(const std::vector<Iterations>& relaxations)
{
  constexpr double millisecond = 1e6;
  std::vector<Times> sums;
  for (const Iterations& relaxation : relaxations) {
    Times sum;
    for (const Iteration& iteration : relaxation) {
      sum.update += iteration.times.update;
      sum.insert += iteration.times.insert;
      sum.ordered += iteration.times.ordered;
    }
    sums.push_back(sum);
  }
  Case_result result;
  result.figures["runs"] = static_cast<double>(sums.size());
  result.seconds = seconds_of(sums);
  add_times(result.figures, sums, millisecond);
  return result;
}

// ALL ---------------------------------------------------------------------------------------------

std::vector<Column> columns(const Column& count, const std::vector<Column>& more)
{
  std::vector<Column> columns = {count,          {"update", 9, 1},  {"u_q1", 8, 1},
                                 {"u_q3", 8, 1}, {"insert", 9, 1},  {"i_q1", 8, 1},
                                 {"i_q3", 8, 1}, {"ordered", 9, 1}, {"o_q1", 8, 1},
                                 {"o_q3", 8, 1}, {"i/u", 7, 2},     {"o/u", 7, 2}};
  columns.insert(columns.end(), more.begin(), more.end());
  return columns;
}

const Case_table by_iterations = {
    "Iterations by their numbers, ns a point",
    columns({"frames", 8, 0}, {{"flips", 9, 4}, {"rebuilds", 9, 0}, {"step", 8, 4}})};
const Case_table whole = {"Whole relaxations, a hundred iterations, ms",
                          columns({"runs", 8, 0}, {})};

void add_all(Case_list& cases, Relaxations& relaxations)
{
  const std::size_t sizes[] = {1'000, 10'000, 100'000};
  const std::size_t lasts[] = {1, 2, 5, 10, 20, 50, iterations};
  for (const std::size_t points : sizes) {
    std::size_t first = 1;
    for (const std::size_t last : lasts) {
      const std::string numbers = first == last
                                      ? std::to_string(first)
                                      : std::to_string(first) + '-' + std::to_string(last);
      cases.add(by_iterations, std::to_string(points) + "/iteration_" + numbers, [=, &relaxations] {
        return iterations_case(relaxations.of(points), points, first, last);
      });
      first = last + 1;
    }
  }
  for (const std::size_t points : sizes) {
    cases.add(whole, std::to_string(points) + "/all",
              [=, &relaxations] { return whole_case(relaxations.of(points)); });
  }
}

} // namespace

int main(int argc, char** argv)
{
  Relaxations relaxations;
  return run_case_program(
      "lloyd", [&relaxations](Case_list& cases) { add_all(cases, relaxations); }, argc, argv);
}
