// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The program run_scenario where points move in periodic space: dumps and XYZ files as simulations
// of molecules write them, and what it writes itself.

#include "scenario_program.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Open_motion.h"
#include "scenario_runner/space/Motion_3.h"
#include "scenario_runner/space/Scenario_file_3.h"
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
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using run::number_text;
using scenario::Cell_3;
using scenario::Point_3;
using scenario::Recording;

// FILES AS OTHER PROGRAMS WRITE THEM -------------------------------------------------------------

// A box as LAMMPS has it: its sides are (lx, 0, 0), (xy, ly, 0) and (xz, yz, lz).
struct Box
{
  Point_3 low;
  Point_3 lengths;
  double xy = 0.0, xz = 0.0, yz = 0.0;

  double volume() const { return lengths[0] * lengths[1] * lengths[2]; }
  std::array<Point_3, 3> sides() const
  {
    return {{{lengths[0], 0, 0}, {xy, lengths[1], 0}, {xz, yz, lengths[2]}}};
  }
  Point_3 place(const Point_3& fractions) const
  {
    Point_3 place = low;
    for (std::size_t side = 0; side != 3; ++side) {
      for (std::size_t axis = 0; axis != 3; ++axis) {
        place[axis] += fractions[side] * sides()[side][axis];
      }
    }
    return place;
  }
};

// A frame of particles, whose fractions of the box may lead out of it.
struct Frame
{
  Box box;
  std::vector<Point_3> fractions;
};

std::string e(double number) // as LAMMPS writes bounds
{
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%-1.16e", number);
  return text.data();
}

// `dump custom`, and its column styles.
std::string dump_of(const std::vector<Frame>& frames, const std::string& columns)
{
  std::ostringstream out;
  for (std::size_t step = 0; step != frames.size(); ++step) {
    const auto& [box, fractions] = frames[step];
    const bool is_tilted = box.xy != 0.0 || box.xz != 0.0 || box.yz != 0.0;
    const std::array<double, 3> tilts = {box.xy, box.xz, box.yz};
    const std::array<double, 3> below = {(std::min)({0.0, box.xy, box.xz, box.xy + box.xz}),
                                         (std::min)(0.0, box.yz), 0.0},
                                above = {(std::max)({0.0, box.xy, box.xz, box.xy + box.xz}),
                                         (std::max)(0.0, box.yz), 0.0};
    out << "ITEM: TIMESTEP\n"
        << 100 * step << "\nITEM: NUMBER OF ATOMS\n"
        << fractions.size() << "\nITEM: BOX BOUNDS " << (is_tilted ? "xy xz yz " : "")
        << "pp pp pp\n";
    for (std::size_t i = 0; i != 3; ++i) {
      out << e(box.low[i] + below[i]) << ' ' << e(box.low[i] + box.lengths[i] + above[i])
          << (is_tilted ? ' ' + e(tilts[i]) : "") << '\n';
    }
    out << "ITEM: ATOMS id type " << columns << '\n';
    for (std::size_t i = 0; i != fractions.size(); ++i) {
      const std::size_t atom = (i + step) % fractions.size(); // processors have them in any order
      Point_3 wrapped = fractions[atom];
      std::array<double, 3> image{};
      for (std::size_t k = 0; k != 3; ++k) {
        image[k] = std::floor(wrapped[k]);
        wrapped[k] -= image[k];
      }
      const bool is_unwrapped = columns.find('u') != columns.npos;
      const Point_3 shown = is_unwrapped ? fractions[atom] : wrapped;
      const bool is_scaled = columns.find('s') != columns.npos;
      const Point_3 numbers = is_scaled ? shown : box.place(shown);
      out << atom + 1 << " 1 " << number_text(numbers[0]) << ' ' << number_text(numbers[1]) << ' '
          << number_text(numbers[2]);
      if (columns.find("ix") != columns.npos) {
        out << ' ' << image[0] << ' ' << image[1] << ' ' << image[2];
      }
      out << '\n';
    }
  }
  return out.str();
}

