// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Polygon_text.h"

#include "scenario_runner/Number_text.h"

#include <cstddef>
#include <iterator>
#include <utility>

namespace scenario {

namespace {

std::string place_text(const Point& point)
{
  return "(" + run::number_text(point.x) + ", " + run::number_text(point.y) + ")";
}

} // namespace

std::string problem_of_ring(const std::vector<Point>& corners)
{
  constexpr std::size_t fewest = 4;
  if (corners.empty()) {
    return "has no corners, needed are at least three, and the first one again";
  }
  const Point &first = corners.front(), &last = corners.back();
  if (first.x != last.x || first.y != last.y) {
    return "is not closed: it begins at " + place_text(first) + " and ends at " + place_text(last) +
           ", expected the first corner again";
  }
  if (corners.size() < fewest) {
    return "has " + std::to_string(corners.size()) +
           (corners.size() == 1 ? " corner" : " corners") +
           ", needed are at least three, and the first one again";
  }
  return {};
}

Polygon polygon_of_rings(std::vector<std::vector<Point>> rings)
{
  for (std::vector<Point>& ring : rings) {
    ring.pop_back();
  }
  const auto holes = std::make_move_iterator(rings.begin());
  return {std::move(rings.front()), {holes + 1, std::make_move_iterator(rings.end())}};
}

} // namespace scenario
