// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CLASSIFIERS_RECORDED_SCENARIO_H
#define CLASSIFIERS_RECORDED_SCENARIO_H

#include "../common/Contest.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Scenario_run.h"
#include "scenario_runner/Simulated_motion.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace classifiers {

using Points = std::vector<scenario::Point>;

// The points of all frames, so that all classifiers follow the same motion.
using Recorded_frames = std::vector<Points>;

// Records a motion whose neighbors come from an exact triangulation.
inline Recorded_frames record(scenario::Motion& motion, std::size_t frames)
{
  using Exact = CGAL::Dynamic_Delaunay_triangulation_2<run::Kernel>;
  Recorded_frames recording = {motion.points()};
  Exact triangulation(recording.front().begin(), recording.front().end(), run::Point_map());
  run::Neighbor_reader neighbors;
  while (recording.size() <= frames) {
    if (!motion.advance(neighbors(motion, triangulation))) {
      break;
    }
    recording.push_back(motion.points());
    triangulation.update(recording.back().begin(), recording.back().end(), run::Point_map());
  }
  return recording;
}

// Alternates between `turn` frames of hardly any motion and `turn` frames of new random clouds.
inline Recorded_frames record_turns(std::size_t number, std::size_t frames, std::size_t turn)
{
  constexpr double step = 0.001;
  scenario::Random_source random(1);
  Recorded_frames recording = {common::random_cloud<scenario::Point>(number, random)};
  while (recording.size() <= frames) {
    Points points = recording.back();
    if (recording.size() / turn % 2 == 0) {
      for (scenario::Point& point : points) {
        point.x += step * random.gaussian();
        point.y += step * random.gaussian();
      }
    } else {
      points = common::random_cloud<scenario::Point>(number, random);
    }
    recording.push_back(points);
  }
  return recording;
}

// A random cloud at rest, and a point that flies through it at `speed` spacings a frame, away from
// the hull.
inline Recorded_frames record_flight(double speed, std::size_t frames)
{
  constexpr std::size_t number = 2000;
  constexpr double margin = 3.0;
  scenario::Random_source random(1);
  Points points = common::random_cloud<scenario::Point>(number, random);
  const double side = std::sqrt(static_cast<double>(number));
  scenario::Point& flier = points.front();
  flier = {margin, 0.5 * side};
  double dx = speed * 0.94;
  double dy = speed * 0.34;
  const auto fly = [&](double place, double& velocity) {
    if (place + velocity < margin || place + velocity > side - margin) {
      velocity = -velocity;
    }
    return place + velocity;
  };
  Recorded_frames recording = {points};
  while (recording.size() <= frames) {
    flier = {fly(flier.x, dx), fly(flier.y, dy)};
    recording.push_back(points);
  }
  return recording;
}

} // namespace classifiers

#endif // CLASSIFIERS_RECORDED_SCENARIO_H