std::string text_of(const Point_3& p)
{
  return number_text(p[0]) + ' ' + number_text(p[1]) + ' ' + number_text(p[2]);
}

// As ASE and OVITO write it.
std::string xyz_of(const std::vector<Frame>& frames, const std::string& pbc = "T T T")
{
  std::string text;
  for (const auto& [box, fractions] : frames) {
    const auto sides = box.sides();
    text += std::to_string(fractions.size()) + "\nLattice=\"" + text_of(sides[0]) + ' ' +
            text_of(sides[1]) + ' ' + text_of(sides[2]) + "\" Origin=\"" + text_of(box.low) +
            "\" Properties=species:S:1:pos:R:3 pbc=\"" + pbc + "\"\n";
    for (const Point_3& p : fractions) {
      text += "Ar " + text_of(box.place(p)) + '\n';
    }
  }
  return text;
}

// Particles that drift out of their box, which shears, is flipped, and shrinks.
std::vector<Frame> sheared_frames(std::size_t number, std::size_t particles)
{
  scenario::Random_source random(3);
  std::vector<Point_3> fractions;
  for (std::size_t i = 0; i != particles; ++i) {
    fractions.push_back({random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)});
  }
  std::vector<Frame> frames;
  double xz = 0.0;
  for (std::size_t frame = 0; frame != number; ++frame) {
    const double length = 10.0 - 0.01 * static_cast<double>(frame);
    frames.push_back({{{-3, 2, 1}, {length, 9, 8}, 1.5, xz, -0.5}, fractions});
    double next = xz + 0.7;
    const double flip = next > length / 2 ? 1.0 : 0.0;
    xz = next - flip * length;
    for (Point_3& p : fractions) {
      // by other vectors for the same lattice: c is the old c less the old a
      p[0] += flip * p[2] + 0.003 * random.gaussian() + 0.05;
      p[1] += 0.003 * random.gaussian();
      p[2] += 0.003 * random.gaussian();
    }
  }
  return frames;
}

// ROWS OF --cells --------------------------------------------------------------------------------

struct Row
{
  double volume;
  double surface_area;
  int contacts;
};
using Rows = std::map<std::pair<std::string, std::string>, Row>; // by frame and id

Rows rows_of(const std::string& path)
{
  std::istringstream lines(content_of(path));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "frame,time,id,x,y,z,volume,density,surface_area,contacts");
  Rows rows;
  while (std::getline(lines, line)) {
    Words fields;
    std::istringstream row(line);
    for (std::string field; std::getline(row, field, ',');) {
      fields.push_back(field);
    }
    rows[{fields.at(0), fields.at(2)}] = {fields.at(6).empty() ? HUGE_VAL : std::stod(fields.at(6)),
                                          fields.at(8).empty() ? HUGE_VAL : std::stod(fields.at(8)),
                                          std::stoi(fields.at(9))};
  }
  return rows;
}

Rows cells_of(const Words& arguments)
{
  const std::string path = temporary_path("cells.csv");
  run_quietly(with(arguments, {"--cells", path}));
  return rows_of(path);
}

std::map<std::string, double> volumes_by_frame(const Rows& rows)
{
  std::map<std::string, double> volumes;
  for (const auto& [key, row] : rows) {
    volumes[key.first] += row.volume;
  }
  return volumes;
}

void expect_same(const Rows& rows, const Rows& others)
{
  ASSERT_EQ(rows.size(), others.size());
  for (const auto& [key, row] : rows) {
    const Row& other = others.at(key);
    EXPECT_NEAR(row.volume, other.volume, 1e-9 * row.volume) << key.first << ' ' << key.second;
    EXPECT_NEAR(row.surface_area, other.surface_area, 1e-9 * row.surface_area);
    EXPECT_EQ(row.contacts, other.contacts) << key.first << ' ' << key.second;
  }
}

