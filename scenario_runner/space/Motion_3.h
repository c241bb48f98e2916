// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SPACE_MOTION_3_H
#define SCENARIO_RUNNER_SPACE_MOTION_3_H

#include "scenario_runner/Motion.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/space/Cell_3.h"

#include <optional>
#include <string>
#include <vector>

namespace scenario {

// Points that move in space.
class Motion_3 : public Any_motion
{
public:
  using Any_motion::Any_motion;

  // In the order of ids().
  virtual const std::vector<Point_3>& points() const = 0;

  // The far corner of the box from the origin that the points do not leave, if there is one.
  virtual std::optional<Point_3> box() const { return std::nullopt; }

  // The cell of the frame, periodic along all sides, or in a slab along two; none where space is
  // open. All frames are alike in this.
  virtual std::optional<Cell_3> cell() const { return std::nullopt; }
};

// Whether the points of a recording move in space: some of their third coordinates differ.
bool is_in_space(const Recording& recording);

// \throws Scenario_error, with the frame and the point, if a third coordinate of a recording in
// space is no finite number; or if its boxes do not all make an open space, or all one that is
// periodic along the same sides, three or two. `choice` is how the reader of the message says that
// the recording is to be in the plane.
void check_in_space(const std::string& file, const Recording& recording, const std::string& choice);

// A recording whose points have a third coordinate.
class Recorded_motion_3 : public Played_motion<Motion_3>
{
public:
  // \throws Scenario_error as `check_in_space()`.
  Recorded_motion_3(const std::string& file, const std::string& name, Recording recording);

  const std::vector<Point_3>& points() const override { return m_points; }
  std::optional<Cell_3> cell() const override { return frame().box; }
  bool advance(const Neighbor_edges& neighbors) override;

private:
  void read_points();

  std::vector<Point_3> m_points;
};

} // namespace scenario

#endif // SCENARIO_RUNNER_SPACE_MOTION_3_H
