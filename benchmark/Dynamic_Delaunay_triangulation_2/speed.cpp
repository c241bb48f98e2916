// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What an exact frame costs, in nanoseconds a point, and where the time goes; next to two ways of
// triangulating the same frame anew, timed in the same process in turn. One row for each case,
// written as a table and as JSON.
//
//   read      reading and checking the positions
//   classify  the circumcircle classifier
//   repair    flips, splices and rebuilds
//   certify   all the rest: the end of the proof, writing the points into CGAL's vertices, and
//             after_update() of the classifier, which looks for safe edges
//   insert    CGAL's insertion of the range
//   fastest   CGAL's insertion one by one in rounds along the last frame's Hilbert curve; of fresh
//             clouds the better of insert and of sorting along that curve before
//   vs_...    how many times faster the update is than these
//
// Times are medians over the frames, each of its own, so the phases need not add up to the whole;
// q1 and q3 are the quartiles of the whole, `worst` its slowest frame. These frames are cold:
// between two updates the opponents have had the caches. `hot` is the median of the same frames in
// bursts of eight, without anything between them. Flips are those a point and frame.
//
// Cases whose names begin with `shared` have the Parallel_tag and as many threads as the machine
// has processors. From 100,000 points on nearly all of a frame is shared.
//
// The phases are timed by wrapping the classifier and the repair, from outside: four or five
// readings of the clock to an update, at about 25 ns each. The whole is the time of this same
// wrapped update, so they are in it: about a tenth of a nanosecond a point at 1000 points. An
// update that rebuilds before it classifies counts as repair.
//
// Outside of the timing every frame has to be certified, and the last frame of every case has to
// be valid and to agree with a fresh triangulation in every edge. A case that fails says so in
// place of its figures, and the program ends with an error.

#include "common/Cases.h"
#include "scenario_runner/Open_motion.h"
#include "speed/Change_cases.h"
#include "speed/Heap_cases.h"
#include "speed/Motion_cases.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace speed;
using namespace common;

const std::vector<Column> time_columns = {
    {"points", 9, 0},   {"frames", 7, 0},     {"dynamic", 9, 1},     {"q1", 8, 1},
    {"q3", 8, 1},       {"hot", 8, 1},        {"worst", 9, 1},       {"read", 8, 1},
    {"classify", 9, 1}, {"repair", 8, 1},     {"certify", 8, 1},     {"insert", 9, 1},
    {"fastest", 9, 1},  {"vs_insert", 10, 2}, {"vs_fastest", 11, 2}, {"flips", 9, 5},
    {"rebuilds", 9, 0}};

std::vector<Column> time_columns_and(std::initializer_list<Column> further)
{
  std::vector<Column> columns = time_columns;
  columns.insert(columns.end(), further);
  return columns;
}

const Case_table own_step = {"Scenarios at their own time step, ns a point", time_columns};
const Case_table largest_step = {"Scenarios at their largest stable time step, ns a point",
                                 time_columns};
const Case_table shared = {
    "Scenarios at their own time step with all threads (Parallel_tag), which the opponents do not "
    "have; ns a point",
    time_columns};
const Case_table brownian = {"Brownian motion by its steps in spacings, ns a point", time_columns};
const Case_table teleport = {
    "Every point at a fresh random place in every frame, ns a point; 'sorted' "
    "sorts along the curve while it is timed",
    time_columns_and({{"sorted", 9, 1}, {"of_fastest", 11, 2}})};
const Case_table recorded = {"Recorded motion with its whole population, ns a point",
                             time_columns_and({{"changes", 9, 0}})};
const Case_table changes = {"Single points of a random cloud that come, go, move a hundredth of a "
                            "spacing, or anywhere; ns a "
                            "point, against CGAL's insert(), remove() and move_if_no_collision()",
                            {{"points", 9, 0},
                             {"dynamic", 9, 1},
                             {"q1", 9, 1},
                             {"q3", 9, 1},
                             {"CGAL", 9, 1},
                             {"vs_CGAL", 9, 2}}};
const Case_table memory = {
    "Memory, bytes a point",
    {{"points", 9, 0}, {"frames", 7, 0}, {"dynamic", 9, 1}, {"CGAL", 9, 1}, {"beyond", 9, 1}}};
const Case_table allocations = {"Heap allocations a frame without edge changes",
                                {{"points", 9, 0}, {"frames", 7, 0}, {"allocations", 13, 2}}};

constexpr std::size_t many_points = 100'000;
constexpr std::size_t max_points = 1'000'000;

std::unique_ptr<scenario::Motion> open(const std::string& name,
                                       const scenario::Overrides& overrides)
{
  return scenario::open_motion(scenario::scenario_file(name), overrides);
}

template <class Concurrency_tag = CGAL::Sequential_tag>
void add_scenario(Case_list& cases, const Case_table& table, const std::string& name,
                  const std::string& scenario_name, const scenario::Overrides& overrides,
                  const Frame_choice& frames)
{
  cases.add(table, name,
            [=] { return motion_case<Concurrency_tag>(*open(scenario_name, overrides), frames); });
}

std::string joined(const std::string& prefix, const std::string& name, std::size_t points)
{
  return prefix + name + '/' + std::to_string(points);
}

constexpr std::size_t many_frames = 1000;

// Adds a scenario at its own size, and the first frames of it at a large size.
void add_moving(Case_list& cases, const Case_table& table, const std::string& prefix,
                const std::string& name, scenario::Overrides overrides)
{
  const std::size_t points = open(name, {})->points().size();
  add_scenario(cases, table, joined(prefix, name, points), name, overrides, {0, many_frames});
  overrides.points = many_points;
  add_scenario(cases, table, joined(prefix, name + "_start", many_points), name, overrides,
               {0, 60});
}