// The same in open space: a table of all points and their 26 images, whose ids come first.
Rows cells_among_images(const Frame& frame)
{
  std::ostringstream table;
  table << "frame,id,x,y,z\n";
  std::size_t id = 1;
  for (int image = 0; image != 27; ++image) {
    const int kind = (image + 13) % 27; // the points themselves first
    for (const Point_3& p : frame.fractions) {
      const Point_3 wrapped = {p[0] - std::floor(p[0]), p[1] - std::floor(p[1]),
                               p[2] - std::floor(p[2])};
      const Point_3 place = frame.box.place(
          {wrapped[0] + kind % 3 - 1, wrapped[1] + kind / 3 % 3 - 1, wrapped[2] + kind / 9 - 1});
      table << "0," << id++ << ',' << number_text(place[0]) << ',' << number_text(place[1]) << ','
            << number_text(place[2]) << '\n';
    }
  }
  Rows rows = cells_of({write_file("images.csv", table.str())});
  for (auto row = rows.begin(); row != rows.end();) {
    const bool is_image = std::stoul(row->first.second) > frame.fractions.size();
    row = is_image ? rows.erase(row) : std::next(row);
  }
  return rows;
}

// RUNS -------------------------------------------------------------------------------------------

TEST(Run_in_periodic_space, reports_what_it_did)
{
  const Json report = report_of({"brownian_periodic_3", "--frames", "10", "--points", "300"});
  EXPECT_EQ(report["scenario"], "brownian_periodic_3");
  EXPECT_EQ(report["dimension"], 3);
  EXPECT_EQ(report["cell"], "torus");
  EXPECT_EQ(report["points"], 300);
  EXPECT_EQ(report["certified_frames"], 10);
  EXPECT_EQ(report["valid_frames"], 10);
  EXPECT_EQ(report["rebuilds"], 0);
  EXPECT_GT(report["flips_mean"], 0.0);
  EXPECT_GT(report["speedup_vs_fastest"], 0.0);
  EXPECT_GE(report["static_insert_ns_per_point"], report["static_fastest_ns_per_point"]);
  EXPECT_TRUE(report_of({"brownian_3", "--frames", "1", "--points", "9"})["cell"].is_null());
  const Outcome outcome = run_program({"brownian_periodic_3", "--frames", "2", "--points", "9"});
  EXPECT_TRUE(contains(outcome.output, "torus")) << outcome.output;
}

TEST(Run_in_periodic_space, lets_a_policy_choose_rebuilds)
{
  const auto rebuilds = [](const std::string& policy) {
    const auto report =
        report_of({"brownian_periodic_3", "--points", "200", "--frames", "6", "--policy", policy});
    EXPECT_EQ(report["policy"], policy.substr(0, policy.find(':')));
    return report["rebuilds"].get<int>();
  };
  EXPECT_EQ(rebuilds("always_static"), 6);
  EXPECT_EQ(rebuilds("key_frames:3"), 2);
  EXPECT_EQ(rebuilds("always_dynamic"), 0);
  const Outcome outcome = run_program({"brownian_periodic_3", "--policy", "hybrid"});
  EXPECT_FALSE(outcome.succeeded);
  EXPECT_TRUE(contains(outcome.errors, "--policy hybrid: is for the plane")) << outcome.errors;
}

TEST(Run_in_periodic_space, takes_threads_and_seed)
{
  const Rows one = cells_of(
      {"brownian_periodic_3", "--frames", "3", "--points", "100", "--seed", "5", "--threads", "1"});
  const Rows two = cells_of(
      {"brownian_periodic_3", "--frames", "3", "--points", "100", "--seed", "5", "--threads", "2"});
  expect_same(one, two);
}

