// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The program run_scenario, run as a user runs it.

#include "case_table.h"
#include "scenario_program.h"
#include "scenario_runner/Text_input.h"
#include "temporary_files.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/version.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

TEST(Report, says_everything_about_a_run)
{
  const Json report = report_of({"dam_break", "--frames", "150", "--points", "300"});
  EXPECT_EQ(report["scenario"], "dam_break");
  EXPECT_EQ(report["points"], 300);
  EXPECT_EQ(report["classifier"], "circumcircle");
  EXPECT_TRUE(report["parameter"].is_null());
  EXPECT_EQ(report["padding"], 1);
  EXPECT_EQ(report["repair"], "hold_and_flip");
  EXPECT_EQ(report["engine"], "guibas_stolfi");
  EXPECT_EQ(report["threads"], 1);
  EXPECT_EQ(report["packing"], "square");
  EXPECT_EQ(report["population_changes"], 0);
  EXPECT_TRUE(report["cell"].is_null());
  EXPECT_TRUE(report["seed"].is_number_unsigned());
  EXPECT_TRUE(report["time_step"].is_number_float());
  EXPECT_TRUE(report["rebuild_reasons"].is_object());
  for (const char* key :
       {"rebuilds", "classified_mean", "padded_mean", "border_mean", "flips_mean", "splices_mean",
        "enlargements_mean", "relocated_mean", "dynamic_ns_per_point", "static_insert_ns_per_point",
        "static_fastest_ns_per_point", "speedup_vs_insert", "speedup_vs_fastest",
        "speedup_vs_insert_last_half"}) {
    EXPECT_TRUE(report[key].is_number()) << key;
  }
  expect_exact_report(report, 150);
}

TEST(Report, gives_medians_that_lie_between_their_quartiles_and_their_ratios_as_speedups)
{
  const Json report = report_of({"static", "--frames", "60"});
  for (const std::string name : {"dynamic", "static_insert", "static_fastest"}) {
    const double median = report[name + "_ns_per_point"];
    const auto quartiles = report[name + "_ns_per_point_quartiles"].get<std::vector<double>>();
    EXPECT_GT(quartiles.at(0), 0.0);
    EXPECT_LE(quartiles.at(0), median);
    EXPECT_LE(median, quartiles.at(1));
  }
  EXPECT_DOUBLE_EQ(report["speedup_vs_insert"].get<double>() *
                       report["dynamic_ns_per_point"].get<double>(),
                   report["static_insert_ns_per_point"].get<double>());
}

TEST(Report, leaves_out_the_numbers_that_no_frame_gives)
{
  const Json report = report_of({"--frames", "0"});
  EXPECT_EQ(report["frames"], 0);
  EXPECT_EQ(report["points"], 1008);
  for (const char* key : {"mcc_min", "mcc_mean", "flips_mean", "dynamic_ns_per_point",
                          "dynamic_ns_per_point_quartiles", "speedup_vs_insert"}) {
    EXPECT_TRUE(report[key].is_null()) << key;
  }
}

TEST(Report, is_the_same_of_equal_runs_but_for_the_times)
{
  const Words arguments = {"dam_break",    "--points", "200",    "--frames", "80",
                           "--classifier", "random",   "--seed", "7"};
  Json first = report_of(arguments);
  const Json second = report_of(arguments);
  EXPECT_EQ(first["seed"], 7);
  for (const auto& [key, value] : second.items()) {
    if (!contains(key, "_ns_") && !contains(key, "speedup")) {
      EXPECT_EQ(first[key], value) << key;
    }
  }
}

// The words of a command, which a blank separates; they may be empty.
Words words_of(const std::string& command)
{
  std::vector<std::string_view> words;
  scenario::split_at(' ', command, words);
  return Words(words.begin() + 1, words.end());
}

