// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPACE_WALLED_CASES_H
#define SPACE_WALLED_CASES_H

#include "../common/Statistics.h"
#include "../common/Table.h"
#include "Periodic_cases.h"
#include "Space_points.h"
#include "Static_ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace space {

inline const std::vector<std::string>& walled_kinds()
{
  static const std::vector<std::string> kinds{"cube", "slab", "slab_walls", "layer",
                                              "pipe", "duct", "duct_walls"};
  return kinds;
}

// Random points of density 1 in a cell that is periodic along x, y and z, along x and y, or along x
// alone, and has walls elsewhere, from which points bounce. Some points may slide along these.
class Walled_cloud
{
public:
  Walled_cloud(const std::string& kind, std::size_t n)
    : m_kind(kind)
    , m_length(kind == "layer"  ? std::sqrt(double(n))
               : kind == "pipe" ? std::cbrt(4 * double(n) / std::acos(-1.0))
                                : std::cbrt(double(n)))
    , m_periodic(kind == "cube"                                  ? 3
                 : kind == "layer" || kind.rfind("slab", 0) == 0 ? 2
                                                                 : 1)
  {
    std::uniform_real_distribution<double> place(0, m_length);
    Points points;
    while (points.size() < n) {
      const Place p{place(m_random), place(m_random), place(m_random)};
      if (kind != "pipe" || distance_from_axis(p) < m_length / 2) {
        points.emplace_back(p[0], p[1], p[2]);
      }
    }
    CGAL::spatial_sort(points.begin(), points.end());
    for (const Point& p : points) {
      Place inside{p.x(), p.y(), p.z()};
      if (const std::size_t axis = axis_across_wall(m_places.size()); axis < 3) {
        inside[axis] = kind == "layer" || inside[axis] < m_length / 2 ? 0 : m_length;
      }
      m_places.push_back(inside);
    }
  }

  CGAL::Periodic_cell_3 cell() const
  {
    using Vector = Kernel::Vector_3;
    const Vector a(m_length, 0, 0), b(0, m_length, 0);
    return m_periodic == 3   ? CGAL::Periodic_cell_3(m_length, m_length, m_length)
           : m_periodic == 2 ? CGAL::Periodic_cell_3(a, b)
                             : CGAL::Periodic_cell_3(a);
  }
  Points points() const
  {
    Points points;
    for (const Place& p : m_places) {
      points.emplace_back(p[0], p[1], p[2]);
    }
    return points;
  }
  void move(double step)
  {
    std::normal_distribution<double> way(0, step / std::sqrt(3.0));
    for (std::size_t i = 0; i != m_places.size(); ++i) {
      Place& p = m_places[i];
      const std::size_t fixed = axis_across_wall(i);
      for (std::size_t axis = 0; axis != 3; ++axis) {
        p[axis] = axis == fixed ? p[axis] : kept_inside(axis, p[axis] + way(m_random));
      }
      bounce_from_pipe(p);
    }
  }

private:
  using Place = std::array<double, 3>;

  // The axis across the wall on which a point slides, or 3.
  std::size_t axis_across_wall(std::size_t i) const
  {
    return m_kind == "layer"                                          ? 2
           : m_kind.find("_walls") == std::string::npos || i % 3 != 0 ? 3
           : m_periodic == 2 || i % 2 == 0                            ? 2
                                                                      : 1;
  }
  // Wrapped, as simulations do, or reflected.
  double kept_inside(std::size_t axis, double x) const
  {
    if (axis < m_periodic) {
      return x - m_length * std::floor(x / m_length);
    }
    return m_kind == "pipe" ? x : x < 0 ? -x : x > m_length ? 2 * m_length - x : x;
  }
  double distance_from_axis(const Place& p) const
  {
    return std::hypot(p[1] - m_length / 2, p[2] - m_length / 2);
  }
  void bounce_from_pipe(Place& p) const
  {
    const double radius = m_length / 2, distance = distance_from_axis(p);
    for (std::size_t axis = 1; m_kind == "pipe" && distance > radius && axis != 3; ++axis) {
      p[axis] = radius + (2 * radius - distance) / distance * (p[axis] - radius);
    }
  }

  std::string m_kind;
  double m_length;
  std::size_t m_periodic; // the number of these axes
  std::mt19937_64 m_random{1};
  std::vector<Place> m_places;
};

