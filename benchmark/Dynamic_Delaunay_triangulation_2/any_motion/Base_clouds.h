// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_BASE_CLOUDS_H
#define ANY_MOTION_BASE_CLOUDS_H

#include "Cloud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace any_motion {

// Where points are in the beginning. `make` gives an empty cloud its box, its spacing, its fresh
// places, and so many points.
struct Base_cloud
{
  const char* name;
  const char* is;
  void (*make)(Cloud& cloud, std::size_t points, Random& random);
};

namespace base_clouds {

inline void set_square_box(Cloud& cloud, double side)
{
  cloud.low = {0.0, 0.0};
  cloud.high = {side, side};
}

inline void fill_with_fresh(Cloud& cloud, std::size_t points, Random& random)
{
  for (std::size_t i = 0; i != points; ++i) {
    cloud.add(cloud.fresh(random));
  }
}

inline double square_side(std::size_t points)
{
  return std::ceil(std::sqrt(static_cast<double>(points)));
}

inline void make_square(Cloud& cloud, std::size_t points, Random& random)
{
  const double side = std::sqrt(static_cast<double>(points));
  set_square_box(cloud, side);
  cloud.fresh = [side](Random& source) {
    const double x = source.uniform(0.0, side);
    return Point{x, source.uniform(0.0, side)};
  };
  fill_with_fresh(cloud, points, random);
}

inline void make_ball(Cloud& cloud, std::size_t points, Random& random)
{
  const double sigma = std::sqrt(static_cast<double>(points)) / 4.0;
  set_square_box(cloud, 4.0 * sigma);
  cloud.fresh = [sigma](Random& source) {
    const double x = sigma * (2.0 + source.gaussian());
    return Point{x, sigma * (2.0 + source.gaussian())};
  };
  fill_with_fresh(cloud, points, random);
}

// Rows of a lattice, every other one moved by `indent`. Fresh places are about the middles of
// cells, so that nobody is there.
inline void make_rows(Cloud& cloud, std::size_t points, double indent, double row_height)
{
  const auto side = static_cast<std::size_t>(square_side(points));
  const auto length = static_cast<double>(side);
  const auto site = [=](std::size_t column, std::size_t row) {
    return Point{static_cast<double>(column) + indent * static_cast<double>(row % 2),
                 row_height * static_cast<double>(row)};
  };
  cloud.low = {0.0, 0.0};
  cloud.high = {length, row_height * length};
  cloud.fresh = [=](Random& source) {
    const std::size_t column = any_below(side, source);
    const Point corner = site(column, any_below(side, source));
    const double x = corner.x + 0.5 + 0.01 * source.gaussian();
    return Point{x, corner.y + row_height * (0.5 - indent / 3.0) + 0.01 * source.gaussian()};
  };
  for (std::size_t i = 0; i != points; ++i) {
    cloud.add(site(i % side, i / side));
  }
}

inline void make_lattice(Cloud& cloud, std::size_t points, Random&)
{
  make_rows(cloud, points, 0.0, 1.0);
}

inline void make_hexagons(Cloud& cloud, std::size_t points, Random&)
{
  make_rows(cloud, points, 0.5, std::sqrt(0.75));
}

// All integer points with the distance 5 from the middle of a tile, exactly cocircular.
inline void make_rings(Cloud& cloud, std::size_t points, Random&)
{
  static constexpr std::array<std::array<double, 2>, 12> ring = {{{5, 0},
                                                                  {4, 3},
                                                                  {3, 4},
                                                                  {0, 5},
                                                                  {-3, 4},
                                                                  {-4, 3},
                                                                  {-5, 0},
                                                                  {-4, -3},
                                                                  {-3, -4},
                                                                  {0, -5},
                                                                  {3, -4},
                                                                  {4, -3}}};
  constexpr std::size_t tile = 12;
  const auto side = static_cast<std::size_t>(square_side((points + tile - 1) / tile));
  set_square_box(cloud, static_cast<double>(tile * side));
  cloud.spacing = 3.0;
  const auto site = [side](std::size_t i) {
    const std::size_t number = i / ring.size();
    const auto& offset = ring[i % ring.size()];
    return Point{static_cast<double>(tile * (number % side)) + offset[0],
                 static_cast<double>(tile * (number / side)) + offset[1]};
  };
  cloud.fresh = [=](Random& source) { return site(any_below(points, source)); };
  for (std::size_t i = 0; i != points; ++i) {
    cloud.add(site(i));
  }
}

inline void make_parabola(Cloud& cloud, std::size_t points, Random&)
{
  const auto on_parabola = [](double x) { return Point{x, x * x}; };
  cloud.low = {-1.0, 0.0};
  cloud.high = {1.0, 1.0};
  cloud.spacing = 2.0 / static_cast<double>(points);
  cloud.fresh = [=](Random& source) { return on_parabola(source.uniform(-1.0, 1.0)); };
  cloud.along = [=](const Point& point, double distance) {
    return on_parabola(point.x + distance);
  };
  for (std::size_t i = 0; i != points; ++i) {
    cloud.add(on_parabola(-1.0 + cloud.spacing * (static_cast<double>(i) + 0.5)));
  }
}

inline void make_circle(Cloud& cloud, std::size_t points, Random&)
{
  constexpr double whole_turn = 6.283185307179586;
  const double radius = static_cast<double>(points) / whole_turn;
  const auto on_circle = [radius](double angle) {
    return Point{radius * std::cos(angle), radius * std::sin(angle)};
  };
  cloud.low = {-radius, -radius};
  cloud.high = {radius, radius};
  cloud.fresh = [=](Random& source) { return on_circle(source.uniform(0.0, whole_turn)); };
  cloud.along = [=](const Point& point, double distance) {
    return on_circle(std::atan2(point.y, point.x) + distance / radius);
  };
  for (std::size_t i = 0; i != points; ++i) {
    cloud.add(on_circle(whole_turn * static_cast<double>(i) / static_cast<double>(points)));
  }
}

// Horizontal ones, ten spacings from each other.
inline void make_lines(Cloud& cloud, std::size_t points, std::size_t lines)
{
  constexpr double distance = 10.0;
  const double length = static_cast<double>(points) / static_cast<double>(lines);
  cloud.low = {0.0, 0.0};
  cloud.high = {length, distance};
  cloud.fresh = [=](Random& source) {
    const double x = source.uniform(0.0, length);
    return Point{x, distance * static_cast<double>(any_below(lines, source))};
  };
  for (std::size_t i = 0; i != points; ++i) {
    cloud.add({static_cast<double>(i / lines), distance * static_cast<double>(i % lines)});
  }
}

inline void make_line(Cloud& cloud, std::size_t points, Random&)
{
  make_lines(cloud, points, 1);
}

inline void make_two_lines(Cloud& cloud, std::size_t points, Random&)
{
  make_lines(cloud, points, 2);
}

// One spacing from each other along the spiral, and three between its windings.
inline void make_spiral(Cloud& cloud, std::size_t points, Random&)
{
  constexpr double growth = 3.0 / 6.283185307179586;
  const auto count = static_cast<double>(points);
  const auto on_spiral = [=](double length) {
    const double angle = std::sqrt(2.0 * length / growth);
    return Point{growth * angle * std::cos(angle), growth * angle * std::sin(angle)};
  };
  const double radius = growth * std::sqrt(2.0 * count / growth);
  cloud.low = {-radius, -radius};
  cloud.high = {radius, radius};
  cloud.fresh = [=](Random& source) { return on_spiral(source.uniform(0.0, count)); };
  for (std::size_t i = 0; i != points; ++i) {
    cloud.add(on_spiral(static_cast<double>(i) + 1.0));
  }
}

// The spacing is that within a cluster.
inline void make_clusters(Cloud& cloud, std::size_t points, Random& random)
{
  constexpr std::size_t clusters = 100;
  constexpr double sigma = 1e-3;
  set_square_box(cloud, 1.0);
  cloud.spacing = 3.0 * sigma * std::sqrt(static_cast<double>(clusters) / double(points));
  std::vector<Point> middles;
  for (std::size_t i = 0; i != clusters; ++i) {
    const double x = random.uniform();
    middles.push_back({x, random.uniform()});
  }
  cloud.fresh = [middles](Random& source) {
    const Point& middle = middles[any_below(middles.size(), source)];
    const double x = middle.x + sigma * source.gaussian();
    return Point{x, middle.y + sigma * source.gaussian()};
  };
  fill_with_fresh(cloud, points, random);
}

// Each coordinate from 1e-8 to 1e8.
inline void make_scales(Cloud& cloud, std::size_t points, Random& random)
{
  constexpr double most = 1e8;
  set_square_box(cloud, most);
  cloud.spacing = most / std::sqrt(static_cast<double>(points));
  cloud.fresh = [](Random& source) {
    const double x = std::pow(10.0, source.uniform(-8.0, 8.0));
    return Point{x, std::pow(10.0, source.uniform(-8.0, 8.0))};
  };
  fill_with_fresh(cloud, points, random);
}

// Nine in ten within a thousandth of the box, the others all over it.
inline void make_crowd(Cloud& cloud, std::size_t points, Random& random)
{
  set_square_box(cloud, 1.0);
  cloud.spacing = 1e-3 / std::sqrt(static_cast<double>(points));
  cloud.fresh = [](Random& source) {
    const double side = source.uniform() < 0.9 ? 1e-3 : 1.0;
    const double x = source.uniform(0.0, side);
    return Point{x, source.uniform(0.0, side)};
  };
  fill_with_fresh(cloud, points, random);
}

} // namespace base_clouds

