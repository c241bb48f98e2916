// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_errors.h"
#include "scenario_runner/Scenario_file.h"
#include "scenario_runner/Static_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace scenario;

const std::vector<std::string>& scenario_names()
{
  static const std::vector<std::string> names = {"dam_break",
                                                 "spinning",
                                                 "explosion",
                                                 "static",
                                                 "dam_break_hexagonal",
                                                 "spinning_hexagonal",
                                                 "explosion_hexagonal",
                                                 "static_hexagonal",
                                                 "brownian"};
  return names;
}

// Replaces a part of a JSON text. `what` and `by` have single quotation marks for double ones.
std::string with_replaced(std::string text, std::string what, std::string by)
{
  for (std::string* json : {&what, &by}) {
    std::replace(json->begin(), json->end(), '\'', '"');
  }
  const std::size_t place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  return text.replace(place, what.size(), by);
}

Overrides with_points(std::size_t points)
{
  Overrides overrides;
  overrides.points = points;
  return overrides;
}

std::unique_ptr<Particle_motion> open_particles(const std::string& name,
                                                const Overrides& overrides = {})
{
  const Scenario_description description = read_scenario_file(scenario_file(name));
  return make_motion(description, std::get<Particle_description>(description.kind), overrides);
}

bool inside(const Point& point, double width, double height)
{
  return point.x >= 0.0 && point.x <= width && point.y >= 0.0 && point.y <= height;
}

bool all_finite(const std::vector<Point>& points)
{
  return std::all_of(points.begin(), points.end(), [](const Point& point) {
    return std::isfinite(point.x) && std::isfinite(point.y);
  });
}

bool same_places(const std::vector<Point>& a, const std::vector<Point>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; });
}

// The energy after every frame, the first included.
std::vector<double> run_motion(Particle_motion& motion, std::size_t frames)
{
  Static_neighbors neighbors;
  std::vector<double> energies;
  for (std::size_t frame = 0; frame != frames; ++frame) {
    const Neighbor_edges& edges = neighbors(motion.points());
    energies.push_back(motion.energy(edges).total());
    motion.advance(edges);
  }
  return energies;
}

double largest_rise(const std::vector<double>& energies)
{
  double lowest = std::numeric_limits<double>::infinity();
  double rise = 0.0;
  for (const double energy : energies) {
    lowest = (std::min)(lowest, energy);
    rise = (std::max)(rise, energy - lowest);
  }
  return rise;
}

// The rotation, counterclockwise, that takes the points [begin, end) from their first places to the
// second ones, by least squares.
double rotation(const std::vector<Point>& first, const std::vector<Point>& second,
                std::size_t begin, std::size_t end)
{
  Point a{0.0, 0.0};
  Point b{0.0, 0.0};
  const auto number = static_cast<double>(end - begin);
  for (std::size_t i = begin; i != end; ++i) {
    a = {a.x + first[i].x / number, a.y + first[i].y / number};
    b = {b.x + second[i].x / number, b.y + second[i].y / number};
  }
  double cosine = 0.0;
  double sine = 0.0;
  for (std::size_t i = begin; i != end; ++i) {
    const Point p{first[i].x - a.x, first[i].y - a.y};
    const Point q{second[i].x - b.x, second[i].y - b.y};
    cosine += p.x * q.x + p.y * q.y;
    sine += p.x * q.y - p.y * q.x;
  }
  return std::atan2(sine, cosine);
}

double largest_displacement(const std::vector<Point>& first, const std::vector<Point>& second)
{
  double largest = 0.0;
  for (std::size_t i = 0; i != first.size(); ++i) {
    largest = (std::max)(largest, std::hypot(second[i].x - first[i].x, second[i].y - first[i].y));
  }
  return largest;
}

Neighbor_edges sorted(Neighbor_edges edges)
{
  for (auto& [a, b] : edges) {
    if (a > b) {
      std::swap(a, b);
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::size_t number_of_new_edges(const Neighbor_edges& before, const Neighbor_edges& after)
{
  Neighbor_edges added;
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(),
                      std::back_inserter(added));
  return added.size();
}

std::size_t number_where(const std::vector<Point>& points, bool (*predicate)(const Point&))
{
  return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), predicate));
}

const char* const small_hard_body = R"({
  "name": "small", "kind": "particles", "packing": "square", "jitter": 0, "seed": 1,
  "frames": 10, "time_step": 0.3, "diameter": 1, "mass": 1, "stiffness": 1, "damping": 0.1,
  "gravity": 0,
  "bodies": [
    { "rows": 1, "columns": 2, "position": [0, 0], "bonded": true, "shiver": 0.01 }
  ]
})";

} // namespace

