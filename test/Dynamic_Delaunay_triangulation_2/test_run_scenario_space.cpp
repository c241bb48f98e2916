// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The program run_scenario where points move in space, and what it reads and writes there.

#include "scenario_program.h"
#include "scenario_runner/Open_motion.h"
#include "scenario_runner/space/Motion_3.h"
#include "scenario_runner/space/Simulated_motion_3.h"
#include "scenario_runner/Text_input.h"
#include "temporary_files.h"

#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using scenario::Point_3;
using scenario::Recording;

// What of a recording in space is read: all points of all frames, in their order.
std::vector<Point_3> points_of(const Recording& recording)
{
  std::vector<Point_3> points;
  scenario::Recorded_motion_3 motion("test", "test", recording);
  do {
    points.insert(points.end(), motion.points().begin(), motion.points().end());
  } while (motion.advance({}));
  return points;
}

std::string message_of(const Recording& recording)
{
  try {
    scenario::Recorded_motion_3("file", "name", recording);
  } catch (const scenario::Scenario_error& error) {
    return error.what();
  }
  return "";
}

// Corners of a tetrahedron, and a point in it that moves up.
std::string table_in_space()
{
  return "frame,id,x,y,z\n"
         "0,1,0,0,0\n0,2,4,0,0\n0,3,0,4,0\n0,4,0,0,4\n0,5,1,1,0.5\n"
         "1,1,0,0,0\n1,2,4,0,0\n1,3,0,4,0\n1,4,0,0,4\n1,5,1,1,1\n";
}

// REPORTS ----------------------------------------------------------------------------------------

TEST(Run_in_space, reports_what_it_did)
{
  const Json report = report_of({"brownian_3", "--frames", "20", "--points", "300"});
  EXPECT_EQ(report["scenario"], "brownian_3");
  EXPECT_EQ(report["dimension"], 3);
  EXPECT_EQ(report["points"], 300);
  EXPECT_EQ(report["frames"], 20);
  EXPECT_EQ(report["exact"], true);
  EXPECT_EQ(report["certified_frames"], 20);
  EXPECT_EQ(report["valid_frames"], 20);
  EXPECT_EQ(report["seed"], 1);
  EXPECT_EQ(report["time_step"], 0.01);
  EXPECT_EQ(report["threads"], 1);
  EXPECT_GT(report["flips_mean"], 0.0);
  for (const char* key : {"unproved_mean", "held_mean", "relocated_mean", "dynamic_ns_per_point",
                          "static_insert_ns_per_point", "static_fastest_ns_per_point",
                          "speedup_vs_insert", "speedup_vs_fastest"}) {
    EXPECT_TRUE(report[key].is_number()) << key;
  }
}

TEST(Run_in_space, shows_a_table)
{
  const Outcome outcome = run_program({"dam_break_3", "--frames", "10", "--points", "200"});
  EXPECT_TRUE(outcome.succeeded) << outcome.errors;
  EXPECT_TRUE(contains(outcome.output, "dam_break_3, 200 points in space, 10 frames"));
  EXPECT_TRUE(contains(outcome.output, "10 of 10"));
  EXPECT_TRUE(contains(outcome.output, "always_dynamic"));
  EXPECT_TRUE(contains(outcome.output, "speedup over fastest static"));
}

TEST(Run_in_space, takes_seed_time_step_and_threads)
{
  const Json report = report_of({"brownian_3", "--frames", "3", "--points", "100", "--seed", "7",
                                 "--time-step", "0.1", "--threads", "2"});
  EXPECT_EQ(report["seed"], 7);
  EXPECT_EQ(report["time_step"], 0.1);
  EXPECT_EQ(report["certified_frames"], 3);
}

TEST(Run_in_space, has_policies)
{
  const auto rebuilds = [](const std::string& policy) {
    const Json report =
        report_of({"brownian_3", "--frames", "6", "--points", "200", "--policy", policy});
    EXPECT_EQ(report["certified_frames"], 6);
    EXPECT_EQ(report["policy"], policy.substr(0, policy.find(':')));
    return report["rebuilds"];
  };
  EXPECT_EQ(rebuilds("always_dynamic"), 0);
  EXPECT_EQ(rebuilds("key_frames:3"), 2);
  EXPECT_EQ(rebuilds("always_static"), 6);
}

