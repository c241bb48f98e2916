// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/space/Periodic_opponents_3.h"

#include "scenario_runner/Measurement.h"

#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>

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

void Periodic_opponents_3::prepare(const scenario::Motion_3& motion)
{
  m_fresh.reset();
  m_of_cgal->triangulation.reset();
  m_of_cgal->points.clear();
  m_points.clear();
  m_cell = motion.cell();
  for (const auto& [x, y, z] : motion.points()) {
    m_points.emplace_back(x, y, z);
  }
  if (m_cell->is_cube()) {
    const double side = m_cell->sides[0][0];
    for (const auto& [x, y, z] : motion.points()) {
      m_of_cgal->points.emplace_back(wrapped(x, side), wrapped(y, side), wrapped(z, side));
    }
  }
}

double Periodic_opponents_3::time_insert()
{
  // CGAL is told that there are so many points that one copy of them suffices, where that is
  // faster.
  constexpr std::size_t large = 100;
  if (!m_cell->is_cube()) {
    return time_fastest();
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
  if (!m_fresh) {
    m_nanoseconds = nanoseconds_of([this] { m_fresh.emplace(m_points, periodic_cell(*m_cell)); });
  }
  return m_nanoseconds;
}

} // namespace run