TEST(Scenarios, have_the_number_of_points_of_the_thesis_in_either_packing)
{
  for (const auto& [name, points] : {std::pair("dam_break", 1008u),
                                     {"spinning", 800u},
                                     {"explosion", 968u},
                                     {"static", 1024u}}) {
    for (const std::string packing : {"", "_hexagonal"}) {
      EXPECT_EQ(open_motion(scenario_file(name + packing))->points().size(), points) << name;
    }
  }
  EXPECT_EQ(open_motion(scenario_file("brownian"))->points().size(), 10000u);
}

TEST(Scenarios, are_named_after_their_files)
{
  for (const std::string& name : scenario_names()) {
    EXPECT_EQ(open_motion(scenario_file(name))->name(), name);
  }
}

TEST(Scenarios, run_below_their_largest_stable_time_step)
{
  for (const std::string& name : scenario_names()) {
    const auto motion = open_motion(scenario_file(name));
    ASSERT_TRUE(motion->time_step()) << name;
    if (motion->uses_neighbors()) {
      ASSERT_TRUE(motion->largest_stable_time_step()) << name;
      EXPECT_LT(*motion->time_step(), *motion->largest_stable_time_step()) << name;
    }
  }
}

TEST(Scenarios, scale_to_exactly_the_number_of_points_asked_for)
{
  for (const std::string& name : scenario_names()) {
    for (const std::size_t points : {1u, 2u, 3u, 4u, 5u, 7u, 10u, 97u, 1000u, 1009u, 100000u}) {
      const auto motion = open_motion(scenario_file(name), with_points(points));
      EXPECT_EQ(motion->points().size(), points) << name;
      EXPECT_EQ(motion->ids().size(), points) << name;
      EXPECT_TRUE(std::is_sorted(motion->ids().begin(), motion->ids().end())) << name;
    }
  }
}

TEST(Scenarios, run_with_very_few_points)
{
  for (const std::string& name : scenario_names()) {
    for (const std::size_t points : {1u, 2u, 3u, 5u}) {
      const auto motion = open_motion(scenario_file(name), with_points(points));
      Static_neighbors neighbors;
      for (int frame = 0; frame != 200; ++frame) {
        EXPECT_TRUE(motion->advance(neighbors(motion->points())));
      }
      EXPECT_TRUE(all_finite(motion->points())) << name << " with " << points;
    }
  }
}

TEST(Scenarios, keep_their_shape_when_scaled)
{
  const auto motion = open_motion(scenario_file("dam_break"), with_points(100 * 1008));
  double right = 0.0;
  double top = 0.0;
  for (const Point& point : motion->points()) {
    right = (std::max)(right, point.x);
    top = (std::max)(top, point.y);
  }
  EXPECT_NEAR(right, 280.0, 1.0);
  EXPECT_NEAR(top, 360.0, 1.0);
}

TEST(Scenarios, keep_the_pressure_at_the_bottom_when_scaled)
{
  const Scenario_description description = read_scenario_file(scenario_file("dam_break"));
  const auto& particles = std::get<Particle_description>(description.kind);
  const Scaled_scenario scaled = scaled_to(particles, 100 * 1008);
  EXPECT_DOUBLE_EQ(scaled.gravity, particles.gravity / 10.0);
  EXPECT_DOUBLE_EQ(scaled.box->width, particles.box->width * 10.0);
}

TEST(Scenarios, move_alike_with_the_same_seed)
{
  for (const std::string& name : scenario_names()) {
    const auto one = open_motion(scenario_file(name));
    const auto other = open_motion(scenario_file(name));
    Static_neighbors neighbors_of_one;
    Static_neighbors neighbors_of_other;
    for (int frame = 0; frame != 50; ++frame) {
      one->advance(neighbors_of_one(one->points()));
      other->advance(neighbors_of_other(other->points()));
    }
    EXPECT_TRUE(same_places(one->points(), other->points())) << name;
    EXPECT_EQ(one->time(), other->time()) << name;
  }
}

TEST(Scenarios, move_differently_with_another_seed)
{
  Overrides overrides;
  overrides.seed = 7;
  for (const std::string& name : scenario_names()) {
    const auto one = open_motion(scenario_file(name));
    const auto other = open_motion(scenario_file(name), overrides);
    EXPECT_FALSE(same_places(one->points(), other->points())) << name;
  }
}

