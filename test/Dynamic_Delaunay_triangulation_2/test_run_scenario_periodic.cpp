// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The program run_scenario, run on motion in periodic space.

#include "scenario_program.h"
#include "scenario_runner/Lammps_box.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Open_motion.h"
#include "scenario_runner/Periodic_run.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Simulated_motion.h"
#include "temporary_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

namespace {

using run::number_text;
using scenario::Cell;
using scenario::Point;
using scenario::Recording;

// Points that diffuse in a cell, which may change with every frame and takes them along. They are
// wrapped into it in each frame, where it is periodic.
class Wrapped_cloud
{
public:
  explicit Wrapped_cloud(std::size_t points, std::uint64_t seed = 1)
    : m_random(seed)
  {
    for (std::size_t i = 0; i != points; ++i) {
      m_fractions.push_back({m_random.uniform(), m_random.uniform()});
    }
  }

  void advance(double step, const Cell& cell)
  {
    for (Point& p : m_fractions) {
      p.x += step * m_random.gaussian();
      p.y += step * m_random.gaussian();
      wrap(p.x, cell.is_periodic[0]);
      wrap(p.y, cell.is_periodic[1]);
    }
  }

  // Adds a multiple of the first side of the cell to the second one. No point moves.
  void shear_back(int times)
  {
    for (Point& p : m_fractions) {
      p.x -= times * p.y;
      wrap(p.x, true);
    }
  }

  std::vector<Point> points(const Cell& cell) const
  {
    const auto& [a, b] = cell.sides;
    std::vector<Point> points;
    for (const Point& p : m_fractions) {
      points.push_back(
          {cell.corner.x + p.x * a.x + p.y * b.x, cell.corner.y + p.x * a.y + p.y * b.y});
    }
    return points;
  }

  std::size_t wraps() const { return m_wraps; }

private:
  void wrap(double& fraction, bool is_periodic)
  {
    if (is_periodic && (fraction < 0.0 || fraction >= 1.0)) {
      fraction -= std::floor(fraction);
      ++m_wraps;
    }
  }

