// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMON_CONTEST_H
#define COMMON_CONTEST_H

#include "scenario_runner/Motion.h"
#include "scenario_runner/Simulated_motion.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/delaunay_agreement.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace common {

using Points = std::vector<run::Kernel::Point_2>;

// Calls `compete(i)` for each contestant; the order rotates from frame to frame: whoever comes
// first warms the caches for the others.
template <class Compete>
void in_turn(std::size_t frame, std::size_t contestants, const Compete& compete)
{
  for (std::size_t i = 0; i != contestants; ++i) {
    compete((frame + i) % contestants);
  }
}

// A uniform cloud in a square, one point to a unit of area.
template <class Point>
std::vector<Point> random_cloud(std::size_t number, scenario::Random_source& random)
{
  const double side = std::sqrt(static_cast<double>(number));
  std::vector<Point> points;
  for (std::size_t i = 0; i != number; ++i) {
    const double x = random.uniform(0.0, side);
    points.push_back({x, random.uniform(0.0, side)});
  }
  return points;
}

inline Points places_of(const std::vector<scenario::Point>& points)
{
  Points places;
  places.reserve(points.size());
  for (const scenario::Point& point : points) {
    places.emplace_back(point.x, point.y);
  }
  return places;
}

inline run::Static_triangulation fresh_triangulation(const std::vector<scenario::Point>& points)
{
  const Points places = places_of(points);
  return run::Static_triangulation(places.begin(), places.end());
}

inline void require(bool is_right, const std::string& what)
{
  if (!is_right) {
    throw std::runtime_error(what);
  }
}

// Throws unless the triangulation is valid and equal to a fresh one. `where` begins the message.
template <class Dynamic>
void require_equal(const Dynamic& dynamic, const run::Static_triangulation& fresh,
                   const std::string& where = "")
{
  require(dynamic.is_valid(), where + "the triangulation is not valid");
  require(CGAL::delaunay_agreement(dynamic, fresh).matthews_correlation_coefficient() == 1.0,
          where + "the triangulation differs from a fresh one");
}

inline std::string in_frame(std::size_t frame)
{
  return "frame " + std::to_string(frame) + ": ";
}

} // namespace common

#endif // COMMON_CONTEST_H