TEST(Run_in_periodic_space, keeps_a_cell_for_each_frame)
{
  const std::vector<Frame> frames = sheared_frames(14, 60);
  const std::string dump = write_file("sheared.lammpstrj", dump_of(frames, "x y z"));
  const Json report = report_of({dump});
  EXPECT_EQ(report["cell"], "torus");
  EXPECT_EQ(report["points"], 60);
  EXPECT_EQ(report["certified_frames"], 13);
  EXPECT_EQ(report["valid_frames"], 13);
  EXPECT_EQ(report["population_changes"], 0);
  const Rows rows = cells_of({dump});
  ASSERT_EQ(rows.size(), 14u * 60u);
  const auto volumes = volumes_by_frame(rows);
  for (std::size_t frame = 0; frame != frames.size(); ++frame) {
    EXPECT_NEAR(volumes.at(std::to_string(100 * frame)), frames[frame].box.volume(), 1e-9);
  }
}

TEST(Run_in_periodic_space, reads_coordinates_of_all_styles)
{
  const std::vector<Frame> frames = sheared_frames(6, 40);
  const Rows rows = cells_of({write_file("d.dump", dump_of(frames, "x y z"))});
  for (const char* const columns :
       {"x y z ix iy iz", "xu yu zu", "xs ys zs", "xs ys zs ix iy iz", "xsu ysu zsu"}) {
    SCOPED_TRACE(columns);
    expect_same(cells_of({write_file("d.dump", dump_of(frames, columns))}), rows);
  }
  Rows by_number; // XYZ has neither time steps nor ids here
  for (const auto& [key, row] : rows) {
    by_number[{std::to_string(std::stoi(key.first) / 100),
               std::to_string(std::stoi(key.second) - 1)}] = row;
  }
  expect_same(cells_of({write_file("d.xyz", xyz_of(frames))}), by_number);
}

TEST(Run_in_periodic_space, has_the_cells_that_images_have)
{
  for (Frame frame : sheared_frames(2, 70)) {
    for (Point_3& p : frame.fractions) {
      p[1] *= 0.8; // not even
    }
    expect_same(cells_of({write_file("one.dump", dump_of({frame}, "xu yu zu"))}),
                cells_among_images(frame));
  }
}

TEST(Run_in_periodic_space, has_neighbors_in_crystals)
{
  std::vector<Point_3> simple, face_centered;
  for (int i = 0; i != 27; ++i) {
    const Point_3 p = {i % 3 / 3.0, i / 3 % 3 / 3.0, i / 9 / 3.0};
    simple.push_back(p);
    face_centered.insert(face_centered.end(), {p,
                                               {p[0] + 1 / 6.0, p[1] + 1 / 6.0, p[2]},
                                               {p[0] + 1 / 6.0, p[1], p[2] + 1 / 6.0},
                                               {p[0], p[1] + 1 / 6.0, p[2] + 1 / 6.0}});
  }
  const auto contacts = [](const std::vector<Point_3>& fractions) {
    std::map<int, int> numbers;
    for (const auto& [key, row] :
         cells_of({write_file("crystal.dump", dump_of({{{{}, {6, 6, 6}}, fractions}}, "x y z"))})) {
      ++numbers[row.contacts];
    }
    return numbers;
  };
  EXPECT_EQ(contacts(simple), (std::map<int, int>{{6, 27}}));
  EXPECT_EQ(contacts(face_centered), (std::map<int, int>{{12, 108}}));
}

TEST(Run_in_periodic_space, takes_few_points)
{
  const Box box{{}, {3, 4, 5}, 1, 0.5, -1};
  for (const std::size_t number : {1, 2, 3, 4, 5, 9}) {
    std::vector<Frame> frames = sheared_frames(5, number);
    EXPECT_EQ(report_of({write_file("few.dump", dump_of(frames, "x y z")), "--dimension",
                         "3"})["certified_frames"],
              4)
        << number;
  }
  const Rows rows = cells_of(
      {write_file("one.dump", dump_of({{box, {{0, 0, 0}}}, {box, {{0, 0, 0.5}}}}, "x y z"))});
  ASSERT_EQ(rows.size(), 2u);
  for (const auto& [key, row] : rows) {
    EXPECT_NEAR(row.volume, 60.0, 1e-12);
  }
  const Rows none = cells_of(
      {write_file("none.dump", dump_of({{box, {}}, {box, {{0, 0, 0.5}}}, {box, {}}}, "x y z")),
       "--dimension", "3"});
  EXPECT_EQ(none.size(), 1u);
}

