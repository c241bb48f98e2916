// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What run_scenario writes for other programs, read back.

#include "scenario_program.h"
#include "scenario_runner/Output_formats.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Scenario_run.h"
#include "scenario_runner/Simulated_motion.h"
#include "temporary_files.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <istream>
#include <limits>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using Xml = boost::property_tree::ptree;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;

// Three ids in the counterclockwise order of the triangle's corners, the smallest first.
using Triangle = std::array<std::int64_t, 3>;
using Triangles = std::multiset<Triangle>;

Triangle triangle(std::int64_t a, std::int64_t b, std::int64_t c)
{
  Triangle ids = {a, b, c};
  std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
  return ids;
}

// The numbers in a text, read strictly and exactly, as readers of recordings do.
template <class Number>
std::vector<Number> numbers(const std::string& text)
{
  std::vector<std::string_view> fields;
  scenario::split_at_blanks(text, fields);
  const scenario::Text_scanner scanner("numbers", "");
  std::vector<Number> values;
  for (const std::string_view field : fields) {
    if constexpr (std::is_floating_point_v<Number>) {
      values.push_back(scanner.number(field, "number"));
    } else {
      values.push_back(scanner.integer(field, "number"));
    }
  }
  return values;
}

struct Grid
{
  std::int64_t number; // of the frame
  double time;
  std::vector<std::int64_t> ids;
  std::vector<std::string> names; // none where ids are numbers
  std::vector<std::int64_t> sets;
  std::vector<std::int64_t> delaunay;
  std::vector<scenario::Point> points;
  Triangles triangles;
};

// The array that has this name among those of an element.
std::string array_of(const Xml& element, const std::string& name)
{
  for (const auto& [tag, child] : element) {
    if (tag == "DataArray" && child.get<std::string>("<xmlattr>.Name") == name) {
      EXPECT_EQ(child.get<std::string>("<xmlattr>.format"), "ascii");
      std::string text = child.data();
      std::replace(text.begin(), text.end(), '\n', ' ');
      return text;
    }
  }
  throw std::runtime_error("there is no array " + name);
}

// The texts of the array `name`, if there is one: each is its bytes as numbers, and a zero.
std::vector<std::string> names_in(const Xml& point_data)
{
  std::vector<std::string> names(1);
  for (const auto& [tag, child] : point_data) {
    if (tag == "DataArray" && child.get<std::string>("<xmlattr>.Name") == "name") {
      EXPECT_EQ(child.get<std::string>("<xmlattr>.type"), "String");
      for (const std::int64_t byte : numbers<std::int64_t>(array_of(point_data, "name"))) {
        if (byte == 0) {
          names.emplace_back();
        } else {
          names.back() += static_cast<char>(byte);
        }
      }
    }
  }
  names.pop_back();
  return names;
}

void read_points(const Xml& piece, Grid& grid)
{
  const auto coordinates = numbers<double>(array_of(piece.get_child("Points"), "Points"));
  ASSERT_EQ(coordinates.size(), 3 * piece.get<std::size_t>("<xmlattr>.NumberOfPoints"));
  for (std::size_t i = 0; i != coordinates.size(); i += 3) {
    grid.points.push_back({coordinates[i], coordinates[i + 1]});
    EXPECT_EQ(coordinates[i + 2], 0.0);
  }
}

void read_triangles(const Xml& piece, Grid& grid)
{
  const Xml& cells = piece.get_child("Cells");
  const auto corners = numbers<std::int64_t>(array_of(cells, "connectivity"));
  const auto offsets = numbers<std::int64_t>(array_of(cells, "offsets"));
  const auto types = numbers<std::int64_t>(array_of(cells, "types"));
  const auto size = piece.get<std::size_t>("<xmlattr>.NumberOfCells");
  ASSERT_EQ(corners.size(), 3 * size);
  ASSERT_EQ(offsets.size(), size);
  EXPECT_EQ(types, std::vector<std::int64_t>(size, 5));
  const auto id = [&](std::size_t i) { return grid.ids.at(static_cast<std::size_t>(corners[i])); };
  for (std::size_t i = 0; i != size; ++i) {
    EXPECT_EQ(offsets[i], static_cast<std::int64_t>(3 * (i + 1)));
    grid.triangles.insert(triangle(id(3 * i), id(3 * i + 1), id(3 * i + 2)));
  }
}

