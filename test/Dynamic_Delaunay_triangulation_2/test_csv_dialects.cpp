// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Tables of positions as other programs write them, where cases/*csv.txt do not say it.

#include "recording_text.h"
#include "scenario_errors.h"
#include "scenario_runner/Recorded_motion.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#ifdef SCENARIO_HAS_ZLIB
#include <zlib.h>
#endif

namespace {

using namespace scenario;

TEST(Separators, are_found_in_the_header)
{
  for (const std::string separator : {",", ";", "\t", " ", "  ", " \t ", ", ", " ; "}) {
    SCOPED_TRACE("'" + separator + "'");
    std::string text = "frame,time,id,x,y\n0,0.5,7,1,2\n0,0.5,8,3,4\n1,0.75,7,1.5,2\n"
                       "1,0.75,8,3,-4\n";
    for (std::size_t place = 0; (place = text.find(',', place)) != std::string::npos;) {
      text.replace(place, 1, separator == "," ? ",  " : separator);
      place += separator == "," ? 3 : separator.size();
    }
    EXPECT_EQ(text_of(parse_csv("file", text)),
              "0 t=0.5 7:(1 2) 8:(3 4)\n1 t=0.75 7:(1.5 2) 8:(3 -4)\n");
  }
}

TEST(Names, that_are_long_and_strange_are_not_all_in_the_message)
{
  std::string header;
  for (int column = 0; column != 50; ++column) {
    header += std::string(30, '\x01') + ',';
  }
  const Scenario_error error = error_of_call([&] { parse_csv("file", header + "\n"); });
  EXPECT_LT(std::string(error.what()).size(), 500u);
}

TEST(Extensions, of_tables_are_csv_tsv_and_txt)
{
  for (const std::string name : {"a.csv", "a.tsv", "a.txt", "a.CSV"}) {
    EXPECT_EQ(open_motion(write_file(name, "frame\tid\tx\ty\n0\t7\t1\t2\n"))->name(), "a");
  }
  expect_words(error_of("a.xls.gz"), {"'.xls'", ".tsv", ".txt", ".gz"});
}

#ifdef SCENARIO_HAS_ZLIB

std::string zipped(const std::string& text)
{
  const std::string path = temporary_path("zipped");
  const gzFile file = gzopen(path.c_str(), "wb");
  EXPECT_EQ(gzwrite(file, text.data(), static_cast<unsigned>(text.size())),
            static_cast<int>(text.size()));
  EXPECT_EQ(gzclose(file), Z_OK);
  return content_of(path);
}

std::string many_rows()
{
  std::string text = "frame,id,x,y\n";
  for (int row = 0; row != 20000; ++row) {
    text += std::to_string(row) + ",7," + std::to_string(row * row % 977) + ",1\n";
  }
  return text;
}

TEST(Gzip, is_read_whatever_is_in_it)
{
  const auto motion = open_motion(write_file("motion.csv.gz", zipped(many_rows())));
  EXPECT_EQ(motion->name(), "motion");
  EXPECT_EQ(motion->frames(), 19999u);
  const std::string dump = "ITEM: TIMESTEP\n4\nITEM: NUMBER OF ATOMS\n0\nITEM: ATOMS id x y\n";
  EXPECT_EQ(open_motion(write_file("motion.dump.gz", zipped(dump)))->time(), 4.0);
  const std::string cloud = R"({"name": "cloud", "kind": "brownian", "seed": 1, "frames": 10,
    "time_step": 0.01, "points": 5, "box": [1, 1]})";
  EXPECT_EQ(open_motion(write_file("cloud.json.gz", zipped(cloud)))->points().size(), 5u);
}

TEST(Gzip, may_have_several_members)
{
  const std::string path =
      write_file("two.csv.gz", zipped("frame,id,x,y\n0,7,1,2\n") + zipped("1,7,3,4\n"));
  EXPECT_EQ(text_of(read_csv_motion(path)), "0 t=0 7:(1 2)\n1 t=1 7:(3 4)\n");
}

TEST(Gzip, that_is_truncated_is_refused_with_the_line_that_it_reaches)
{
  const std::string whole = zipped(many_rows());
  const Scenario_error early =
      error_of(write_file("cut.csv.gz", whole.substr(0, whole.size() / 2)));
  expect_words(early, {"cut.csv.gz, line ", "gzip stream ends too early"});
  EXPECT_GT(early.line(), 1000u);
  EXPECT_LT(early.line(), 19000u);
  const Scenario_error late = error_of(write_file("cut.csv.gz", whole.substr(0, whole.size() - 1)));
  expect_words(late, {"ends too early"});
  EXPECT_EQ(late.line(), 20002u);
  EXPECT_EQ(error_of(write_file("cut.csv.gz", whole.substr(0, 2))).line(), 1u);
}

TEST(Gzip, that_is_damaged_or_goes_on_is_refused)
{
  std::string wrong = zipped(many_rows());
  wrong[wrong.size() - 6] = static_cast<char>(wrong[wrong.size() - 6] ^ 1); // of its checksum
  expect_words(error_of(write_file("wrong.csv.gz", wrong)), {"is damaged", "data check"});
  expect_words(error_of(write_file("more.csv.gz", zipped("frame,id,x,y\n0,1,2,3\n") + "a")),
               {"line 3", "something else follows"});
}

#else

TEST(Gzip, is_refused_with_the_way_out)
{
  expect_words(error_of(write_file("motion.csv.gz", "\x1F\x8B\x08")),
               {"compressed by gzip", "without zlib", "gzip -d"});
}

#endif

} // namespace