TEST(Run_in_periodic_space, takes_points_that_coincide)
{
  const Box box{{}, {4, 4, 4}};
  const Frame apart{box, {{0.125, 0.125, 0.125}, {0.6, 0.2, 0.3}, {0.3, 0.7, 0.8}}},
      together{box, {{0.125, 0.125, 0.125}, {1.125, -0.875, 0.125}, {0.3, 0.7, 0.8}}};
  const Rows rows =
      cells_of({write_file("twins.dump", dump_of({apart, together, apart}, "xu yu zu"))});
  for (const auto& [frame, volume] : volumes_by_frame(rows)) {
    EXPECT_NEAR(volume, 64.0, 1e-12) << frame;
  }
  EXPECT_NEAR(rows.at({"100", "1"}).volume, rows.at({"100", "2"}).volume, 1e-12);
}

TEST(Run_in_periodic_space, takes_points_that_come_and_go)
{
  const std::vector<Frame> frames = sheared_frames(9, 50);
  std::string text;
  std::vector<std::size_t> sizes = {50, 40, 45, 50, 3, 30, 0, 50, 50};
  for (std::size_t frame = 0; frame != frames.size(); ++frame) {
    Frame some = frames[frame];
    some.fractions.resize(sizes[frame]);
    std::string dump = dump_of({some}, "xu yu zu");
    text += dump.replace(15, 1, std::to_string(frame));
  }
  const std::string path = write_file("population.dump", text);
  const Json report = report_of({path});
  EXPECT_EQ(report["certified_frames"], 8);
  EXPECT_EQ(report["population_changes"], 7);
  const auto volumes = volumes_by_frame(cells_of({path}));
  for (std::size_t frame = 0; frame != frames.size(); ++frame) {
    if (sizes[frame] != 0) {
      EXPECT_NEAR(volumes.at(std::to_string(frame)), frames[frame].box.volume(), 1e-9) << frame;
    }
  }
}

TEST(Run_in_periodic_space, takes_a_box_that_shrinks_below_its_content)
{
  std::vector<Frame> frames = sheared_frames(1, 40);
  for (const double length : {9.0, 5.0, 1.0, 0.1, 30.0}) {
    Frame frame = frames.front();
    frame.box.lengths = {length, length, length};
    for (Point_3& p : frame.fractions) { // the places stay as they were
      p = {p[0] * 10 / length, p[1] * 9 / length, p[2] * 8 / length};
    }
    frame.box.xy = frame.box.xz = frame.box.yz = 0.0;
    frames.push_back(frame);
  }
  const std::string path = write_file("shrinking.dump", dump_of(frames, "xu yu zu"));
  EXPECT_EQ(report_of({path})["certified_frames"], 5);
  const auto volumes = volumes_by_frame(cells_of({path}));
  for (std::size_t i = 0; i != frames.size(); ++i) {
    EXPECT_NEAR(volumes.at(std::to_string(100 * i)) / frames[i].box.volume(), 1.0, 1e-9);
  }
}

TEST(Run_in_periodic_space, is_in_the_plane_too)
{
  const std::string path = write_file(
      "d.dump", dump_of({{{{}, {4, 4, 4}}, {{0, 0, 0}, {0.5, 0.2, 0.4}, {0.2, 0.6, 0.9}}},
                         {{{}, {4, 4, 4}}, {{0, 0, 0}, {0.5, 0.3, 0.4}, {0.2, 0.6, 0.8}}}},
                        "x y z"));
  const Json report = report_of({path, "--dimension", "2"});
  EXPECT_FALSE(report.contains("dimension"));
  EXPECT_EQ(report["cell"], "torus");
  expect_exact_report(report, 1);
}