// Of a value in a report, as `rebuild_reasons.policy=5` and `mcc_min>0.5`.
void expect_value(const Json& report, const std::string& expectation)
{
  const std::size_t place = expectation.find_first_of("<=>");
  std::string key = '/' + expectation.substr(0, place);
  std::replace(key.begin(), key.end(), '.', '/');
  const std::string text = expectation.substr(place + 1);
  const Json::json_pointer pointer(key);
  const Json value = report.contains(pointer) ? report.at(pointer) : Json("missing");
  Json expected = Json::parse(text, nullptr, false);
  if (expected.is_discarded()) {
    expected = text;
  }
  switch (expectation.at(place)) {
  case '<':
    EXPECT_LT(value, expected) << key;
    break;
  case '>':
    EXPECT_GT(value, expected) << key;
    break;
  default:
    EXPECT_EQ(value, expected) << key;
  }
}

TEST(Runs, report_what_they_did)
{
  for (const Case& run : read_cases("runs").cases) {
    SCOPED_TRACE(run.given);
    const Json report = report_of(words_of(run.given));
    EXPECT_LE(report["mcc_min"], report["mcc_mean"]);
    EXPECT_LE(report["mcc_mean"], 1.0);
    std::istringstream expectations(run.expected);
    for (std::string word; expectations >> word;) {
      if (word == "exact") {
        expect_exact_report(report, report["frames"]);
      } else {
        expect_value(report, word);
      }
    }
  }
}

TEST(Summary, names_classifier_and_policy_with_their_parameters)
{
  const Outcome outcome =
      run_program({"--points", "200", "--frames", "20", "--policy", "key_frames:8", "--classifier",
                   "refined:point_distance+random:0.5"});
  EXPECT_TRUE(contains(outcome.output, "refined:point_distance:0.7+random:0.5 (heuristic)"));
  EXPECT_TRUE(contains(outcome.output, "key_frames:8"));
}

TEST(Recordings, may_change_their_population)
{
  const Json report = report_of({write_file("small.csv", small_csv())});
  EXPECT_EQ(report["scenario"], "small");
  EXPECT_EQ(report["points"], 5);
  EXPECT_EQ(report["population_changes"], 2);
  EXPECT_TRUE(report["seed"].is_null());
  EXPECT_TRUE(report["time_step"].is_null());
  expect_exact_report(report, 7);
}

TEST(Recordings, may_have_no_one_and_two_points)
{
  const std::string path = write_file("small.lammpstrj", small_dump());
  const Json report = report_of({path, "--svg", temporary_path("small_pictures")});
  EXPECT_EQ(report["points"], 4);
  EXPECT_EQ(report["population_changes"], 4);
  expect_exact_report(report, 5);
}

TEST(Recordings, may_come_from_standard_input)
{
  const std::string path = temporary_path("piped.json");
  const std::string command = "\"" RUN_SCENARIO "\" - --quiet --report \"" + path + "\" < \"" +
                              write_file("piped", small_csv()) + "\"";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const Json report = Json::parse(content_of(path));
  EXPECT_EQ(report["scenario"], "standard_input");
  expect_exact_report(report, 7);
  const std::string errors = temporary_path("errors");
  const std::string wrong = "\"" RUN_SCENARIO "\" - < \"" + write_file("piped", "frame,id\n0,1\n") +
                            "\" 2> \"" + errors + "\"";
  EXPECT_NE(std::system(wrong.c_str()), 0);
  EXPECT_TRUE(contains(content_of(errors), "standard input, line 1: columns 'x' and 'y'"))
      << content_of(errors);
}

TEST(Recordings, from_standard_input_may_be_of_any_format)
{
  const std::string path = temporary_path("piped.json");
  const std::string command = "\"" RUN_SCENARIO "\" - --quiet --report \"" + path + "\" < \"" +
                              write_file("piped", small_dump()) + "\"";
  ASSERT_EQ(std::system(command.c_str()), 0);
  expect_exact_report(Json::parse(content_of(path)), 5);
}

