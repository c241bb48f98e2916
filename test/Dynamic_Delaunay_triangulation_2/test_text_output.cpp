// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How the scenario runner and the benchmarks write numbers, tables, and comma separated values.

#include "scenario_runner/Csv_writer.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Table.h"
#include "temporary_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

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
