// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The second lines of frames in extended XYZ files, by the whole grammar of the format.

#include "recording_text.h"
#include "scenario_runner/Recorded_motion.h"

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace scenario;

std::string read_frame(const std::string& comment, const std::string& row = "X 1 2 0")
{
  SCOPED_TRACE(comment);
  return text_of(parse_xyz("file", "1\n" + comment + "\n" + row + "\n"));
}

const std::string torus = "0 t=0 [(0 0) (10 0) (0 10) pp] 0:(1 2)\n";
const std::string plane = "0 t=0 0:(1 2)\n";

TEST(Xyz_comment, has_blanks_around_equal_signs)
{
  EXPECT_EQ(read_frame("Lattice = \"10 0 0 0 10 0 0 0 10\""), torus);
  EXPECT_EQ(read_frame("Lattice= \"10 0 0 0 10 0 0 0 10\""), torus);
  EXPECT_EQ(read_frame("Lattice\t =\"10 0 0 0 10 0 0 0 10\"\r"), torus);
  EXPECT_EQ(read_frame("Lattice=\"10 0 0 0 10 0 0 0 10\" pbc = \"F F F\""), plane);
  EXPECT_EQ(read_frame("Properties = species:S:1:id:I:1:pos:R:3", "O 7 1 3 0"), "0 t=0 7:(1 3)\n");
  EXPECT_EQ(read_frame("Properties = species:S:1:id:I:1:pos:R:3", "O 7 1 3"), "0 t=0 7:(1 3)\n");
  EXPECT_EQ(read_frame("Time = 0.5  Frame =120"), "120 t=0.5 0:(1 2)\n");
}

TEST(Xyz_comment, has_arrays_of_all_kinds)
{
  for (const std::string lattice :
       {"[[10,0,0],[0,10,0],[0,0,10]]", "[ [10, 0, 0] , [0, 10, 0], [0, 0, 10] ]",
        "[10,0,0,0,10,0,0,0,10]", "{10 0 0 0 10 0 0 0 10}", "\"10, 0, 0, 0, 10, 0, 0, 0, 10\"",
        "10,0,0,0,10,0,0,0,10", "'10 0 0 0 10 0 0 0 10'", "[10 0 0 0 10 0 0 0 10]"}) {
    EXPECT_EQ(read_frame("Lattice=" + lattice), torus);
  }
  for (const std::string pbc :
       {"[T,F,F]", "[ True , false, F ]", "{T F T}", "\"TRUE F F\"", "1,0,0", "[1, 0, 1]"}) {
    EXPECT_EQ(read_frame("Lattice=\"10 0 0 0 10 0 0 0 10\" pbc=" + pbc),
              "0 t=0 [(0 0) (10 0) (0 10) pf] 0:(1 2)\n");
  }
  EXPECT_EQ(read_frame("Time=[0.5]"), "0 t=0.5 0:(1 2)\n");
}

TEST(Xyz_comment, has_numbers_of_fortran)
{
  EXPECT_EQ(
      read_frame("Lattice=\"1.0D1 0 0 0 +1d+1 0 0 0 1.\" Origin={-.5D0 0. 0}", "X 1.0D0 20D-1 0"),
      "0 t=0 [(-0.5 0) (10 0) (0 10) pp] 0:(1 2)\n");
}

TEST(Xyz_comment, has_quotes_in_quotes)
{
  EXPECT_EQ(read_frame("name=\"the \\\"Lattice = 5\\\" run\\\\\" Lattice=\"10 0 0 0 10 0 0 0 10\""),
            torus);
  EXPECT_EQ(read_frame("name=\"pbc=\\\"T T T\\\"\""), plane);
  EXPECT_EQ(read_frame("\"Lattice\" = \"10 0 0 0 10 0 0 0 10\""), torus);
  EXPECT_EQ(
      read_frame("names=[\"a]\", \"Lattice=1, b\"] sets={ {1} Lattice=[[10,0,0],[0,10,0],[0,0,1]]"),
      torus);
}

TEST(Xyz_comment, has_flags_and_other_keys)
{
  EXPECT_EQ(read_frame("relaxed Lattice=\"10 0 0 0 10 0 0 0 10\" a=1 a=2 energy=-3.5e2 done"),
            torus);
  EXPECT_EQ(read_frame("LATTICE=\"10 0 0 0 10 0 0 0 10\" PBC=\"T T T\""), torus);
  EXPECT_EQ(read_frame("Lattice=\"10 0 0 0 10 0 0 0 10\"pbc=\"T T T\""), torus);
}

TEST(Xyz_comment, may_be_a_remark)
{
  for (const std::string remark :
       {"", "any words, and an equation=\"of state\"", "frame 0 | Written by a program",
        "Fcc Al oriented X=[100], Y=[010], Z=[001].", "an FCC lattice of 'atoms", "time 0.5",
        "it's \"half open", "= =", "energy = -5 [eV"}) {
    EXPECT_EQ(read_frame(remark), plane);
  }
  EXPECT_EQ(read_frame(" i =        5, time =        0.500, E =       -17.16"),
            "0 t=0.5 0:(1 2)\n");
}

TEST(Xyz_ids, may_be_text)
{
  EXPECT_EQ(text_of(parse_xyz("file", "2\nProperties=id:S:1:pos:R:2\nZoe 1 2\n7 3 4\n"
                                      "1\nProperties=id:S:1:pos:R:2\n7 5 6\n")),
            "0 t=0 Zoe:(1 2) 7:(3 4)\n1 t=1 7:(5 6)\n");
}

TEST(Xyz_frames, have_their_own_numbers)
{
  EXPECT_EQ(text_of(parse_xyz("file", "1\nFrame=120\nX 1 2 0\n1\nFrame=125 Time=5\nX 3 4 0\n")),
            "120 t=120 0:(1 2)\n125 t=5 0:(3 4)\n");
}

} // namespace