TEST(Recordings, may_have_columns_that_are_named_by_an_option)
{
  std::string csv = small_csv();
  csv.replace(0, csv.find('\n'), "a,b,c,d,e");
  const std::string path = write_file("unknown.csv", csv);
  expect_exact_report(report_of({path, "--columns", "frame,time,id,x,y"}), 7);
  expect_exact_report(report_of({path, "--columns", "frame=A,id=C,x=D,y=E"}), 7);
}

TEST(Recordings, end_where_they_end_and_seed_the_random_classifier)
{
  const Json report = report_of({write_file("small.csv", small_csv()), "--frames", "1000",
                                 "--classifier", "random:0.5", "--seed", "3"});
  EXPECT_EQ(report["frames"], 7);
  EXPECT_EQ(report["seed"], 3);
}

TEST(Outputs, are_a_table_a_row_for_each_frame_and_pictures)
{
  const std::string csv = temporary_path("frames.csv");
  const std::filesystem::path pictures = temporary_path("pictures/of/it");
  const Outcome outcome =
      run_program({"explosion", "--points", "100", "--frames", "45", "--csv", csv, "--svg",
                   pictures.string(), "--classifier", "point_distance"});
  EXPECT_TRUE(outcome.succeeded);
  EXPECT_EQ(outcome.errors, "") << "progress is for terminals";
  EXPECT_TRUE(contains(outcome.output, "explosion, 100 points, 45 frames"));
  EXPECT_TRUE(contains(outcome.output, "point_distance:0.7 (heuristic)"));
  EXPECT_TRUE(contains(outcome.output, "guibas_stolfi"));
  EXPECT_EQ(number_of_lines(content_of(csv)), 1u + 45u);
  std::size_t number_of_pictures = 0;
  for (const auto& file : std::filesystem::directory_iterator(pictures)) {
    if (file.path().filename() == "index.html") {
      continue;
    }
    const std::string picture = content_of(file.path().string());
    EXPECT_EQ(picture.rfind("<svg", 0), 0u);
    EXPECT_TRUE(contains(picture, "</svg>"));
    EXPECT_FALSE(contains(picture, "nan"));
    ++number_of_pictures;
  }
  EXPECT_LE(number_of_pictures, 32u);
  EXPECT_TRUE(std::filesystem::exists(pictures / "frame_00000.svg"));
  EXPECT_TRUE(std::filesystem::exists(pictures / "frame_00045.svg"));
}

TEST(Outputs, leave_the_last_report_alone_when_the_run_fails)
{
  const std::string path = write_file("old.json", "old");
  EXPECT_FALSE(run_program({"no_such_scenario", "--report", path}).succeeded);
  EXPECT_FALSE(run_program({"--time-step", "-1", "--report", path}).succeeded);
  EXPECT_EQ(content_of(path), "old");
}

TEST(Help, lists_scenarios_classifiers_repairs_policies_engines_and_formats)
{
  const Outcome outcome = run_program({"--help"});
  EXPECT_TRUE(outcome.succeeded);
  for (const char* word :
       {"dam_break", "point_distance", "hold_and_flip", "key_frames:K", "bowyer_watson",
        "--time-step", "--vtk", "ParaView", "--xyz", "--lammps", "--cells", "--radius", "--domain",
        "--cell-rule", "--every", "doc/Dynamic_Delaunay_triangulation_2/Scenario_files.txt"}) {
    EXPECT_TRUE(contains(outcome.output, word)) << word;
  }
  EXPECT_TRUE(
      contains(run_program({"--version"}).output, CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION));
}

std::map<std::string, std::string> texts_in(const std::string& directory)
{
  std::map<std::string, std::string> texts;
  for (const auto& file : std::filesystem::directory_iterator(directory)) {
    texts[file.path().filename().string()] = content_of(file.path().string());
  }
  return texts;
}