// BOXES ------------------------------------------------------------------------------------------

// Bounds are those of the box that encloses the tilted one.
TEST(Box_in_space, is_read_as_lammps_means_it)
{
  const std::string head = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ",
                    atoms = "ITEM: ATOMS id xs ys zs\n1 0.25 0.5 0.75\n";
  const std::string tilted = "xy xz yz pp pp pp\n0 13 2\n0 13 1\n0 10 3\n",
                    leaning = "xy xz yz pp pp pp\n-3 12 -2\n1 12 -1\n0 10 -1\n",
                    vectors = "abc origin pp pp pp\n10 0 0 -1\n2 10 1 0\n1 3 10 5\n";
  const auto read = [&](const std::string& box) {
    const scenario::Recorded_frame frame =
        scenario::parse_lammps_dump("file", head + box + atoms).front();
    return std::pair(*frame.box, Point_3{frame.points[0].x, frame.points[0].y, frame.heights[0]});
  };
  const std::array<bool, 3> all = {true, true, true};
  EXPECT_EQ(read(tilted),
            std::pair(Cell_3({{0, 0, 0}, {{{10, 0, 0}, {2, 10, 0}, {1, 3, 10}}}, all}),
                      Point_3({4.25, 7.25, 7.5})));
  EXPECT_EQ(read(leaning),
            std::pair(Cell_3({{0, 2, 0}, {{{12, 0, 0}, {-2, 10, 0}, {-1, -1, 10}}}, all}),
                      Point_3({1.25, 6.25, 7.5})));
  EXPECT_EQ(read(vectors),
            std::pair(Cell_3({{-1, 0, 5}, {{{10, 0, 0}, {2, 10, 1}, {1, 3, 10}}}, all}),
                      Point_3({3.25, 7.25, 13.0})));
}

// REFUSALS ---------------------------------------------------------------------------------------

std::string errors_of(const std::string& name, const std::string& text, const Words& words = {})
{
  const std::string path = write_file(name, text);
  const Outcome outcome = run_program(with({path}, words));
  EXPECT_FALSE(outcome.succeeded) << outcome.output;
  const auto place = outcome.errors.find(path);
  return place == outcome.errors.npos ? outcome.errors : outcome.errors.substr(place + path.size());
}

std::string dump_with_box(const std::string& boundaries, const std::string& bounds)
{
  return "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS " + boundaries + '\n' +
         bounds + "\nITEM: ATOMS id x y z\n1 1 2 3\n2 2 1 1\n";
}

TEST(Refused_in_periodic_space, are_boxes_whose_only_periodic_side_is_0)
{
  EXPECT_EQ(errors_of("no_lattice.xyz", "2\npbc=\"F F T\"\nX 1 2 3\nX 1 2 4\n"),
            ": is in space, and has the frame 0, whose box is periodic along its third side, whose "
            "length is 0; --dimension 2 takes x and y alone\n");
}

TEST(Refused_in_periodic_space, are_boxes_without_a_volume)
{
  EXPECT_EQ(errors_of("flat.dump", dump_with_box("pp pp pp", "0 8\n0 8\n4 4")),
            ", line 8: the box is periodic here, so its upper bound '4' has to be above its lower "
            "bound '4'; --dimension 2 takes x and y alone\n");
  EXPECT_TRUE(contains(errors_of("turned.dump", dump_with_box("pp pp pp", "0 8\n0 8\n9 4")),
                       "line 8: the box is periodic here"));
  run_quietly(
      {write_file("flat.dump", dump_with_box("pp pp pp", "0 8\n0 8\n4 4")), "--dimension", "2"});
  EXPECT_TRUE(contains(
      errors_of("abc.dump", dump_with_box("abc origin pp pp pp", "8 0 1 0\n0 8 1 0\n8 8 2 0")),
      "is in space, and has the frame 7, whose box has no volume"));
  EXPECT_TRUE(
      contains(errors_of("long.dump", dump_with_box("pp pp pp", "0 8\n0 8\n-1.7e308 1.7e308")),
               "too long for a number"));
  EXPECT_TRUE(
      contains(errors_of("needle.dump", dump_with_box("abc origin pp pp pp",
                                                      "1e150 0 0 0\n0 1e-150 0 0\n0 0 1 0")),
               "frame 7: a periodic cell has the vectors"));
}