TEST(Scenarios, start_with_a_very_small_jitter)
{
  const auto motion = open_motion(scenario_file("static"));
  const Point& first = motion->points()[0];
  EXPECT_NE(first.x, 0.5);
  EXPECT_NEAR(first.x, 0.5, 0.001);
  EXPECT_NEAR(first.y, 0.5, 0.001);
}

TEST(Scenarios, start_their_hard_bodies_jittered_but_without_stress)
{
  for (const char* name : {"spinning", "explosion", "static", "spinning_hexagonal",
                           "explosion_hexagonal", "static_hexagonal"}) {
    const auto motion = open_particles(name);
    Static_neighbors neighbors;
    const Energy energy = motion->energy(neighbors(motion->points()));
    EXPECT_LT(energy.potential, 1e-20) << name;
    EXPECT_LT(motion->system().largest_strain(), 1e-12) << name;
  }
}

TEST(Scenarios, take_another_packing_on_demand)
{
  Overrides overrides;
  overrides.packing = Packing::hexagonal;
  const auto motion = open_motion(scenario_file("static"), overrides);
  EXPECT_NEAR(motion->points()[32].x, 1.0, 0.001);
  EXPECT_NEAR(motion->points()[32].y, 0.5 + std::sqrt(0.75), 0.001);
}

TEST(Scenarios, go_through_less_time_with_a_smaller_time_step)
{
  Overrides overrides;
  overrides.time_step = 0.1;
  const auto motion = open_motion(scenario_file("spinning"), overrides);
  motion->advance({});
  EXPECT_DOUBLE_EQ(motion->time(), 0.1);
  EXPECT_DOUBLE_EQ(*motion->time_step(), 0.1);
}

TEST(Dam_break, spills_reaches_the_far_wall_and_loses_energy)
{
  for (const char* name : {"dam_break", "dam_break_hexagonal"}) {
    const auto motion = open_particles(name);
    const std::vector<double> energies = run_motion(*motion, 2000);
    const auto at_far_wall =
        number_where(motion->points(), [](const Point& point) { return point.x > 66.0; });
    EXPECT_GT(at_far_wall, 20u) << name;
    EXPECT_LT(largest_rise(energies), 0.01 * energies.front()) << name;
    EXPECT_LT(energies.back(), 0.8 * energies.front()) << name;
    EXPECT_EQ(motion->system().number_put_back(), 0u) << name;
    for (const Point& point : motion->points()) {
      EXPECT_TRUE(inside(point, 70.0, 70.0)) << name;
    }
  }
}

TEST(Dam_break, settles_to_flat_and_calm_water)
{
  Overrides overrides;
  overrides.time_step = 0.5;
  const auto motion = open_particles("dam_break", overrides);
  const std::vector<double> energies = run_motion(*motion, 4000);
  double kinetic = 0.0;
  for (const Point& velocity : motion->system().velocities()) {
    kinetic += 0.5 * (velocity.x * velocity.x + velocity.y * velocity.y);
  }
  EXPECT_LT(kinetic, 0.005 * energies.front());
  std::vector<double> top(7, 0.0);
  for (const Point& point : motion->points()) {
    double& highest = top[std::min<std::size_t>(6, static_cast<std::size_t>(point.x / 10.0))];
    highest = (std::max)(highest, point.y);
  }
  const auto [low, high] = std::minmax_element(top.begin(), top.end());
  EXPECT_GT(*low, 8.0);
  EXPECT_LT(*high, 18.0);
  EXPECT_LT(largest_rise(energies), 0.01 * energies.front());
}

TEST(Dam_break, moves_by_about_four_percent_of_the_spacing_where_it_is_fast)
{
  const auto motion = open_particles("dam_break");
  run_motion(*motion, 1000);
  double fastest = 0.0;
  for (const Point& velocity : motion->system().velocities()) {
    fastest = (std::max)(fastest, *motion->time_step() * std::hypot(velocity.x, velocity.y));
  }
  EXPECT_GT(fastest, 0.03);
  EXPECT_LT(fastest, 0.06);
}

TEST(Dam_break, stays_in_its_box_with_more_and_with_fewer_points)
{
  for (const std::size_t points : {60u, 5000u}) {
    const auto motion = open_particles("dam_break", with_points(points));
    const std::vector<double> energies = run_motion(*motion, 500);
    const double side = 70.0 * std::sqrt(static_cast<double>(points) / 1008.0);
    for (const Point& point : motion->points()) {
      EXPECT_TRUE(inside(point, side, side)) << points;
    }
    EXPECT_LT(largest_rise(energies), 0.01 * energies.front()) << points;
  }
}