TEST(Refused_commands, say_why_and_write_nothing)
{
  const Case_table table = read_cases("commands");
  const std::string directory = temporary_path("refused");
  std::filesystem::create_directories(directory);
  for (const auto& [name, text] : table.files) {
    write_file("refused/" + name, text);
  }
  for (const Case& refusal : table.cases) {
    SCOPED_TRACE(refusal.given);
    const Outcome outcome =
        run_program(with(words_of(refusal.given), {"--report", "report.json"}), directory);
    EXPECT_FALSE(outcome.succeeded);
    EXPECT_EQ(outcome.output, "");
    EXPECT_TRUE(says(outcome.errors, "run_scenario: " + refusal.expected + "\n")) << outcome.errors;
    EXPECT_EQ(texts_in(directory), table.files);
  }
}

// -------------------------------------------------------------------------------------------------
// The cells of --cells.

using Rows = std::vector<std::map<std::string, std::string>>;

Words fields_of(const std::string& line)
{
  std::vector<std::string_view> fields;
  scenario::split_at(',', line, fields);
  return Words(fields.begin(), fields.end());
}

Rows rows_of(const std::string& path)
{
  std::istringstream in(content_of(path));
  std::string line;
  std::getline(in, line);
  const Words columns = fields_of(line);
  Rows rows;
  while (std::getline(in, line)) {
    const Words fields = fields_of(line);
    EXPECT_EQ(fields.size(), columns.size()) << line;
    rows.emplace_back();
    for (std::size_t i = 0; i != fields.size(); ++i) {
      rows.back()[columns[i]] = fields[i];
    }
  }
  return rows;
}

Rows cells_of(const Words& arguments)
{
  const std::string path = temporary_path("cells.csv");
  std::filesystem::remove(path);
  run_quietly(with(arguments, {"--cells", path}));
  return rows_of(path);
}

double sum(const Rows& rows, const std::string& column, const std::string& frame)
{
  double sum = 0;
  for (const auto& row : rows) {
    if (row.at("frame") == frame) {
      sum += std::stod(row.at(column));
    }
  }
  return sum;
}

std::string pentagon()
{
  return write_file("pentagon.wkt", "POLYGON ((-1 0, 4 -1, 5 3, 2 7, -1 4, -1 0))\n");
}
constexpr double area_of_pentagon = 33;

TEST(Cells, fill_their_domain_in_every_frame_also_where_points_come_and_go)
{
  const Rows rows = cells_of({write_file("tracks.csv", small_csv()), "--domain", pentagon()});
  EXPECT_EQ(rows.size(), 8u * 5u - 2u);
  const double walls = std::hypot(5, 1) + std::hypot(1, 4) + 5 + std::hypot(3, 3) + 4;
  for (std::size_t frame = 0; frame != 8; ++frame) {
    const std::string number = std::to_string(frame);
    EXPECT_NEAR(sum(rows, "area", number), area_of_pentagon, 1e-12);
    EXPECT_NEAR(sum(rows, "wall_length", number), walls, 1e-12);
    EXPECT_EQ(sum(rows, "free_length", number), 0);
  }
  for (const auto& row : rows) {
    EXPECT_DOUBLE_EQ(std::stod(row.at("density")) * std::stod(row.at("area")), 1);
    const bool is_alone_in_the_middle = row.at("id") == "4";
    EXPECT_EQ(row.at("contacts") == "4", is_alone_in_the_middle) << row.at("frame");
  }
  EXPECT_EQ(rows[4].at("x"), "2");
  EXPECT_EQ(rows.back().at("time"), "7");
}

