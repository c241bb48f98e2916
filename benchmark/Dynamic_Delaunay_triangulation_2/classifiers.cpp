// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What classifiers find, what they miss, and what they cost; what update policies make of the exact
// one; and how far padding reaches. All follow the same recorded motion, whose neighbors
// come from an exact triangulation, so that a heuristic is held against the truth and not against
// its own mistakes in the physics. Options: --frames=N, and those of Google Benchmark; the names of
// the rows are what --benchmark_filter looks at.
//
// Classifiers:
//   TP FP FN TN  vertices a frame that were classified or not, rightly or not. A vertex needs
//                mending if an edge of its star is not Delaunay at the new positions, before the
//                repair, by exact predicates. Its star are the edges at it and those opposite to
//                it: a flip changes the neighbors of four vertices. A vertex counts as classified
//                too if an edge was named for its sake.
//   FDR          false discovery rate, FP of all that were classified
//   edges        share of the broken edges that were named themselves or had an end named
//   CC           the classifier: classifying, and learning after the update
//   TC           the repair. CC, TC and so on are means in ns a point
//   TCC          the whole update: by the thesis's model (4.2.1) CC + TC
//   rest         what the model leaves out: reading, proving, writing the points, and rebuilds that
//                no repair has asked for
//   TC/PC        ns of repair for each classified vertex
//   MCC_...      validity, in every second frame
//   rebuilt      share of the frames that were
//
// Policies, with the exact classifier: means in ns a point; of_best is hybrid's over the better of
// always_static and always_dynamic; ..._rebuilt are shares of the frames.
//
// Padding: a point flies through a cloud at rest by so many spacings a frame. `right` is the share
// of the frames without a wrong edge; all others are a frame.
//
// Each recording is gone through three times, and of each frame the fastest update counts. All that
// is not an update is outside of the timing. A triangulation that is not what it claims to be ends
// its row with an error.

#include "classifiers/Classifier_figures.h"
#include "classifiers/Classifier_run.h"
#include "classifiers/Recorded_scenario.h"
#include "common/Cases.h"
#include "common/Csv_file.h"
#include "scenario_runner/Command_line.h"
#include "scenario_runner/Open_motion.h"

#include <benchmark/benchmark.h>

#include <cstddef>
#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace classifiers;
using namespace common;

constexpr std::size_t passes = 3;

const Case_table classifier_table = {"Classifiers, each with its usual repair",
                                     {{"points", 7, 0},
                                      {"frames", 7, 0},
                                      {"TP", 7, 1},
                                      {"FP", 7, 1},
                                      {"FN", 7, 1},
                                      {"TN", 7, 0},
                                      {"precision", 10, 3},
                                      {"recall", 7, 3},
                                      {"FDR", 7, 3},
                                      {"edges", 7, 3},
                                      {"CC", 7, 1},
                                      {"TC", 7, 1},
                                      {"CC+TC", 7, 1},
                                      {"rest", 7, 1},
                                      {"TCC", 7, 1},
                                      {"TC/PC", 7, 0},
                                      {"MCC_min", 8, 3},
                                      {"MCC_mean", 9, 3},
                                      {"rebuilt", 8, 3}}};
const Case_table policy_table = {"Policies with the exact classifier, ns a point",
                                 {{"points", 7, 0},
                                  {"frames", 7, 0},
                                  {"always_static", 15, 1},
                                  {"always_dynamic", 15, 1},
                                  {"hybrid", 8, 1},
                                  {"key_frames:10", 15, 1},
                                  {"of_best", 8, 2},
                                  {"dyn_rebuilt", 12, 3},
                                  {"hyb_rebuilt", 12, 3}}};
const Case_table padding_table = {"A fast point through a cloud at rest, border splice",
                                  {{"frames", 7, 0},
                                   {"right", 7, 3},
                                   {"wrong", 7, 2},
                                   {"padded", 8, 1},
                                   {"enlargements", 13, 2},
                                   {"rebuilt", 8, 3}}};

// A recording that is made for the first row of a scenario and kept for those that follow.
class Kept_recording
{
public:
  using Make = std::function<Recorded_frames()>;

  const Recorded_frames& get(const std::string& name, const Make& make)
  {
    if (m_name != name) {
      m_recording = make();
      m_name = name;
    }
    return m_recording;
  }

private:
  std::string m_name;
  Recorded_frames m_recording;
};

// The rows of all tables, with the recordings that they need.
class Rows
{
public:
  Rows(Case_list& cases, std::size_t frames)
    : m_cases(cases)
    , m_frames(frames)
  {
  }

  std::size_t frames() const { return m_frames; }

  // `work` makes a Case_result of a recording.
  template <class Work>
  void add(const Case_table& table, const std::string& recording, const std::string& method,
           const Kept_recording::Make& make, Work work)
  {
    const std::string name = recording + '/' + method;
    m_cases.add(table, name, [this, &table, name, recording, make, work] {
      const Case_result result = work(m_recording.get(recording, make));
      m_rows[&table].emplace_back(name, result.figures);
      return result;
    });
  }

  // Writes the rows that were run, with all digits; cells without a figure are empty.
  void write_csv(const Case_table& table, const std::string& path) const
  {
    if (m_rows.count(&table) == 0) {
      return;
    }
    std::vector<std::string> columns = {"name"};
    for (const Column& column : table.columns) {
      columns.push_back(column.name);
    }
    Csv_file file(path, {}, columns);
    for (const auto& [name, figures] : m_rows.at(&table)) {
      std::vector<std::string> cells = {name};
      for (const Column& column : table.columns) {
        const auto figure = figures.find(column.name);
        cells.push_back(figure == figures.end()
                            ? ""
                            : csv_cell(figure->second, std::numeric_limits<double>::max_digits10));
      }
      file.write_line(cells);
    }
    file.finish();
    std::cerr << "CSV: " << path << '\n';
  }

private:
  Case_list& m_cases;
  std::size_t m_frames;
  Kept_recording m_recording;
  std::map<const Case_table*, std::vector<std::pair<std::string, Figures>>> m_rows;
};