inline common::Table walled_table()
{
  return common::Table(std::cout, 24,
                       {{"update", 9, 0},
                        {"worst", 9, 0},
                        {"open", 9, 0},
                        {"update/open", 13, 2},
                        {"anew", 9, 0},
                        {"flips", 8, 3},
                        {"held %", 8, 3},
                        {"rebuilds %", 12, 1},
                        {"/anew", 9, 2}});
}

// One row. In every twentieth frame a triangulation is made anew, and the points in open space,
// which drift apart, start again.
inline void write_walled(common::Table& table, const std::string& kind, std::size_t n, double step,
                         int frames)
{
  constexpr int frames_of_anew = 20;
  Walled_cloud cloud(kind, n);
  const CGAL::Periodic_cell_3 cell = cloud.cell();
  Periodic walled(cloud.points(), cell);
  std::mt19937_64 random(1);
  const Points first_open_points = points_of("poisson", n, random);
  Points open_points;
  Dynamic open;
  std::vector<double> updates, opens, anew, rebuilt;
  double flips = 0, held = 0;
  for (int frame = 0; frame != frames; ++frame) {
    cloud.move(step);
    const Points points = cloud.points();
    CGAL::Update_report_3 report;
    updates.push_back(nanoseconds(n, [&] { report = walled.update(points); }));
    flips += double(report.flips);
    held += double(report.held);
    if (report.rebuilt()) {
      rebuilt.push_back(updates.back());
    }
    if (frame % frames_of_anew == 0) {
      open_points = first_open_points;
      open = Dynamic(open_points);
    }
    move("poisson", step, open_points, random);
    opens.push_back(nanoseconds(n, [&] { open.update(open_points); }));
    if (frame % frames_of_anew == 0) {
      anew.push_back(nanoseconds(n, [&] { const Periodic fresh(points, cell); }));
    }
  }
  if (!walled.is_valid(true) || walled.number_of_vertices() != n) {
    throw std::runtime_error("a triangulation between walls is wrong");
  }
  const double of_anew = common::median(anew);
  table.write_row("  " + kind + ' ' + common::cell(step, 4), common::median(updates),
                  common::largest(updates), common::median(opens),
                  common::median_ratio(updates, opens), of_anew, flips / (double(n) * frames),
                  100 * held / (double(n) * frames), 100 * double(rebuilt.size()) / frames,
                  rebuilt.empty() ? 0 : common::median(rebuilt) / of_anew);
}

// Another one, of points that rest, of which this share leaves in each frame, and comes back.
inline void write_walled_exchange(common::Table& table, const std::string& kind, std::size_t n,
                                  double share, int frames)
{
  const Walled_cloud cloud(kind, n);
  std::mt19937_64 random(1);
  Periodic walled(cloud.points(), cloud.cell());
  Dynamic open(points_of("poisson", n, random));
  const auto exchange = [](auto& triangulation, const std::vector<std::size_t>& ids) {
    Points gone;
    for (const std::size_t id : ids) {
      gone.push_back(triangulation.point(id));
    }
    const bool has_rebuilt = triangulation.remove(ids).rebuilt();
    return triangulation.insert(gone).rebuilt() || has_rebuilt;
  };
  std::vector<double> updates, opens, anew, rebuilt;
  for (int frame = 0; frame != frames; ++frame) {
    std::vector<std::size_t> ids(std::size_t(share * double(n)));
    for (std::size_t& id : ids) {
      id = random() % n;
    }
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    bool has_rebuilt = false;
    updates.push_back(nanoseconds(n, [&] { has_rebuilt = exchange(walled, ids); }));
    opens.push_back(nanoseconds(n, [&] { exchange(open, ids); }));
    if (has_rebuilt) {
      rebuilt.push_back(updates.back());
    }
    if (frame % 20 == 0) {
      anew.push_back(nanoseconds(n, [&] { const Periodic fresh(cloud.points(), cloud.cell()); }));
    }
  }
  if (!walled.is_valid(true) || walled.number_of_vertices() != n) {
    throw std::runtime_error("a triangulation between walls is wrong");
  }
  const double of_anew = common::median(anew);
  table.write_row("  " + kind + " exchange " + common::cell(share, 2), common::median(updates),
                  common::largest(updates), common::median(opens),
                  common::median_ratio(updates, opens), of_anew, 0.0, 0.0,
                  100 * double(rebuilt.size()) / frames,
                  rebuilt.empty() ? 0 : common::median(rebuilt) / of_anew);
}

} // namespace space

#endif // SPACE_WALLED_CASES_H