// Adds the scenario `static`, in its first frames and settled, in the last half of its frames.
void add_static(Case_list& cases, const Case_table& table, const std::string& prefix,
                scenario::Overrides overrides)
{
  const auto motion = open("static", {});
  const std::size_t half = motion->frames() / 2;
  add_scenario(cases, table, joined(prefix, "static_settled", motion->points().size()), "static",
               overrides, {motion->frames() - half, half});
  overrides.points = many_points;
  add_scenario(cases, table, joined(prefix, "static_start", many_points), "static", overrides,
               {0, 60});
  add_scenario(cases, table, joined(prefix, "static_settled", many_points), "static", overrides,
               {motion->frames() - half, 60});
}

// Adds scenarios of many points; one in several frames is measured. With the largest stable time
// steps, which were found at their own sizes, not all of them last so long.
template <class Concurrency_tag>
void add_large(Case_list& cases, const Case_table& table, const std::string& prefix)
{
  scenario::Overrides overrides;
  overrides.points = many_points;
  for (const char* const name : {"dam_break", "spinning", "explosion", "static"}) {
    add_scenario<Concurrency_tag>(cases, table, joined(prefix, name, many_points), name, overrides,
                                  {0, 60, many_frames / 60});
  }
  overrides.points = max_points;
  for (const char* const name : {"dam_break", "explosion"}) {
    add_scenario<Concurrency_tag>(cases, table, joined(prefix, name, max_points), name, overrides,
                                  {0, 15, 16});
  }
}

void add_own_step(Case_list& cases)
{
  for (const char* const name : {"dam_break", "spinning", "explosion"}) {
    add_moving(cases, own_step, "", name, {});
  }
  add_static(cases, own_step, "", {});
  add_large<CGAL::Sequential_tag>(cases, own_step, "");
}

scenario::Overrides largest_step_of(const std::string& name)
{
  scenario::Overrides overrides;
  overrides.time_step = open(name, {})->largest_stable_time_step();
  return overrides;
}

void add_largest_step(Case_list& cases)
{
  const std::string prefix = "largest_step/";
  for (const char* const name : {"dam_break", "spinning", "explosion"}) {
    add_moving(cases, largest_step, prefix, name, largest_step_of(name));
  }
  add_static(cases, largest_step, prefix, largest_step_of("static"));
}

std::string with_number(const std::string& text, double number)
{
  std::ostringstream name;
  name << text << number;
  return name.str();
}

scenario::Overrides brownian_overrides(double step)
{
  scenario::Overrides overrides;
  overrides.points = many_points;
  overrides.time_step = step;
  return overrides;
}

void add_brownian(Case_list& cases)
{
  for (const double step : {0.001, 0.01, 0.03, 0.1}) {
    add_scenario(cases, brownian, with_number(joined("", "brownian", many_points) + '/', step),
                 "brownian", brownian_overrides(step), {0, 30});
  }
}

void add_teleport(Case_list& cases)
{
  for (const std::size_t points : {std::size_t(1000), many_points}) {
    cases.add(teleport, joined("", "teleport", points), [=] { return teleport_case(points); });
  }
}

void add_recorded(Case_list& cases)
{
  const std::vector<std::string> paths = scenario::recordings();
  for (const std::string& path : paths) {
    cases.add(recorded, "recorded/" + std::filesystem::path(path).stem().string(),
              [=] { return recorded_case(path); });
  }
  if (paths.empty()) {
    std::cerr << "recorded/...: skipped, " << scenario::no_recordings_message() << '\n';
  }
}

void add_changes(Case_list& cases)
{
  using Kind = Change_case::Kind;
  const std::pair<const char*, Kind> kinds[] = {{"insert", Kind::INSERT},
                                                {"remove", Kind::REMOVE},
                                                {"move_near", Kind::MOVE_NEAR},
                                                {"move_far", Kind::MOVE_FAR}};
  for (const auto& [name, kind] : kinds) {
    for (const std::size_t points : {std::size_t(1000), many_points}) {
      cases.add(changes, joined("change/", name, points),
                [points, kind = kind] { return Case_result{Change_case(points, kind).measure()}; });
    }
  }
}

void add_memory(Case_list& cases)
{
  for (const double step : {1e-9, 0.001, 0.03}) {
    cases.add(memory, with_number(joined("", "memory", many_points) + '/', step), [=] {
      return Case_result{memory_figures(*open("brownian", brownian_overrides(step)), 30)};
    });
  }
}

void add_allocations(Case_list& cases)
{
  const auto add = [&cases](const std::string& name, double distance) {
    cases.add(allocations, joined("", name, many_points), [=] {
      const auto cloud = open("brownian", brownian_overrides(1.0));
      return Case_result{allocation_figures(cloud->points(), distance)};
    });
  };
  add("allocations/still", 0.0);
  add("allocations/drift", 1e-9);
}

void add_all(Case_list& cases)
{
  add_own_step(cases);
  add_largest_step(cases);
#ifdef CGAL_LINKED_WITH_TBB
  add_large<CGAL::Parallel_tag>(cases, shared, "shared/");
#endif
  add_brownian(cases);
  add_teleport(cases);
  add_recorded(cases);
  add_changes(cases);
  add_memory(cases);
  add_allocations(cases);
}

} // namespace

int main(int argc, char** argv)
{
  return run_case_program("speed", add_all, argc, argv);
}
