// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPACE_PERIODIC_CASES_H
#define SPACE_PERIODIC_CASES_H

#include "../common/Statistics.h"
#include "../common/Table.h"
#include "Space_points.h"
#include "Static_ways.h"

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace space {

using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel>;
using Periodic_static = CGAL::Periodic_3_Delaunay_triangulation_3<
    CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>>;

inline CGAL::Periodic_cell_3 cell_of(const std::string& kind, double edge)
{
  using Vector = Kernel::Vector_3;
  return kind == "triclinic"
             ? CGAL::Periodic_cell_3(Vector(edge, 0, 0), Vector(0.3 * edge, edge, 0),
                                     Vector(-0.2 * edge, 0.4 * edge, edge))
             : CGAL::Periodic_cell_3(edge, edge, edge);
}

inline common::Table periodic_table()
{
  return common::Table(std::cout, 24,
                       {{"update", 9, 0},
                        {"worst", 9, 0},
                        {"open", 9, 0},
                        {"update/open", 13, 2},
                        {"CGAL", 9, 0},
                        {"/CGAL", 8, 1},
                        {"flips", 8, 3},
                        {"rebuilds %", 12, 0}});
}

// Random points of a cube, and the same in the cell of a kind, which is that cube or shears it.
class Periodic_cloud
{
public:
  Periodic_cloud(const std::string& kind, std::size_t n)
    : m_edge(std::cbrt(double(n)))
    , m_shear(kind == "triclinic" ? 1 : 0)
    , m_cell(cell_of(kind, m_edge))
    , m_cube(points_of("poisson", n, m_random))
  {
    wrap();
  }

  const CGAL::Periodic_cell_3& cell() const { return m_cell; }
  double edge() const { return m_edge; }
  const Points& cube() const { return m_cube; }
  Points points() const
  {
    Points points;
    for (const Point& p : m_cube) {
      points.emplace_back(p.x() + m_shear * (0.3 * p.y() - 0.2 * p.z()),
                          p.y() + m_shear * 0.4 * p.z(), p.z());
    }
    return points;
  }
  void move(double step)
  {
    space::move("poisson", step, m_cube, m_random);
    wrap();
  }

private:
  // As simulations do, and CGAL asks for.
  void wrap()
  {
    const auto inside = [this](double x) {
      const double y = x - m_edge * std::floor(x / m_edge);
      return y < m_edge ? y : 0;
    };
    for (Point& p : m_cube) {
      p = Point(inside(p.x()), inside(p.y()), inside(p.z()));
    }
  }

  std::mt19937_64 m_random{1};
  double m_edge, m_shear;
  CGAL::Periodic_cell_3 m_cell;
  Points m_cube;
};

inline void insert_periodic(const Points& points, double edge)
{
  Periodic_static fresh(Periodic_static::Iso_cuboid(0, 0, 0, edge, edge, edge));
  fresh.insert(points.begin(), points.end(), true);
}

// One row. CGAL's insertion, which takes far longer, is timed in every fourth frame.
inline void write_periodic(common::Table& table, const std::string& kind, std::size_t n,
                           double step, int frames)
{
  constexpr int frames_of_cgal = 4;
  Periodic_cloud cloud(kind, n);
  Periodic torus(cloud.points(), cloud.cell());
  std::mt19937_64 random(1);
  Points open_points = points_of("poisson", n, random);
  Dynamic open(open_points);
  std::vector<double> updates, opens, others;
  double flips = 0, rebuilds = 0;
  for (int frame = 0; frame != frames; ++frame) {
    cloud.move(step);
    const Points points = cloud.points();
    CGAL::Update_report_3 report;
    updates.push_back(nanoseconds(n, [&] { report = torus.update(points); }));
    flips += double(report.flips);
    rebuilds += report.rebuilt();
    move("poisson", step, open_points, random);
    opens.push_back(nanoseconds(n, [&] { open.update(open_points); }));
    if (frame % frames_of_cgal == 0) {
      others.push_back(nanoseconds(n, [&] { insert_periodic(cloud.cube(), cloud.edge()); }));
    }
  }
  if (!torus.is_valid(true) || torus.number_of_vertices() != n) {
    throw std::runtime_error("a periodic triangulation is wrong");
  }
  const double update = common::median(updates), other = common::median(others);
  table.write_row("  " + kind + ' ' + common::cell(step, 4), update, common::largest(updates),
                  common::median(opens), common::median_ratio(updates, opens), other,
                  other / update, flips / (double(n) * frames), 100 * rebuilds / frames);
}

} // namespace space

#endif // SPACE_PERIODIC_CASES_H
