// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/space/Periodic_opponents_3.h"

#include "scenario_runner/Measurement.h"

#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace run {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cgal_periodic = CGAL::Periodic_3_Delaunay_triangulation_3<
    CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>>;

double wrapped(double value, double period)
{
  const double in_period = value - period * std::floor(value / period);
  return in_period < period ? in_period : 0.0;
}

using scenario::Cell_3;
using scenario::Point_3;

Point_3 cross(const Point_3& u, const Point_3& v)
{
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

double dot(const Point_3& u, const Point_3& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

// The squared radius of the sphere through the origin and three points; 0 if they are nearly in a
// plane with it, as in a cell between others that have the same sphere.
double squared_radius(const Point_3& a, const Point_3& b, const Point_3& c)
{
  const double aa = dot(a, a), bb = dot(b, b), cc = dot(c, c);
  const Point_3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const double twice_product = 2.0 * dot(a, bc);
  if (std::abs(twice_product) <= 1e-9 * std::sqrt(aa * bb * cc)) {
    return 0.0;
  }
  Point_3 center{};
  for (std::size_t i = 0; i != 3; ++i) {
    center[i] = (aa * bc[i] + bb * ca[i] + cc * ab[i]) / twice_product;
  }
  return dot(center, center);
}

double largest_radius(const Dynamic_periodic_3& dt)
{
  double largest = 0.0;
  dt.for_each_cell([&](const std::array<std::size_t, 4>& ids,
                       const std::array<CGAL::Periodic_shift_3, 4>& shifts) {
    std::array<Point_3, 3> ways{};
    for (std::size_t i = 0; i != 3; ++i) {
      const auto way = dt.vector(ids[0], ids[i + 1], shifts[i + 1]);
      ways[i] = {way.x(), way.y(), way.z()};
    }
    largest = (std::max)(largest, squared_radius(ways[0], ways[1], ways[2]));
  });
  return std::sqrt(largest);
}

// The vectors of which the products with a vector are its multiples of the cell's sides.
std::array<Point_3, 3> duals(const Cell_3& cell)
{
  const auto& [a, b, c] = cell.sides;
  std::array<Point_3, 3> duals = {cross(b, c), cross(c, a), cross(a, b)};
  for (Point_3& dual : duals) {
    for (double& coordinate : dual) {
      coordinate /= cell.volume();
    }
  }
  return duals;
}

} // namespace

struct Periodic_opponents_3::Of_cgal
{
  std::vector<Cgal_periodic::Point> points;
  std::optional<Cgal_periodic> triangulation;
};

Periodic_opponents_3::Periodic_opponents_3()
  : m_of_cgal(std::make_unique<Of_cgal>())
{
  keep_freed_memory();
}

Periodic_opponents_3::~Periodic_opponents_3() = default;

void Periodic_opponents_3::prepare(const scenario::Motion_3& motion,
                                   const Dynamic_periodic_3& before)
{
  m_fresh.reset();
  m_of_cgal->triangulation.reset();
  m_of_cgal->points.clear();
  m_points.clear();
  m_cell = motion.cell();
  for (const auto& [x, y, z] : motion.points()) {
    m_points.emplace_back(x, y, z);
  }
  if (m_cell->number_of_periodic_sides() < 3) {
    return;
  }
  if (m_cell->is_cube()) {
    const double side = m_cell->sides[0][0];
    for (const auto& [x, y, z] : motion.points()) {
      m_of_cgal->points.emplace_back(wrapped(x, side), wrapped(y, side), wrapped(z, side));
    }
  }
  const double scale = std::cbrt(std::abs(m_cell->volume()) / before.cell().volume());
  m_ghosts.prepare(with_ghosts(motion, 1.25 * scale * largest_radius(before)), true);
}

double Periodic_opponents_3::time_insert()
{
  // CGAL is told that there are so many points that one copy of them suffices, where that is
  // faster.
  constexpr std::size_t large = 100;
  if (m_cell->number_of_periodic_sides() < 3) {
    return time_fresh();
  }
  if (!m_cell->is_cube()) {
    return m_ghosts.time_insert();
  }
  const double side = m_cell->sides[0][0];
  const std::vector<Cgal_periodic::Point>& points = m_of_cgal->points;
  return nanoseconds_of([&] {
    Cgal_periodic& triangulation =
        m_of_cgal->triangulation.emplace(Cgal_periodic::Iso_cuboid(0, 0, 0, side, side, side));
    triangulation.insert(points.begin(), points.end(), points.size() >= large);
  });
}

double Periodic_opponents_3::time_fastest()
{
  if (m_cell->number_of_periodic_sides() < 3) {
    return time_fresh();
  }
  const double by_ghosts = m_ghosts.time_fastest();
  if (!m_may_fresh_win) {
    return by_ghosts;
  }
  const double fresh = time_fresh();
  m_may_fresh_win = fresh < 3.0 * by_ghosts;
  return (std::min)(fresh, by_ghosts);
}

double Periodic_opponents_3::time_fresh()
{
  m_fresh.reset();
  return nanoseconds_of([this] { m_fresh.emplace(m_points, periodic_cell(*m_cell)); });
}

// All images in the cell and the margin. Where that would be far more than anyone would
// triangulate, as in a frame that is nothing like the one before, the margin is halved.
std::vector<Point_3> Periodic_opponents_3::with_ghosts(const scenario::Motion_3& motion,
                                                       double margin) const
{
  constexpr double most_images = 1000.0; // of a point
  const std::array<Point_3, 3> to_fractions = duals(*m_cell);
  Point_3 reach{};
  do {
    for (std::size_t i = 0; i != 3; ++i) {
      reach[i] = margin * std::sqrt(dot(to_fractions[i], to_fractions[i]));
    }
    margin /= 2.0;
  } while ((1 + 2 * reach[0]) * (1 + 2 * reach[1]) * (1 + 2 * reach[2]) > most_images);
  std::vector<Point_3> images;
  for (const Point_3& point : motion.points()) {
    std::array<int, 3> first{}, last{};
    for (std::size_t i = 0; i != 3; ++i) {
      const double fraction = dot(to_fractions[i], point);
      first[i] = static_cast<int>(std::ceil(-reach[i] - fraction));
      last[i] = static_cast<int>(std::floor(1.0 + reach[i] - fraction));
    }
    scenario::Shift_3 shift{};
    for (shift[0] = first[0]; shift[0] <= last[0]; ++shift[0]) {
      for (shift[1] = first[1]; shift[1] <= last[1]; ++shift[1]) {
        for (shift[2] = first[2]; shift[2] <= last[2]; ++shift[2]) {
          images.push_back(m_cell->image(point, shift));
        }
      }
    }
  }
  return images;
}

} // namespace run