TEST(Run_in_space, is_refused_what_only_the_plane_has)
{
  for (const Words& words : {Words{"--classifier", "circumcircle"},
                             {"--padding", "2"},
                             {"--repair", "flip"},
                             {"--policy", "hybrid"},
                             {"--engine", "insertion"},
                             {"--packing", "square"},
                             {"--svg", temporary_path("svg")},
                             {"--html", temporary_path("page.html")}}) {
    const Outcome outcome = run_program(with({"brownian_3"}, words));
    EXPECT_FALSE(outcome.succeeded) << words.front();
    EXPECT_TRUE(
        contains(outcome.errors, words.front() == "--packing" ? "no packing" : words.front()))
        << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, "in space")) << outcome.errors;
  }
}

TEST(Run_in_space, has_the_dimension_of_its_scenario)
{
  EXPECT_TRUE(contains(run_program({"brownian_3", "--dimension", "2"}).errors,
                       "is a scenario in space: its dimension cannot be chosen"));
  EXPECT_TRUE(contains(run_program({"brownian", "--dimension", "3"}).errors,
                       "is a scenario in the plane: its dimension cannot be chosen"));
}

// RECORDINGS -------------------------------------------------------------------------------------

TEST(Recording_in_space, is_what_has_heights_that_differ)
{
  const auto is = [](const std::string& text) {
    return scenario::is_in_space(scenario::parse_recording("recording", text));
  };
  EXPECT_TRUE(is(table_in_space()));
  EXPECT_FALSE(is("frame,id,x,y\n0,1,0,0\n0,2,4,0\n"));
  EXPECT_FALSE(is("frame,id,x,y,z\n0,1,0,0,7\n0,2,4,0,7\n1,1,0,0,7\n"));
  EXPECT_TRUE(is("frame,id,x,y,z\n0,1,0,0,7\n1,1,0,0,7.5\n"));
  EXPECT_TRUE(is("frame,id,x,y,z\n0,1,0,0,0\n1,1,0,0,7\n"));
  EXPECT_FALSE(is("frame,id,x,y,z\n0,1,0,0,\n0,2,0,3,?\n"));
  EXPECT_FALSE(is("1\n\nX 1 2 0\n1\n\nX 1 2 0\n"));
  EXPECT_TRUE(is("1\n\nX 1 2 0\n1\n\nX 1 2 1\n"));
  EXPECT_FALSE(is("1\n\nX 1 2\n1\n\nX 1 3\n"));
}

TEST(Recording_in_space, is_read_from_tables)
{
  const std::vector<Point_3> points = {{1, 2, 3}, {4, 5, 6}};
  for (const char* const head : {"frame,id,x,y,z", "frame,particle,x,y,z", "t,TID,x,y,z",
                                 "FRAME,TRACK_ID,POSITION_X,POSITION_Y,POSITION_Z"}) {
    EXPECT_EQ(points_of(scenario::parse_csv("f", std::string(head) + "\n0,1,1,2,3\n0,2,4,5,6\n")),
              points)
        << head;
  }
  EXPECT_EQ(points_of(scenario::parse_csv("f", "0,9,1,3,1,2\n0,9,2,6,4,5\n",
                                          scenario::table_columns("frame,-,id,z,x,y"))),
            points);
  EXPECT_EQ(points_of(scenario::parse_csv("f", "frame,id,x,y,h\n0,1,1,2,3\n0,2,4,5,6\n",
                                          scenario::table_columns("z=h"))),
            points);
}

TEST(Recording_in_space, is_read_from_xyz)
{
  const std::vector<Point_3> points = {{1, 2, 3}, {4, 5, 0.6}};
  EXPECT_EQ(points_of(scenario::parse_xyz("f", "2\nremark\nX 1 2 3\nY 4 5 6D-1\n")), points);
  EXPECT_EQ(
      points_of(scenario::parse_xyz("f", "2\nProperties=pos:R:3:id:I:1\n4 5 0.6 8\n1 2 3 7\n")),
      points);
}

TEST(Recording_in_space, is_read_from_dumps)
{
  const std::string head = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\n";
  const std::vector<Point_3> points = {{1, 2, 3}, {4, 4, 5}};
  EXPECT_EQ(points_of(scenario::parse_lammps_dump(
                "f", head + "ITEM: BOX BOUNDS ff ff ff\n0 8\n0 8\n0 8\nITEM: ATOMS id x z y\n"
                            "1 1 3 2\n2 4 5 4\n")),
            points);
  EXPECT_EQ(points_of(scenario::parse_lammps_dump(
                "f", head + "ITEM: BOX BOUNDS ff ff ff\n0 8\n0 8\n1 9\nITEM: ATOMS id xs ys zs\n"
                            "1 0.125 0.25 0.25\n2 0.5 0.5 0.5\n")),
            points);
  EXPECT_EQ(points_of(scenario::parse_lammps_dump(
                "f", head + "ITEM: BOX BOUNDS abc origin ff ff ff\n8 0 0 0\n0 8 2 0\n0 0 8 1\n"
                            "ITEM: ATOMS id xs ys zs\n1 0.125 0.25 0.1875\n2 0.5 0.5 0.375\n")),
            points);
}