TEST(Refused_in_periodic_space, are_sections_that_the_plane_cannot_have)
{
  const std::string text = "2\nLattice=\"4 0 0 0 0 4 0 4 0\"\nX 1 2 3\nX 1 1 1\n";
  EXPECT_EQ(report_of({write_file("turned.xyz", text)})["cell"], "torus");
  EXPECT_EQ(errors_of("turned.xyz", text, {"--dimension", "2"}),
            ", line 2: the box is periodic along its second side, whose length is 0\n");
}

TEST(Refused_in_periodic_space, are_points_that_are_far_away)
{
  EXPECT_TRUE(
      contains(errors_of("far.dump", "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX "
                                     "BOUNDS pp pp pp\n0 1\n0 1\n0 1\nITEM: ATOMS id xu yu "
                                     "zu\n1 1 2 3\n2 2e7 1 1\n"),
               "frame 7: point 1 has the coordinates"));
  EXPECT_TRUE(contains(errors_of("nan.dump",
                                 "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX "
                                 "BOUNDS pp pp pp\n0 1\n0 1\n0 1\nITEM: ATOMS id x y "
                                 "z\n1 1 2 3\n2 2 1 nan\n",
                                 {"--dimension", "3"}),
                       "z of id 2 in frame 7 is no finite number"));
}

// OUTPUT -----------------------------------------------------------------------------------------

TEST(Files_in_periodic_space, are_read_as_the_same_motion)
{
  const std::string given = write_file("given.dump", dump_of(sheared_frames(7, 30), "xu yu zu")),
                    xyz = temporary_path("again.xyz"), dump = temporary_path("again.lammpstrj");
  run_quietly({given, "--xyz", xyz, "--lammps", dump});
  const Recording by_given = scenario::read_recording(given);
  ASSERT_EQ(by_given.size(), 7u);
  for (const std::string& path : {xyz, dump}) {
    const Recording again = scenario::read_recording(path);
    expect_equal_recordings(again, by_given);
    for (std::size_t i = 0; i != by_given.size(); ++i) {
      EXPECT_EQ(again[i].heights, by_given[i].heights);
      ASSERT_TRUE(again[i].box.has_value());
      EXPECT_EQ(*again[i].box, *by_given[i].box);
    }
  }
  EXPECT_TRUE(contains(content_of(dump), "ITEM: BOX BOUNDS xy xz yz pp pp pp"));
}

TEST(Files_in_periodic_space, have_boxes_of_any_vectors)
{
  const std::string given = write_file(
      "given.xyz", "2\nLattice=\"4 1 0.3 -1 5 0.7 0.1 -2 6\" Origin=\"1 2 3\"\nX 1 2 3\nX 2 1 1\n");
  const std::string dump = temporary_path("vectors.lammpstrj");
  run_quietly({given, "--lammps", dump});
  EXPECT_TRUE(contains(content_of(dump), "ITEM: BOX BOUNDS abc origin pp pp pp\n4 1 0.3 1\n"
                                         "-1 5 0.7 2\n0.1 -2 6 3\n"));
  EXPECT_EQ(*scenario::read_recording(dump)[0].box, *scenario::read_recording(given)[0].box);
}

using Grid = boost::property_tree::ptree;