TEST(Spinning, turns_both_squares_clockwise_and_holds_them_together)
{
  for (const char* name : {"spinning", "spinning_hexagonal"}) {
    const auto motion = open_particles(name);
    const std::vector<Point> first = motion->points();
    const std::vector<double> energies = run_motion(*motion, 1000);
    const double expected = -0.007 * motion->time();
    EXPECT_NEAR(rotation(first, motion->points(), 0, 400), expected, 0.05) << name;
    EXPECT_NEAR(rotation(first, motion->points(), 400, 800), expected, 0.05) << name;
    EXPECT_EQ(motion->system().bonds().number_of_broken(), 0u) << name;
    EXPECT_LT(motion->system().largest_strain(), 0.01) << name;
    EXPECT_LT(largest_rise(energies), 0.01 * energies.front()) << name;
    EXPECT_GT(energies.back(), 0.98 * energies.front()) << name;
  }
}

TEST(Spinning, keeps_its_squares_apart)
{
  const auto motion = open_particles("spinning");
  Static_neighbors neighbors;
  double nearest = std::numeric_limits<double>::infinity();
  for (int frame = 0; frame != 1000; ++frame) {
    const Neighbor_edges& edges = neighbors(motion->points());
    for (const auto& [a, b] : edges) {
      if ((a < 400) != (b < 400)) {
        const Point& p = motion->points()[a];
        const Point& q = motion->points()[b];
        nearest = (std::min)(nearest, std::hypot(p.x - q.x, p.y - q.y));
      }
    }
    motion->advance(edges);
  }
  EXPECT_GT(nearest, 1.5);
}

TEST(Explosion, shatters_both_squares_and_sprays_in_all_directions)
{
  for (const char* name : {"explosion", "explosion_hexagonal"}) {
    const auto motion = open_particles(name);
    const std::vector<double> energies = run_motion(*motion, 500);
    const Bond_network& bonds = motion->system().bonds();
    EXPECT_GT(static_cast<double>(bonds.number_of_broken()),
              0.95 * static_cast<double>(bonds.number_of_bonds()))
        << name;
    const std::vector<Point>& points = motion->points();
    EXPECT_GT(number_where(points, [](const Point& p) { return p.x < -10.0; }), 20u) << name;
    EXPECT_GT(number_where(points, [](const Point& p) { return p.x > 64.0; }), 20u) << name;
    EXPECT_GT(number_where(points, [](const Point& p) { return p.y < -30.0; }), 20u) << name;
    EXPECT_GT(number_where(points, [](const Point& p) { return p.y > 52.0; }), 20u) << name;
    EXPECT_LT(largest_rise(energies), 0.02 * energies.front()) << name;
    EXPECT_TRUE(all_finite(points)) << name;
  }
}

TEST(Explosion, moves_by_about_a_quarter_of_the_spacing_where_it_is_fastest)
{
  for (const char* name : {"explosion", "explosion_hexagonal"}) {
    const auto motion = open_particles(name);
    Static_neighbors neighbors;
    double fastest = 0.0;
    for (int frame = 0; frame != 300; ++frame) {
      motion->advance(neighbors(motion->points()));
      for (const Point& velocity : motion->system().velocities()) {
        fastest = (std::max)(fastest, *motion->time_step() * std::hypot(velocity.x, velocity.y));
      }
    }
    EXPECT_NEAR(fastest, 0.24, 0.03) << name;
  }
}

TEST(Static, shivers_by_less_than_its_jitter)
{
  for (const char* name : {"static", "static_hexagonal"}) {
    const auto motion = open_particles(name);
    const std::vector<Point> first = motion->points();
    double farthest = 0.0;
    Static_neighbors neighbors;
    for (int frame = 0; frame != 300; ++frame) {
      motion->advance(neighbors(motion->points()));
      farthest = (std::max)(farthest, largest_displacement(first, motion->points()));
    }
    EXPECT_GT(farthest, 0.00005) << name;
    EXPECT_LT(farthest, 0.0003) << name;
    EXPECT_EQ(motion->system().bonds().number_of_broken(), 0u) << name;
  }
}

TEST(Static, settles_within_half_of_its_frames)
{
  for (const char* name : {"static", "static_hexagonal"}) {
    const auto motion = open_particles(name);
    const std::vector<Point> first = motion->points();
    const std::vector<double> energies = run_motion(*motion, motion->frames() / 2);
    EXPECT_GT(energies[10], 0.5 * energies.front()) << name;
    EXPECT_LT(energies.back(), 0.002 * energies.front()) << name;
    EXPECT_LT(largest_displacement(first, motion->points()), 0.0001) << name;
  }
}