TEST(Recording_in_space, needs_finite_heights)
{
  EXPECT_EQ(
      message_of(scenario::parse_csv("f", "frame,id,x,y,z\n3,1,0,0,1\n3,2,4,0,none\n")),
      "file: is in space, and z of id 2 in frame 3 is no finite number; --dimension 2 takes x "
      "and y alone");
  EXPECT_EQ(message_of(scenario::parse_csv("f", "frame,id,x,y,z\n3,Ann,0,0,inf\n")),
            "file: is in space, and z of id 'Ann' in frame 3 is no finite number; --dimension 2 "
            "takes x and y alone");
}

TEST(Recording_in_space, runs_in_the_plane_too)
{
  const std::string path = write_file("space.csv", table_in_space());
  EXPECT_EQ(report_of({path})["dimension"], 3);
  EXPECT_EQ(report_of({path, "--dimension", "3"})["dimension"], 3);
  const Json report = report_of({path, "--dimension", "2"});
  EXPECT_FALSE(report.contains("dimension"));
  expect_exact_report(report, 1);
}

TEST(Recording_in_space, may_be_flat)
{
  const std::string path = write_file("flat.csv", small_csv());
  const Json report = report_of({path, "--dimension", "3"});
  EXPECT_EQ(report["dimension"], 3);
  EXPECT_EQ(report["certified_frames"], 7);
  EXPECT_EQ(report["population_changes"], 2);
}

TEST(Recording_in_space, may_have_points_that_come_go_and_coincide)
{
  std::string text = "frame,id,x,y,z\n";
  for (int frame = 0; frame != 12; ++frame) {
    for (int id = 0; id != 30; ++id) {
      if ((id + frame) % 5 != 0 && frame != 6) {
        const int place = frame == 9 && id % 2 == 0 ? 0 : id;
        text += std::to_string(frame) + ',' + std::to_string(1000 - id) + ',' +
                std::to_string(place % 3) + ',' + std::to_string(place / 3 % 4) + ',' +
                std::to_string(place / 12 + 0.1 * frame) + '\n';
      }
    }
  }
  const Json report = report_of({write_file("population.csv", text)});
  EXPECT_EQ(report["frames"], 10); // the one without points is not in the file
  EXPECT_EQ(report["certified_frames"], 10);
  EXPECT_EQ(report["population_changes"], 10);
}

// FILES ------------------------------------------------------------------------------------------

TEST(Files_in_space, are_read_as_the_same_motion)
{
  const std::string xyz = temporary_path("points.xyz"), dump = temporary_path("points.lammpstrj");
  run_quietly({"brownian_3", "--frames", "3", "--points", "50", "--xyz", xyz, "--lammps", dump});
  const Recording by_xyz = scenario::read_recording(xyz), by_dump = scenario::read_recording(dump);
  ASSERT_EQ(by_xyz.size(), 4u);
  expect_equal_recordings(by_xyz, by_dump);
  EXPECT_EQ(points_of(by_xyz), points_of(by_dump));
  const scenario::Opened_motion motion = scenario::open_any_motion(
      scenario::scenario_path("brownian_3"), {50, {}, {}, {}}, {}, std::nullopt);
  std::vector<Point_3> points = motion.in_space->points();
  while (points.size() < 200) {
    motion.in_space->advance({});
    const std::vector<Point_3>& more = motion.in_space->points();
    points.insert(points.end(), more.begin(), more.end());
  }
  EXPECT_EQ(points_of(by_dump), points);
  const std::string again = temporary_path("again.xyz");
  run_quietly({dump, "--xyz", again});
  EXPECT_EQ(points_of(scenario::read_recording(again)), points);
}

TEST(Files_in_space, have_a_row_for_each_frame)
{
  const std::string path = temporary_path("frames.csv");
  run_quietly({"dam_break_3", "--frames", "5", "--points", "100", "--csv", path});
  const std::string text = content_of(path);
  EXPECT_EQ(number_of_lines(text), 6u);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "frame,time,points,population_changed,certified,rebuild_reason,unproved,flips,held,"
            "relocated,inserted,removed,merged,parted,dynamic_ns,static_insert_ns,"
            "static_fastest_ns");
}