  scenario::Random_source m_random;
  std::vector<Point> m_fractions;
  std::size_t m_wraps = 0;
};

Cell rectangle(double x, double y, double width, double height, bool along_x = true,
               bool along_y = true)
{
  return {{x, y}, {{{width, 0.0}, {0.0, height}}}, {along_x, along_y}};
}

std::string dump_frame(std::size_t timestep, const Cell& cell, const std::vector<Point>& points,
                       std::size_t first_id = 1)
{
  std::ostringstream out;
  out << "ITEM: TIMESTEP\n" << timestep << "\nITEM: NUMBER OF ATOMS\n" << points.size() << '\n';
  scenario::write_lammps_box(out, cell);
  out << "ITEM: ATOMS id type x y z ix iy\n";
  for (std::size_t i = 0; i != points.size(); ++i) {
    out << first_id + i << " 1 " << number_text(points[i].x) << ' ' << number_text(points[i].y)
        << " 0 0 0\n";
  }
  return out.str();
}

std::string xyz_frame(const std::string& comment, const std::vector<Point>& points)
{
  std::string text = std::to_string(points.size()) + "\n" + comment + "\n";
  for (const Point& point : points) {
    text += "Ar " + number_text(point.x) + " " + number_text(point.y) + " 0\n";
  }
  return text;
}

// Every frame is certified, valid and as another triangulation has it, and none is rebuilt.
void expect_whole(const Json& report, std::size_t frames, const std::string& cell)
{
  expect_exact_report(report, frames);
  EXPECT_EQ(report["cell"], cell);
  EXPECT_EQ(report["rebuilds"], 0);
}

constexpr std::size_t frames = 40;

// A dump of a cloud, in the cells that `cell` returns for the frames.
std::string cloud_dump(Wrapped_cloud& cloud, double step,
                       const std::function<Cell(std::size_t)>& cell)
{
  std::string text;
  for (std::size_t frame = 0; frame <= frames; ++frame) {
    cloud.advance(step, cell(frame));
    text += dump_frame(frame, cell(frame), cloud.points(cell(frame)));
  }
  return text;
}

TEST(Periodic_dump, that_wraps_its_points_is_followed_without_a_rebuild)
{
  Wrapped_cloud cloud(150);
  const std::string dump =
      cloud_dump(cloud, 0.002, [](std::size_t) { return rectangle(-1.0, 10.0, 4.0, 10.0); });
  EXPECT_GT(cloud.wraps(), frames / 4);
  EXPECT_TRUE(contains(dump, "BOX BOUNDS pp pp pp\n"));
  expect_whole(report_of({write_file("wraps.dump", dump)}), frames, "torus");
}

TEST(Periodic_dump, is_known_by_the_two_boundaries_of_the_plane)
{
  const std::string dump = dump_frame(0, rectangle(0.0, 0.0, 1.0, 1.0), {{0.1, 0.2}, {0.5, 0.6}});
  const auto cell_under = [&](const std::string& boundaries) {
    std::string text = dump;
    text.replace(text.find("pp pp pp"), 8, boundaries);
    return scenario::parse_lammps_dump("dump", text).front().cell;
  };
  EXPECT_EQ(cell_under("pp pp ff")->is_periodic, (std::array<bool, 2>{true, true}));
  EXPECT_EQ(cell_under("pp ss pp")->is_periodic, (std::array<bool, 2>{true, false}));
  EXPECT_EQ(cell_under("fs pp ff")->is_periodic, (std::array<bool, 2>{false, true}));
  EXPECT_FALSE(cell_under("ff mm pp"));
  EXPECT_THROW(cell_under(""), scenario::Scenario_error) << "it does not say";
}

TEST(Tilted_dump, is_followed_through_a_flip_of_its_cell_without_a_rebuild)
{
  Wrapped_cloud cloud(150);
  std::string text;
  double tilt = 0.0;
  std::size_t flips = 0;
  for (std::size_t frame = 0; frame <= frames; ++frame) {
    if (tilt >
        5.0) { // half of the width: the cell that leans to the other side has the same lattice
      tilt -= 10.0;
      cloud.shear_back(-1);
      ++flips;
    }
    const Cell cell{{2.0, 3.0}, {{{10.0, 0.0}, {tilt, 8.0}}}, {true, true}};
    cloud.advance(0.001, cell);
    text += dump_frame(frame, cell, cloud.points(cell));
    tilt += 0.3;
  }
  EXPECT_GT(flips, 0u);
  EXPECT_TRUE(contains(text, "BOX BOUNDS xy xz yz pp pp pp\n"));
  expect_whole(report_of({write_file("sheared.dump", text)}), frames, "torus");
}

TEST(Tilted_dump, states_the_bounds_of_the_box_around_it)
{
  const std::string head = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS xy xz yz "
                           "pp pp pp\n";
  const auto frame_of = [&](const std::string& text) {
    return scenario::parse_lammps_dump("dump", head + text).front();
  };
  const auto left = frame_of("-3 10 -3\n0 8 0\n0 1 0\nITEM: ATOMS id xs ys\n1 0.5 0.5\n");
  EXPECT_EQ(left.cell, (Cell{{0.0, 0.0}, {{{10.0, 0.0}, {-3.0, 8.0}}}, {true, true}}));
  EXPECT_EQ(left.points[0].x, 3.5);
  EXPECT_EQ(left.points[0].y, 4.0);
  const auto deep = frame_of("-1 14 2\n0 9 -1\n0 1 1\nITEM: ATOMS id x y\n1 0.5 0.5\n");
  EXPECT_EQ(deep.cell, (Cell{{0.0, 0.0}, {{{12.0, 0.0}, {2.0, 8.0}}}, {true, true}}));
}

TEST(Dump_with_vectors, has_a_cell_at_any_angle)
{
  const Cell cell{{-1.0, 2.0}, {{{3.0, 4.0}, {-5.0, 2.0}}}, {true, true}};
  Wrapped_cloud cloud(100);
  const std::string dump = cloud_dump(cloud, 0.002, [&](std::size_t) { return cell; });
  EXPECT_TRUE(contains(dump, "BOX BOUNDS abc origin pp pp pp\n3 4 0 -1\n-5 2 0 2\n"));
  EXPECT_EQ(scenario::parse_lammps_dump("dump", dump).front().cell, cell);
  expect_whole(report_of({write_file("vectors.dump", dump)}), frames, "torus");
}

TEST(Periodic_dump, may_change_its_box_from_frame_to_frame)
{
  Wrapped_cloud cloud(150);
  const std::string dump = cloud_dump(cloud, 0.001, [](std::size_t frame) {
    const double growth = 1.0 + 0.01 * static_cast<double>(frame);
    return rectangle(-growth, 0.0, 2.0 * growth, 3.0 / growth);
  });
  expect_whole(report_of({write_file("breathing.dump", dump)}), frames, "torus");
}

TEST(Periodic_dump, may_have_points_that_are_never_wrapped)
{
  std::string text;
  for (std::size_t frame = 0; frame <= frames; ++frame) {
    std::string frame_text =
        dump_frame(frame, rectangle(0.0, 0.0, 1.0, 1.0),
                   {{0.1 * static_cast<double>(frame), 0.3}, {-7.8, 0.1}, {0.5, 3.9}, {0.9, 0.8}});
    frame_text.replace(frame_text.find(" x y z"), 6, " xu yu z");
    text += frame_text;
  }
  expect_exact_report(report_of({write_file("unwrapped.dump", text)}), frames);
}

TEST(Periodic_dump, may_change_its_population)
{
  Wrapped_cloud cloud(60);
  const Cell cell = rectangle(0.0, 0.0, 6.0, 10.0);
  std::string text;
  for (std::size_t frame = 0; frame <= frames; ++frame) {
    cloud.advance(0.002, cell);
    std::vector<Point> points = cloud.points(cell);
    points.resize(frame % 10 == 9 ? 57 : 60);
    text += dump_frame(frame, cell, points);
  }
  const Json report = report_of({write_file("population.dump", text)});
  EXPECT_EQ(report["population_changes"], 8);
  expect_whole(report, frames, "torus");
}

TEST(Periodic_dump, may_have_no_one_two_and_coincident_points)
{
  const Cell cell = rectangle(0.0, 0.0, 2.0, 1.0);
  const std::vector<std::vector<Point>> all = {{},
                                               {{0.5, 0.5}},
                                               {{0.5, 0.5}, {1.5, 0.25}},
                                               {{0.5, 0.5}, {2.5, 0.5}, {1.5, 0.25}},
                                               {{0.5, 0.5}, {2.5, -0.5}, {1.5, 0.25}, {1.0, 0.75}},
                                               {}};
  std::string text;
  for (std::size_t frame = 0; frame != all.size(); ++frame) {
    text += dump_frame(frame, cell, all[frame]);
  }
  expect_exact_report(report_of({write_file("few.dump", text)}), all.size() - 1);
}

TEST(Periodic_dump, of_a_lattice_is_full_of_ties_and_no_tie_is_an_error)
{
  std::vector<Point> points;
  for (int i = 0; i != 36; ++i) {
    points.push_back({static_cast<double>(i % 6), static_cast<double>(i / 6)});
  }
  std::string text;
  for (std::size_t frame = 0; frame != 6; ++frame) {
    text += dump_frame(frame, rectangle(0.0, 0.0, 6.0, 6.0), points);
    for (Point& point : points) {
      point.x += 0.25;
    }
  }
  expect_exact_report(report_of({write_file("lattice.dump", text)}), 5);
}

// An empty circle is many times as wide as the cell.
TEST(Periodic_dump, may_have_a_thin_box_and_a_large_hole)
{
  const Cell thin = rectangle(0.0, 0.0, 30.0, 0.5);
  std::string text;
  for (std::size_t frame = 0; frame != 5; ++frame) {
    std::vector<Point> points;
    for (std::size_t i = 0; i != 40; ++i) {
      const double at = static_cast<double>(i + frame) / 41.0;
      points.push_back({2.0 * at * at, std::fmod(13.7 * at, 0.5)});
    }
    text += dump_frame(frame, thin, points);
  }
  expect_exact_report(report_of({write_file("thin.dump", text)}), 4);
}

TEST(Slab_dump, is_periodic_along_the_axis_that_says_so)
{
  for (const bool along_x : {true, false}) {
    SCOPED_TRACE(along_x);
    Wrapped_cloud cloud(120);
    const Cell cell = rectangle(1.0, 2.0, 8.0, 6.0, along_x, !along_x);
    const std::string dump = cloud_dump(cloud, 0.002, [&](std::size_t) { return cell; });
    EXPECT_GT(cloud.wraps(), frames / 10);
    EXPECT_TRUE(contains(dump, along_x ? "BOUNDS pp ff ff" : "BOUNDS ff pp ff"));
    expect_whole(report_of({write_file("slab.dump", dump)}), frames, "slab");
  }
}

TEST(Slab_dump, may_be_tilted_change_its_box_and_its_population)
{
  Wrapped_cloud cloud(80);
  std::string text;
  for (std::size_t frame = 0; frame <= frames; ++frame) {
    const double growth = 1.0 + 0.005 * static_cast<double>(frame);
    const Cell cell{{0.0, 0.0}, {{{8.0, 0.0}, {2.0 * growth, 5.0 * growth}}}, {false, true}};
    cloud.advance(0.001, cell);
    std::vector<Point> points = cloud.points(cell);
    points.resize(frame == 20 ? 79 : 80);
    text += dump_frame(frame, cell, points);
  }
  const Json report = report_of({write_file("slab.dump", text)});
  EXPECT_EQ(report["population_changes"], 2);
  expect_exact_report(report, frames);
  EXPECT_EQ(report["cell"], "slab");
}

TEST(Slab_dump, may_have_all_points_on_a_line)
{
  std::string text;
  for (std::size_t frame = 0; frame != 4; ++frame) {
    text += dump_frame(frame, rectangle(0.0, 0.0, 3.0, 1.0, true, false),
                       {{0.5 + 0.1 * static_cast<double>(frame), 0.5}, {1.5, 0.5}, {2.5, 0.5}});
  }
  expect_exact_report(report_of({write_file("line.dump", text)}), 3);
}

TEST(Xyz_file, with_a_lattice_is_periodic)
{
  Wrapped_cloud cloud(100);
  const Cell cell{{0.0, 0.0}, {{{10.0, 0.0}, {3.0, 8.0}}}, {true, true}};
  std::string text;
  for (std::size_t frame = 0; frame <= frames; ++frame) {
    cloud.advance(0.002, cell);
    text += xyz_frame("Properties=species:S:1:pos:R:3 Lattice=\"10 0 0 3 8 0 0 0 1\" Time=" +
                          number_text(0.5 * static_cast<double>(frame)) + " pbc=\"T T F\"",
                      cloud.points(cell));
  }
  const std::string path = write_file("lattice.xyz", text);
  expect_whole(report_of({path}), frames, "torus");
  const auto motion = scenario::open_motion(path);
  EXPECT_EQ(motion->cell(), cell);
  ASSERT_TRUE(motion->advance({}));
  EXPECT_EQ(motion->time(), 0.5);
}

TEST(Xyz_file, says_which_vectors_are_periodic_and_where_the_cell_is)
{
  const std::string lattice = "lattice = 3";
  const auto cell_of = [](const std::string& comment) {
    return scenario::parse_xyz("file", xyz_frame(comment, {{0.0, 1.0}})).front().cell;
  };
  const std::string vectors = "Lattice=\"10 0 0 0 8 0 0 0 1\"";
  EXPECT_EQ(cell_of(vectors), rectangle(0.0, 0.0, 10.0, 8.0)) << "the default";
  EXPECT_EQ(cell_of(vectors + " pbc=\"F T T\" Origin=\"-1 -2 0\""),
            rectangle(-1.0, -2.0, 10.0, 8.0, false, true));
  EXPECT_FALSE(cell_of(vectors + " pbc=\"F F T\""));
  EXPECT_FALSE(cell_of(""));
  EXPECT_FALSE(cell_of("any words, and an equation=\"of state\""));
}

TEST(Xyz_file, may_have_ids_and_any_columns)
{
  const Recording recording = scenario::parse_xyz(
      "file", "2\nProperties=mass:R:1:pos:R:2:id:I:1\n7 0.5 1.5 12\n8 2.5 3.5 -3\n"
              "1\n\nX 1 2 0\n");
  EXPECT_EQ(recording[0].ids, (std::vector<std::int64_t>{-3, 12}));
  EXPECT_EQ(recording[0].points[0].x, 2.5);
  EXPECT_EQ(recording[0].points[1].y, 1.5);
  EXPECT_EQ(recording[1].ids, (std::vector<std::int64_t>{0}));
  EXPECT_EQ(recording[1].time, 1.0);
}

TEST(Box, that_changes_between_slabs_along_x_and_y_turns_the_slab)
{
  const std::vector<Point> points = {{0.1, 0.2}, {0.5, 0.9}, {0.8, 0.4}};
  const std::string along_x = dump_frame(0, rectangle(0.0, 0.0, 1.0, 1.0, true, false), points);
  const std::string along_y = dump_frame(1, rectangle(0.0, 0.0, 1.0, 1.0, false, true), points);
  expect_exact_report(report_of({write_file("turned.dump", along_x + along_y)}), 1);
}

std::vector<run::Periodic_face> faces_of(const run::Run_view& periodic)
{
  std::vector<run::Periodic_face> faces;
  for (const run::Shown_triangle& triangle : periodic.triangles()) {
    const auto& [a, b, c] = triangle.corners;
    faces.push_back({{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                      static_cast<std::uint32_t>(c)},
                     triangle.shifts});
  }
  return faces;
}

TEST(Agreement_in_periodic_space, is_perfect_for_the_right_faces_alone)
{
  for (const auto kind : {scenario::Cell_kind::periodic, scenario::Cell_kind::channel}) {
    scenario::Brownian_motion motion("cloud", {80, {1.0, 2.0}, 0.01, kind}, 1, 3);
    run::Periodic_run<CGAL::Circumcircle_classifier_2> periodic(
        motion, CGAL::Circumcircle_classifier_2(), run::Any_repair(), {}, run::Any_policy());
    std::vector<std::uint32_t> representatives(80);
    std::iota(representatives.begin(), representatives.end(), 0U);
    run::Ghost_opponents ghosts;
    const auto agreement = [&](const std::vector<run::Periodic_face>& faces) {
      ghosts.prepare(motion.points(), *motion.cell());
      ghosts.time_insert();
      return ghosts.agreement(faces, representatives);
    };
    const std::vector<run::Periodic_face> faces = faces_of(periodic);
    EXPECT_EQ(agreement(faces), 1.0);
    std::vector<run::Periodic_face> wrong = faces;
    wrong[5].places[2] = (wrong[5].places[2] + 40) % 80;
    EXPECT_LT(agreement(wrong), 1.0) << "a corner at another point";
    wrong = faces;
    wrong[5].shifts[2][0] += 1;
    EXPECT_LT(agreement(wrong), 1.0) << "a corner at another image";
    wrong.assign(faces.begin() + 20, faces.end());
    EXPECT_LT(agreement(wrong), 1.0) << "a hole";
    for (int frame = 0; frame != 60; ++frame) {
      motion.advance({});
    }
    EXPECT_LT(agreement(faces), 1.0) << "the faces of another frame";
  }
}

std::string channel_scenario(const std::string& cell)
{
  return R"({"name": "cloud", "kind": "brownian", "seed": 3, "frames": 40, "time_step": 0.05,
             "points": 150, "box": [3.0, 1.0], "cell": ")" +
         cell + "\"}";
}

TEST(Brownian_motion, in_a_channel_crosses_only_its_open_ends)
{
  const std::string path = write_file("channel.json", channel_scenario("channel"));
  expect_whole(report_of({path}), 40, "slab");
  const auto motion = scenario::open_motion(path);
  std::size_t wraps = 0;
  for (std::vector<Point> before = motion->points(); motion->time() < 40.0;
       before = motion->points()) {
    ASSERT_TRUE(motion->advance({}));
    for (std::size_t i = 0; i != before.size(); ++i) {
      const Point& p = motion->points()[i];
      wraps += std::abs(p.x - before[i].x) > 1.5 ? 1 : 0;
      EXPECT_LT(std::abs(p.y - before[i].y), 0.5);
      EXPECT_TRUE(p.x >= 0.0 && p.x < 3.0 && p.y >= 0.0 && p.y <= 1.0);
    }
  }
  EXPECT_GT(wraps, 5u);
}

TEST(Scenario_file, may_close_its_box)
{
  EXPECT_FALSE(
      scenario::open_motion(write_file("closed.json", channel_scenario("closed")))->cell());
}

TEST(Block_on_a_torus, is_bonded_across_its_sides)
{
  const auto description = scenario::read_scenario_file(scenario::scenario_file("static_periodic"));
  const auto motion = scenario::make_motion(
      description, std::get<scenario::Particle_description>(description.kind), {});
  EXPECT_EQ(motion->system().bonds().number_of_bonds(), 4u * 32u * 32u)
      << "each disc has eight partners";
  EXPECT_TRUE(motion->system().bonds().connects(0, 31));
  EXPECT_TRUE(motion->system().bonds().connects(0, 1023));
  EXPECT_FALSE(motion->system().bonds().connects(0, 30));
}

// Two discs that approach each other across a side bounce off.
TEST(Discs_on_a_torus, collide_across_its_sides)
{
  const std::string path = write_file("collision.json", R"({"name": "collision",
    "kind": "particles", "packing": "square", "jitter": 0.0, "seed": 1, "frames": 100,
    "time_step": 0.1, "diameter": 1.0, "mass": 1.0, "stiffness": 1.0, "damping": 0.0,
    "gravity": 0.0, "box": [20.0, 20.0], "cell": "periodic", "bodies": [
      {"rows": 1, "columns": 1, "position": [1.0, 5.0], "velocity": [-0.3, 0.0]},
      {"rows": 1, "columns": 1, "position": [18.0, 5.0], "velocity": [0.3, 0.0]}]})");
  expect_exact_report(report_of({path, "--lammps", temporary_path("collision.dump")}), 100);
  const Recording recording = scenario::read_lammps_dump(temporary_path("collision.dump"));
  EXPECT_GT(recording.back().points[0].x, 1.5);
  EXPECT_LT(recording.back().points[0].x, 5.0);
  EXPECT_LT(recording.back().points[1].x, 18.5);
  EXPECT_GT(recording.back().points[1].x, 15.0);
}

