// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program run_scenario, run as a user runs it, and small recordings for it.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SCENARIO_PROGRAM_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SCENARIO_PROGRAM_H

#include "scenario_runner/Recorded_motion.h"
#include "temporary_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

using Json = nlohmann::json;
using Words = std::vector<std::string>;

inline std::size_t number_of_lines(const std::string& text)
{
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

inline bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

inline Words with(Words arguments, const Words& more)
{
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

struct Outcome
{
  bool succeeded;
  std::string output;
  std::string errors;
};

inline Outcome run_program(const Words& arguments, const std::string& directory = ".")
{
  const std::string output = temporary_path("output");
  const std::string errors = temporary_path("errors");
  std::string command = "cd \"" + directory + "\" && \"" RUN_SCENARIO "\"";
  for (const std::string& argument : arguments) {
    command += " \"" + argument + "\"";
  }
  command += " > \"" + output + "\" 2> \"" + errors + "\"";
  const bool succeeded = std::system(command.c_str()) == 0;
  return {succeeded, content_of(output), content_of(errors)};
}

// The program succeeds, and says nothing.
inline void run_quietly(const Words& arguments)
{
  const Outcome outcome = run_program(with(arguments, {"--quiet"}));
  EXPECT_TRUE(outcome.succeeded);
  EXPECT_EQ(outcome.output + outcome.errors, "");
}

inline Json report_of(const Words& arguments)
{
  const std::string path = temporary_path("report.json");
  std::filesystem::remove(path);
  run_quietly(with(arguments, {"--report", path}));
  return Json::parse(content_of(path));
}

inline void expect_exact_report(const Json& report, std::size_t frames)
{
  EXPECT_EQ(report["exact"], true);
  EXPECT_EQ(report["frames"], frames);
  EXPECT_EQ(report["certified_frames"], frames);
  EXPECT_EQ(report["valid_frames"], frames);
  EXPECT_EQ(report["mcc_min"], 1.0);
  EXPECT_EQ(report["mcc_mean"], 1.0);
}

inline void expect_equal_recordings(const scenario::Recording& frames,
                                    const scenario::Recording& others)
{
  ASSERT_EQ(frames.size(), others.size());
  for (std::size_t i = 0; i != others.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(frames[i].number, others[i].number);
    EXPECT_EQ(frames[i].ids, others[i].ids);
    EXPECT_EQ(frames[i].time, others[i].time);
    EXPECT_EQ(frames[i].cell, others[i].cell);
    ASSERT_EQ(frames[i].points.size(), others[i].points.size());
    for (std::size_t j = 0; j != others[i].points.size(); ++j) {
      EXPECT_EQ(frames[i].points[j].x, others[i].points[j].x);
      EXPECT_EQ(frames[i].points[j].y, others[i].points[j].y);
    }
  }
}

// Frames of no point, one, two, three points on a line, four, and the four with one of them moved.
inline std::string small_dump()
{
  const std::vector<Words> frames = {{},
                                     {"1 0 0"},
                                     {"1 0 0", "2 1 0"},
                                     {"1 0 0", "2 1 0", "3 2 0"},
                                     {"1 0 0", "2 1 0", "3 2 0", "4 1 2"},
                                     {"1 0 0", "2 1 0.5", "3 2 0", "4 1 2"}};
  std::string text;
  for (std::size_t frame = 0; frame != frames.size(); ++frame) {
    text += "ITEM: TIMESTEP\n" + std::to_string(frame) + "\nITEM: NUMBER OF ATOMS\n" +
            std::to_string(frames[frame].size()) +
            "\nITEM: BOX BOUNDS ff ff ff\n0 2\n0 2\n0 1\nITEM: ATOMS id x y\n";
    for (const std::string& atom : frames[frame]) {
      text += atom + "\n";
    }
  }
  return text;
}

// Five points of which the last comes and goes.
inline std::string small_csv()
{
  const Words points = {"0,0", "4,0", "4,4", "0,4", "2,1."};
  std::string text = "frame,time,id,x,y\n";
  for (std::size_t frame = 0; frame != 8; ++frame) {
    const std::string number = std::to_string(frame);
    const std::size_t size = frame == 3 || frame == 4 ? 4 : 5;
    for (std::size_t id = 0; id != size; ++id) {
      text += number + "," + number + "," + std::to_string(id) + "," + points[id] +
              (id == 4 ? number : "") + "\n";
    }
  }
  return text;
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SCENARIO_PROGRAM_H