inline const std::vector<Base_cloud>& all_base_clouds()
{
  using namespace base_clouds;
  static const std::vector<Base_cloud> bases = {
      {"square", "evenly random in a square", make_square},
      {"ball", "normally distributed", make_ball},
      {"lattice", "a square lattice of whole numbers", make_lattice},
      {"hexagons", "a hexagonal lattice", make_hexagons},
      {"rings", "circles of twelve integer points", make_rings},
      {"parabola", "on y = x^2, convex", make_parabola},
      {"circle", "on a circle, convex", make_circle},
      {"line", "all on a line", make_line},
      {"two_lines", "on two parallel lines", make_two_lines},
      {"spiral", "on a spiral", make_spiral},
      {"clusters", "a hundred small clusters", make_clusters},
      {"scales", "coordinates from 1e-8 to 1e8", make_scales},
      {"crowd", "most of them in one corner", make_crowd}};
  return bases;
}

// \throws std::invalid_argument if there is none.
inline const Base_cloud& base_cloud(const std::string& name)
{
  const auto& bases = all_base_clouds();
  const auto found = std::find_if(bases.begin(), bases.end(),
                                  [&](const Base_cloud& base) { return base.name == name; });
  if (found == bases.end()) {
    throw std::invalid_argument("there is no base cloud '" + name + "'");
  }
  return *found;
}

} // namespace any_motion

#endif // ANY_MOTION_BASE_CLOUDS_H
