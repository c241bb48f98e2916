// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCALE_SERIAL_SPACE_H
#define SCALE_SERIAL_SPACE_H

#include "../common/Contest.h"
#include "../common/Table.h"
#include "../space/Space_points.h"
#include "Part_log.h"
#include "Serial_share.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_cell_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace scale {

struct Measured_in_open_space
{
  using Dynamic =
      CGAL::Dynamic_Delaunay_triangulation_3<space::Kernel, CGAL::With_concurrency_2<Measured_tag>>;

  static Dynamic build(const space::Points& points) { return Dynamic(points); }
};

struct Measured_in_periodic_space
{
  using Dynamic =
      CGAL::Dynamic_periodic_Delaunay_triangulation_3<space::Kernel,
                                                      CGAL::With_concurrency_2<Measured_tag>>;

  static Dynamic build(const space::Points& points)
  {
    const double edge = std::cbrt(static_cast<double>(points.size()));
    return Dynamic(points, CGAL::Periodic_cell_3(edge, edge, edge));
  }
};

// Frames of a Poisson cloud that takes steps of so many spacings.
template <class Space>
std::vector<Part_log::Entries> follow_in_space(std::size_t points, double step, std::size_t frames)
{
  constexpr std::size_t warm_up = 2;
  std::mt19937_64 random(1);
  space::Points cloud = space::points_of("poisson", points, random);
  auto dynamic = Space::build(cloud);
  std::vector<Part_log::Entries> logs;
  for (std::size_t frame = 0; frame != warm_up + frames; ++frame) {
    space::move("poisson", step, cloud, random);
    Part_log::instance().start(Part_log::READ);
    dynamic.update(cloud);
    const Part_log::Entries& entries = Part_log::instance().finish();
    if (frame >= warm_up) {
      logs.push_back(entries);
    }
    common::require(dynamic.is_certified(), "the triangulation is not certified");
  }
  return logs;
}

template <class Space>
void write_serial_shares_in_space(Serial_table& table, const std::string& name, std::size_t points,
                                  std::size_t frames)
{
  for (const double step : {0.0001, 0.001, 0.01, 0.03, 0.1}) {
    table.write(name + "steps of " + common::cell(step, 4) + '/' + std::to_string(points), points,
                follow_in_space<Space>(points, step, frames));
  }
}

} // namespace scale

#endif // SCALE_SERIAL_SPACE_H
