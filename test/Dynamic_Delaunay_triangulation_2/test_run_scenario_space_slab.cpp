// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The program run_scenario where points move in a slab in space: dumps and XYZ files as simulations
// of films, membranes and of what is between walls write them, and what it writes itself. And where
// they move in a wire.

#include "scenario_program.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Open_motion.h"
#include "scenario_runner/Simulated_motion.h"
#include "scenario_runner/space/Motion_3.h"
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
#include <iterator>
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

// A frame: a box, of which two sides are periodic, and places.
struct Frame
{
  Cell_3 box;
  std::vector<Point_3> points;
};

std::string text_of(const Point_3& p)
{
  return number_text(p[0]) + ' ' + number_text(p[1]) + ' ' + number_text(p[2]);
}

std::string rows_of_atoms(const std::vector<Point_3>& points)
{
  std::string rows;
  for (std::size_t i = 0; i != points.size(); ++i) {
    rows += std::to_string(i + 1) + " 1 " + text_of(points[i]) + '\n';
  }
  return rows;
}

// A frame of a dump whose box is given by its three lines.
std::string dump_with_box(std::size_t step, const std::string& boundaries,
                          const std::string& bounds, const std::vector<Point_3>& points,
                          const std::string& columns = "x y z")
{
  return "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF ATOMS\n" +
         std::to_string(points.size()) + "\nITEM: BOX BOUNDS " + boundaries + '\n' + bounds +
         "\nITEM: ATOMS id type " + columns + '\n' + rows_of_atoms(points);
}

// `dump custom` of a box whose tilt is xy alone, the only one that LAMMPS allows in a slab along x
// and y.
std::string dump_of(const std::vector<Frame>& frames, const std::string& free = "ff")
{
  std::string text;
  for (std::size_t i = 0; i != frames.size(); ++i) {
    const auto& [a, b, c] = frames[i].box.sides;
    const Point_3& low = frames[i].box.corner;
    const double xy = b[0];
    text +=
        dump_with_box(100 * i, "xy xz yz pp pp " + free,
                      number_text(low[0] + (std::min)(0.0, xy)) + ' ' +
                          number_text(low[0] + a[0] + (std::max)(0.0, xy)) + ' ' + number_text(xy) +
                          '\n' + number_text(low[1]) + ' ' + number_text(low[1] + b[1]) + " 0\n" +
                          number_text(low[2]) + ' ' + number_text(low[2] + c[2]) + " 0",
                      frames[i].points);
  }
  return text;
}

// As ASE and OVITO write it.
std::string xyz_of(const std::vector<Frame>& frames)
{
  std::string text;
  for (std::size_t i = 0; i != frames.size(); ++i) {
    const Cell_3& box = frames[i].box;
    std::string pbc;
    for (const bool is_periodic : box.is_periodic) {
      pbc += std::string(pbc.empty() ? "" : " ") + (is_periodic ? 'T' : 'F');
    }
    text += std::to_string(frames[i].points.size()) + "\nLattice=\"" + text_of(box.sides[0]) + ' ' +
            text_of(box.sides[1]) + ' ' + text_of(box.sides[2]) + "\" Origin=\"" +
            text_of(box.corner) + "\" Properties=id:I:1:species:S:1:pos:R:3 pbc=\"" + pbc +
            "\" Frame=" + std::to_string(100 * i) + '\n' + rows_of_atoms(frames[i].points);
  }
  return text;
}

// Particles of a film that is sheared along x, is given by other vectors at times, and shrinks;
// they drift out of the box, and are never wrapped.
std::vector<Frame> film(std::size_t number, std::size_t particles, double height = 4.0)
{
  scenario::Random_source random(3);
  std::vector<Point_3> fractions;
  for (std::size_t i = 0; i != particles; ++i) {
    fractions.push_back({random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)});
  }
  std::vector<Frame> frames;
  double xy = 1.5;
  for (std::size_t frame = 0; frame != number; ++frame) {
    const double length = 10.0 - 0.01 * static_cast<double>(frame);
    const Cell_3 box{
        {-3, 2, 1}, {{{length, 0, 0}, {xy, 9, 0}, {0, 0, height}}}, {true, true, false}};
    std::vector<Point_3> points;
    for (const Point_3& p : fractions) {
      points.push_back({-3 + p[0] * length + p[1] * xy, 2 + p[1] * 9, 1 + p[2] * height});
    }
    frames.push_back({box, points});
    const double flip = xy + 0.7 > length / 2 ? 1.0 : 0.0;
    xy += 0.7 - flip * length;
    for (Point_3& p : fractions) {
      p[0] += flip * p[1] + 0.003 * random.gaussian() + 0.05;
      p[1] += 0.003 * random.gaussian();
      p[2] += 0.003 * random.gaussian();
    }
  }
  return frames;
}

