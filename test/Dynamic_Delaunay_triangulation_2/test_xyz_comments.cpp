// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The second lines of frames in extended XYZ files, by the whole grammar of the format.

#include "recording_text.h"
#include "scenario_errors.h"
#include "scenario_runner/Recorded_motion.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace {

using namespace scenario;

std::string read_frame(const std::string& comment, const std::string& row = "X 1 2 0")
{
  SCOPED_TRACE(comment);
  return text_of(parse_xyz("file", "1\n" + comment + "\n" + row + "\n"));
}

void expect_refused(const std::string& comment, const Words& words, std::size_t line = 2,
                    const std::string& row = "X 1 2 0")
{
  SCOPED_TRACE(comment);
  const Scenario_error error = error_of_call([&] { read_frame(comment, row); });
  EXPECT_EQ(error.line(), line) << error.what();
  expect_words(error, words);
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
  expect_refused("Lattice=\"1D1 0 0 0 1DD1 0 0 0 1\"", {"not a number"});
  expect_refused("Time=1D999", {"out of range"});
  expect_refused("", {"x 'dark' is not a number"}, 3, "X dark 2 0");
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

TEST(Xyz_comment, with_a_key_that_has_no_value_is_refused)
{
  const std::string lattice = " \"10 0 0 0 10 0 0 0 10\"";
  for (const std::string key : {"Lattice", "lattice", "LATTICE", "Lattice:"}) {
    expect_refused(key + lattice, {"no value"});
  }
  expect_refused("Lattice=" + lattice + " pbc", {"'pbc' has no value", "'pbc=...'"});
  expect_refused("Lattice=" + lattice + " Origin -1 0 0", {"'Origin' has no value"});
  expect_refused("Lattice=" + lattice + " Time 5", {"'Time' has no value"});
  expect_refused("Lattice", {"'Lattice' has no value"});
  expect_refused("Lattice=", {"'Lattice' has no value"});
  expect_refused("Properties species:S:1:id:I:1:pos:R:3", {"'Properties' has no value"});
  expect_refused("properties species:S:1:id:I:1:pos:R:3", {"'properties' has no value"});
  expect_refused("pbc T T F", {"'pbc' has no value"});
  expect_refused("Frame 0 cell_orig 0 0 0 cell_vec1 1 0 0 pbc 1 1 1", {"'pbc' has no value"});
}

TEST(Xyz_comment, with_a_key_that_is_hidden_is_refused)
{
  const std::string value = "\"10 0 0 0 10 0 0 0 10\"";
  for (const std::string line :
       {"name=gasLattice=", "name= Lattice=", "name=a\"b Lattice=", "(Lattice=", "Lattice'=",
        "Lattice\xC2\xA0=", "name=\"half Lattice=", "a=[1, 2 Lattice=", "name=x;Lattice=",
        "={Lattice="}) {
    SCOPED_TRACE(line);
    expect_words(error_of_call([&] { read_frame(line + value); }), {"line 2"});
  }
  expect_refused("Lattice=" + value + " Lattice=" + value, {"'Lattice' is there twice"});
  expect_refused("Lattice=" + value + " lattice=" + value, {"'lattice' is there twice"});
}

TEST(Xyz_comment, with_a_wrong_value_is_refused)
{
  expect_refused("Lattice=[[10,0,0],[0,10,0]]", {"2 rows", "three"});
  expect_refused("Lattice=[[10,0,0,0,10],[0,0],[0,10]]", {"three of three"});
  expect_refused("Lattice=[[10,0,0],[0,10,0],[0,0,10]", {"has no end"});
  expect_refused("Lattice=[[10,0,0][0,10,0][0,0,10]]", {"expected rows"});
  expect_refused("Lattice=[[[10,0,0]]]", {"more than two dimensions"});
  expect_refused("Lattice=[10,,0,0,0,10,0,0,0,10]", {"a value is missing"});
  expect_refused("Lattice=\"10 0 0 0 10 0 0 0\"", {"8 numbers instead of 9"});
  expect_refused("Lattice=\"10 0 0 0 10 0 0 0 10", {"has no end"});
  expect_refused("Lattice=\"10 0 0 0 10 0 0 0 10\"5", {"goes on after its end"});
  expect_refused("Lattice=10 0 0 0 10 0 0 0 10", {"1 numbers instead of 9"});
  expect_refused("Time=half", {"time 'half' is not a number"});
  expect_refused("Time=\"1 2\"", {"2 numbers instead of 1"});
  expect_refused("Frame=1.5", {"frame '1.5' is not an integer"});
  expect_refused("Frame=first", {"frame 'first' is not an integer"});
  expect_refused("pbc=T", {"pbc is 'T'"});
  expect_refused("pbc=[[T,T,F]]x", {"goes on after its end"});
}

TEST(Xyz_properties, that_are_wrong_are_refused)
{
  expect_refused("Properties=species:S:1:pos:R:3:pos:R:3", {"'pos'", "once"});
  expect_refused("Properties=id:I:1:id:I:1:pos:R:3", {"'id'", "once"});
  expect_refused("Properties=species:S:1:pos:R:1", {"'pos'", "two or three columns"});
  expect_refused("Properties=species:S:1:pos:S:3", {"'pos'", "type 'S'"});
  expect_refused("Properties=species:X:1:pos:R:3", {"'species'", "type 'X'"});
  expect_refused("Properties=species:S:1:pos:R:3", {"6 fields", "4 columns"}, 3, "X 1 2 0 5 6");
  expect_refused("Properties=pos:R:3:id:I:1", {"3 fields", "4 columns"}, 3, "1 2 7");
  const Scenario_error error =
      error_of_call([] { parse_xyz("file", "2\nProperties=id:I:1:pos:R:3\n7 1 2 0\n8 1 2\n"); });
  expect_words(error, {"line 4", "3 fields", "4 columns"});
}

TEST(Xyz_ids, may_be_text)
{
  EXPECT_EQ(text_of(parse_xyz("file", "2\nProperties=id:S:1:pos:R:2\nZoe 1 2\n7 3 4\n"
                                      "1\nProperties=id:S:1:pos:R:2\n7 5 6\n")),
            "0 t=0 Zoe:(1 2) 7:(3 4)\n1 t=1 7:(5 6)\n");
  expect_words(error_of_call([] {
                 parse_xyz("file", "1\nProperties=id:S:1:pos:R:2\nZoe 1 2\n1\n\nX 1 2 0\n");
               }),
               {"line 5", "ids of some frames are text"});
}

TEST(Xyz_frames, have_their_own_numbers)
{
  EXPECT_EQ(text_of(parse_xyz("file", "1\nFrame=120\nX 1 2 0\n1\nFrame=125 Time=5\nX 3 4 0\n")),
            "120 t=120 0:(1 2)\n125 t=5 0:(3 4)\n");
  const auto expect = [](const std::string& second, const Words& words) {
    const Scenario_error error = error_of_call(
        [&] { parse_xyz("file", "1\nFrame=5\nX 1 2 0\n1\n" + second + "\nX 3 4 0\n"); });
    EXPECT_EQ(error.line(), 5u);
    expect_words(error, words);
  };
  expect("Frame=5", {"Frame 5 follows 5"});
  expect("Frame=4", {"Frame 4 follows 5"});
  expect("", {"no Frame=, those before it have"});
}

} // namespace