const std::vector<std::string> scenarios = {"dam_break", "spinning", "explosion", "static"};

Kept_recording::Make maker(const std::string& name, std::size_t frames,
                           const scenario::Overrides& overrides = {})
{
  return [=] {
    return record(*scenario::open_motion(scenario::scenario_file(name), overrides), frames);
  };
}

void add_method(Rows& rows, const std::string& scenario, const std::string& name,
                const Method& method)
{
  constexpr std::size_t stride = 2;
  rows.add(classifier_table, scenario, name, maker(scenario, rows.frames()),
           [=](const Recorded_frames& recording) {
             return classifier_result(recording, run_method(recording, method, passes, stride));
           });
}

void add_classifiers(Rows& rows)
{
  const std::vector<std::string> names = {
      "circumcircle",          "safe_region",
      "point_distance:0.3",    "point_distance:0.7",
      "point_distance:0.9",    "inflation_aware:0.7",
      "voronoi_circumcenter",  "voronoi_circumcenter_estimated",
      "voronoi_edge_length:1", "nearly_delaunay:0.05",
      "random:0.0025",         "refined:point_distance:0.9+voronoi_circumcenter"};
  for (const std::string& scenario : scenarios) {
    for (const std::string& name : names) {
      add_method(rows, scenario, name, method(name));
    }
    Method with_key_frames = method("point_distance:0.7");
    with_key_frames.policy = run::policy_choice("key_frames:10");
    add_method(rows, scenario, "point_distance:0.7/key_frames:10", with_key_frames);
  }
}

void add_policies(Rows& rows, const std::string& name, const Kept_recording::Make& make)
{
  const std::vector<std::string> policies = {"always_static", "always_dynamic", "hybrid",
                                             "key_frames:10"};
  rows.add(policy_table, name, "policies", make, [=](const Recorded_frames& recording) {
    return policy_result(recording, policies, run_policies(recording, policies, passes));
  });
}

void add_brownian_policies(Rows& rows, std::size_t points, std::size_t frames)
{
  for (const double step : {0.001, 0.003, 0.01, 0.03, 0.05, 0.08, 0.1, 0.3}) {
    scenario::Overrides overrides;
    overrides.points = points;
    overrides.time_step = step;
    std::ostringstream name;
    name << "brownian/" << points << '/' << step;
    add_policies(rows, name.str(), maker("brownian", frames, overrides));
  }
}

void add_policies(Rows& rows)
{
  constexpr std::size_t many_points = 10'000;
  constexpr std::size_t few_frames = 80;
  for (const std::string& scenario : scenarios) {
    add_policies(rows, scenario, maker(scenario, rows.frames()));
  }
  add_brownian_policies(rows, 1000, 4 * few_frames);
  add_brownian_policies(rows, many_points, few_frames);
  for (const std::size_t turn : {std::size_t(1), std::size_t(4), std::size_t(20)}) {
    const std::string name = "calm_and_teleport/" + std::to_string(many_points) + '/';
    add_policies(rows, name + std::to_string(turn),
                 [=] { return record_turns(many_points, few_frames, turn); });
  }
}

void add_padding(Rows& rows, double speed, const std::string& classifier, unsigned padding)
{
  constexpr std::size_t frames = 60;
  Method chosen = method(classifier);
  chosen.repair = "splice";
  chosen.padding = padding;
  std::ostringstream name;
  name << "flight/" << speed;
  rows.add(
      padding_table, name.str(), classifier + "/padding:" + std::to_string(padding),
      [=] { return record_flight(speed, frames); },
      [=](const Recorded_frames& recording) {
        return padding_result(run_method(recording, chosen, 1, 1));
      });
}

void add_padding(Rows& rows)
{
  for (const double speed : {1.0, 2.0, 4.0}) {
    for (const char* const classifier : {"point_distance:0.7", "circumcircle"}) {
      for (const unsigned padding : {0u, 1u, 2u, 3u, 5u}) {
        add_padding(rows, speed, classifier, padding);
      }
    }
  }
}

std::size_t frames_argument(const std::string& text)
{
  try {
    return run::count_argument(text, 1, 1'000'000);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string("--frames: ") + error.what());
  }
}

// Takes --frames=N out of the arguments; Google Benchmark does not know it.
std::size_t take_frames(std::vector<char*>& arguments)
{
  const std::string option = "--frames=";
  std::size_t frames = 1000;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string argument = arguments[i];
    if (argument.compare(0, option.size(), option) == 0) {
      frames = frames_argument(argument.substr(option.size()));
      arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i--));
    }
  }
  return frames;
}

bool run_classifiers(std::vector<char*> arguments)
{
  Case_list cases;
  Rows rows(cases, take_frames(arguments));
  add_classifiers(rows);
  add_policies(rows);
  add_padding(rows);
  const bool is_right = run_cases(cases, static_cast<int>(arguments.size()), arguments.data(),
                                  RESULTS_DIR "/classifiers.json");
  rows.write_csv(classifier_table, RESULTS_DIR "/classifiers.csv");
  rows.write_csv(policy_table, RESULTS_DIR "/policies.csv");
  rows.write_csv(padding_table, RESULTS_DIR "/padding.csv");
  return is_right;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    return run_classifiers(std::vector<char*>(argv, argv + argc)) ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "classifiers: " << error.what() << '\n';
    return 1;
  }
}
