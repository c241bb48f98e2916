// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What scenarios, recordings and domains mean, or why they are refused, case by case.

#include "case_table.h"
#include "recording_text.h"
#include "scenario_errors.h"
#include "scenario_runner/Polygon_text.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <regex>
#include <string>

namespace {

void read(const std::string& kind, const std::string& text)
{
  if (kind == "wkt") {
    scenario::parse_wkt("file", text);
  } else if (kind == "geojson") {
    scenario::parse_geojson("file", text);
  } else {
    scenario::open_motion(write_file("file." + kind, text));
  }
}

std::size_t line_in(const std::string& message)
{
  std::smatch line;
  return std::regex_search(message, line, std::regex("^file, line (\\d+)"))
             ? std::stoul(line[1].str())
             : 0;
}

class Refused_files : public testing::TestWithParam<std::string>
{
};

TEST_P(Refused_files, say_where_and_why)
{
  const std::string path = temporary_path("file." + GetParam());
  for (const Case& refusal : read_cases(GetParam()).cases) {
    SCOPED_TRACE(refusal.given);
    const scenario::Scenario_error error = error_of_call([&] { read(GetParam(), refusal.given); });
    std::string message = error.what();
    if (message.rfind(path, 0) == 0) {
      message.replace(0, path.size(), "file");
    }
    EXPECT_TRUE(says(message, refusal.expected)) << message << '\n' << refusal.expected;
    EXPECT_EQ(error.line(), line_in(message));
  }
}

class Read_files : public testing::TestWithParam<std::string>
{
};

TEST_P(Read_files, mean_what_they_should)
{
  for (const Case& file : read_cases("read_" + GetParam()).cases) {
    SCOPED_TRACE(file.given);
    EXPECT_EQ(text_of(scenario::parse_recording("file." + GetParam(), file.given)),
              unescaped(file.expected));
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Read_files, testing::Values("csv", "xyz"),
                         [](const auto& kind) { return kind.param; });

INSTANTIATE_TEST_SUITE_P(Of, Refused_files,
                         testing::Values("csv", "dump", "geojson", "json", "mdf", "wkt", "xyz"),
                         [](const auto& kind) { return kind.param; });

} // namespace
