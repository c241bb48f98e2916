// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Recordings as other programs write them: the files in `dialects` are made by the documentation or
// the source of these programs.

#include "recording_text.h"
#include "scenario_errors.h"
#include "scenario_runner/Recorded_motion.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace {

using namespace scenario;

std::string read_dialect(const std::string& name)
{
  return text_of(read_recording(DIALECTS_FOLDER "/" + name));
}

std::string read_table(const std::string& text, const std::string& columns = "")
{
  return text_of(
      parse_csv("file", text, columns.empty() ? Table_columns() : table_columns(columns)));
}

void expect_refused_table(const std::string& text, const std::string& columns, std::size_t line,
                          const Words& words)
{
  SCOPED_TRACE(text + columns);
  const Scenario_error error = error_of_call([&] { read_table(text, columns); });
  EXPECT_EQ(error.line(), line) << error.what();
  expect_words(error, words);
}

std::string dump(const std::string& timestep, const std::string& box = "pp pp pp",
                 const std::string& columns = "id x y")
{
  return "ITEM: TIMESTEP\n" + timestep + "\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS " + box +
         "\n0 10\n0 8\n-0.5 0.5\nITEM: ATOMS " + columns + "\n7 1 2\n";
}

TEST(Dialect, of_ase)
{
  EXPECT_EQ(read_dialect("ase.extxyz"), "0 t=0 [(0 0) (10 0) (0 8) pf] 0:(0.5 1.25) 1:(9.9 1)\n"
                                        "1 t=1 [(0 0) (10 0) (0 8) pf] 0:(0.5 1.5) 1:(0.3 1)\n");
}

TEST(Dialect, of_ovito_in_xyz)
{
  EXPECT_EQ(read_dialect("ovito.xyz"),
            "0 t=0 [(-5 -4) (10 0) (2 8) pp] 3:(2.5 -3.75) 7:(-4.5 1.25)\n");
}

TEST(Dialect, of_ovito_in_lammps)
{
  EXPECT_EQ(read_dialect("ovito.dump"),
            "500 t=500 [(-5 -4) (10 0) (2 8) pp] 3:(2.5 -3.75) 7:(-4.5 1.25)\n");
}

TEST(Dialect, of_mdanalysis)
{
  EXPECT_EQ(read_dialect("mdanalysis.xyz"),
            "0 t=0 0:(0.5 1.25) 1:(2 1.5)\n1 t=1 0:(0.75 1.25) 1:(1.875 1.5)\n");
}

TEST(Dialect, of_lammps_custom_by_its_usual_file_name)
{
  EXPECT_EQ(read_dialect("dump.shear"),
            "0 t=0 [(0 0) (10 0) (2 8) pp] 1:(0.5 1.25) 2:(9.875 1)\n"
            "100 t=0.5 [(0 0) (10 0) (2.5 8) pp] 1:(0.5 1.25) 2:(0.25 1)\n");
}

TEST(Dialect, of_lammps_atom_by_its_usual_file_name)
{
  EXPECT_EQ(read_dialect("dump.melt"), "250 t=250 [(-1 10) (4 0) (0 10) pf] 1:(1 12.5) 2:(2 15)\n");
}

TEST(Dialect, of_jupedsim)
{
  EXPECT_EQ(read_dialect("jupedsim.txt"), "0 t=0 1:(3.5 3.25) 2:(4.5 4.75)\n8 t=8 1:(3.75 3.25)\n");
}

TEST(Dialect, of_pedpy_without_a_header)
{
  EXPECT_EQ(read_dialect("pedpy.txt"),
            "120 t=120 1:(0.5 1.25) 2:(2 1.5)\n125 t=125 1:(0.75 1.25)\n");
}

TEST(Dialect, of_petrack)
{
  EXPECT_EQ(read_dialect("petrack.txt"), read_dialect("pedpy.txt"));
}

TEST(Dialect, of_trackpy)
{
  EXPECT_EQ(read_dialect("trackpy.csv"),
            "0 t=0 0:(0.5 1.25) 1:(2 1.5)\n3 t=3 0:(0.75 1.25) 1:(1.875 1.5)\n");
}

TEST(Dialect, of_trackmate)
{
  EXPECT_EQ(read_dialect("trackmate.csv"),
            "3 t=1.5 1:(23.25 57.5) 4:(31.5 12.125)\n4 t=2 1:(23.5 57.25)\n");
}

TEST(Dialect, of_viswalk)
{
  EXPECT_EQ(read_dialect("viswalk.pp"), "0 t=0.2 1:(0.5 1.25) 2:(2 1.5)\n1 t=0.4 1:(0.75 1.25)\n");
}

