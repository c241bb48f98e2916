// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How the scenario runner and the benchmarks write numbers, tables, and comma separated values.

#include "scenario_runner/Csv_writer.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Table.h"
#include "temporary_files.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Decimal_number.h>

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <optional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace {

std::string text_of(const run::Table& table)
{
  std::ostringstream out;
  table.write(out);
  return out.str();
}

TEST(Numbers, are_read_as_the_same_again)
{
  constexpr double most = (std::numeric_limits<double>::max)();
  for (const double value : {0.1, 1.0 / 3.0, -1e-300, 154 * 0.3, most}) {
    EXPECT_EQ(std::stod(run::number_text(value)), value);
  }
  EXPECT_EQ(run::number_text(0.1), "0.1");
}

// Reads a number as with standard libraries that have no std::from_chars() for doubles, and
// compares the result with that of this standard library.
double read_as_standard(const std::string& text)
{
  const char* const beyond = text.data() + text.size();
  double expected = 7, read = 7;
  const auto standard = std::from_chars(text.data(), beyond, expected);
  const auto ours = CGAL::Dynamic_Delaunay_triangulations_2::internal::read_decimal_number(
      text.data(), beyond, read);
  EXPECT_EQ(ours.ec, standard.ec) << text;
  EXPECT_EQ(ours.ptr, standard.ptr) << text;
  EXPECT_EQ(read, expected) << text;
  return read;
}

TEST(Numbers, are_read_and_written_the_same_without_the_standard_librarys_functions)
{
  namespace decimal = CGAL::Dynamic_Delaunay_triangulations_2::internal;
  constexpr double least = std::numeric_limits<double>::denorm_min();
  constexpr double most = (std::numeric_limits<double>::max)();
  std::mt19937_64 random(1);
  std::vector<double> values = {0.0, -0.0, 0.1, 1.0 / 3.0, -1e-300, 154 * 0.3, 1e22, least, -most};
  while (values.size() < 10000) {
    const std::uint64_t bits = random();
    double value;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) {
      values.push_back(value);
    }
  }
  for (const double value : values) {
    const std::string shortest = decimal::shortest_decimal_number(value);
    EXPECT_EQ(std::signbit(value), shortest.front() == '-') << shortest;
    for (const std::string& text :
         {shortest, run::number_text(value), run::number_text(value, 5)}) {
      EXPECT_TRUE(read_as_standard(text) == value || text != shortest) << text;
    }
  }
}

TEST(Numbers, end_where_the_standard_library_says_without_its_functions)
{
  for (const std::string text :
       {"", "-", ".", "e5", "+1", " 1", "0x10", "1e", "1e+", "1.5e-x", "12.5.7", "-.5", "3.",
        "1e400", "-1e-400", "1e-310", "010", "1,5"}) {
    read_as_standard(text);
  }
}

TEST(Numbers, are_rounded_where_that_is_asked_for)
{
  EXPECT_EQ(run::number_text(154 * 0.3, 12), "46.2");
  EXPECT_EQ(run::fixed_text(2.0 / 3.0, 2), "0.67");
  EXPECT_EQ(run::readable(123456.0), "123000");
  EXPECT_EQ(run::readable(0.012345), "0.01");
  EXPECT_EQ(run::readable(std::nullopt), "-");
  EXPECT_EQ(run::readable_validity(0.99999999), "0.999999");
}

TEST(Tables, have_columns_as_wide_as_their_widest_cells)
{
  run::Table table({"name", "ns", "share"});
  table.add("ours", 7, 0.5);
  table.add("a longer one", std::string("1234"));
  EXPECT_EQ(text_of(table), "name            ns  share\n"
                            "ours             7   0.50\n"
                            "a longer one  1234\n");
}

TEST(Tables, have_no_line_of_headings_where_there_are_none)
{
  run::Table table({}, run::Table::Align::LEFT);
  table.add("engine", "insertion");
  table.add("repair", "flip");
  EXPECT_EQ(text_of(table), "engine  insertion\nrepair  flip\n");
}

TEST(Comma_separated_values, are_all_digits_and_quoted_where_they_have_to_be)
{
  const std::string path = temporary_path("table.csv");
  run::Csv_writer writer(path, {"name", "value", "is_right"}, {"command: none"});
  writer.write("a,\"b\"", 0.1, true);
  writer.write("none", std::optional<double>(), false);
  EXPECT_FALSE(std::filesystem::exists(path));
  writer.finish();
  EXPECT_EQ(content_of(path),
            "# command: none\nname,value,is_right\n\"a,\"\"b\"\"\",0.1,1\nnone,,0\n");
}

TEST(Comma_separated_values, have_a_cell_for_each_column)
{
  run::Csv_writer writer(temporary_path("narrow.csv"), {"one", "two"});
  EXPECT_THROW(writer.write(1), std::logic_error);
  EXPECT_THROW(writer.write(1, 2, 3), std::logic_error);
}

} // namespace