// The frames with other names for the axes, and the sides in the same order as their axes.
std::vector<Frame> turned(std::vector<Frame> frames, const std::array<std::size_t, 3>& axes)
{
  for (auto& [box, points] : frames) {
    const auto turn = [&axes](const Point_3& p) {
      return Point_3{p[axes[0]], p[axes[1]], p[axes[2]]};
    };
    const Cell_3 before = box;
    box.corner = turn(before.corner);
    for (std::size_t i = 0; i != 3; ++i) {
      box.sides[i] = turn(before.sides[axes[i]]);
      box.is_periodic[i] = before.is_periodic[axes[i]];
    }
    std::transform(points.begin(), points.end(), points.begin(), turn);
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

Rows cells_of(const Words& arguments)
{
  const std::string path = temporary_path("cells.csv");
  run_quietly(with(arguments, {"--cells", path}));
  std::istringstream lines(content_of(path));
  std::string line;
  std::getline(lines, line);
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

void expect_same(const Rows& rows, const Rows& others)
{
  ASSERT_EQ(rows.size(), others.size());
  for (const auto& [key, row] : rows) {
    SCOPED_TRACE(key.first + ' ' + key.second);
    const Row& other = others.at(key);
    if (std::isinf(row.volume)) {
      EXPECT_EQ(row.volume, other.volume);
      EXPECT_EQ(row.surface_area, other.surface_area);
    } else {
      EXPECT_NEAR(row.volume, other.volume, 1e-9 * row.volume);
      EXPECT_NEAR(row.surface_area, other.surface_area, 1e-9 * row.surface_area);
    }
    EXPECT_EQ(row.contacts, other.contacts);
  }
}

// Of the points themselves, in open space among their images in nine times nine boxes, or, of a
// wire, in 81 of them.
Rows cells_among_images(const Frame& frame)
{
  std::ostringstream table;
  table << "frame,id,x,y,z\n";
  std::size_t id = 1;
  for (int image = 0; image != 81; ++image) {
    const int kind = (image + 40) % 81; // the points themselves first
    for (const Point_3& p : frame.points) {
      const Point_3 place = frame.box.image(
          p, frame.box.is_wire() ? scenario::Shift_3{kind - 40, 0, 0}
                                 : scenario::Shift_3{kind % 9 - 4, kind / 9 - 4, 0});
      table << "0," << id++ << ',' << number_text(place[0]) << ',' << number_text(place[1]) << ','
            << number_text(place[2]) << '\n';
    }
  }
  Rows rows = cells_of({write_file("images.csv", table.str())});
  for (auto row = rows.begin(); row != rows.end();) {
    const bool is_image = std::stoul(row->first.second) > frame.points.size();
    row = is_image ? rows.erase(row) : std::next(row);
  }
  return rows;
}

// RUNS -------------------------------------------------------------------------------------------

// Of a scenario in a cell of this kind.
void expect_reports(const std::string& scenario, const std::string& cell)
{
  const Json report = report_of({scenario, "--frames", "10", "--points", "300"});
  EXPECT_EQ(report["scenario"], scenario);
  EXPECT_EQ(report["dimension"], 3);
  EXPECT_EQ(report["cell"], cell);
  EXPECT_EQ(report["points"], 300);
  EXPECT_EQ(report["certified_frames"], 10);
  EXPECT_EQ(report["valid_frames"], 10);
  EXPECT_GT(report["flips_mean"], 0.0);
  EXPECT_GE(report["static_insert_ns_per_point"], report["static_fastest_ns_per_point"]);
  EXPECT_GT(report["static_fastest_ns_per_point"], 0.0);
  const Outcome outcome = run_program({scenario, "--frames", "2", "--points", "9"});
  EXPECT_TRUE(outcome.succeeded) << outcome.errors;
  EXPECT_TRUE(contains(outcome.output, cell)) << outcome.output;
  EXPECT_TRUE(contains(outcome.output, "its own triangulation made anew")) << outcome.output;
}

TEST(Run_in_slab, reports_what_it_did)
{
  expect_reports("brownian_slab_3", "slab");
}

TEST(Run_in_wire, reports_what_it_did)
{
  expect_reports("brownian_wire_3", "wire");
}

TEST(Run_in_slab, takes_all_boundaries_of_lammps)
{
  const std::vector<Frame> frames = film(4, 40);
  const Rows rows = cells_of({write_file("film.dump", dump_of(frames, "ff"))});
  ASSERT_EQ(rows.size(), 160u);
  for (const char* const free : {"fs", "ss", "mm", "sm"}) {
    SCOPED_TRACE(free);
    const std::string path = write_file("film.dump", dump_of(frames, free));
    const Json report = report_of({path});
    EXPECT_EQ(report["cell"], "slab");
    EXPECT_EQ(report["certified_frames"], 3);
    EXPECT_EQ(report["valid_frames"], 3);
    expect_same(cells_of({path}), rows);
  }
}

TEST(Run_in_slab, has_the_cells_that_images_have)
{
  for (const Frame& frame : film(1, 80)) {
    const Rows rows = cells_of({write_file("one.dump", dump_of({frame}))});
    const Rows expected = cells_among_images(frame);
    std::size_t unbounded = 0, compared = 0;
    for (const auto& [key, row] : rows) {
      SCOPED_TRACE(key.second);
      unbounded += std::isinf(row.volume) ? 1 : 0;
      // Those that reach far out of the layer have neighbors farther away than the images.
      if (std::isfinite(row.volume) && row.volume < 100.0) {
        const Row& other = expected.at(key);
        EXPECT_NEAR(row.volume, other.volume, 1e-9 * row.volume);
        EXPECT_NEAR(row.surface_area, other.surface_area, 1e-9 * row.surface_area);
        EXPECT_EQ(row.contacts, other.contacts);
        ++compared;
      }
    }
    EXPECT_GT(compared, 60u);
    EXPECT_EQ(unbounded, 2u); // above the highest point, and below the lowest one
  }
}

TEST(Run_in_slab, may_be_open_across_any_two_sides)
{
  const std::vector<Frame> frames = film(4, 40);
  const Rows rows = cells_of({write_file("film.dump", dump_of(frames))});
  expect_same(cells_of({write_file("film.xyz", xyz_of(frames))}), rows);
  const std::vector<std::array<std::size_t, 3>> orders = {
      {2, 0, 1}, {1, 2, 0}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (const auto& axes : orders) {
    SCOPED_TRACE(axes[0]);
    SCOPED_TRACE(axes[1]);
    const std::string path = write_file("turned.xyz", xyz_of(turned(frames, axes)));
    const Json report = report_of({path});
    EXPECT_EQ(report["cell"], "slab");
    EXPECT_EQ(report["certified_frames"], 3);
    expect_same(cells_of({path}), rows);
  }
}

TEST(Run_in_slab, takes_bounds_that_are_open_along_x_or_y)
{
  const std::vector<Point_3> points = {{1, 2, 3}, {5, 1, 6}, {2, 7, 2}, {6, 6, 6}, {4, 3, 1}};
  const auto rows_with = [](const std::string& boundaries, const std::string& bounds,
                            std::vector<Point_3> places, const std::array<std::size_t, 3>& axes) {
    for (Point_3& p : places) {
      p = {p[axes[0]], p[axes[1]], p[axes[2]]};
    }
    return cells_of({write_file("d.dump", dump_with_box(0, boundaries, bounds, places))});
  };
  const Rows rows = rows_with("pp pp ff", "0 8\n0 9\n0 7", points, {0, 1, 2});
  expect_same(rows_with("ff pp pp", "0 7\n0 8\n0 9", points, {2, 0, 1}), rows);
  expect_same(rows_with("pp fs pp", "0 9\n-5 70\n0 8", points, {1, 2, 0}), rows);
  // tilted: the vectors are (2, 8, 0) and (1, 3, 9)
  const Rows tilted = cells_of({write_file(
      "d.dump", dump_with_box(0, "xy xz yz ff pp pp", "0 10 2\n0 11 1\n0 9 3", points))});
  const Rows vectors = cells_of({write_file(
      "d.dump", dump_with_box(0, "abc origin pp pp ff", "2 8 0 0\n1 3 9 0\n0 0 0 0", points))});
  expect_same(tilted, vectors);
}

TEST(Run_in_slab, reads_fractions_of_a_tilted_box)
{
  const std::string bounds = "-1 11.5 1.5\n0 9 0\n2 6 0", boundaries = "xy xz yz pp pp ss";
  const std::vector<Point_3> fractions = {{0.25, 0.5, 0.125}, {0.5, 0.25, 0.75}, {0.75, 0, 0.5}};
  std::vector<Point_3> places;
  for (const Point_3& p : fractions) {
    places.push_back({-1 + 11 * p[0] + 1.5 * p[1], 9 * p[1], 2 + 4 * p[2]});
  }
  expect_same(
      cells_of({write_file("s.dump", dump_with_box(0, boundaries, bounds, fractions, "xs ys zs"))}),
      cells_of({write_file("x.dump", dump_with_box(0, boundaries, bounds, places))}));
}

TEST(Run_in_slab, takes_few_points_and_layers)
{
  const std::size_t two = 2; // the highest point and the lowest one
  for (const std::size_t number : {0, 1, 2, 3, 4, 7}) {
    SCOPED_TRACE(number);
    for (const double height : {0.0, 4.0, 50.0}) {
      const std::string path = write_file("few.dump", dump_of(film(5, number, height)));
      EXPECT_EQ(report_of({path, "--dimension", "3"})["certified_frames"], 4);
      const Rows rows = cells_of({path, "--dimension", "3"});
      EXPECT_EQ(rows.size(), 5 * number);
      const auto unbounded = std::count_if(rows.begin(), rows.end(), [](const auto& keyed) {
        return std::isinf(keyed.second.volume);
      });
      EXPECT_EQ(std::size_t(unbounded), 5 * (height == 0.0 ? number : (std::min)(number, two)));
    }
  }
  // all points of a square layer have four neighbors in it
  std::vector<Point_3> layer;
  for (int i = 0; i != 16; ++i) {
    layer.push_back({double(i % 4), double(i / 4), 5});
  }
  for (const auto& [key, row] :
       cells_of({write_file("layer.dump", dump_with_box(0, "pp pp ff", "0 4\n0 4\n5 5", layer)),
                 "--dimension", "3"})) {
    EXPECT_EQ(row.contacts, 4) << key.second;
    EXPECT_TRUE(std::isinf(row.volume));
  }
}

TEST(Run_in_slab, takes_points_that_come_and_go)
{
  std::vector<Frame> frames = film(9, 50);
  const std::vector<std::size_t> sizes = {50, 40, 45, 50, 3, 30, 0, 50, 50};
  for (std::size_t i = 0; i != frames.size(); ++i) {
    frames[i].points.resize(sizes[i]);
  }
  const std::string path = write_file("population.xyz", xyz_of(frames));
  const Json report = report_of({path});
  EXPECT_EQ(report["certified_frames"], 8);
  EXPECT_EQ(report["population_changes"], 7);
  const Rows rows = cells_of({path});
  for (std::size_t i = 0; i != frames.size(); ++i) {
    if (!frames[i].points.empty()) {
      const Rows alone =
          cells_of({write_file("alone.xyz", xyz_of({frames[i]})), "--dimension", "3"});
      for (const auto& [key, row] : alone) {
        const Row& other = rows.at({std::to_string(100 * i), key.second});
        EXPECT_EQ(row.contacts, other.contacts);
      }
    }
  }
}

TEST(Run_in_slab, takes_a_lattice_of_two_vectors)
{
  const std::string path = write_file("ase.xyz", "3\nLattice=\"4 0 0 1 5 0 0 0 0\" pbc=\"T T F\"\n"
                                                 "C 1 2 3\nC 2 1 1\nC 3 3 9\n");
  EXPECT_EQ(report_of({path})["cell"], "slab");
  const std::string dump = temporary_path("again.dump");
  run_quietly({path, "--lammps", dump});
  EXPECT_EQ(*scenario::read_recording(dump)[0].box, *scenario::read_recording(path)[0].box);
}

TEST(Run_in_slab, lets_a_policy_choose_rebuilds)
{
  for (const char* const scenario : {"brownian_slab_3", "brownian_wire_3"}) {
    const auto rebuilds = [scenario](const std::string& policy) {
      return report_of(
                 {scenario, "--points", "200", "--frames", "6", "--policy", policy})["rebuilds"]
          .get<int>();
    };
    EXPECT_EQ(rebuilds("always_static"), 6);
    EXPECT_GE(rebuilds("key_frames:3"), 2);
  }
}

TEST(Run_in_slab, is_in_the_plane_too)
{
  const std::string path = write_file("film.dump", dump_of(film(3, 30)));
  const Json report = report_of({path, "--dimension", "2"});
  EXPECT_EQ(report["cell"], "torus");
  expect_exact_report(report, 2);
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

const std::vector<Point_3> two_points = {{1, 2, 3}, {2, 1, 1}};

TEST(Run_in_wire, follows_dumps_and_XYZ_files_along_any_side)
{
  std::vector<Frame> frames = film(4, 40);
  for (Frame& frame : frames) {
    frame.box.is_periodic = {true, false, false};
  }
  const std::string path = write_file("wire.xyz", xyz_of(frames));
  const Json report = report_of({path});
  EXPECT_EQ(report["cell"], "wire");
  EXPECT_EQ(report["certified_frames"], 3);
  EXPECT_EQ(report["valid_frames"], 3);
  const Rows rows = cells_of({path});
  ASSERT_EQ(rows.size(), 160u);
  Rows last;
  for (const auto& [key, row] : rows) {
    if (key.first == "300") {
      last[{"0", key.second}] = row;
    }
  }
  expect_same(last, cells_among_images(frames.back()));
  const std::vector<Frame> upright = turned(frames, {1, 2, 0});
  expect_same(cells_of({write_file("upright_wire.xyz", xyz_of(upright))}), rows);
  for (const char* const boundaries : {"pp ff ff", "ff pp fs", "ff mm pp"}) {
    EXPECT_EQ(report_of({write_file("wire.dump", dump_with_box(7, boundaries, "0 8\n0 8\n0 8",
                                                               frames[0].points))})["cell"],
              "wire");
  }
  const Outcome outcome = run_program({path});
  EXPECT_TRUE(contains(outcome.output, "CGAL has none of wires")) << outcome.output;
}

TEST(Refused_in_slab, are_frames_of_different_kinds)
{
  const std::string bounds = "0 8\n0 8\n0 8";
  const auto both = [&](const std::string& first, const std::string& second) {
    return errors_of("mixed.dump", dump_with_box(7, first, bounds, two_points) +
                                       dump_with_box(8, second, bounds, two_points));
  };
  EXPECT_EQ(both("pp pp pp", "pp pp ff"),
            ": is in space, and the boxes of its frames are periodic along different sides, that "
            "of the frame 8 along its first and its second side; --dimension 2 takes x and y "
            "alone\n");
  EXPECT_TRUE(contains(both("pp ff pp", "ff pp pp"), "different sides, that of the frame 8 along "
                                                     "its second and its third side"));
  EXPECT_TRUE(contains(both("ff ff ff", "pp pp ff"), "the box is periodic in x and y, that of the "
                                                     "frame before is open"));
}

TEST(Refused_in_slab, are_sides_that_are_parallel)
{
  EXPECT_EQ(errors_of("parallel.dump", dump_with_box(7, "abc origin pp ff pp",
                                                     "2 4 6 0\n0 8 0 0\n1 2 3 0", two_points)),
            ": is in space, and has the frame 7, whose box is periodic along its first and its "
            "third side, which are parallel; --dimension 2 takes x and y alone\n");
  EXPECT_EQ(errors_of("parallel.xyz", "2\nLattice=\"4 0 0 8 0 0 0 0 6\" pbc=\"T T F\"\nX 1 2 3\n"
                                      "X 1 1 1\n"),
            ", line 2: the box is periodic along both sides, which are parallel\n");
  EXPECT_TRUE(contains(errors_of("no_lattice.xyz", "2\npbc=\"T T F\"\nX 1 2 3\nX 1 1 1\n"),
                       "has no Lattice"));
  // the plane of x and y is no section of it
  const std::string upright = "2\nLattice=\"4 0 0 0 0 5 0 6 0\" pbc=\"T T F\"\nX 1 2 3\nX 1 1 1\n";
  EXPECT_EQ(report_of({write_file("upright.xyz", upright)})["cell"], "slab");
  EXPECT_EQ(errors_of("upright.xyz", upright, {"--dimension", "2"}),
            ", line 2: the box is periodic along its second side, whose length is 0\n");
}

TEST(Refused_in_slab, are_bounds_that_are_turned_where_they_are_periodic)
{
  EXPECT_EQ(errors_of("turned.dump", dump_with_box(7, "ff pp pp", "0 8\n0 8\n9 4", two_points)),
            ", line 8: the box is periodic here, so its upper bound '4' has to be above its lower "
            "bound '9'; --dimension 2 takes x and y alone\n");
  EXPECT_EQ(report_of({write_file(
                "open.dump", dump_with_box(7, "pp pp ff", "0 8\n0 8\n9 4", two_points))})["cell"],
            "slab");
}

TEST(Refused_in_slab, is_what_is_for_the_plane)
{
  for (const char* const scenario : {"brownian_slab_3", "brownian_wire_3"}) {
    for (const std::string option : {"--html", "--svg"}) {
      const Outcome outcome =
          run_program({scenario, "--points", "20", option, temporary_path("out")});
      EXPECT_FALSE(outcome.succeeded);
      EXPECT_TRUE(
          contains(outcome.errors, option + ": is for the plane, and the motion is in space"))
          << outcome.errors;
    }
  }
}

TEST(Refused_in_slab, are_points_that_are_far_away)
{
  EXPECT_TRUE(contains(errors_of("far.dump", dump_with_box(7, "pp pp ff", "0 1\n0 1\n0 1",
                                                           {{1, 2, 3}, {2e7, 1, 1}})),
                       "frame 7: point 1 has the coordinates"));
}

// OUTPUT -----------------------------------------------------------------------------------------

TEST(Files_in_slab, are_read_as_the_same_motion)
{
  for (const std::array<std::size_t, 3>& axes :
       {std::array<std::size_t, 3>{0, 1, 2}, {2, 0, 1}, {0, 2, 1}}) {
    const std::string given = write_file("given.xyz", xyz_of(turned(film(7, 30), axes))),
                      xyz = temporary_path("again.xyz"), dump = temporary_path("again.dump");
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
  }
  const std::string xyz = temporary_path("b.xyz"), dump = temporary_path("b.dump");
  run_quietly(
      {"brownian_slab_3", "--points", "9", "--frames", "1", "--xyz", xyz, "--lammps", dump});
  EXPECT_TRUE(contains(content_of(dump), "ITEM: BOX BOUNDS pp pp ff\n0 1\n0 1\n0 1\n"));
  EXPECT_TRUE(contains(content_of(xyz), "pbc=\"T T F\""));
  run_quietly(
      {"brownian_wire_3", "--points", "9", "--frames", "1", "--xyz", xyz, "--lammps", dump});
  EXPECT_TRUE(contains(content_of(dump), "ITEM: BOX BOUNDS pp ff ff\n0 1\n0 1\n0 1\n"));
  EXPECT_TRUE(contains(content_of(xyz), "pbc=\"T F F\""));
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

// The tetrahedra of a grid; each must be positively oriented.
double volume_of_tetrahedra(const Grid& grid)
{
  const std::vector<double> points = array_of(grid, "Piece.Points", "Points"),
                            corners = array_of(grid, "Piece.Cells", "connectivity");
  double volume = 0.0;
  for (std::size_t cell = 0; cell != corners.size() / 4; ++cell) {
    const auto corner = [&](std::size_t i, std::size_t axis) {
      return points[3 * static_cast<std::size_t>(corners[4 * cell + i]) + axis];
    };
    Cell_3 parallelepiped{};
    for (std::size_t i = 0; i != 9; ++i) {
      parallelepiped.sides[i / 3][i % 3] = corner(i / 3 + 1, i % 3) - corner(0, i % 3);
    }
    EXPECT_GT(parallelepiped.volume(), -1e-9);
    volume += parallelepiped.volume() / 6.0;
  }
  return volume;
}

// Images by the wrong sides would not fit together.
TEST(Files_in_slab, have_tetrahedra_that_fill_the_layer)
{
  const std::string folder = temporary_path("vtk");
  const std::vector<std::pair<std::array<std::size_t, 3>, std::vector<double>>> kinds = {
      {{0, 1, 2}, {1, 1, 0}}, {{2, 0, 1}, {0, 1, 1}}, {{0, 2, 1}, {1, 0, 1}}};
  for (const auto& [axes, periodic] : kinds) {
    for (const std::size_t particles : {1, 2, 20}) {
      const std::vector<Frame> frames = film(2, particles);
      run_quietly(
          {write_file("d.xyz", xyz_of(turned(frames, axes))), "--vtk", folder, "--dimension", "3"});
      Grid grid;
      boost::property_tree::read_xml((std::filesystem::path(folder) / "frame_00100.vtu").string(),
                                     grid);
      EXPECT_EQ(array_of(grid, "FieldData", "CellIsPeriodic"), periodic);
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (const Point_3& p : frames[1].points) {
        low = (std::min)(low, p[2]);
        high = (std::max)(high, p[2]);
      }
      EXPECT_NEAR(volume_of_tetrahedra(grid), frames[1].box.area_of_slab() * (high - low), 1e-9);
    }
  }
}

TEST(Files_in_slab, have_a_row_for_each_frame)
{
  const std::string path = temporary_path("frames.csv");
  for (const char* const scenario : {"brownian_slab_3", "brownian_wire_3"}) {
    run_quietly({scenario, "--frames", "5", "--points", "50", "--csv", path});
    EXPECT_EQ(number_of_lines(content_of(path)), 6u);
  }
}

// SCENARIOS --------------------------------------------------------------------------------------

// Points have to stay in the cell's box. Returns along which axes some have jumped: reflected ones
// take no longer steps.
std::array<bool, 3> wrapped_axes(const std::string& kind)
{
  const std::string text =
      R"({"dimension": 3, "name": "b", "kind": "brownian", "seed": 1, "frames": 9, "time_step": 0.2,
          "points": 20, "box": [2, 3, 4], "cell": ")" +
      kind + "\"}";
  const scenario::Opened_motion motion =
      scenario::open_any_motion(write_file("b.json", text), {}, {}, std::nullopt);
  EXPECT_TRUE(motion.in_space);
  EXPECT_FALSE(motion.in_space->box());
  const Cell_3 cell = *motion.in_space->cell();
  EXPECT_EQ(cell.kind(), kind);
  std::array<bool, 3> have_jumped{};
  for (int frame = 0; frame != 40; ++frame) {
    const std::vector<Point_3> before = motion.in_space->points();
    motion.in_space->advance({});
    for (std::size_t i = 0; i != before.size(); ++i) {
      for (std::size_t axis = 0; axis != 3; ++axis) {
        const double place = motion.in_space->points()[i][axis], side = cell.sides[axis][axis];
        EXPECT_TRUE(place >= 0.0 && place <= side);
        have_jumped[axis] = have_jumped[axis] || std::abs(place - before[i][axis]) > 0.75 * side;
      }
    }
  }
  EXPECT_EQ(have_jumped, cell.is_periodic);
  return have_jumped;
}

TEST(Scenario_in_slab, wraps_its_points_along_two_axes)
{
  EXPECT_EQ(wrapped_axes("slab"), (std::array<bool, 3>{true, true, false}));
}

TEST(Scenario_in_wire, wraps_its_points_along_one_axis)
{
  EXPECT_EQ(wrapped_axes("wire"), (std::array<bool, 3>{true, false, false}));
}

} // namespace