std::vector<double> array_of(const Grid& grid, const std::string& part, const std::string& name)
{
  std::vector<double> numbers;
  for (const auto& [key, array] : grid.get_child("VTKFile.UnstructuredGrid." + part)) {
    if (key == "DataArray" && array.get<std::string>("<xmlattr>.Name") == name) {
      std::istringstream text(array.get_value<std::string>());
      for (double number{}; text >> number;) {
        numbers.push_back(number);
      }
    }
  }
  return numbers;
}

TEST(Files_in_periodic_space, have_tetrahedra_that_fill_the_cell)
{
  const std::string folder = temporary_path("vtk");
  for (const std::size_t particles : {1, 20}) {
    const std::vector<Frame> frames = sheared_frames(2, particles);
    run_quietly(
        {write_file("d.dump", dump_of(frames, "x y z")), "--vtk", folder, "--dimension", "3"});
    Grid grid;
    boost::property_tree::read_xml((std::filesystem::path(folder) / "frame_00100.vtu").string(),
                                   grid);
    const std::vector<double> points = array_of(grid, "Piece.Points", "Points"),
                              corners = array_of(grid, "Piece.Cells", "connectivity"),
                              images = array_of(grid, "Piece.PointData", "image"),
                              sides = array_of(grid, "FieldData", "CellSides");
    EXPECT_EQ(std::count(images.begin(), images.end(), 0.0), std::ptrdiff_t(particles));
    EXPECT_EQ(array_of(grid, "Piece.PointData", "id").size(), images.size());
    EXPECT_EQ(sides.size(), 9u);
    EXPECT_EQ(array_of(grid, "FieldData", "CellIsPeriodic"), (std::vector<double>{1, 1, 1}));
    double volume = 0.0;
    for (std::size_t cell = 0; cell != corners.size() / 4; ++cell) {
      Cell_3 parallelepiped{};
      const auto corner = [&](std::size_t i, std::size_t axis) {
        return points[3 * static_cast<std::size_t>(corners[4 * cell + i]) + axis];
      };
      for (std::size_t i = 0; i != 9; ++i) {
        parallelepiped.sides[i / 3][i % 3] = corner(i / 3 + 1, i % 3) - corner(0, i % 3);
      }
      EXPECT_GT(parallelepiped.volume(), -1e-9);
      volume += parallelepiped.volume() / 6.0;
    }
    EXPECT_NEAR(volume, frames[1].box.volume(), 1e-9);
  }
}

TEST(Files_in_periodic_space, have_a_row_for_each_frame)
{
  const std::string path = temporary_path("frames.csv");
  run_quietly({"brownian_periodic_3", "--frames", "5", "--points", "50", "--csv", path});
  EXPECT_EQ(number_of_lines(content_of(path)), 6u);
}

// SCENARIOS --------------------------------------------------------------------------------------

TEST(Scenario_in_periodic_space, wraps_its_points)
{
  const std::string text =
      R"({"dimension": 3, "name": "b", "kind": "brownian", "seed": 1, "frames": 9, "time_step": 2,
          "points": 20, "box": [1, 2, 3], "cell": "periodic"})";
  const scenario::Opened_motion motion =
      scenario::open_any_motion(write_file("b.json", text), {}, {}, std::nullopt);
  ASSERT_TRUE(motion.in_space);
  EXPECT_FALSE(motion.in_space->box());
  for (int frame = 0; frame != 20; ++frame) {
    motion.in_space->advance({});
    const Cell_3 cell = *motion.in_space->cell();
    EXPECT_EQ(cell.volume(), 6.0);
    EXPECT_EQ(cell.number_of_periodic_sides(), 3);
    for (const Point_3& point : motion.in_space->points()) {
      for (std::size_t axis = 0; axis != 3; ++axis) {
        EXPECT_TRUE(point[axis] >= 0.0 && point[axis] <= cell.sides[axis][axis]);
      }
    }
  }
  EXPECT_THROW(scenario::parse_scenario_3(
                   "file", std::string(text).replace(text.find("periodic"), 8, "channel")),
               scenario::Scenario_error);
}

} // namespace