Grid read_grid(std::istream& in)
{
  Xml xml;
  boost::property_tree::read_xml(in, xml); // throws if it is not well-formed
  EXPECT_EQ(xml.get<std::string>("VTKFile.<xmlattr>.type"), "UnstructuredGrid");
  const Xml& whole = xml.get_child("VTKFile.UnstructuredGrid");
  const Xml& piece = whole.get_child("Piece");
  Grid grid;
  grid.number = numbers<std::int64_t>(array_of(whole.get_child("FieldData"), "Frame")).at(0);
  grid.names = names_in(piece.get_child("PointData"));
  grid.time = numbers<double>(array_of(whole.get_child("FieldData"), "TimeValue")).at(0);
  grid.ids = numbers<std::int64_t>(array_of(piece.get_child("PointData"), "id"));
  grid.sets = numbers<std::int64_t>(array_of(piece.get_child("PointData"), "set"));
  grid.delaunay = numbers<std::int64_t>(array_of(piece.get_child("CellData"), "delaunay"));
  read_points(piece, grid);
  EXPECT_EQ(grid.ids.size(), grid.points.size());
  EXPECT_EQ(grid.sets.size(), grid.points.size());
  read_triangles(piece, grid);
  EXPECT_EQ(grid.delaunay.size(), grid.triangles.size());
  return grid;
}

struct Collection
{
  std::vector<double> times;
  std::vector<std::string> files;
  std::vector<Grid> grids;
};

Collection read_collection(const std::filesystem::path& directory)
{
  Xml xml;
  boost::property_tree::read_xml((directory / "frames.pvd").string(), xml);
  EXPECT_EQ(xml.get<std::string>("VTKFile.<xmlattr>.type"), "Collection");
  Collection collection;
  for (const auto& [tag, child] : xml.get_child("VTKFile.Collection")) {
    EXPECT_EQ(tag, "DataSet");
    collection.times.push_back(numbers<double>(child.get<std::string>("<xmlattr>.timestep")).at(0));
    collection.files.push_back(child.get<std::string>("<xmlattr>.file"));
    std::ifstream file(directory / collection.files.back());
    EXPECT_TRUE(file.is_open()) << collection.files.back();
    collection.grids.push_back(read_grid(file));
  }
  EXPECT_EQ(
      std::adjacent_find(collection.times.begin(), collection.times.end(), std::greater_equal<>()),
      collection.times.end())
      << "times do not ascend";
  return collection;
}

// A file whose lines are as other programs expect them, of a motion without a cell: a number of
// points, what stands in a line for each, and a cell that has an area and right angles.
scenario::Recording read_xyz(const std::string& path)
{
  const std::regex size("\\d+"), point("-?\\d+ X \\S+ \\S+ 0 [0-3]");
  const std::regex head("Lattice=\"(?!0 )\\d\\S* 0 0 0 (?!0 )\\d\\S* 0 0 0 1\" "
                        "Origin=\"\\S+ \\S+ \\S+\" pbc=\"F F F\" "
                        "Properties=id:I:1:species:S:1:pos:R:3:set:I:1 Time=\\S+ Frame=-?\\d+");
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    EXPECT_TRUE(std::regex_match(line, size) || std::regex_match(line, head) ||
                std::regex_match(line, point))
        << line;
  }
  return scenario::read_xyz_motion(path);
}

scenario::Recording recording_of(const Collection& collection)
{
  scenario::Recording frames;
  for (const Grid& grid : collection.grids) {
    frames.push_back({grid.time, grid.ids, grid.points, std::nullopt, grid.number});
  }
  return frames;
}

// The Delaunay triangles of the points, by CGAL alone.
Triangles delaunay_triangles(const Grid& grid)
{
  std::map<Kernel::Point_2, std::int64_t> ids;
  Delaunay triangulation;
  for (std::size_t i = 0; i != grid.points.size(); ++i) {
    const Kernel::Point_2 point(grid.points[i].x, grid.points[i].y);
    ids.emplace(point, grid.ids[i]); // the first one, where several are
    triangulation.insert(point);
  }
  Triangles triangles;
  for (const auto face : triangulation.finite_face_handles()) {
    const auto id = [&](int i) { return ids.at(face->vertex(i)->point()); };
    triangles.insert(triangle(id(0), id(1), id(2)));
  }
  return triangles;
}