TEST(Cells, end_at_their_radius)
{
  const std::string tracks = write_file("pair.csv", "frame,id,x,y\n0,7,0,0\n0,9,1,0\n0,11,100,0\n");
  const Rows rows = cells_of({tracks, "--radius", "1"});
  ASSERT_EQ(rows.size(), 3u);
  const double pi = std::acos(-1), half_angle = std::acos(0.5);
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_NEAR(std::stod(rows[i].at("area")), pi - half_angle + std::sin(half_angle) / 2, 1e-14);
    EXPECT_NEAR(std::stod(rows[i].at("free_length")), 2 * (pi - half_angle), 1e-14);
    EXPECT_NEAR(std::stod(rows[i].at("perimeter")), 2 * (pi - half_angle) + std::sqrt(3), 1e-14);
    EXPECT_EQ(rows[i].at("contacts"), "1");
  }
  EXPECT_NEAR(std::stod(rows[2].at("area")), pi, 1e-14);
  EXPECT_EQ(rows[2].at("contacts"), "0");
  EXPECT_EQ(rows[2].at("id"), "11");
}

TEST(Cells, of_points_in_one_place_share_its_area_and_outside_of_the_domain_have_no_density)
{
  const std::string tracks =
      write_file("twins.csv", "frame,id,x,y\n0,1,1,1\n0,2,1,1\n0,3,3,1\n0,4,90,0\n");
  const Rows rows = cells_of({tracks, "--radius", "10", "--domain", pentagon()});
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].at("area"), rows[1].at("area"));
  EXPECT_EQ(rows[0].at("contacts"), "1");
  EXPECT_EQ(rows[1].at("contacts"), "1");
  EXPECT_NEAR(sum(rows, "area", "0"), area_of_pentagon, 1e-12);
  EXPECT_EQ(rows[3].at("area"), "0");
  EXPECT_EQ(rows[3].at("density"), "");
}

TEST(Cells, fill_a_torus)
{
  std::string xyz = "20\nLattice=\"2 0 0 0.5 1 0 0 0 1\" pbc=\"T T F\"\n";
  for (int i = 0; i != 20; ++i) {
    xyz += "X " + std::to_string(i * 37 % 20 * 0.1 + i * i * 0.001) + ' ' +
           std::to_string(i * 0.05) + " 0\n";
  }
  const Rows rows = cells_of({write_file("torus.xyz", xyz), "--radius", "5"});
  ASSERT_EQ(rows.size(), 20u);
  EXPECT_NEAR(sum(rows, "area", "0"), 2, 1e-12);
  EXPECT_EQ(sum(rows, "contacts", "0"), 6 * 20); // no four on a circle
}

TEST(Cells, are_of_every_nth_frame_and_equal_on_any_number_of_threads)
{
  const Words options = {"brownian", "--points", "500",      "--frames", "7",
                         "--every",  "3",        "--radius", "0.05"};
  const Rows rows = cells_of(options);
  std::set<std::string> frames;
  for (const auto& row : rows) {
    frames.insert(row.at("frame"));
  }
  EXPECT_EQ(frames, (std::set<std::string>{"0", "3", "6", "7"}));
  EXPECT_EQ(rows.size(), 4u * 500u);
  EXPECT_EQ(cells_of(with(options, {"--threads", "2"})), rows);
}

TEST(Cells, are_a_table_that_can_be_run_again)
{
  const std::string path = temporary_path("again.csv");
  run_quietly({"brownian", "--points", "50", "--frames", "3", "--cells", path, "--radius", "0.1"});
  EXPECT_EQ(cells_of({path, "--radius", "0.1"}), rows_of(path));
}