TEST(Outputs_with_a_cell, are_read_back_as_the_same_motion)
{
  const double third = 1.0 / 3.0; // whose sums are rounded
  for (const Cell& cell :
       {rectangle(0.0, 0.0, 2.0, 1.0), rectangle(-third, 1e5 + third, third, 3.0 * third),
        rectangle(third, 0.0, 3.0, 2.0, true, false), rectangle(0.0, third, 3.0, 2.0, false, true),
        Cell{{1.0, 2.0}, {{{4.0, 0.0}, {-1.5, 3.0}}}, {true, true}},
        Cell{{third, 2.0}, {{{4.0, 0.0}, {0.7, 3.1}}}, {true, true}},
        Cell{{third, 2.0}, {{{third, 1.0}, {-2.0, 0.1}}}, {true, true}},
        Cell{{0.0, 0.0}, {{{0.0, 1.0}, {1.0, 0.0}}}, {true, true}}}) {
    Wrapped_cloud cloud(20);
    const std::string dump = cloud_dump(cloud, 0.01, [&](std::size_t) { return cell; });
    const Recording recording = scenario::parse_lammps_dump("dump", dump);
    EXPECT_EQ(recording.front().cell, cell);
    const std::string xyz = temporary_path("out.xyz"), lammps = temporary_path("out.lammpstrj");
    expect_exact_report(report_of({write_file("in.dump", dump), "--xyz", xyz, "--lammps", lammps}),
                        frames);
    expect_equal_recordings(scenario::read_lammps_dump(lammps), recording);
    expect_equal_recordings(scenario::read_xyz_motion(xyz), recording);
  }
}