// For points without ties, which would leave two diagonals right.
void expect_delaunay(const Collection& collection)
{
  for (const Grid& grid : collection.grids) {
    SCOPED_TRACE(grid.time);
    EXPECT_EQ(grid.triangles, delaunay_triangles(grid));
    EXPECT_EQ(std::count(grid.delaunay.begin(), grid.delaunay.end(), 1),
              static_cast<std::ptrdiff_t>(grid.triangles.size()));
  }
}

// The files of all formats that one run writes.
struct Written
{
  std::filesystem::path directory;
  std::string xyz;
  std::string dump;
};

Written write_all(const std::string& name, const Words& arguments)
{
  const Written written{temporary_path(name), temporary_path(name + ".xyz"),
                        temporary_path(name + "_out.lammpstrj")};
  run_quietly(with(arguments, {"--vtk", written.directory.string(), "--xyz", written.xyz,
                               "--lammps", written.dump}));
  return written;
}

// Expects that files of all formats contain the recording. Returns the grids.
Collection expect_all_formats(const Written& written, const scenario::Recording& recording)
{
  Collection collection = read_collection(written.directory);
  expect_equal_recordings(scenario::read_lammps_dump(written.dump), recording);
  expect_equal_recordings(read_xyz(written.xyz), recording);
  expect_equal_recordings(recording_of(collection), recording);
  return collection;
}

// Points that come, go, change their place in the row, meet and part, at coordinates that take all
// of their digits.
std::string lively_csv()
{
  std::string text = "frame,time,id,x,y\n";
  for (int frame = 0; frame != 9; ++frame) {
    for (int id = -3; id != 12; ++id) {
      if ((id + 3 * frame + 9) % 7 == 0) {
        continue;
      }
      const bool meets = id == 11 && frame % 3 == 2;
      const int place = meets ? 10 : id;
      std::ostringstream row;
      row.precision(std::numeric_limits<double>::max_digits10);
      row << frame << ',' << 0.1 * frame << ',' << 1'000'000'000'000 * id << ','
          << (place * place % 17) / 3.0 + 0.01 * frame << ','
          << (place * 7 % 13) / 7.0 - 1e-17 * place << '\n';
      text += row.str();
    }
  }
  return text;
}

TEST(Vtk, has_the_delaunay_triangles_of_about_thirty_frames)
{
  const Written written = write_all(
      "brownian", {"brownian", "--points", "60", "--frames", "100", "--time-step", "0.1"});
  const Collection collection = read_collection(written.directory);
  EXPECT_EQ(collection.files.size(), 26u);
  EXPECT_EQ(collection.files.front(), "frame_00000.vtu");
  EXPECT_EQ(collection.files.back(), "frame_00100.vtu");
  EXPECT_EQ(collection.times.back(), 100.0);
  for (const Grid& grid : collection.grids) {
    EXPECT_EQ(grid.points.size(), 60u);
  }
  expect_delaunay(collection);
  std::size_t number_of_files = 0;
  for (const auto& file : std::filesystem::directory_iterator(written.directory)) {
    EXPECT_NE(file.path().extension(), ".part");
    ++number_of_files;
  }
  EXPECT_EQ(number_of_files, collection.files.size() + 1);
}

TEST(Vtk, takes_the_numbers_of_the_frames_for_times_that_do_not_ascend)
{
  std::string text = "frame,time,id,x,y\n";
  for (const char* frame : {"0,5", "1,5", "2,4"}) {
    for (const char* point : {"1,0,0", "2,1,0", "3,0,1"}) {
      text += std::string(frame) + "," + point + "\n";
    }
  }
  const Written written = write_all("timeless", {write_file("timeless.csv", text)});
  const Collection collection = read_collection(written.directory);
  EXPECT_EQ(collection.times, (std::vector<double>{0.0, 1.0, 2.0}));
  EXPECT_EQ(collection.grids.back().time, 4.0);
}

template <class Classifier>
using Cloud_run = run::Scenario_run<Classifier>;

template <class Classifier>
Grid written_grid(const Cloud_run<Classifier>& run)
{
  std::stringstream stream;
  run::write_vtk_grid(stream, run);
  return read_grid(stream);
}