TEST(Static, keeps_nearly_all_edges_once_settled)
{
  for (const char* name : {"static", "static_hexagonal"}) {
    const auto motion = open_particles(name);
    run_motion(*motion, motion->frames() / 2);
    Static_neighbors neighbors;
    std::size_t changes = 0;
    Neighbor_edges before = sorted(neighbors(motion->points()));
    for (int frame = 0; frame != 200; ++frame) {
      motion->advance(before);
      Neighbor_edges after = sorted(neighbors(motion->points()));
      changes += number_of_new_edges(before, after);
      before = std::move(after);
    }
    EXPECT_LT(changes, 200u) << name;
  }
}

TEST(Static, neither_drifts_nor_turns)
{
  for (const char* name : {"static", "static_hexagonal"}) {
    const auto motion = open_particles(name);
    const std::vector<Point> first = motion->points();
    run_motion(*motion, 500);
    Point drift{0.0, 0.0};
    for (std::size_t i = 0; i != first.size(); ++i) {
      drift.x += motion->points()[i].x - first[i].x;
      drift.y += motion->points()[i].y - first[i].y;
    }
    EXPECT_NEAR(drift.x, 0.0, 1e-9) << name;
    EXPECT_NEAR(drift.y, 0.0, 1e-9) << name;
    EXPECT_NEAR(rotation(first, motion->points(), 0, first.size()), 0.0, 1e-7) << name;
  }
}

TEST(Shiver, kicks_the_ends_of_a_bond_along_it_in_opposite_directions)
{
  const auto motion = open_motion(write_file("shiver.json", small_hard_body));
  const auto& system = dynamic_cast<const Particle_motion&>(*motion).system();
  const Point& left = system.velocities()[0];
  const Point& right = system.velocities()[1];
  EXPECT_NE(left.x, 0.0);
  EXPECT_LE(std::abs(left.x), 0.01);
  EXPECT_EQ(left.x, -right.x);
  EXPECT_EQ(left.y, 0.0);
  EXPECT_EQ(right.y, 0.0);
}

TEST(Shiver, is_measured_in_diameters_and_the_time_that_stiffness_and_mass_give)
{
  const auto velocity = [](const std::string& what, const std::string& by) {
    const std::string path = write_file("shiver.json", with_replaced(small_hard_body, what, by));
    const auto motion = open_motion(path);
    return dynamic_cast<const Particle_motion&>(*motion).system().velocities()[0].x;
  };
  const double plain = velocity("small", "plain");
  EXPECT_DOUBLE_EQ(velocity("'stiffness': 1", "'stiffness': 4"), 2.0 * plain);
  EXPECT_DOUBLE_EQ(velocity("'mass': 1", "'mass': 4"), 0.5 * plain);
  EXPECT_DOUBLE_EQ(velocity("'diameter': 1", "'diameter': 2"), 2.0 * plain);
  EXPECT_EQ(velocity("'shiver': 0.01", "'shiver': 0"), 0.0);
}

// A system of particles without bonds.
Particle_system system_of(const std::vector<Point>& positions, const std::vector<Point>& velocities,
                          const std::optional<Box>& box = {})
{
  Bond_network no_bonds;
  for (std::size_t i = 0; i != positions.size(); ++i) {
    no_bonds.begin_particle();
  }
  return Particle_system({1.0, 1.0, 1.0, 0.0, 0.0, box}, positions, velocities, no_bonds);
}

const std::vector<Point> two_at_rest(2, Point{0.0, 0.0});

TEST(Particle_system, lets_only_neighbors_touch)
{
  Particle_system strangers = system_of({{0.0, 0.0}, {0.5, 0.0}}, two_at_rest);
  Particle_system neighbors = strangers;
  strangers.step({}, 0.1);
  neighbors.step({{0u, 1u}}, 0.1);
  EXPECT_EQ(strangers.positions()[0].x, 0.0);
  EXPECT_DOUBLE_EQ(neighbors.positions()[0].x, -0.005);
  EXPECT_DOUBLE_EQ(neighbors.positions()[1].x, 0.505);
}

