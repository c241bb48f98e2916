// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the static engines cost, in nanoseconds a point: for rebuilds of everything, and for the
// regions of border splices. All of them are timed in the same process on the same points, in turn.
// `i/g` and `b/g` are the times of the others as multiples of that of the first one: medians of the
// ratios in a frame.
//
// A rebuild is what Rebuild_repair_2 does: it sorts the points, triangulates, and writes the flat
// arrays and CGAL's structure. Only the triangulating differs.
//   jump    every point is at a fresh random place in every frame: vertices are numbered anew
//   step    every point takes a Gaussian step of a fifth of the spacing: they keep their numbers
//   grid    a square grid whose points are displaced by up to a tenth of its spacing in every frame
//
// A splice is what Border_splice_repair_2 does: it finds the sets, triangulates, compares the
// boundaries, and writes. In every frame other scattered points of a random cloud are named, with
// more and more padding around them. No point moves, so every region has to come out as it was.
// `points` is the mean size of a region, including its border; times are divided by the number of
// points in regions.
//
// Times are medians over the frames, with their quartiles. After the last frame every triangulation
// has to be valid and to be proved Delaunay by exact predicates, edge by edge. A case that fails
// says so in place of its figures, and the program ends with an error.

#include "common/Cases.h"
#include "common/Contest.h"
#include "common/Statistics.h"
#include "common/Timed_phases.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Repairs_and_policies.h"
#include "scenario_runner/Simulated_motion.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Border_splice_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Rebuild_repair_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using namespace common;
using Point = run::Kernel::Point_2;
using Points = std::vector<Point>;
using Ids = std::vector<std::size_t>;

// TRIANGULATIONS ----------------------------------------------------------------------------------

// Names these points. Nothing has to be proved.
class Naming_classifier
{
public:
  static constexpr bool is_exact = false;

  explicit Naming_classifier(const Ids& named)
    : m_named(&named)
  {
  }

  template <class Frame, class Classification>
  void operator()(const Frame&, Classification& classified) const
  {
    for (const std::size_t id : *m_named) {
      classified.add_id(id);
    }
  }

private:
  const Ids* m_named;
};

// One triangulation for each engine, all of the same points.
template <class Repair>
class Contest
{
public:
  Contest(const Points& points, const Repair& repair)
    : m_times(run::engines().size())
  {
    for (const auto& [name, engine] : run::engines()) {
      const typename Dynamic::Settings settings{Naming_classifier(m_named),
                                                Clocked_repair<Repair>(repair, m_nanoseconds),
                                                {engine, engine}};
      m_triangulations.emplace_back(points.begin(), points.end(), settings);
    }
  }
  Contest(const Contest&) = delete;
  Contest& operator=(const Contest&) = delete;

  // Lets all triangulations repair a frame at these points. Times are divided by
  // `divisor(report)`.
  template <class Divisor>
  void measure(const Points& points, const Ids& named, Divisor divisor)
  {
    m_named = named;
    in_turn(m_frames, m_times.size(), [&](std::size_t engine) {
      const auto report = m_triangulations[engine].update(points.begin(), points.end());
      m_times[engine].push_back(m_nanoseconds / divisor(report));
    });
    ++m_frames;
  }

  void check()
  {
    for (auto& triangulation : m_triangulations) {
      require(triangulation.certify() && triangulation.is_valid(),
              "a triangulation is not Delaunay");
    }
  }

  Case_result result(double points) const
  {
    Case_result result;
    Figures& figures = result.figures;
    figures["points"] = points;
    figures["frames"] = static_cast<double>(m_frames);
    for (std::size_t engine = 0; engine != m_times.size(); ++engine) {
      const std::string& name = run::engines()[engine].first;
      const std::string letter = name.substr(0, 1);
      add_spread(figures, name, letter + '_', m_times[engine]);
      figures[letter + "/g"] = median_ratio(m_times[engine], m_times.front());
    }
    return result;
  }

private:
  using Dynamic =
      CGAL::Dynamic_Delaunay_triangulation_2<run::Kernel, Naming_classifier,
                                             CGAL::With_repair_2<Clocked_repair<Repair>>>;

  Ids m_named;
  double m_nanoseconds = 0.0; // of the last repair
  std::vector<Dynamic> m_triangulations;
  std::vector<std::vector<double>> m_times;
  std::size_t m_frames = 0;
};

// REBUILDS ----------------------------------------------------------------------------------------

// The points of the next frame.
using Move = Points (*)(const Points& points, scenario::Random_source& random);

Points at_fresh_places(const Points& points, scenario::Random_source& random)
{
  return random_cloud<Point>(points.size(), random);
}

Points on_displaced_grid(const Points& points, scenario::Random_source& random)
{
  const auto columns =
      static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(points.size()))));
  Points result;
  for (std::size_t i = 0; i != points.size(); ++i) {
    const double x = static_cast<double>(i % columns) + random.uniform(-0.1, 0.1);
    result.emplace_back(x, static_cast<double>(i / columns) + random.uniform(-0.1, 0.1));
  }
  return result;
}

Points stepped(const Points& points, scenario::Random_source& random)
{
  constexpr double step = 0.2;
  Points result;
  for (const Point& point : points) {
    const double dx = step * random.gaussian();
    result.emplace_back(point.x() + dx, point.y() + step * random.gaussian());
  }
  return result;
}