TEST(Files_in_space, have_cells_that_fill_the_box)
{
  const std::string path = temporary_path("cells.csv");
  run_quietly({"brownian_3", "--frames", "4", "--points", "80", "--cells", path, "--every", "2"});
  std::istringstream lines(content_of(path));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "frame,time,id,x,y,z,volume,density,surface_area,contacts");
  std::map<std::string, double> volumes;
  std::size_t rows = 0;
  for (; std::getline(lines, line); ++rows) {
    std::vector<std::string> fields;
    std::istringstream row(line);
    for (std::string field; std::getline(row, field, ',');) {
      fields.push_back(field);
    }
    ASSERT_EQ(fields.size(), 10u);
    volumes[fields[0]] += std::stod(fields[6]);
    EXPECT_NEAR(std::stod(fields[6]) * std::stod(fields[7]), 1.0, 1e-12);
    EXPECT_GE(std::stoi(fields[9]), 4);
  }
  EXPECT_EQ(rows, 240u);
  ASSERT_EQ(volumes.size(), 3u);
  for (const auto& [frame, volume] : volumes) {
    EXPECT_NEAR(volume, 1.0, 1e-12) << frame;
  }
}

TEST(Files_in_space, have_cells_without_an_end)
{
  const std::string table = write_file("space.csv", table_in_space()),
                    path = temporary_path("whole.csv");
  run_quietly({table, "--cells", path});
  const std::string text = content_of(path);
  EXPECT_TRUE(contains(text, "0,0,1,0,0,0,,0,,4\n")) << text; // on the hull
  EXPECT_EQ(number_of_lines(text), 11u);
}

std::vector<double> array_of(const boost::property_tree::ptree& grid, const std::string& part,
                             const std::string& name)
{
  std::vector<double> numbers;
  for (const auto& [key, array] : grid.get_child("VTKFile.UnstructuredGrid.Piece." + part)) {
    if (key == "DataArray" && array.get<std::string>("<xmlattr>.Name") == name) {
      std::istringstream text(array.get_value<std::string>());
      for (double number{}; text >> number;) {
        numbers.push_back(number);
      }
    }
  }
  return numbers;
}

TEST(Files_in_space, have_tetrahedra_that_fill_the_hull)
{
  const std::string table = write_file("space.csv", table_in_space()),
                    folder = temporary_path("vtk");
  run_quietly({table, "--vtk", folder});
  boost::property_tree::ptree grid;
  boost::property_tree::read_xml((std::filesystem::path(folder) / "frame_00001.vtu").string(),
                                 grid);
  const std::vector<double> points = array_of(grid, "Points", "Points"),
                            corners = array_of(grid, "Cells", "connectivity"),
                            types = array_of(grid, "Cells", "types");
  EXPECT_EQ(array_of(grid, "PointData", "id"), (std::vector<double>{1, 2, 3, 4, 5}));
  ASSERT_EQ(points.size(), 15u);
  ASSERT_EQ(corners.size(), 16u);
  EXPECT_EQ(types, (std::vector<double>{10, 10, 10, 10}));
  double volume = 0.0;
  for (std::size_t cell = 0; cell != 4; ++cell) {
    std::array<Point_3, 4> p{};
    for (std::size_t i = 0; i != 12; ++i) {
      p[i / 3][i % 3] = points[3 * static_cast<std::size_t>(corners[4 * cell + i / 3]) + i % 3];
    }
    const auto side = [&](std::size_t i, std::size_t axis) { return p[i][axis] - p[0][axis]; };
    const double sixfold = side(1, 0) * (side(2, 1) * side(3, 2) - side(2, 2) * side(3, 1)) +
                           side(1, 1) * (side(2, 2) * side(3, 0) - side(2, 0) * side(3, 2)) +
                           side(1, 2) * (side(2, 0) * side(3, 1) - side(2, 1) * side(3, 0));
    EXPECT_GT(sixfold, 0.0); // as VTK wants it
    volume += sixfold / 6.0;
  }
  EXPECT_DOUBLE_EQ(volume, 64.0 / 6.0);
}

// SCENARIOS --------------------------------------------------------------------------------------