TEST(Particle_system, moves_alike_however_the_edges_are_listed)
{
  const auto one = open_particles("dam_break");
  const auto other = open_particles("dam_break");
  Static_neighbors neighbors;
  for (int frame = 0; frame != 300; ++frame) {
    Neighbor_edges edges = neighbors(one->points());
    one->advance(edges);
    std::reverse(edges.begin(), edges.end());
    for (auto& [a, b] : edges) {
      std::swap(a, b);
    }
    other->advance(edges);
  }
  EXPECT_TRUE(same_places(one->points(), other->points()));
}

TEST(Particle_system, parts_coincident_neighbors)
{
  Particle_system system = system_of({{2.0, 2.0}, {2.0, 2.0}}, two_at_rest);
  system.step({{0u, 1u}}, 0.1);
  EXPECT_GT(system.positions()[1].x - system.positions()[0].x, 0.0);
}

TEST(Particle_system, puts_a_particle_back_that_passed_a_wall)
{
  Particle_system system = system_of({{5.0, 5.0}}, {{100.0, -1000.0}}, Box{10.0, 10.0});
  system.step({}, 0.1);
  EXPECT_TRUE(inside(system.positions()[0], 10.0, 10.0));
  EXPECT_EQ(system.number_put_back(), 2u);
}

TEST(Particle_system, breaks_a_bond_beyond_its_strain_limit)
{
  const Particle_parameters parameters{1.0, 1.0, 1.0, 0.0, 0.0, {}};
  Bond_network bonds;
  bonds.begin_particle();
  bonds.add(1, 1.0, 0.1);
  bonds.begin_particle();
  bonds.add(2, 1.0, std::nullopt);
  bonds.begin_particle();
  Particle_system system(parameters, {{0.0, 0.0}, {1.2, 0.0}, {2.4, 0.0}},
                         std::vector<Point>(3, Point{0.0, 0.0}), bonds);
  system.step({}, 0.1);
  EXPECT_EQ(system.bonds().number_of_broken(), 1u);
  EXPECT_EQ(system.positions()[0].x, 0.0);
  EXPECT_LT(system.positions()[2].x, 2.4);
}

TEST(Brownian_motion, stays_in_its_box_and_takes_steps_of_the_size_asked_for)
{
  Overrides overrides;
  overrides.time_step = 0.1;
  const auto motion = open_motion(scenario_file("brownian"), overrides);
  const std::vector<Point> first = motion->points();
  motion->advance({});
  double sum = 0.0;
  for (std::size_t i = 0; i != first.size(); ++i) {
    const Point& point = motion->points()[i];
    EXPECT_TRUE(inside(point, 1.0, 1.0));
    sum += std::pow(point.x - first[i].x, 2) + std::pow(point.y - first[i].y, 2);
  }
  const double step = std::sqrt(sum / (2.0 * static_cast<double>(first.size())));
  EXPECT_NEAR(step / 0.01, 0.1, 0.005); // the mean spacing of 10000 points is 0.01
}

TEST(Brownian_motion, stays_in_its_box_with_huge_steps)
{
  Overrides overrides;
  overrides.time_step = 10.0;
  overrides.points = 10;
  const auto motion = open_motion(scenario_file("brownian"), overrides);
  for (int frame = 0; frame != 100; ++frame) {
    motion->advance({});
    for (const Point& point : motion->points()) {
      EXPECT_TRUE(inside(point, 1.0, 1.0));
    }
  }
}

namespace {

const char* const small_scenario = R"({
  "name": "small", "kind": "particles", "packing": "square", "jitter": 0.001, "seed": 1,
  "frames": 10, "time_step": 0.3, "diameter": 1, "mass": 1, "stiffness": 1, "damping": 0.1,
  "gravity": 0.001, "box": [10, 10],
  "bodies": [ { "rows": 2, "columns": 3, "position": [0, 0] } ]
})";

const char* const small_cloud = R"({
  "name": "cloud", "kind": "brownian", "seed": 1, "frames": 10, "time_step": 0.01, "points": 5,
  "box": [1, 1] })";

Scenario_error error_with(const std::string& what, const std::string& by,
                          const std::string& scenario = small_scenario)
{
  return error_of(write_file("changed.json", with_replaced(scenario, what, by)));
}

} // namespace

TEST(Scenario_file, is_accepted_when_it_is_right)
{
  EXPECT_EQ(open_motion(write_file("right.json", small_scenario))->points().size(), 6u);
  EXPECT_EQ(open_motion(write_file("cloud.json", small_cloud))->points().size(), 5u);
}