TEST(Dialect, of_mtrackj)
{
  EXPECT_EQ(read_dialect("mtrackj.mdf"),
            "1 t=1 1:1:(187.5 263.25)\n2 t=2 1:1:(188.5 264) 2:1:(310 15.5)\n");
}

TEST(Dialect, of_mtrackj_in_a_table_of_points)
{
  EXPECT_EQ(read_dialect("mtrackj_points.csv"),
            "0 t=0 1:(187.5 263.25)\n1 t=0.5 1:(188.5 264) 2:(310 15.5)\n");
}

TEST(Trackmate, spots_that_are_in_no_track_are_refused_with_their_line)
{
  const std::string text = content_of(DIALECTS_FOLDER "/trackmate.csv");
  expect_refused_table(text + "ID5,5,,1,30,30,0,0,0,5,1,,1\n", "", 8, {"id ''", "stands for none"});
}

TEST(Mtrackj, tracks_of_one_cluster_have_their_numbers_as_ids)
{
  EXPECT_EQ(
      text_of(parse_mtrackj("file", "MTrackJ 1.5.1 Data File\nAssembly 1\nCluster 4\nTrack 3\n"
                                    "Point 1 1 2 1 9 1\nEnd of MTrackJ Data File\n")),
      "9 t=9 3:(1 2)\n");
}

TEST(Columns, may_be_named_in_their_order)
{
  EXPECT_EQ(read_table("5 1 2 3\n", "frame,id,x,y"), "5 t=5 1:(2 3)\n");
  EXPECT_EQ(read_table("a,b,c,d,e\n5,9,Al,2,3\n", "frame,-,id,y,x"), "5 t=5 Al:(3 2)\n");
  EXPECT_EQ(read_table("0.5;1;2;3;more\n0.25;1;4;5;\n", " Time, ID ,x,y"),
            "0 t=0.25 1:(4 5)\n1 t=0.5 1:(2 3)\n");
}

TEST(Columns, may_be_named_by_their_titles)
{
  EXPECT_EQ(read_table("t,label,id,x,y\n5,1,8,2,3\n", "frame=t,id=label"), "5 t=5 1:(2 3)\n");
  EXPECT_EQ(
      read_table("Step;who;east (m);north (m)\n5;Al;2;3\n", "frame=step,id=who,x=east,y=north"),
      "5 t=5 Al:(2 3)\n");
  EXPECT_EQ(read_table("t,id,x,y\n0.5,1,2,3\n", "time=t"), "0 t=0.5 1:(2 3)\n");
  EXPECT_EQ(read_table("ID,TRACK_ID,POSITION_X,POSITION_Y,FRAME\n8,1,2,3,5\n", "id=ID"),
            "5 t=5 8:(2 3)\n");
}

TEST(Columns, that_are_not_there_are_refused)
{
  expect_refused_table("frame,id,x,y\n0,1,2,3\n", "id=label", 1,
                       {"no column 'label'", "'id'", "4 columns"});
  expect_refused_table("5 1 2\n", "frame,id,x,y", 1, {"3 fields", "4 columns were named"});
  expect_words(error_of_call([] {
                 parse_recording("a.xyz", "1\n\nX 1 2 0\n", table_columns("frame,id,x,y"));
               }),
               {"no table"});
}

TEST(Columns, that_are_named_wrongly_are_refused_with_what_is_allowed)
{
  for (const std::string text : {"", "frame", "frame,id,x", "frame,id,x,y,x", "frame,id,x,z",
                                 "frame=t,id", "frame=", "-=t", "id=a,id=b", "frame,id,x,y,"}) {
    SCOPED_TRACE(text);
    EXPECT_THROW(table_columns(text), std::invalid_argument);
  }
}

TEST(Formats, are_known_by_the_content_whatever_the_name)
{
  const std::string text = "7 t=7 [(0 0) (10 0) (0 8) pp] 7:(1 2)\n";
  for (const std::string name : {"dump.shear", "shear.dump.7", "shear", "shear.txt", "7.xyz"}) {
    EXPECT_EQ(text_of(read_recording(write_file(name, "\xEF\xBB\xBF\n" + dump("7")))), text)
        << name;
  }
  EXPECT_EQ(text_of(parse_recording("path.trj", " 1 \nremark\nX 1 2 0\n")), "0 t=0 0:(1 2)\n");
  EXPECT_EQ(text_of(parse_recording("standard input", "frame,id,x,y\n5,1,2,3\n")),
            "5 t=5 1:(2 3)\n");
}

TEST(Formats, that_are_unknown_are_refused_with_those_that_are_known)
{
  const Scenario_error error = error_of_call([] { parse_recording("picture.PNG", "\x89PNG\r\n"); });
  expect_words(error, {"'.PNG'", ".csv", ".pp", ".lammpstrj", ".mdf", ".gz"});
}

} // namespace
