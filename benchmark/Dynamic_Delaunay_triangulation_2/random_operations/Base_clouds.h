// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_BASE_CLOUDS_H
#define RANDOM_OPERATIONS_BASE_CLOUDS_H

#include "Cloud.h"
#include "Named.h"
#include "Place_sources.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace random_operations {

// Where points are in the beginning. `make` gives an empty cloud its box, its spacing, a source of
// fresh places, and `points` points.
struct Base_cloud
{
  std::string name;
  std::string is;
  std::function<void(Cloud& cloud, std::size_t points, Decisions& decisions)> make;
};

namespace base_clouds {

constexpr double whole_turn = 6.283185307179586;

inline void set_square_box(Cloud& cloud, double side)
{
  cloud.low = {0.0, 0.0};
  cloud.high = {side, side};
}

inline void set_disc_box(Cloud& cloud, double radius)
{
  cloud.low = {-radius, -radius};
  cloud.high = {radius, radius};
}

inline void fill_with_fresh(Cloud& cloud, std::size_t points, Decisions& decisions)
{
  for (std::size_t i = 0; i != points; ++i) {
    cloud.add(cloud.fresh(decisions));
  }
}

// `site(i)` is where the i-th one is.
template <class Site>
void fill(Cloud& cloud, std::size_t points, const Site& site)
{
  for (std::size_t i = 0; i != points; ++i) {
    cloud.add(site(i));
  }
}

inline double square_side(std::size_t points)
{
  return std::ceil(std::sqrt(static_cast<double>(points)));
}

inline void make_square(Cloud& cloud, std::size_t points, Decisions& decisions)
{
  const double side = std::sqrt(static_cast<double>(points));
  set_square_box(cloud, side);
  cloud.fresh = [side](Decisions& source) {
    const double x = source.real(0.0, side);
    return Place{x, source.real(0.0, side)};
  };
  fill_with_fresh(cloud, points, decisions);
}

inline void make_ball(Cloud& cloud, std::size_t points, Decisions& decisions)
{
  const double sigma = std::sqrt(static_cast<double>(points)) / 4.0;
  set_square_box(cloud, 4.0 * sigma);
  cloud.fresh = [sigma](Decisions& source) {
    const double x = sigma * (2.0 + source.deviation());
    return Place{x, sigma * (2.0 + source.deviation())};
  };
  fill_with_fresh(cloud, points, decisions);
}

// Rows of a lattice, every other one moved by `indent`. Fresh places are about the middles of
// cells, so that no point is there.
inline void make_rows(Cloud& cloud, std::size_t points, double indent, double row_height)
{
  const auto side = static_cast<std::size_t>(square_side(points));
  const auto length = static_cast<double>(side);
  const auto site = [=](std::size_t column, std::size_t row) {
    return Place{static_cast<double>(column) + indent * static_cast<double>(row % 2),
                 row_height * static_cast<double>(row)};
  };
  cloud.high = {length, row_height * length};
  cloud.fresh = [=](Decisions& source) {
    const std::size_t column = source.below(side);
    const Place corner = site(column, source.below(side));
    const double x = corner.x + 0.5 + 0.01 * source.deviation();
    return Place{x, corner.y + row_height * (0.5 - indent / 3.0) + 0.01 * source.deviation()};
  };
  fill(cloud, points, [&](std::size_t i) { return site(i % side, i / side); });
}

inline void make_lattice(Cloud& cloud, std::size_t points, Decisions&)
{
  make_rows(cloud, points, 0.0, 1.0);
}

inline void make_hexagons(Cloud& cloud, std::size_t points, Decisions&)
{
  make_rows(cloud, points, 0.5, std::sqrt(0.75));
}

// All integer points with the distance 5 from the middle of a tile, exactly cocircular.
inline void make_rings(Cloud& cloud, std::size_t points, Decisions&)
{
  static const Places ring = {{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                              {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
  constexpr std::size_t tile = 12;
  const auto side = static_cast<std::size_t>(square_side((points + tile - 1) / tile));
  set_square_box(cloud, static_cast<double>(tile * side));
  cloud.spacing = 3.0;
  const auto site = [side](std::size_t i) {
    const std::size_t number = i / ring.size();
    const Place& offset = ring[i % ring.size()];
    return Place{static_cast<double>(tile * (number % side)) + offset.x,
                 static_cast<double>(tile * (number / side)) + offset.y};
  };
  cloud.fresh = [=](Decisions& source) { return site(source.below(points)); };
  fill(cloud, points, site);
}

inline void make_parabola(Cloud& cloud, std::size_t points, Decisions&)
{
  const auto on_parabola = [](double x) { return Place{x, x * x}; };
  cloud.low = {-1.0, 0.0};
  cloud.spacing = 2.0 / static_cast<double>(points);
  cloud.fresh = [=](Decisions& source) { return on_parabola(source.real(-1.0, 1.0)); };
  cloud.along = [=](const Place& place, double distance) {
    return on_parabola(place.x + distance);
  };
  fill(cloud, points, [&](std::size_t i) {
    return on_parabola(-1.0 + cloud.spacing * (static_cast<double>(i) + 0.5));
  });
}

inline void make_circle(Cloud& cloud, std::size_t points, Decisions&)
{
  const double radius = static_cast<double>(points) / whole_turn;
  const auto on_circle = [radius](double angle) {
    return Place{radius * std::cos(angle), radius * std::sin(angle)};
  };
  set_disc_box(cloud, radius);
  cloud.fresh = [=](Decisions& source) { return on_circle(source.real(0.0, whole_turn)); };
  cloud.along = [=](const Place& place, double distance) {
    return on_circle(std::atan2(place.y, place.x) + distance / radius);
  };
  fill(cloud, points, [&](std::size_t i) {
    return on_circle(whole_turn * static_cast<double>(i) / static_cast<double>(points));
  });
}

// Horizontal ones, ten spacings from each other.
template <std::size_t lines>
void make_lines(Cloud& cloud, std::size_t points, Decisions&)
{
  constexpr double distance = 10.0;
  const double length = static_cast<double>(points) / static_cast<double>(lines);
  cloud.high = {length, distance};
  cloud.fresh = [=](Decisions& source) {
    const double x = source.real(0.0, length);
    return Place{x, distance * static_cast<double>(source.below(lines))};
  };
  fill(cloud, points, [](std::size_t i) {
    return Place{static_cast<double>(i / lines), distance * static_cast<double>(i % lines)};
  });
}

// One spacing from each other along the spiral, and three between its windings.
inline void make_spiral(Cloud& cloud, std::size_t points, Decisions&)
{
  constexpr double growth = 3.0 / whole_turn;
  const auto count = static_cast<double>(points);
  const auto on_spiral = [=](double length) {
    const double angle = std::sqrt(2.0 * length / growth);
    return Place{growth * angle * std::cos(angle), growth * angle * std::sin(angle)};
  };
  set_disc_box(cloud, growth * std::sqrt(2.0 * count / growth));
  cloud.fresh = [=](Decisions& source) { return on_spiral(source.real(0.0, count)); };
  fill(cloud, points, [&](std::size_t i) { return on_spiral(static_cast<double>(i) + 1.0); });
}

// The spacing is that within a cluster.
inline void make_clusters(Cloud& cloud, std::size_t points, Decisions& decisions)
{
  constexpr std::size_t clusters = 100;
  constexpr double sigma = 1e-3;
  cloud.spacing = 3.0 * sigma * std::sqrt(static_cast<double>(clusters) / double(points));
  Places middles;
  for (std::size_t i = 0; i != clusters; ++i) {
    const double x = decisions.share();
    middles.push_back({x, decisions.share()});
  }
  cloud.fresh = [middles](Decisions& source) {
    const Place& middle = source.any_of(middles);
    const double x = middle.x + sigma * source.deviation();
    return Place{x, middle.y + sigma * source.deviation()};
  };
  fill_with_fresh(cloud, points, decisions);
}

// Each coordinate from 1e-8 to 1e8.
inline void make_scales(Cloud& cloud, std::size_t points, Decisions& decisions)
{
  constexpr double most = 1e8;
  set_square_box(cloud, most);
  cloud.spacing = most / std::sqrt(static_cast<double>(points));
  cloud.fresh = [](Decisions& source) {
    const double x = std::pow(10.0, source.real(-8.0, 8.0));
    return Place{x, std::pow(10.0, source.real(-8.0, 8.0))};
  };
  fill_with_fresh(cloud, points, decisions);
}

// Nine in ten within a thousandth of the box, the others all over it.
inline void make_crowd(Cloud& cloud, std::size_t points, Decisions& decisions)
{
  cloud.spacing = 1e-3 / std::sqrt(static_cast<double>(points));
  cloud.fresh = [](Decisions& source) {
    const double side = source.share() < 0.9 ? 1e-3 : 1.0;
    const double x = source.real(0.0, side);
    return Place{x, source.real(0.0, side)};
  };
  fill_with_fresh(cloud, points, decisions);
}

// Each where the source puts it beside those before.
inline void make_of_source(const Source& source, Cloud& cloud, std::size_t points,
                           Decisions& decisions)
{
  const double side = square_side(points);
  set_square_box(cloud, side);
  cloud.field.extent = static_cast<int>(side);
  cloud.fresh = [&cloud, place = source.place](Decisions& chance) {
    return place(cloud.field, cloud.points, chance);
  };
  fill_with_fresh(cloud, points, decisions);
}

} // namespace base_clouds

inline const std::vector<Base_cloud>& all_base_clouds()
{
  using namespace base_clouds;
  static const std::vector<Base_cloud> all = [] {
    std::vector<Base_cloud> bases = {{"square", "evenly random in a square", make_square},
                                     {"ball", "normally distributed", make_ball},
                                     {"lattice", "a square lattice of whole numbers", make_lattice},
                                     {"hexagons", "a hexagonal lattice", make_hexagons},
                                     {"rings", "circles of twelve integer points", make_rings},
                                     {"parabola", "on y = x^2, convex", make_parabola},
                                     {"circle", "on a circle, convex", make_circle},
                                     {"line", "all on a line", make_lines<1>},
                                     {"two_lines", "on two parallel lines", make_lines<2>},
                                     {"spiral", "on a spiral", make_spiral},
                                     {"clusters", "a hundred small clusters", make_clusters},
                                     {"scales", "coordinates from 1e-8 to 1e8", make_scales},
                                     {"crowd", "most of them in one corner", make_crowd}};
    for (const Source& source : all_sources()) {
      bases.push_back({std::string("of_") + source.name, source.is,
                       [&source](Cloud& cloud, std::size_t points, Decisions& decisions) {
                         make_of_source(source, cloud, points, decisions);
                       }});
    }
    return bases;
  }();
  return all;
}

} // namespace random_operations

#endif // RANDOM_OPERATIONS_BASE_CLOUDS_H