// The ids of points are their places here.
template <class Dynamic>
Triangles kept_triangles(const Dynamic& triangulation)
{
  Triangles triangles;
  const auto infinite = triangulation.infinite_vertex();
  for (const auto& face : triangulation.tds().faces()) {
    if (!face.has_vertex(infinite)) {
      const auto id = [&](int i) {
        return static_cast<std::int64_t>(triangulation.id(face.vertex(i)));
      };
      triangles.insert(triangle(id(0), id(1), id(2)));
    }
  }
  return triangles;
}

template <class Dynamic>
std::vector<std::int64_t> kept_sets(const Dynamic& triangulation)
{
  std::vector<std::int64_t> sets(triangulation.number_of_points(), 0);
  const auto frame = triangulation.frame();
  std::int64_t number = 0;
  for (const auto* vertices : {&triangulation.border_vertices(), &triangulation.padded_vertices(),
                               &triangulation.classified_vertices()}) {
    ++number;
    for (const auto v : *vertices) {
      sets[frame.id(v)] = number;
    }
  }
  return sets;
}

scenario::Brownian_description cloud()
{
  scenario::Brownian_description description{};
  description.points = 400;
  description.box = {1.0, 1.0};
  description.time_step = 0.02;
  return description;
}

TEST(Vtk, has_the_triangles_of_an_uncertified_triangulation_as_they_are)
{
  scenario::Brownian_motion motion("cloud", cloud(), 1, 20);
  Cloud_run<CGAL::Random_classifier_2> run(motion, CGAL::Random_classifier_2(0.0),
                                           run::make_repair("splice", 1), {}, run::Any_policy());
  for (int frame = 0; frame != 20; ++frame) {
    const Grid grid = written_grid(run);
    EXPECT_EQ(grid.triangles, kept_triangles(run.triangulation()));
    const bool all_are_delaunay = std::count(grid.delaunay.begin(), grid.delaunay.end(), 0) == 0;
    EXPECT_EQ(all_are_delaunay, run.triangulation().is_certified());
    ASSERT_TRUE(run.advance());
  }
  EXPECT_FALSE(run.triangulation().is_certified());
}

TEST(Vtk, has_the_sets_that_a_splice_had)
{
  scenario::Brownian_motion motion("cloud", cloud(), 1, 20);
  Cloud_run<CGAL::Point_distance_classifier_2> run(motion, CGAL::Point_distance_classifier_2(0.6),
                                                   run::make_repair("splice", 1), {},
                                                   run::Any_policy());
  std::set<std::int64_t> seen;
  for (int frame = 0; frame != 20; ++frame) {
    ASSERT_TRUE(run.advance());
    const Grid grid = written_grid(run);
    if (!run.record().update.rebuilt()) {
      EXPECT_EQ(grid.sets, kept_sets(run.triangulation()));
    }
    seen.insert(grid.sets.begin(), grid.sets.end());
  }
  EXPECT_EQ(seen, (std::set<std::int64_t>{0, 1, 2, 3}));
}

TEST(Formats, keep_every_bit_of_a_recording_whose_population_changes)
{
  const std::string csv = write_file("lively.csv", lively_csv());
  expect_delaunay(expect_all_formats(write_all("lively", {csv}), scenario::read_csv_motion(csv)));
}

TEST(Formats, agree_about_a_heuristic_run)
{
  const Written written = write_all("heuristic", {"explosion", "--points", "100", "--frames", "20",
                                                  "--classifier", "point_distance:0.5"});
  const scenario::Recording recording = scenario::read_lammps_dump(written.dump);
  EXPECT_EQ(recording.size(), 21u);
  expect_all_formats(written, recording);
}

TEST(Formats, can_do_with_no_point_one_two_and_three_points_on_a_line)
{
  const std::string path = write_file("few.lammpstrj", small_dump());
  const Collection collection =
      expect_all_formats(write_all("few", {path}), scenario::read_lammps_dump(path));
  std::vector<std::size_t> numbers_of_triangles;
  for (const Grid& grid : collection.grids) {
    numbers_of_triangles.push_back(grid.triangles.size());
  }
  EXPECT_EQ(numbers_of_triangles, (std::vector<std::size_t>{0, 0, 0, 0, 2, 3}));
}

TEST(Formats, can_do_with_the_largest_numbers)
{
  const std::string csv = write_file("large.csv", "frame,time,id,x,y\n"
                                                  "0,0,1,-1.7e308,5e-324\n0,0,2,1.7e308,0\n"
                                                  "0,0,9223372036854775807,0,1.7976e308\n"
                                                  "0,0,-9223372036854775808,-0.0,-1e300\n");
  expect_all_formats(write_all("large", {csv}), scenario::read_csv_motion(csv));
}

