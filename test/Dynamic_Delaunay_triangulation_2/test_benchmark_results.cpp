// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The parts of benchmarks that count, search and write their results.

#include "../../benchmark/Dynamic_Delaunay_triangulation_2/common/Csv_file.h"
#include "../../benchmark/Dynamic_Delaunay_triangulation_2/peers/Peer_output.h"
#include "../../benchmark/Dynamic_Delaunay_triangulation_2/thesis/Mean_and_extremes.h"
#include "../../benchmark/Dynamic_Delaunay_triangulation_2/thesis/Most_points_search.h"
#include "temporary_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using thesis::Frame_milliseconds;
using thesis::Most_points_search;

constexpr std::size_t many = 10'000'000;

// The times of frames that all take equally long.
Frame_milliseconds frames_of(std::size_t points, double milliseconds)
{
  return {points, 1, milliseconds, milliseconds};
}

TEST(The_search_for_max_points, ends_close_below_the_limit_where_cost_is_proportional)
{
  for (const double nanoseconds : {3.0, 15.0, 60.0, 400.0, 100'000.0}) {
    std::size_t tries = 0;
    Most_points_search search(150'000, many);
    const Frame_milliseconds found = search.run([&](std::size_t points) {
      ++tries;
      return frames_of(points, 1e-6 * nanoseconds * static_cast<double>(points));
    });
    const double right = 40.0 / (1e-6 * nanoseconds);
    EXPECT_LE(static_cast<double>(found.points), (std::min)(right, double(many))) << nanoseconds;
    EXPECT_GE(static_cast<double>(found.points), 0.9 * (std::min)(right, double(many)))
        << nanoseconds;
    EXPECT_LE(tries, 6u) << nanoseconds;
  }
}

TEST(The_search_for_max_points, copes_with_cost_that_rises_faster_than_the_number)
{
  Most_points_search search(1000, many);
  const Frame_milliseconds found = search.run([](std::size_t points) {
    const auto number = static_cast<double>(points);
    return frames_of(points, 1e-6 * number * (10.0 + 1e-4 * number));
  });
  EXPECT_LE(found.upper_quartile, 40.0);
  EXPECT_GE(found.upper_quartile, 35.0);
}

TEST(The_search_for_max_points, never_answers_with_a_number_that_was_too_slow)
{
  double noise = 1.0;
  Most_points_search search(150'000, many);
  const Frame_milliseconds found = search.run([&](std::size_t points) {
    noise = noise == 1.0 ? 2.5 : 1.0; // every second try is disturbed
    return frames_of(points, 20e-6 * noise * static_cast<double>(points));
  });
  EXPECT_GT(found.points, 0u);
  EXPECT_LE(found.upper_quartile, 40.0);
}

TEST(The_search_for_max_points, ends_where_there_are_no_more)
{
  Most_points_search search(1000, 5000);
  const Frame_milliseconds found =
      search.run([](std::size_t points) { return frames_of(points, 1e-3); });
  EXPECT_LE(found.points, 5000u);
  EXPECT_GE(found.points, 4500u);
}

TEST(Mean_and_extremes, leave_cells_empty_where_there_is_nothing)
{
  thesis::Mean_and_extremes values;
  std::vector<std::string> cells;
  values.append_cells(cells);
  EXPECT_EQ(cells, (std::vector<std::string>{"", "", ""}));
  cells.clear();
  values.add(1.0);
  values.add(4.0);
  values.append_cells(cells);
  EXPECT_EQ(cells, (std::vector<std::string>{"2.5", "1", "4"}));
}

TEST(A_file_of_results, has_remarks_columns_and_rows)
{
  const std::string path = temporary_path("results.csv");
  common::Csv_file file(path, {"command: none"}, {"name", "value"});
  file.write_row("one", 0.125);
  file.finish();
  EXPECT_EQ(content_of(path), "# command: none\nname,value\none,0.125\n");
}

TEST(A_file_of_results, refuses_rows_that_do_not_fit)
{
  common::Csv_file file(temporary_path("results.csv"), {}, {"name", "value"});
  EXPECT_THROW(file.write_row("one"), std::logic_error);
  EXPECT_THROW(file.write_row("one, two", 1), std::logic_error);
}

// A square, whose diagonals are a tie, and a point beside it.
const peers::Points house = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 3}};

using Corners = std::vector<std::array<std::size_t, 3>>;

bool is_equal(const Corners& faces)
{
  const peers::Frame_truth truth(house);
  peers::Peer_output output(truth);
  for (const auto& [a, b, c] : faces) {
    output.add_face(a, b, c);
  }
  return output.verdict().is_equal;
}

TEST(The_comparison_with_peers, takes_either_diagonal_of_a_tie)
{
  EXPECT_TRUE(is_equal({{0, 1, 2}, {0, 2, 3}, {2, 4, 3}}));
  EXPECT_TRUE(is_equal({{0, 1, 3}, {1, 2, 3}, {2, 4, 3}}));
}

TEST(The_comparison_with_peers, finds_wrong_missing_and_surplus_faces)
{
  EXPECT_FALSE(is_equal({{0, 1, 2}, {0, 2, 4}, {0, 4, 3}}));            // 0-4 is no Delaunay edge
  EXPECT_FALSE(is_equal({{0, 1, 2}, {0, 2, 3}}));                       // no roof
  EXPECT_FALSE(is_equal({{0, 1, 2}, {0, 2, 3}, {2, 4, 3}, {0, 1, 3}})); // one face twice
  EXPECT_FALSE(is_equal({}));
}

} // namespace