TEST(Scenario_file, that_is_missing_a_directory_or_of_an_unknown_kind_is_refused)
{
  expect_words(error_of("/no/such/scenario.json"), {"/no/such/scenario.json", "cannot be opened"});
  const std::string path = temporary_path("directory.json");
  std::filesystem::create_directories(path);
  expect_words(error_of(path), {"is a directory"});
  expect_words(error_of("motion.pdb"),
               {"'.pdb'", ".json", ".csv", ".lammpstrj", ".dump", ".xyz", ".extxyz"});
}

TEST(Scenario_file, that_is_nested_without_end_is_refused)
{
  const std::string nested = std::string(200000, '[') + std::string(200000, ']');
  expect_words(error_with("'mass': 1", "'mass': " + nested),
               {"is nested too deeply", "allowed are 16 levels"});
}

TEST(Overrides, out_of_range_are_refused)
{
  const std::string path = scenario_file("dam_break");
  expect_words(error_of(path, with_points(0)), {"0 points", "allowed are 1 to 10000000"});
  expect_words(error_of(path, with_points(max_points + 1)), {"10000001 points"});
  for (const double time_step : {0.0, -1.0, 11.0, std::nan("")}) {
    Overrides overrides;
    overrides.time_step = time_step;
    expect_words(error_of(path, overrides), {"time step", "allowed are values above 0 to 10"});
  }
}

TEST(Overrides, are_refused_where_they_mean_nothing)
{
  Overrides overrides;
  overrides.packing = Packing::square;
  expect_words(error_of(scenario_file("brownian"), overrides), {"packing"});
  const std::string path = write_file("recorded.csv", "frame,time,id,x,y\n0,0,1,2,3\n");
  expect_words(error_of(path, overrides), {"is a recording"});
  expect_words(error_of(path, with_points(3)), {"is a recording"});
}

TEST(Csv_motion, gives_frames_ids_and_points_to_the_last_bit)
{
  const auto motion = open_motion(write_file(
      "good.csv", "frame,time,id,x,y\n0,0.5,7,0.1,1e-300\n0,0.5,3,-2,0.30000000000000004\n"));
  EXPECT_EQ(motion->name(), "good");
  EXPECT_EQ(motion->ids(), (std::vector<std::int64_t>{3, 7}));
  EXPECT_EQ(motion->points()[1].x, 0.1);
  EXPECT_EQ(motion->points()[1].y, 1e-300);
  EXPECT_EQ(motion->points()[0].y, 0.30000000000000004);
  EXPECT_EQ(motion->time(), 0.5);
  EXPECT_EQ(motion->frames(), 0u);
  EXPECT_FALSE(motion->advance({}));
}

TEST(Csv_motion, says_whether_the_population_changed)
{
  const auto motion = open_motion(
      write_file("population.csv", "frame,time,id,x,y\n0,0,1,0,0\n1,1,1,1,1\n2,2,4,1,1\n"));
  EXPECT_FALSE(motion->population_changed());
  motion->advance({});
  EXPECT_FALSE(motion->population_changed());
  motion->advance({});
  EXPECT_TRUE(motion->population_changed());
}

TEST(Csv_motion, that_is_missing_is_refused)
{
  expect_words(error_of("/no/such/motion.csv"), {"/no/such/motion.csv", "cannot be opened"});
}

namespace {

std::string dump_frame(int timestep, const std::string& columns,
                       const std::vector<std::string>& atoms)
{
  std::string text = "ITEM: TIMESTEP\n" + std::to_string(timestep) + "\nITEM: NUMBER OF ATOMS\n" +
                     std::to_string(atoms.size()) +
                     "\nITEM: BOX BOUNDS pp pp pp\n-1 3\n10 20\n0 1\nITEM: ATOMS " + columns + "\n";
  for (const std::string& atom : atoms) {
    text += atom + "\n";
  }
  return text;
}

} // namespace

