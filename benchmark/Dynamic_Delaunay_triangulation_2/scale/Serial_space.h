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

#include <algorithm>
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

// Constructions of a Poisson cloud, in any order.
template <class Space>
std::vector<Part_log::Entries> construct_in_space(std::size_t points, std::size_t times)
{
  std::mt19937_64 random(1);
  space::Points cloud = space::points_of("poisson", points, random);
  std::shuffle(cloud.begin(), cloud.end(), random);
  std::vector<Part_log::Entries> logs;
  for (std::size_t i = 0; i != times; ++i) {
    Part_log::instance().start(Part_log::REST);
    const auto dynamic = Space::build(cloud);
    logs.push_back(Part_log::instance().finish());
    common::require(dynamic.is_certified(), "the triangulation is not certified");
  }
  return logs;
}

// Frames in which all points jump anywhere, so that they are triangulated anew.
template <class Space>
std::vector<Part_log::Entries> rebuild_in_space(std::size_t points, std::size_t times)
{
  std::mt19937_64 random(1);
  auto dynamic = Space::build(space::points_of("poisson", points, random));
  std::vector<Part_log::Entries> logs;
  for (std::size_t i = 0; i != times; ++i) {
    const space::Points cloud = space::points_of("poisson", points, random);
    Part_log::instance().start(Part_log::READ);
    const CGAL::Update_report_3 report = dynamic.update(cloud);
    logs.push_back(Part_log::instance().finish());
    common::require(report.rebuilt() && dynamic.is_certified(), "it was not triangulated anew");
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
  constexpr std::size_t times = 3;
  const std::string number = '/' + std::to_string(points);
  table.write(name + "rebuild" + number, points, rebuild_in_space<Space>(points, times));
  table.write(name + "construction" + number, points, construct_in_space<Space>(points, times));
}

} // namespace scale

#endif // SCALE_SERIAL_SPACE_H
