// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Motion that was recorded elsewhere, by people who knew nothing of this package.

#include "oracle.h"
#include "scenario_runner/Open_motion.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Estimated_voronoi_circumcenter_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Inflation_aware_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Voronoi_edge_length_classifier_2.h>
#include <CGAL/Dynamic_population_2.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Population = CGAL::Dynamic_population_2<Dynamic>;
using Tracks = std::vector<std::pair<std::int64_t, Epick::Point_2>>;

// The recording of the examples, and those of others if they are installed. If they are not, an
// empty name stands for them, so that a test can say so.
std::vector<std::string> recordings()
{
  std::vector<std::string> paths = scenario::recordings();
  if (paths.empty()) {
    paths.push_back("");
  }
  paths.push_back(EXAMPLES_DATA_DIR "/corridor.csv");
  return paths;
}

std::string test_name(const testing::TestParamInfo<std::string>& info)
{
  return info.param.empty() ? "none" : std::filesystem::path(info.param).stem().string();
}

Tracks tracks_of(const scenario::Motion& motion)
{
  Tracks tracks;
  for (std::size_t i = 0; i != motion.points().size(); ++i) {
    const scenario::Point& point = motion.points()[i];
    tracks.emplace_back(motion.ids()[i], Epick::Point_2(point.x, point.y));
  }
  return tracks;
}

std::vector<Epick::Point_2> points_of(const Tracks& tracks)
{
  std::vector<Epick::Point_2> points;
  for (const auto& [id, point] : tracks) {
    points.push_back(point);
  }
  return points;
}

void expect_all_points(const Population& population, const Tracks& tracks)
{
  ASSERT_EQ(population.size(), tracks.size());
  ASSERT_EQ(population.triangulation().number_of_points(), tracks.size());
  for (const auto& [id, point] : tracks) {
    ASSERT_EQ(population.point(id), point) << "id " << id;
  }
}

class Recorded_motion : public testing::TestWithParam<std::string>
{
protected:
  // Recordings may be missing with their usual directory; a directory that holds none, or one that
  // is named and not there, is a mistake.
  void SetUp() override
  {
    if (GetParam().empty()) {
      ASSERT_FALSE(scenario::recordings_are_expected()) << scenario::no_recordings_message();
      GTEST_SKIP() << scenario::no_recordings_message();
    }
  }
};

TEST_P(Recorded_motion, is_followed_exactly_on_every_frame_with_its_whole_population)
{
  // Comparing with a fresh triangulation is expensive: only so many frames of a recording are.
  constexpr std::size_t comparisons = 40;
  const auto motion = scenario::open_motion(GetParam());
  const std::size_t stride = motion->frames() / comparisons + 1;
  Population population;
  std::size_t frame = 0;
  do {
    SCOPED_TRACE("frame " + std::to_string(frame));
    const Tracks tracks = tracks_of(*motion);
    ASSERT_TRUE(population.update(tracks.begin(), tracks.end()).certified);
    ASSERT_TRUE(population.triangulation().is_certified());
    ASSERT_TRUE(population.triangulation().is_valid(true));
    ASSERT_NO_FATAL_FAILURE(expect_all_points(population, tracks));
    if (frame % stride == 0) {
      ASSERT_NO_FATAL_FAILURE(expect_delaunay(population.triangulation(), points_of(tracks)));
    }
    ++frame;
  } while (motion->advance({}));
  EXPECT_EQ(frame, motion->frames() + 1);
}

// Follows a recording with a heuristic classifier at an absurd setting.
template <class Classifier>
void follow(const std::string& path, const Classifier& classifier)
{
  using Heuristic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, Classifier>;
  const auto motion = scenario::open_motion(path);
  const std::size_t stride = motion->frames() / 20 + 1;
  CGAL::Dynamic_population_2<Heuristic> population{Heuristic(classifier)};
  std::size_t frame = 0;
  do {
    SCOPED_TRACE("frame " + std::to_string(frame));
    const Tracks tracks = tracks_of(*motion);
    population.update(tracks.begin(), tracks.end());
    ASSERT_EQ(population.size(), tracks.size());
    if (frame++ % stride == 0) {
      ASSERT_TRUE(population.triangulation().is_valid(true)); // a false certificate is not
      for (const auto& [id, point] : tracks) {
        ASSERT_EQ(population.point(id), point) << "id " << id;
      }
    }
  } while (motion->advance({}));
  population.mend();
  const Tracks tracks = tracks_of(*motion);
  ASSERT_NO_FATAL_FAILURE(expect_delaunay(population.triangulation(), points_of(tracks)));
}

TEST_P(Recorded_motion, keeps_a_valid_structure_under_absurd_heuristics)
{
  ASSERT_NO_FATAL_FAILURE(follow(GetParam(), CGAL::Point_distance_classifier_2(0)));
  ASSERT_NO_FATAL_FAILURE(follow(GetParam(), CGAL::Inflation_aware_classifier_2(0)));
  ASSERT_NO_FATAL_FAILURE(follow(GetParam(), CGAL::Random_classifier_2(0.01, 1)));
  ASSERT_NO_FATAL_FAILURE(follow(GetParam(), CGAL::Estimated_voronoi_circumcenter_classifier_2()));
  ASSERT_NO_FATAL_FAILURE(follow(GetParam(), CGAL::Voronoi_edge_length_classifier_2(0)));
}

INSTANTIATE_TEST_SUITE_P(All, Recorded_motion, testing::ValuesIn(recordings()), test_name);

} // namespace