TEST(Formats, of_a_dump_that_is_run_again_are_the_same)
{
  const Written first =
      write_all("first", {"brownian", "--points", "40", "--frames", "15", "--time-step", "0.05"});
  const Written second = write_all("second", {first.dump});
  expect_equal_recordings(scenario::read_lammps_dump(second.dump),
                          scenario::read_lammps_dump(first.dump));
  const Written third = write_all("third", {second.dump});
  EXPECT_EQ(content_of(third.dump), content_of(second.dump));
  EXPECT_EQ(content_of(third.xyz), content_of(second.xyz));
}

// Frames by their numbers: their times, and positions by what the user calls the points.
using Named_points = std::map<std::string, std::pair<double, double>>;
using Named_frames = std::map<std::int64_t, std::pair<double, Named_points>>;

Named_frames named(const scenario::Recording& recording)
{
  Named_frames frames;
  scenario::Recorded_motion motion("motion", recording);
  do {
    auto& [time, points] = frames[motion.frame_number().value_or(-1)];
    time = motion.time();
    for (std::size_t i = 0; i != motion.ids().size(); ++i) {
      points[motion.id_text(i)] = {motion.points()[i].x, motion.points()[i].y};
    }
  } while (motion.advance({}));
  return frames;
}

// With the ids of a table instead of their numbers.
Named_frames renamed(const scenario::Recording& recording, const std::string& table)
{
  std::map<std::string, std::string> names;
  std::ifstream in(table);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "id,name");
  while (std::getline(in, line)) {
    const std::size_t comma = line.find(',');
    names[line.substr(0, comma)] = line.substr(comma + 1);
  }
  Named_frames frames;
  for (const auto& [number, frame] : named(recording)) {
    frames[number].first = frame.first;
    for (const auto& [id, point] : frame.second) {
      frames[number].second[names.at(id)] = point;
    }
  }
  return frames;
}

Named_frames named(const Collection& collection)
{
  Named_frames frames;
  for (const Grid& grid : collection.grids) {
    auto& [time, points] = frames[grid.number];
    time = grid.time;
    for (std::size_t i = 0; i != grid.points.size(); ++i) {
      points[grid.names.at(i)] = {grid.points[i].x, grid.points[i].y};
    }
  }
  return frames;
}

// A recording whose frames have numbers with gaps, and whose ids are text, as names of people.
std::string named_csv(const std::string& somebody)
{
  return "frame,time,id,x,y\n-7,0.5,Zo\xC3\xAB,0,0\n-7,0.5,7,4,0\n-7,0.5," + somebody +
         ",4,3\n120,1.5," + somebody + ",4,3.1\n120,1.5,7,4.1,0\n120,1.5,a;b,2,1\n" +
         "120,1.5,Zo\xC3\xAB,0.1,0\n1000000,9,7,4.2,0\n1000000,9,a;b,2,1.1\n1000000,9," + somebody +
         ",4,3.2\n";
}

TEST(Frames_and_ids, of_a_recording_are_those_of_all_files)
{
  for (const std::string somebody : {"Anna", "Anna Maria"}) {
    SCOPED_TRACE(somebody);
    const std::string csv = write_file("named.csv", named_csv(somebody));
    const Named_frames frames = named(scenario::read_csv_motion(csv));
    ASSERT_EQ(frames.size(), 3u);
    ASSERT_EQ(frames.at(120).second.at(somebody).second, 3.1);
    const std::string cells = temporary_path("named_cells.csv"), log = temporary_path("log.csv");
    const Written written =
        write_all("named", {csv, "--cells", cells, "--radius", "2", "--csv", log});
    EXPECT_EQ(named(scenario::read_csv_motion(cells)), frames);
    EXPECT_EQ(named(read_collection(written.directory)), frames);
    EXPECT_EQ(renamed(scenario::read_lammps_dump(written.dump), written.dump + ".ids.csv"), frames);
    const scenario::Recording xyz = scenario::read_xyz_motion(written.xyz);
    const std::string table = written.xyz + ".ids.csv";
    if (somebody == "Anna") {
      EXPECT_EQ(named(xyz), frames);
      EXPECT_FALSE(std::filesystem::exists(table));
    } else {
      EXPECT_EQ(renamed(xyz, table), frames);
    }
    const std::string rows = content_of(log);
    EXPECT_EQ(number_of_lines(rows), 3u);
    EXPECT_NE(rows.find("\n120,1.5,4,"), std::string::npos) << rows;
    EXPECT_NE(rows.find("\n1000000,9,3,"), std::string::npos) << rows;
  }
}

