// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Tables of positions as other programs write them.

#include "scenario_errors.h"
#include "scenario_runner/Recorded_motion.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#ifdef SCENARIO_HAS_ZLIB
#include <zlib.h>
#endif

namespace {

using namespace scenario;

// Frames, times, ids and coordinates, in a line each.
std::string content_of(const Recording& recording)
{
  std::ostringstream text;
  for (const Recorded_frame& frame : recording) {
    text << "t=" << frame.time;
    for (std::size_t i = 0; i != frame.ids.size(); ++i) {
      text << ' ' << frame.ids[i] << ":(" << frame.points[i].x << ' ' << frame.points[i].y << ')';
    }
    text << '\n';
  }
  return text.str();
}

std::string read(const std::string& text)
{
  return content_of(parse_csv("file", text));
}

// Two frames of two points.
const std::string two_frames = "t=0.5 7:(1 2) 8:(3 4)\nt=0.75 7:(1.5 2) 8:(3 -4)\n";

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
    EXPECT_EQ(read(text), two_frames);
  }
}

TEST(Separators, are_those_that_find_the_columns_though_others_are_in_further_names)
{
  EXPECT_EQ(read("frame;id;x;y;size a, b, c, d and e\n3;1;4;5;1,2\n"), "t=3 1:(4 5)\n");
  EXPECT_EQ(read("frame\tid\tx\ty\tsize, of head\n3\t1\t4\t5\t\n"), "t=3 1:(4 5)\n");
}

TEST(Tabs, around_empty_fields_count)
{
  EXPECT_EQ(read("\tframe\tid\tx\ty\tremark\n\t3\t1\t4\t5\t\r\n1\t3\t2\t6\t7\tslow\r\n"),
            "t=3 1:(4 5) 2:(6 7)\n");
}

TEST(Quotes, may_be_around_names_and_values)
{
  EXPECT_EQ(read("\"frame\",\"time\",\"id\",\"x\",\"y\"\n\"0\",\"0.5\",\"7\",\"1\",\"2\"\n"
                 "0 , \"0.5\" ,8,\"3\", 4\n1,0.75,7,1.5,2\n1,0.75,8,\"3\",\"-4\"\n"),
            two_frames);
  EXPECT_EQ(read("\"frame\"\t\"id\"\t\"x\"\t\"y\"\n0\t\"7\"\t1\t2\n"), "t=0 7:(1 2)\n");
}

TEST(Quotes, may_have_separators_and_quotes_within)
{
  EXPECT_EQ(read("frame,\"who, and \"\"how\"\"\",id,x,y\n0,\"a, \"\"b\"\", c\",7,1,2\n"),
            "t=0 7:(1 2)\n");
  EXPECT_EQ(read("frame who id x y\n0 \"a b  c\" 7 1 2\n"), "t=0 7:(1 2)\n");
  EXPECT_EQ(read("frame,size,id,x,y\n0,5 1/2\",7,1,2\n"), "t=0 7:(1 2)\n")
      << "a quote in the middle is part of the field";
}

TEST(Comments, may_stand_anywhere)
{
  EXPECT_EQ(read("# recorded in a hall\nframe,id,x,y\n# the first\n0,7,1,2\n  # , \" the second\n"
                 "1,7,3,4\n#"),
            "t=0 7:(1 2)\nt=1 7:(3 4)\n");
}

TEST(Header_in_a_comment, is_the_last_one_before_numbers)
{
  EXPECT_EQ(read("# PeTrack project: hall.pet\n# framerate: 25 fps\n# id frame x/m y/m z/m\n"
                 "1 27 -0.5 3.25 1.75\n1 28 -0.25 3.5 1.75\n2 28 4 5 1.5\n"),
            "t=27 1:(-0.5 3.25)\nt=28 1:(-0.25 3.5) 2:(4 5)\n");
  EXPECT_EQ(read("# description: corridor\n#framerate: 16.00\n# PersID\tFrame\tX\tY\tZ\n"
                 "1\t98\t4.5\t1.5\t1.75\n2 98 5.5 1.25 1.75\n"),
            "t=98 1:(4.5 1.5) 2:(5.5 1.25)\n");
  EXPECT_EQ(read("#ID FR X Y A B\n1 0 2 3 0.5 0.5\n"), "t=0 1:(2 3)\n");
  EXPECT_EQ(read("#frame,id,x,y\n0,a,2,3\n"), "t=0 0:(2 3)\n");
}

