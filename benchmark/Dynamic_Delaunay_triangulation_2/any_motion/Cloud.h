// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_CLOUD_H
#define ANY_MOTION_CLOUD_H

#include "scenario_runner/Motion.h"
#include "scenario_runner/Simulated_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace any_motion {

using scenario::Point;
using Random = scenario::Random_source;
using Id = std::int64_t;
using Places = std::vector<std::size_t>; // in a cloud

// From 0 to count - 1.
inline std::size_t any_below(std::size_t count, Random& random)
{
  const auto number = static_cast<std::size_t>(random.uniform() * static_cast<double>(count));
  return (std::min)(number, count - 1);
}

inline Point in_random_direction(const Point& point, double distance, Random& random)
{
  const double angle = 6.283185307179586 * random.uniform();
  return {point.x + distance * std::cos(angle), point.y + distance * std::sin(angle)};
}

// Points with ascending ids, and the part of the plane that they are at home in.
class Cloud
{
public:
  std::vector<Point> points{};
  Point low{0.0, 0.0}, high{1.0, 1.0}; // corners of their box
  double spacing = 1.0;                // usual distance between neighbors
  // A new place like those of the others.
  std::function<Point(Random&)> fresh{};
  // Further on the curve that the points are on, if they are on one.
  std::function<Point(const Point&, double)> along = [](const Point& point, double distance) {
    return Point{point.x + distance, point.y};
  };

  std::size_t size() const { return points.size(); }
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
  Point middle() const { return {0.5 * (low.x + high.x), 0.5 * (low.y + high.y)}; }

  const std::vector<Id>& ids() const { return m_ids; }

  // Of an id that may have gone.
  std::optional<std::size_t> place(Id id) const
  {
    const auto found = std::lower_bound(m_ids.begin(), m_ids.end(), id);
    if (found == m_ids.end() || *found != id) {
      return std::nullopt;
    }
    return static_cast<std::size_t>(found - m_ids.begin());
  }

  void add(const Point& point)
  {
    points.push_back(point);
    m_ids.push_back(m_next_id++);
  }

  void remove(const Places& places)
  {
    std::vector<bool> goes(size(), false);
    for (const std::size_t place : places) {
      goes[place] = true;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i != size(); ++i) {
      if (!goes[i]) {
        points[kept] = points[i];
        m_ids[kept++] = m_ids[i];
      }
    }
    points.resize(kept);
    m_ids.resize(kept);
  }

private:
  std::vector<Id> m_ids;
  Id m_next_id = 0;
};

} // namespace any_motion

#endif // ANY_MOTION_CLOUD_H