TEST(Domain, is_the_same_in_any_file_that_holds_it)
{
  const std::string tracks = write_file("tracks.csv", small_csv());
  const Rows rows = cells_of({tracks, "--domain", pentagon()});
  const std::string ring = "[[-1,0],[4,-1],[5,3],[2,7],[-1,4],[-1,0]]";
  const std::string polygon = R"({"type": "Polygon", "coordinates": [)" + ring + "]}";
  const std::string feature =
      R"({"type": "Feature", "properties": {"name": "room"}, "geometry": )" + polygon + "}";
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"lines.WKT", "  POLYGON((\n -1 0,\n 4 -1,\n 5 3,\n 2 7,\n -1 4,\n -1 0))\n\n"},
           {"polygon.geojson", polygon},
           {"heights.json", R"({"type": "Polygon", "coordinates":
               [[[-1,0,7],[4,-1,7],[5,3,7],[2,7,7],[-1,4,7],[-1,0,7]]]})"},
           {"feature.geojson", feature},
           {"features.geojson",
            R"({"type": "FeatureCollection", "features": [)" + feature + "]}"}}) {
    EXPECT_EQ(cells_of({tracks, "--domain", write_file(name, text)}), rows) << name;
  }
  const Rows clockwise =
      cells_of({tracks, "--domain",
                write_file("clockwise.wkt", "POLYGON ((-1 0, -1 4, 2 7, 5 3, 4 -1, -1 0))")});
  EXPECT_NEAR(sum(clockwise, "area", "0"), area_of_pentagon, 1e-12);
}

TEST(Domain, may_have_walls_that_divide_cells_by_a_rule)
{
  // three rooms above a corridor with a pillar; one point is in the middle room, one in the
  // corridor, and one is outside
  const std::string rooms =
      write_file("rooms.wkt", "POLYGON ((0 0, 12 0, 12 10, 9 10, 9 2, 8 2, 8 10, 5 10, 5 2, 4 2, "
                              "4 10, 0 10, 0 0), (1 1, 2 1, 2 1.5, 1 1.5, 1 1))");
  const std::string tracks =
      write_file("rooms.csv", "frame,id,x,y\n0,1,6.5,9\n0,2,6.5,1\n0,3,6.5,30\n");
  const auto cells_by = [&](const Words& options) {
    return cells_of(with({tracks, "--domain", rooms}, options));
  };
  const Rows whole = cells_by({});
  ASSERT_EQ(whole.size(), 3u);
  EXPECT_EQ(cells_by({"--cell-rule", "whole"}), whole);
  EXPECT_NEAR(std::stod(whole[0].at("area")), 20 + 15 + 15, 1e-12);
  EXPECT_NEAR(std::stod(whole[1].at("area")), 54 - 0.5, 1e-12);
  EXPECT_EQ(whole[0].at("contacts"), "1"); // in three rooms
  EXPECT_EQ(whole[2].at("area"), "0");
  const Rows connected = cells_by({"--cell-rule", "connected"});
  EXPECT_NEAR(std::stod(connected[0].at("area")), 15, 1e-12);
  EXPECT_EQ(connected[1].at("area"), whole[1].at("area"));
  const Rows visible = cells_by({"--cell-rule", "visible"});
  EXPECT_LT(std::stod(visible[1].at("area")), 50);
  EXPECT_GT(std::stod(visible[1].at("free_length")), 1);
  EXPECT_EQ(visible[2].at("density"), "");
  EXPECT_EQ(visible[2].at("contacts"), "0");
  const Rows near = cells_by({"--cell-rule", "visible", "--radius", "0.5"});
  EXPECT_NEAR(std::stod(near[1].at("area")), std::acos(-1) / 4, 1e-14);
}

TEST(Domain, keeps_its_area_whoever_leaves_it)
{
  const std::string left = write_file("left.csv", "frame,id,x,y\n0,1,1,1\n0,2,-2,5\n0,3,90,0\n");
  for (const std::string& domain :
       {pentagon(), write_file("bent.wkt", "POLYGON ((0 0, 8 0, 8 4, 4 1, 0 4, 0 0))")}) {
    const Rows rows = cells_of({left, "--domain", domain});
    EXPECT_NEAR(sum(rows, "area", "0"), domain == pentagon() ? area_of_pentagon : 20, 1e-12);
    EXPECT_GT(std::stod(rows[1].at("area")), 0);
    const Rows seen = cells_of({left, "--domain", domain, "--cell-rule", "visible"});
    EXPECT_EQ(seen[1].at("area"), "0");
  }
}

} // namespace