TEST(Lammps_dump, gives_atoms_sorted_by_id_whatever_the_order_of_rows_and_columns)
{
  const auto motion = open_motion(
      write_file("good.lammpstrj", dump_frame(0, "id x y", {"2 0.5 1", "1 0.1 2"}) +
                                       dump_frame(250, "y type id vx x ",
                                                  {"7 1 2 0 6 ", "5 1 1 0 4 ", "9 1 3 0 8 "})));
  EXPECT_EQ(motion->frames(), 1u);
  EXPECT_EQ(motion->ids(), (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(motion->points()[0].x, 0.1);
  ASSERT_TRUE(motion->advance({}));
  EXPECT_EQ(motion->time(), 250.0);
  EXPECT_EQ(motion->ids(), (std::vector<std::int64_t>{1, 2, 3}));
  EXPECT_EQ(motion->points()[1].x, 6.0);
  EXPECT_EQ(motion->points()[1].y, 7.0);
}

TEST(Lammps_dump, may_have_frames_of_no_one_and_two_atoms)
{
  const auto motion = open_motion(write_file(
      "few.dump", dump_frame(0, "id x y", {}) + dump_frame(1, "id x y", {"1 0 0"}) +
                      dump_frame(2, "id x y", {"1 0 0", "2 1 1"}) + dump_frame(3, "id x y", {})));
  for (const std::size_t expected : {0u, 1u, 2u, 0u}) {
    EXPECT_EQ(motion->points().size(), expected);
    motion->advance({});
  }
}

TEST(Lammps_dump, scales_scaled_coordinates_by_the_box_and_takes_unwrapped_ones)
{
  const auto scaled =
      open_motion(write_file("scaled.lammpstrj", dump_frame(0, "id xs ys", {"1 0.5 0.25"})));
  EXPECT_EQ(scaled->points()[0].x, 1.0);
  EXPECT_EQ(scaled->points()[0].y, 12.5);
  const auto unwrapped =
      open_motion(write_file("unwrapped.lammpstrj", dump_frame(0, "id xu yu", {"1 50 60"})));
  EXPECT_EQ(unwrapped->points()[0].x, 50.0);
}

TEST(Lammps_dump, scales_in_a_tilted_box_too)
{
  const std::string plain = "BOX BOUNDS pp pp pp\n-1 3\n10 20\n0 1";
  const std::string box = "BOX BOUNDS xy xz yz pp pp pp\n-1 5 2\n10 20 0\n0 1 0";
  const auto tilted = open_motion(write_file(
      "tilted.dump", with_replaced(dump_frame(0, "id xs ys", {"1 0.5 0.5"}), plain, box)));
  EXPECT_EQ(tilted->points()[0].x, 2.0);
  EXPECT_EQ(tilted->points()[0].y, 15.0);
}

TEST(Lammps_dump, takes_the_time_where_it_is_written)
{
  const auto motion = open_motion(write_file(
      "time.dump", "ITEM: UNITS\nlj\nITEM: TIME\n0.25\n" + dump_frame(100, "id x y", {"1 0 0"})));
  EXPECT_EQ(motion->time(), 0.25);
}

TEST(Scenario_error, keeps_a_message_short_when_the_file_is_not)
{
  const std::string word(100000, 'z');
  const std::string digits(100000, '9');
  for (const Scenario_error& error :
       {error_of(write_file("long.lammpstrj", word)), error_with("gravity", word),
        error_with("square", word), error_with("'gravity': 0.001", "'gravity': " + digits),
        error_with("'mass'", "'" + word + "': 1, '" + word + "'")}) {
    EXPECT_LT(std::string(error.what()).size(), 500u) << error.what();
  }
}

namespace {

struct Shared_file
{
  const char* name;
  std::size_t number_of_frames;
  std::size_t fewest;
  std::size_t most;
};

} // namespace

TEST(Recorded_data, parses_with_the_frames_and_points_its_description_states)
{
  if (!recordings_are_expected()) {
    GTEST_SKIP() << no_recordings_message();
  }
  const std::vector<Shared_file> files = {
      {"traffic_bologna.csv", 201, 1005, 1099}, {"sph_dambreak.csv", 35, 3938, 3938},
      {"cells_c2c12.csv", 780, 31, 267},        {"crowd_juelich.csv", 3247, 1, 50},
      {"crowd_bottleneck.csv", 1657, 1, 75},    {"madras_1A.csv", 297, 39, 51},
      {"satellites.csv", 150, 833, 833},        {"asteroids.csv", 25, 7098, 7098},
      {"md_crack.lammpstrj", 11, 8141, 8141},   {"granular_pour.lammpstrj", 101, 0, 1000}};
  for (const Shared_file& file : files) {
    const auto motion = open_motion(recordings_directory() + "/" + file.name);
    EXPECT_EQ(motion->frames() + 1, file.number_of_frames) << file.name;
    std::size_t fewest = motion->points().size();
    std::size_t most = fewest;
    while (motion->advance({})) {
      EXPECT_EQ(motion->ids().size(), motion->points().size()) << file.name;
      fewest = (std::min)(fewest, motion->points().size());
      most = (std::max)(most, motion->points().size());
    }
    EXPECT_EQ(fewest, file.fewest) << file.name;
    EXPECT_EQ(most, file.most) << file.name;
  }
}
