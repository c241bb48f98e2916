// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RECORDED_MOTION_H
#define SCENARIO_RECORDED_MOTION_H

#include "Motion.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace scenario {

// Ids ascending, each once; points in the same order.
struct Recorded_frame
{
  double time = 0.0;
  std::vector<std::int64_t> ids;
  std::vector<Point> points;
  bool is_periodic = false; // its box is, in x or y
};

using Recording = std::vector<Recorded_frame>;

class Recorded_motion : public Motion
{
public:
  Recorded_motion(std::string name, Recording recording)
    : Motion(std::move(name))
    , m_recording(std::move(recording))
  {
    if (m_recording.empty()) {
      throw std::invalid_argument("a recorded motion needs at least one frame");
    }
  }

  const std::vector<std::int64_t>& ids() const override { return frame().ids; }
  const std::vector<Point>& points() const override { return frame().points; }
  double time() const override { return frame().time; }
  bool has_fixed_population() const override
  {
    return std::all_of(m_recording.begin(), m_recording.end(), [this](const Recorded_frame& frame) {
      return frame.ids == m_recording.front().ids;
    });
  }
  bool population_changed() const override { return m_population_changed; }
  std::size_t frames() const override { return m_recording.size() - 1; }

  std::string remark() const override
  {
    const bool is_periodic =
        std::any_of(m_recording.begin(), m_recording.end(),
                    [](const Recorded_frame& frame) { return frame.is_periodic; });
    return is_periodic ? "the box is periodic, and is taken for an open one: points that leave it "
                         "on one side jump to the other, and nobody has neighbors across its sides"
                       : "";
  }

  bool advance(const Neighbor_edges&) override
  {
    if (m_current + 1 == m_recording.size()) {
      return false;
    }
    m_population_changed = m_recording[m_current].ids != m_recording[m_current + 1].ids;
    ++m_current;
    return true;
  }

private:
  const Recorded_frame& frame() const { return m_recording[m_current]; }

  Recording m_recording;
  std::size_t m_current = 0;
  bool m_population_changed = false;
};

} // namespace scenario

#endif // SCENARIO_RECORDED_MOTION_H