TEST(Frames_and_ids, of_a_recording_are_those_of_pictures_and_the_page)
{
  const std::string csv = write_file("shown.csv", named_csv("Anna <Maria>"));
  const std::filesystem::path pictures = temporary_path("named_pictures");
  const std::string page = temporary_path("named.html");
  run_quietly({csv, "--svg", pictures.string(), "--html", page});
  std::set<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(pictures)) {
    names.insert(file.path().filename().string());
  }
  EXPECT_EQ(names, (std::set<std::string>{"frame_-00007.svg", "frame_00120.svg",
                                          "frame_1000000.svg", "index.html"}));
  EXPECT_NE(content_of((pictures / "frame_00120.svg").string()).find("frame 120, time 1.5"),
            std::string::npos);
  EXPECT_NE(content_of((pictures / "index.html").string()).find("frame_-00007.svg\">frame -7, "),
            std::string::npos);
  const std::string text = content_of(page);
  EXPECT_NE(text.find("\"frame\":[-7,120,1000000]"), std::string::npos);
  EXPECT_NE(text.find("\"names\":[\"Zo\xC3\xAB\",\"7\",\"Anna \\u003cMaria>\",\"a;b\"]"),
            std::string::npos);
}

TEST(Frames_and_ids, of_a_dump_and_of_xyz_are_read_back_and_written_again)
{
  std::string dump = small_dump();
  for (int frame = 5; frame >= 0; --frame) { // steps 0, 1, 2 to 100, 350, 600
    const std::string head = "TIMESTEP\n";
    dump.replace(dump.find(head + std::to_string(frame) + "\n") + head.size(), 1,
                 std::to_string(100 + 250 * frame));
  }
  const std::string path = write_file("steps.dump", dump);
  const scenario::Recording recording = scenario::read_lammps_dump(path);
  EXPECT_EQ(recording.back().number, 1350);
  expect_all_formats(write_all("steps", {path}), recording);
  expect_all_formats(write_all("steps_again", {temporary_path("steps.xyz")}), recording);
}

TEST(Frames_and_ids, without_numbers_that_ascend_are_counted)
{
  scenario::Recording recording(3);
  EXPECT_EQ(scenario::Recorded_motion("none", recording).frame_number(), std::nullopt);
  for (std::size_t i = 0; i != 3; ++i) {
    recording[i].number = static_cast<std::int64_t>(10 * i) - 4;
  }
  scenario::Recorded_motion motion("numbers", recording);
  EXPECT_EQ(motion.frame_number(), -4);
  motion.advance({});
  EXPECT_EQ(motion.frame_number(), 6);
  EXPECT_EQ(motion.names(), nullptr);
}

TEST(Every, chooses_the_frames_of_all_formats)
{
  const std::filesystem::path pictures = temporary_path("every_pictures");
  const Written written = write_all("every", {"brownian", "--points", "20", "--frames", "10",
                                              "--every", "4", "--svg", pictures.string()});
  const Collection collection =
      expect_all_formats(written, scenario::read_lammps_dump(written.dump));
  EXPECT_EQ(collection.times, (std::vector<double>{0.0, 4.0, 8.0, 10.0}));
  std::set<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(pictures)) {
    names.insert(file.path().filename().string());
  }
  EXPECT_EQ(names, (std::set<std::string>{"frame_00000.svg", "frame_00004.svg", "frame_00008.svg",
                                          "frame_00010.svg", "index.html"}));
}

TEST(Every, that_is_larger_than_the_run_chooses_its_first_and_last_frame)
{
  const Written written =
      write_all("ends", {"brownian", "--points", "20", "--frames", "10", "--every", "1000"});
  EXPECT_EQ(read_xyz(written.xyz).size(), 2u);
  const Written first =
      write_all("start", {"brownian", "--points", "20", "--frames", "0", "--every", "3"});
  EXPECT_EQ(read_xyz(first.xyz).size(), 1u);
  EXPECT_EQ(read_collection(first.directory).files.size(), 1u);
}