TEST(Header_in_a_comment, gives_way_to_one_that_is_none)
{
  EXPECT_EQ(read("# x y id frame\nframe id x y\n1 2 3 4\n"), "t=1 2:(3 4)\n");
}

TEST(Names, may_be_in_any_case_and_have_units)
{
  EXPECT_EQ(read("Frame,Time,ID,X,Y\n0,0.5,7,1,2\n"), "t=0.5 7:(1 2)\n");
  EXPECT_EQ(read("FRAME,time/s,Id,x/m,y/m\n0,0.5,7,1,2\n"), "t=0.5 7:(1 2)\n");
  EXPECT_EQ(read("frame,time [ms],id,x [px],y [px],x/y\n0,0.5,7,1,2,9\n"), "t=0.5 7:(1 2)\n");
  EXPECT_EQ(read("frame,id,x (\xC2\xB5m),y (\xC2\xB5m)\n0,7,1,2\n"), "t=0 7:(1 2)\n");
}

TEST(Names, are_found_in_any_order_after_a_mark_of_the_encoding_and_before_empty_lines)
{
  EXPECT_EQ(read("\xEF\xBB\xBFy, speed ,id,frame,x,time\r\n\r\n2,fast,5,0,+1,9\r\n"),
            "t=9 5:(1 2)\n");
}

TEST(Rows, that_are_sorted_by_id_are_grouped_into_ascending_frames)
{
  EXPECT_EQ(read("frame,time,id,x,y\n10,1,1,0,0\n11,2,1,1,0\n14,5,1,2,0\n9,0,2,0,5\n10,1,2,0,6\n"
                 "14,5,2,0,7"),
            "t=0 2:(0 5)\nt=1 1:(0 0) 2:(0 6)\nt=2 1:(1 0)\nt=5 1:(2 0) 2:(0 7)\n");
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

TEST(Pandas, may_write_its_index)
{
  EXPECT_EQ(read(",frame,id,x,y\n0,0,7,1,2\n1,1,7,3,4\n"), "t=0 7:(1 2)\nt=1 7:(3 4)\n");
  EXPECT_EQ(read("frame,id,x,y,\n0,7,1,2,\n"), "t=0 7:(1 2)\n");
}

TEST(R, may_write_its_row_names)
{
  EXPECT_EQ(read("\"\",\"frame\",\"id\",\"x\",\"y\"\n\"1\",0,7,1,2\n"), "t=0 7:(1 2)\n");
  EXPECT_EQ(read("\"frame\" \"id\" \"x\" \"y\"\n\"1\" 0 7 1 2\n\"2\" 1 7 3 4\n"),
            "t=0 7:(1 2)\nt=1 7:(3 4)\n");
}

TEST(Whole_numbers, may_be_written_as_floating_point)
{
  EXPECT_EQ(read("frame,id,x,y\n1.0,7.0,1,2\n1e1,-8.00,3,4\n+1,9,5,6\n"),
            "t=1 7:(1 2) 9:(5 6)\nt=10 -8:(3 4)\n");
}

TEST(Text_ids, are_numbered_in_the_order_of_their_first_appearance)
{
  EXPECT_EQ(read("frame,id,x,y\n0,Zoe,1,1\n0,Al,2,2\n1,Al,3,3\n1,Bo,4,4\n1,Zoe,5,5\n"),
            "t=0 0:(1 1) 1:(2 2)\nt=1 0:(5 5) 1:(3 3) 2:(4 4)\n");
}

TEST(Text_ids, make_names_of_the_numbers_among_them)
{
  EXPECT_EQ(read("frame,id,x,y\n0,7,1,1\n0,5,2,2\n1,a,3,3\n1,5.0,4,4\n1,7,5,5\n"),
            "t=0 0:(1 1) 1:(2 2)\nt=1 0:(5 5) 1:(4 4) 2:(3 3)\n");
}

TEST(Time, is_the_number_of_the_frame_where_it_is_missing)
{
  EXPECT_EQ(read("id,frame,x,y\n7,-3,1,2\n7,12,3,4\n"), "t=-3 7:(1 2)\nt=12 7:(3 4)\n");
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
  return ::content_of(path);
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
  EXPECT_EQ(content_of(read_csv_motion(path)), "t=0 7:(1 2)\nt=1 7:(3 4)\n");
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
