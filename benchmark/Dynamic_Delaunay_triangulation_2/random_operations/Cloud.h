// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_CLOUD_H
#define RANDOM_OPERATIONS_CLOUD_H

#include "Decisions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace random_operations {

// A place, of which kernels make their points.
struct Place
{
  double x, y;
};

using Places = std::vector<Place>;
using Id = std::int64_t;
using Indices = std::vector<std::size_t>; // of points in a cloud

// The coordinates in which motions are described: their unit and their origin.
struct Field
{
  double unit = 1.0;
  double offset_x = 0.0, offset_y = 0.0;
  int extent = 10; // in units
  double limit = 1e150;

  // The place with these coordinates, no farther away than the limit.
  Place place(double x, double y) const { return kept({offset_x + unit * x, offset_y + unit * y}); }

  double x(const Place& place) const { return (place.x - offset_x) / unit; }
  double y(const Place& place) const { return (place.y - offset_y) / unit; }

  Place kept(const Place& place) const { return {kept(place.x), kept(place.y)}; }

private:
  double kept(double value) const
  {
    return std::isnan(value) ? 0.0 : (std::max)(-limit, (std::min)(limit, value));
  }
};

inline Place in_random_direction(const Place& place, double distance, Decisions& decisions)
{
  const double angle = 6.283185307179586 * decisions.share();
  return {place.x + distance * std::cos(angle), place.y + distance * std::sin(angle)};
}

// Points with ascending ids, and the part of the plane that they are at home in.
class Cloud
{
public:
  Cloud() = default;
  Cloud(const Cloud&) = delete; // `fresh` may refer to it
  Cloud& operator=(const Cloud&) = delete;

  Places points{};
  Field field{};
  Place low{0.0, 0.0}, high{1.0, 1.0}; // corners of their box, in the field
  double spacing = 1.0;                // usual distance between neighbors, in units

  // Returns a new place that is distributed like those of the points.
  std::function<Place(Decisions&)> fresh{};

  // Returns the place further on the curve of the points, if they are on one.
  std::function<Place(const Place&, double)> along = [](const Place& place, double distance) {
    return Place{place.x + distance, place.y};
  };

  std::size_t size() const { return points.size(); }
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
  Place middle() const { return {0.5 * (low.x + high.x), 0.5 * (low.y + high.y)}; }
  const std::vector<Id>& ids() const { return m_ids; }

  // The index of the point with an id; nothing if the point has been removed.
  std::optional<std::size_t> index(Id id) const
  {
    const auto found = std::lower_bound(m_ids.begin(), m_ids.end(), id);
    if (found == m_ids.end() || *found != id) {
      return std::nullopt;
    }
    return static_cast<std::size_t>(found - m_ids.begin());
  }

  void add(const Place& place)
  {
    points.push_back(place);
    m_ids.push_back(m_next_id++);
  }

  void remove(const Indices& indices)
  {
    std::vector<bool> goes(size(), false);
    for (const std::size_t index : indices) {
      goes[index] = true;
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

} // namespace random_operations

#endif // RANDOM_OPERATIONS_CLOUD_H
