// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The program run_scenario, run as a user runs it.

#include "scenario_program.h"
#include "temporary_files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
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
  EXPECT_EQ(report["repair"], "flip_and_splice");
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

std::string test_name(const testing::TestParamInfo<std::string>& info)
{
  return info.param;
}

class Thesis_scenarios : public testing::TestWithParam<std::string>
{
};

TEST_P(Thesis_scenarios, are_exact_on_every_frame)
{
  expect_exact_report(report_of({GetParam(), "--frames", "150"}), 150);
}

TEST_P(Thesis_scenarios, stay_valid_under_a_heuristic)
{
  for (const char* packing : {"square", "hexagonal"}) {
    const Json report = report_of({GetParam(), "--frames", "150", "--classifier",
                                   "point_distance:0.9", "--packing", packing});
    EXPECT_EQ(report["exact"], false);
    EXPECT_EQ(report["classifier"], "point_distance");
    EXPECT_EQ(report["parameter"], 0.9);
    EXPECT_EQ(report["repair"], "splice");
    EXPECT_EQ(report["packing"], packing);
    EXPECT_EQ(report["valid_frames"], 150);
    EXPECT_GT(report["mcc_min"], 0.5);
    EXPECT_LE(report["mcc_min"], report["mcc_mean"]);
    EXPECT_LE(report["mcc_mean"], 1.0);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Thesis_scenarios,
                         testing::Values("dam_break", "spinning", "explosion", "static"),
                         test_name);

TEST(Brownian_motion, is_exact_with_every_repair)
{
  for (const char* repair : {"flip_and_splice", "splice", "flip", "relocate", "rebuild"}) {
    const Json report = report_of({"brownian", "--points", "500", "--frames", "40", "--time-step",
                                   "0.02", "--repair", repair});
    SCOPED_TRACE(repair);
    EXPECT_EQ(report["repair"], repair);
    EXPECT_EQ(report["time_step"], 0.02);
    EXPECT_TRUE(report["packing"].is_null());
    expect_exact_report(report, 40);
  }
}

TEST(Engines, run_by_their_names_for_rebuilds_and_for_splices)
{
  for (const char* engine : {"guibas_stolfi", "insertion", "bowyer_watson"}) {
    SCOPED_TRACE(engine);
    const Words arguments = {"brownian",    "--points", "300",      "--frames", "20",
                             "--time-step", "0.05",     "--engine", engine,     "--repair"};
    for (const char* repair : {"rebuild", "splice"}) {
      Words all = arguments;
      all.push_back(repair);
      const Json report = report_of(all);
      EXPECT_EQ(report["engine"], engine);
      expect_exact_report(report, 20);
    }
  }
}

TEST(Classifiers, run_by_their_names_and_exact_ones_end_certified)
{
  const Words arguments = {"brownian", "--points",    "300",  "--frames",
                           "20",       "--time-step", "0.01", "--classifier"};
  const auto report_under = [&](const std::string& classifier) {
    Words all = arguments;
    all.push_back(classifier);
    return report_of(all);
  };
  for (const char* name : {"circumcircle", "safe_region", "refined:safe_region+circumcircle",
                           "refined:circumcircle+safe_region"}) {
    SCOPED_TRACE(name);
    const Json report = report_under(name);
    EXPECT_EQ(report["repair"], "flip_and_splice");
    expect_exact_report(report, 20);
  }
  for (const char* name :
       {"point_distance", "inflation_aware:0.9", "voronoi_circumcenter",
        "voronoi_circumcenter_estimated", "voronoi_edge_length:0.3", "random:0.1",
        "refined:point_distance:1e+0+voronoi_circumcenter", "refined:circumcircle+random:0.5"}) {
    SCOPED_TRACE(name);
    const Json report = report_under(name);
    EXPECT_EQ(report["exact"], false);
    EXPECT_EQ(report["repair"], "splice");
    EXPECT_EQ(report["valid_frames"], 20);
    EXPECT_GT(report["mcc_min"], 0.7);
  }
  EXPECT_EQ(report_under("nearly_delaunay")["repair"], "flip_and_splice");
  EXPECT_EQ(report_under("nearly_delaunay")["parameter"], 0.05);
}

TEST(Classifiers, that_are_refined_are_reported_with_both_of_their_parts)
{
  const Words arguments = {
      "--points", "200", "--frames", "20", "--classifier", "refined:point_distance+random:0.5",
      "--seed",   "3"};
  const Json report = report_of(arguments);
  EXPECT_EQ(report["classifier"], "refined");
  EXPECT_EQ(report["parameter"], "point_distance:0.7+random:0.5");
  EXPECT_EQ(report["seed"], 3);
  const Outcome outcome = run_program(arguments);
  EXPECT_TRUE(contains(outcome.output, "refined:point_distance:0.7+random:0.5 (heuristic)"));
}

TEST(Policies, run_by_their_names_and_are_reported)
{
  const Words arguments = {"brownian", "--points",    "300", "--frames",
                           "20",       "--time-step", "0.3", "--policy"};
  const auto report_under = [&](const std::string& policy) {
    Words all = arguments;
    all.push_back(policy);
    const Json report = report_of(all);
    expect_exact_report(report, 20);
    return report;
  };
  const Json dynamic = report_under("always_dynamic");
  EXPECT_EQ(dynamic["policy"], "always_dynamic");
  EXPECT_TRUE(dynamic["policy_parameter"].is_null());
  EXPECT_FALSE(dynamic["rebuild_reasons"].contains("policy"));
  EXPECT_EQ(report_under("always_static")["rebuild_reasons"]["policy"], 20);
  const Json key_frames = report_under("key_frames:4");
  EXPECT_EQ(key_frames["policy"], "key_frames");
  EXPECT_EQ(key_frames["policy_parameter"], 4);
  EXPECT_EQ(key_frames["rebuild_reasons"]["policy"], 5);
  EXPECT_EQ(report_under("key_frames")["policy_parameter"], 10);
  const Json hybrid = report_under("hybrid");
  EXPECT_EQ(hybrid["policy"], "hybrid");
  EXPECT_GT(hybrid["rebuild_reasons"]["policy"], 15);
  EXPECT_EQ(report_of({"--frames", "3"})["policy"], "always_dynamic");
}

TEST(Policies, certify_the_key_frames_of_a_heuristic)
{
  const Words arguments = {"dam_break",    "--points", "300",      "--frames",    "40",
                           "--classifier", "random:0", "--policy", "key_frames:8"};
  const Json report = report_of(arguments);
  EXPECT_EQ(report["exact"], false);
  EXPECT_EQ(report["rebuilds"], 5);
  EXPECT_GE(report["certified_frames"], 5);
  const Outcome outcome = run_program(arguments);
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
  for (const char* word : {"dam_break", "point_distance", "flip_and_splice", "key_frames:K",
                           "bowyer_watson", "--time-step", "--vtk", "ParaView", "--xyz", "--lammps",
                           "--every", "doc/Dynamic_Delaunay_triangulation_2/Scenario_files.txt"}) {
    EXPECT_TRUE(contains(outcome.output, word)) << word;
  }
  EXPECT_TRUE(run_program({"--version"}).succeeded);
}

TEST(Mistakes, in_a_name_are_answered_with_the_names_that_exist)
{
  expect_refusal({"no_such_scenario"}, {"no_such_scenario", "dam_break", "spinning"});
  expect_refusal({"no_such_file.csv"}, {"no_such_file.csv"});
  expect_refusal({"--classifier", "oracle"},
                 {"oracle", "circumcircle", "safe_region", "point_distance", "inflation_aware",
                  "voronoi_circumcenter", "voronoi_circumcenter_estimated", "voronoi_edge_length",
                  "nearly_delaunay", "random", "refined:FIRST+SECOND"});
  expect_refusal({"--classifier", "refined:oracle+circumcircle"}, {"oracle", "safe_region"});
  expect_refusal({"--classifier", "refined:circumcircle"}, {"takes two", "safe_region"});
  for (const char* name : {"refined", "refined:", "refined:1", "refined:1+1", "refined:+"}) {
    expect_refusal({"--classifier", name}, {"safe_region", "refined:FIRST+SECOND"});
  }
  expect_refusal({"--classifier", "refined:circumcircle+refined:random+random"},
                 {"no refined classifier", "safe_region"});
  expect_refusal({"--repair", "glue"}, {"glue", "splice", "flip", "relocate", "rebuild"});
  for (const char* name : {"sometimes", "", "Hybrid"}) {
    expect_refusal({"--policy", name}, {name, "always_dynamic", "always_static", "hybrid",
                                        "key_frames:K", "from 1 to 1000000"});
  }
  expect_refusal({"--engine", "steam"},
                 {"--engine", "steam", "guibas_stolfi", "insertion", "bowyer_watson"});
  expect_refusal({"--packing", "round"}, {"round", "square", "hexagonal"});
  expect_refusal({"--speed", "1"}, {"--speed"});
}

TEST(Mistakes, in_a_number_are_answered_with_its_range)
{
  expect_refusal({"--classifier", "point_distance:1.5"}, {"point_distance", "1.5", "from 0 to 1"});
  expect_refusal({"--classifier", "point_distance:nan"}, {"nan", "from 0 to 1"});
  expect_refusal({"--classifier", "random:-0.1"}, {"random", "-0.1", "from 0 to 1"});
  expect_refusal({"--classifier", "random:"}, {"random", "from 0 to 1"});
  for (const char* name :
       {"circumcircle", "safe_region", "voronoi_circumcenter", "voronoi_circumcenter_estimated"}) {
    expect_refusal({"--classifier", std::string(name) + ":1"},
                   {std::string(name) + " takes no parameter"});
  }
  for (const char* name : {"inflation_aware", "voronoi_edge_length", "nearly_delaunay"}) {
    for (const char* value : {"-0.1", "1.01", "nan", "", "x"}) {
      expect_refusal({"--classifier", std::string(name) + ":" + value},
                     {name, value, "from 0 to 1"});
    }
  }
  expect_refusal({"--classifier", "refined:circumcircle+random:2"}, {"random", "2", "from 0 to 1"});
  for (const char* value : {"0", "-1", "1000001", "2.5", "", "x"}) {
    expect_refusal({"--policy", std::string("key_frames:") + value},
                   {"key_frames", value, "from 1 to 1000000"});
  }
  for (const char* name : {"always_dynamic", "always_static", "hybrid"}) {
    expect_refusal({"--policy", std::string(name) + ":1"}, {name, "takes no parameter"});
  }
  expect_refusal({"--frames", "-1"}, {"--frames", "-1", "from 0"});
  expect_refusal({"--frames", "ten"}, {"--frames", "ten"});
  expect_refusal({"--points", "0"}, {"--points", "from 1"});
  expect_refusal({"--points", "99999999999999999999"}, {"--points"});
  expect_refusal({"--padding", "-1"}, {"--padding", "from 0"});
  expect_refusal({"--threads", "0"}, {"--threads", "from 1"});
  for (const char* time_step : {"0", "-1", "nan", "inf", "1e300", "fast"}) {
    expect_refusal({"--time-step", time_step}, {"--time-step", time_step});
  }
}

TEST(Mistakes, in_a_file_are_answered_with_their_place)
{
  expect_refusal({write_file("broken.json", "{\n  \"name\": oops\n}\n")},
                 {"broken.json", "line 2", "column"});
  expect_refusal({write_file("nan.csv", "frame,time,id,x,y\n0,0,1,2,3\n0,0,2,nan,3\n")},
                 {"nan.csv", "line 3", "id 2", "nan"});
  const std::string dump = small_dump();
  expect_refusal({write_file("cut.lammpstrj", dump.substr(0, dump.size() - 15))},
                 {"cut.lammpstrj"});
}

} // namespace
