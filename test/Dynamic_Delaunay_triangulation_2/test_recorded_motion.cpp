// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Motion that was recorded elsewhere, by people who knew nothing of this package.

#include "oracle.h"
#include "scenario/Open_motion.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace {

using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Points = std::vector<Epick::Point_2>;

// One empty name where there is no recording, so that a test can say so.
std::vector<std::string> recordings()
{
  std::vector<std::string> paths;
  std::error_code ignored;
  for (const auto& file : std::filesystem::directory_iterator(SHARED_DATA_DIR, ignored)) {
    const std::string extension = file.path().extension().string();
    if (extension == ".csv" || extension == ".lammpstrj" || extension == ".dump") {
      paths.push_back(file.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths.empty() ? std::vector<std::string>{""} : paths;
}

std::string test_name(const testing::TestParamInfo<std::string>& info)
{
  return info.param.empty() ? "none" : std::filesystem::path(info.param).stem().string();
}

Points points_of(const scenario::Motion& motion)
{
  Points points;
  for (const scenario::Point& point : motion.points()) {
    points.emplace_back(point.x, point.y);
  }
  return points;
}

class Recorded_motion : public testing::TestWithParam<std::string>
{
};

TEST_P(Recorded_motion, is_followed_exactly_on_every_frame)
{
  if (GetParam().empty()) {
    GTEST_SKIP() << "no recordings in " SHARED_DATA_DIR;
  }
  // A comparison with a fresh triangulation is dear: so many frames of each recording get one.
  constexpr std::size_t comparisons = 40;
  const auto motion = scenario::open_motion(GetParam());
  const std::size_t stride = motion->frames() / comparisons + 1;
  std::optional<Dynamic> triangulation;
  std::size_t frame = 0;
  do {
    SCOPED_TRACE("frame " + std::to_string(frame));
    const Points points = points_of(*motion);
    if (!triangulation || motion->population_changed()) {
      triangulation.emplace(points.begin(), points.end());
    } else {
      ASSERT_TRUE(triangulation->update(points.begin(), points.end()).certified);
    }
    ASSERT_TRUE(triangulation->is_certified());
    ASSERT_TRUE(triangulation->is_valid(true));
    if (frame % stride == 0) {
      ASSERT_NO_FATAL_FAILURE(expect_exact(*triangulation, points));
    }
    ++frame;
  } while (motion->advance({}));
  EXPECT_EQ(frame, motion->frames() + 1);
}

INSTANTIATE_TEST_SUITE_P(All, Recorded_motion, testing::ValuesIn(recordings()), test_name);

} // namespace