TEST(Scenario_in_space, says_that_it_is)
{
  EXPECT_TRUE(scenario::is_scenario_in_space("file", R"({"dimension": 3})"));
  EXPECT_FALSE(scenario::is_scenario_in_space("file", R"({"name": "static"})"));
  for (const char* const dimension : {"2", "4", "3.5", "\"3\"", "null"}) {
    EXPECT_THROW(
        scenario::is_scenario_in_space("file", std::string("{\"dimension\": ") + dimension + '}'),
        scenario::Scenario_error)
        << dimension;
  }
  EXPECT_THROW(scenario::open_motion(scenario::scenario_path("brownian_3")),
               scenario::Scenario_error);
}

TEST(Scenario_in_space, refuses_what_it_does_not_know)
{
  const auto message = [](const std::string& text) {
    try {
      scenario::parse_scenario_3("file", text);
    } catch (const scenario::Scenario_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string brownian =
      R"("dimension": 3, "name": "b", "kind": "brownian", "seed": 1, "frames": 9, "time_step": 0.1)";
  EXPECT_EQ(message("{" + brownian + R"(, "points": 9, "box": [1, 2, 3]})"), "");
  EXPECT_EQ(message("{" + brownian + R"(, "points": 9, "box": [1, 2]})"),
            "file: key 'box' is [1,2], expected an array of three numbers");
  EXPECT_EQ(message("{" + brownian + R"(, "points": 0, "box": [1, 2, 3]})"),
            "file: key 'points' is 0, allowed are values from 1 to 10000000");
  const std::string particles =
      R"("dimension": 3, "name": "p", "kind": "particles", "seed": 1, "frames": 9, "time_step": 0.1,
         "jitter": 0, "diameter": 1, "mass": 1, "stiffness": 1, "damping": 0, "gravity": 0)";
  const auto block = [&](const std::string& text) {
    return message("{" + particles + R"(, "box": [4, 4, 4], "blocks": [)" + text + "]}");
  };
  EXPECT_EQ(block(R"({"counts": [4, 4, 4], "position": [0, 0, 0]})"), "");
  EXPECT_EQ(block(R"({"counts": [4, 4, 5], "position": [0, 0, 0]})"),
            "file: key 'blocks[0]' describes a block that is not inside of the box of key 'box'");
  EXPECT_EQ(block(R"({"counts": [4, 4, 1.5], "position": [0, 0, 0]})"),
            "file: key 'blocks[0].counts' has to have three integers");
  EXPECT_EQ(block(R"({"counts": [300, 300, 300], "position": [0, 0, 0]})"),
            "file: key 'blocks[0].counts' has too many points, allowed are 10000000");
  EXPECT_TRUE(contains(block(R"({"count": 4})"), "unknown key 'blocks[0].count'"));
}

// Balls stay in their box, come to rest on its bottom, and keep their distances.
TEST(Scenario_in_space, lets_balls_fall_and_spread)
{
  const std::string dump = temporary_path("balls.lammpstrj");
  run_quietly(
      {"dam_break_3", "--frames", "400", "--points", "300", "--lammps", dump, "--every", "400"});
  const Recording frames = scenario::read_recording(dump);
  ASSERT_EQ(frames.size(), 2u);
  const auto mean_of = [](const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
      sum += value;
    }
    return sum / static_cast<double>(values.size());
  };
  const auto mean_x = [](const scenario::Recorded_frame& frame) {
    double sum = 0.0;
    for (const scenario::Point& point : frame.points) {
      sum += point.x;
    }
    return sum / static_cast<double>(frame.points.size());
  };
  EXPECT_LT(mean_of(frames[1].heights), mean_of(frames[0].heights));
  EXPECT_GT(mean_x(frames[1]), mean_x(frames[0]));
  for (const double z : frames[1].heights) {
    EXPECT_GT(z, 0.0);
  }
}

TEST(Scenario_in_space, is_scaled_to_any_number_of_points)
{
  const auto path = scenario::scenario_path("dam_break_3");
  const auto usual = scenario::parse_scenario_3(path, scenario::read_text_file(path));
  const auto& particles = std::get<scenario::Particle_description_3>(usual.kind);
  for (const std::size_t points : std::vector<std::size_t>{1, 2, 7, 100, 999, 4032, 50'000}) {
    const auto scaled = scenario::scaled_to(particles, points);
    EXPECT_GE(scaled.number_of_points(), points);
    const scenario::Particle_motion_3 motion(usual, scaled, points, 1);
    ASSERT_EQ(motion.points().size(), points);
    const Point_3 highest =
        *std::max_element(motion.points().begin(), motion.points().end(),
                          [](const Point_3& p, const Point_3& q) { return p[2] < q[2]; });
    EXPECT_LT(highest[2], (*scaled.box)[2]);
  }
}

} // namespace