TEST(Outputs_with_a_cell, run_again_with_the_same_result)
{
  const std::string dump = temporary_path("again.lammpstrj");
  const Json first =
      report_of({"brownian_periodic", "--points", "200", "--frames", "30", "--lammps", dump});
  const Json second = report_of({dump});
  for (const char* key :
       {"points", "frames", "certified_frames", "rebuilds", "flips_mean", "cell"}) {
    EXPECT_EQ(first[key], second[key]) << key;
  }
}

TEST(Pictures_of_a_cell, show_its_outline_and_halves_of_the_edges_that_leave_it)
{
  // One point has three edges to its own images: six halves.
  const std::string one = write_file(
      "one.dump",
      dump_frame(0, Cell{{0.0, 0.0}, {{{2.0, 0.0}, {0.5, 1.0}}}, {true, true}}, {{5.0, 7.5}}));
  const std::string directory = temporary_path("one_picture");
  report_of({one, "--svg", directory});
  const std::string picture = content_of(directory + "/frame_00000.svg");
  const std::string path = picture.substr(picture.find(" d=\""));
  const std::string edges = path.substr(0, path.find("\"/>"));
  EXPECT_EQ(static_cast<int>(std::count(edges.begin(), edges.end(), 'L')), 6);
  const std::string outline = picture.substr(picture.find("<polygon"));
  EXPECT_EQ(std::count(outline.begin(),
                       outline.begin() + static_cast<std::ptrdiff_t>(outline.find("/>")), ','),
            4);
  const std::string plain = temporary_path("plain_pictures");
  report_of({"brownian", "--points", "20", "--frames", "0", "--svg", plain});
  EXPECT_FALSE(contains(content_of(plain + "/frame_00000.svg"), "<polygon"));
}