TEST(Files, of_a_run_that_fails_are_as_they_were)
{
  if (!std::filesystem::exists("/dev/full")) {
    GTEST_SKIP() << "there is no device that is full";
  }
  const std::string xyz = write_file("kept.xyz", "old"), dump = write_file("kept.dump", "old");
  const std::filesystem::path directory = temporary_path("kept");
  const std::string pictures = temporary_path("kept_pictures");
  const Outcome outcome =
      run_program({"dam_break", "--points", "50", "--frames", "9", "--csv", "/dev/full", "--xyz",
                   xyz, "--lammps", dump, "--vtk", directory.string(), "--svg", pictures});
  EXPECT_FALSE(outcome.succeeded);
  EXPECT_TRUE(contains(outcome.errors, "/dev/full: cannot be written to its end: No space left"))
      << outcome.errors;
  EXPECT_EQ(content_of(xyz), "old");
  EXPECT_EQ(content_of(dump), "old");
  for (const std::string& file : {(directory / "frames.pvd").string(), pictures + "/index.html"}) {
    EXPECT_FALSE(std::filesystem::exists(file));
    EXPECT_FALSE(std::filesystem::exists(file + ".part"));
  }
}

// An error is reported at once, not after the last one of many frames.
TEST(A_full_disk, is_told_when_it_is_full)
{
  if (!std::filesystem::exists("/dev/full")) {
    GTEST_SKIP() << "there is no device that is full";
  }
  const auto start = std::chrono::steady_clock::now();
  const Outcome outcome = run_program(
      {"dam_break", "--points", "50", "--frames", "100000000", "--quiet", "--csv", "/dev/full"});
  EXPECT_FALSE(outcome.succeeded);
  EXPECT_TRUE(contains(outcome.errors, "No space left")) << outcome.errors;
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::minutes(1));
}

TEST(Standard_output, that_is_full_is_a_failure)
{
  if (!std::filesystem::exists("/dev/full")) {
    GTEST_SKIP() << "there is no device that is full";
  }
  const std::string errors = temporary_path("errors");
  const std::string command =
      "\"" RUN_SCENARIO "\" dam_break --points 50 --frames 2 > /dev/full 2> \"" + errors + "\"";
  EXPECT_NE(std::system(command.c_str()), 0);
  EXPECT_TRUE(contains(content_of(errors), "standard output: cannot be written: No space left"))
      << content_of(errors);
}

#ifndef _WIN32
// The frames until then are written completely, and summarized.
TEST(An_interrupted_run, finishes_what_it_has_written)
{
  const std::string log = temporary_path("interrupted.csv"),
                    dump = temporary_path("interrupted.xyz");
  const std::string output = temporary_path("output"), errors = temporary_path("errors");
  for (const char* signal : {"INT", "TERM"}) {
    SCOPED_TRACE(signal);
    std::filesystem::remove(log);
    std::filesystem::remove(dump);
    // In the foreground: else the program may get the signal a second time, with its group.
    const std::string command = std::string("timeout --foreground --signal=") + signal +
                                " 3 \"" RUN_SCENARIO "\" dam_break --points 60 --frames 100000000" +
                                " --csv \"" + log + "\" --xyz \"" + dump + "\" > \"" + output +
                                "\" 2> \"" + errors + "\"";
    EXPECT_NE(std::system(command.c_str()), 0);
    EXPECT_TRUE(contains(content_of(errors), "run_scenario: interrupted")) << content_of(errors);
    EXPECT_TRUE(contains(content_of(output), "certified")) << content_of(output);
    const std::string rows = content_of(log);
    ASSERT_GT(number_of_lines(rows), 2u);
    EXPECT_EQ(rows.back(), '\n');
    EXPECT_TRUE(std::filesystem::exists(dump));
    for (const std::string& path : {log, dump}) {
      EXPECT_FALSE(std::filesystem::exists(path + ".part"));
    }
  }
}
#endif

TEST(Frame_log, has_times_that_do_not_drift_in_few_digits)
{
  const std::string log = temporary_path("short.csv");
  run_quietly({"dam_break", "--points", "20", "--frames", "40", "--csv", log});
  const std::string rows = content_of(log);
  EXPECT_TRUE(contains(rows, "\n1,0.3,20,")) << rows;
  EXPECT_TRUE(contains(rows, "\n40,12,20,")) << rows;
}

} // namespace