// More frames of few points, whose times scatter.
std::size_t frames_for(std::size_t points)
{
  constexpr std::size_t fewest = 5, most = 1000, all_points = 3'000'000;
  return std::clamp(all_points / points, fewest, most);
}

Case_result rebuild_case(std::size_t number, Move move)
{
  scenario::Random_source random(number);
  Points points = random_cloud<Point>(number, random);
  Contest<CGAL::Rebuild_repair_2> contest(points, CGAL::Rebuild_repair_2());
  for (std::size_t frame = 0; frame != frames_for(number); ++frame) {
    points = move(points, random);
    contest.measure(points, {0}, [&](const auto&) { return static_cast<double>(points.size()); });
  }
  contest.check();
  return contest.result(static_cast<double>(number));
}

// SPLICES -----------------------------------------------------------------------------------------

// Points near the places of a lattice with a random origin, `distance` apart from each other.
Ids scattered_ids(const Points& points, double distance, scenario::Random_source& random)
{
  const double side = std::sqrt(static_cast<double>(points.size()));
  const auto rows = static_cast<std::size_t>(side / distance);
  const double x0 = random.uniform(0.0, distance), y0 = random.uniform(0.0, distance);
  std::vector<double> nearest(rows * rows, 1.0); // squared distances; farther points are not near
  Ids ids(rows * rows, points.size());
  for (std::size_t id = 0; id != points.size(); ++id) {
    const double x = (points[id].x() - x0) / distance, y = (points[id].y() - y0) / distance;
    const double column = std::round(x), row = std::round(y);
    const double squared_distance =
        distance * distance * ((x - column) * (x - column) + (y - row) * (y - row));
    if (column < 0.0 || row < 0.0) {
      continue;
    }
    const std::size_t place =
        static_cast<std::size_t>(row) * rows + static_cast<std::size_t>(column);
    if (column < static_cast<double>(rows) && place < ids.size() &&
        squared_distance < nearest[place]) {
      nearest[place] = squared_distance;
      ids[place] = id;
    }
  }
  ids.erase(std::remove(ids.begin(), ids.end(), points.size()), ids.end());
  return ids;
}

Case_result splice_case(unsigned padding)
{
  constexpr std::size_t number = 20'000, frames = 100;
  const double distance = 3.0 * (padding + 2.0); // an edge is hardly ever longer than 1.5
  scenario::Random_source random(padding);
  const Points points = random_cloud<Point>(number, random);
  Contest<CGAL::Border_splice_repair_2> contest(points, CGAL::Border_splice_repair_2(padding));
  double regions = 0.0, points_of_regions = 0.0;
  for (std::size_t frame = 0; frame != frames; ++frame) {
    const Ids named = scattered_ids(points, distance, random);
    contest.measure(points, named, [&](const CGAL::Update_report_2& report) {
      require(!report.rebuilt() && report.enlargements == 0, "a region has not come out as it was");
      const auto size = static_cast<double>(report.classified + report.padded + report.border);
      regions += static_cast<double>(named.size());
      points_of_regions += size;
      return size;
    });
  }
  contest.check();
  return contest.result(points_of_regions / regions);
}

// ALL ---------------------------------------------------------------------------------------------

std::vector<Column> columns(int decimals_of_points)
{
  return {{"points", 9, decimals_of_points},
          {"frames", 7, 0},
          {"guibas_stolfi", 15, 0},
          {"g_q1", 6, 0},
          {"g_q3", 6, 0},
          {"insertion", 11, 0},
          {"i_q1", 6, 0},
          {"i_q3", 6, 0},
          {"bowyer_watson", 15, 0},
          {"b_q1", 6, 0},
          {"b_q3", 6, 0},
          {"i/g", 7, 2},
          {"b/g", 7, 2}};
}

const Case_table jump = {"Rebuilds, every point at a fresh random place in every frame, ns a point",
                         columns(0)};
const Case_table step = {"Rebuilds, random steps of a fifth of the spacing, ns a point",
                         columns(0)};
const Case_table grid = {"Rebuilds of a square grid, displaced in every frame, ns a point",
                         columns(0)};
const Case_table splice = {"Splices by the size of their regions, ns a point of a region",
                           columns(1)};

void add_rebuilds(Case_list& cases, const Case_table& table, const std::string& name, Move move)
{
  for (const std::size_t number :
       {10u, 20u, 50u, 100u, 300u, 1000u, 10'000u, 100'000u, 1'000'000u}) {
    cases.add(table, name + '/' + std::to_string(number),
              [=] { return rebuild_case(number, move); });
  }
}

void add_all(Case_list& cases)
{
  add_rebuilds(cases, jump, "jump", at_fresh_places);
  add_rebuilds(cases, step, "step", stepped);
  add_rebuilds(cases, grid, "grid", on_displaced_grid);
  for (const unsigned padding : {0u, 1u, 2u, 3u, 5u, 13u}) {
    cases.add(splice, "splice/padding_" + std::to_string(padding),
              [=] { return splice_case(padding); });
  }
}

} // namespace

int main(int argc, char** argv)
{
  return run_case_program("static_engines", add_all, argc, argv);
}