// The numbers of an array of a grid.
std::vector<double> array_of(const std::string& grid, const std::string& name)
{
  const std::size_t begin = grid.find('>', grid.find("Name=\"" + name + "\"")) + 1;
  std::istringstream in(grid.substr(begin, grid.find("</DataArray>", begin) - begin));
  std::vector<double> numbers;
  for (double number; in >> number;) {
    numbers.push_back(number);
  }
  return numbers;
}

TEST(Grids_of_a_cell, cover_it_once_by_triangles_with_corners_at_images)
{
  const std::string directory = temporary_path("torus_grids");
  report_of({"brownian_periodic", "--points", "50", "--frames", "3", "--vtk", directory});
  const std::string grid = content_of(directory + "/frame_00003.vtu");
  const auto points = array_of(grid, "Points"), corners = array_of(grid, "connectivity");
  const auto ids = array_of(grid, "id"), are_images = array_of(grid, "image");
  EXPECT_EQ(corners.size(), 3u * 2u * 50u);
  ASSERT_GT(ids.size(), 50u);
  ASSERT_EQ(points.size(), 3 * ids.size());
  ASSERT_EQ(are_images.size(), ids.size());
  EXPECT_EQ(array_of(grid, "set").size(), ids.size());
  for (std::size_t i = 0; i != ids.size(); ++i) {
    EXPECT_EQ(are_images[i], i < 50 ? 0.0 : 1.0);
    const auto original = static_cast<std::size_t>(ids[i]);
    for (std::size_t axis = 0; axis != 2; ++axis) {
      const double apart = points[3 * i + axis] - points[3 * original + axis];
      EXPECT_NEAR(apart, std::round(apart), 1e-12);
    }
  }
  double area = 0.0;
  for (std::size_t i = 0; i != corners.size(); i += 3) {
    const auto corner = [&](std::size_t k) {
      const std::size_t at = 3 * static_cast<std::size_t>(corners[i + k]);
      return Point{points[at], points[at + 1]};
    };
    const Point p = corner(0), q = corner(1), r = corner(2);
    const double twice = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    EXPECT_GT(twice, 0.0);
    area += 0.5 * twice;
  }
  EXPECT_NEAR(area, 1.0, 1e-9);
  EXPECT_EQ(array_of(grid, "CellSides"), (std::vector<double>{1, 0, 0, 0, 1, 0}));
  EXPECT_EQ(array_of(grid, "CellCorner"), (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(array_of(grid, "CellIsPeriodic"), (std::vector<double>{1, 1}));
}

} // namespace
