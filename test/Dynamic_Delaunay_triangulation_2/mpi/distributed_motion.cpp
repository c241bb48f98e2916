// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: the union of their edges is the triangulation of all points, in each frame.

#include "distributed_oracle.h"
#include "distributed_theme.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace distributed_motion {

// A block of soft discs falls over in a box. All ranks compute the same motion of all of them, with
// the contacts that one process finds.
class Dam_break
{
public:
  explicit Dam_break(const Points& points)
    : m_dt(points.begin(), points.end())
    , m_points(points)
    , m_speeds(points.size(), CGAL::NULL_VECTOR)
  {
  }

  const Point& position(std::size_t i, int frame)
  {
    for (; m_frame < frame; ++m_frame)
      step();
    return m_points[i];
  }

private:
  void step()
  {
    const double time_step = 0.3, gravity = 0.005;
    m_dt.for_each_edge([&](std::size_t i, std::size_t j) {
      const Kernel::Vector_2 apart = m_points[j] - m_points[i];
      const double distance = std::sqrt(apart.squared_length());
      if (distance >= 1 || distance == 0)
        return;
      const Kernel::Vector_2 kick = time_step * (1 - distance) / distance * apart;
      m_speeds[i] -= kick;
      m_speeds[j] += kick;
    });
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      const Point& p = m_points[i];
      m_speeds[i] =
          0.999 * m_speeds[i] + time_step * Kernel::Vector_2(push(p.x()), push(p.y()) - gravity);
      m_points[i] = p + time_step * m_speeds[i];
    }
    m_dt.update(m_points.begin(), m_points.end());
  }

  static double push(double x) { return (std::max)(0.0, 0.5 - x) - (std::max)(0.0, x - 39.5); }

  CGAL::Dynamic_Delaunay_triangulation_2<Kernel> m_dt;
  Points m_points;
  std::vector<Kernel::Vector_2> m_speeds;
  int m_frame = 0;
};

void refuse_bad_input()
{
  const Population points =
      numbered({{0, 0}, {1, 0}, {0, 1}, {1, 1.5}, {2, 3}, {3, 1}, {4, 2}, {5, 5}});
  auto dt = distributed(points, in_order);
  Points next = own_positions(dt, points);
  const bool is_bad = !next.empty() && dt.owned_ids()[0] == 0;
  if (is_bad)
    next[0] = Point(std::numeric_limits<double>::quiet_NaN(), 0);
  const auto refuse = [&] { dt.update(next.begin(), next.end()); };
  expect(is_bad ? is_refused<CGAL::Non_finite_coordinate_error_2>(refuse)
                : is_refused<CGAL::Distributed_input_error_2>(refuse),
         "NaN on one rank is refused on all ranks");
  expect_exact(dt, points, "after a refusal");
}

void run_theme()
{
  const char* const wanted = std::getenv("DYNAMIC_DELAUNAY_DISTRIBUTED_FRAMES");
  const int frames = wanted ? std::atoi(wanted) : 20;

  std::mt19937 random(7); // the same on all ranks
  std::uniform_real_distribution<double> coordinate(0, 20);
  std::normal_distribution<double> step(0, 0.05);
  Points cloud = any_points(400, 20, random);
  std::sort(cloud.begin(), cloud.end());
  for (const Ownership& ownership : {Ownership{in_order, no_balance}, Ownership()}) {
    run("Brownian motion", cloud, frames, ownership, [&](std::size_t, const Point& p, int) {
      return Point(p.x() + step(random), p.y() + step(random));
    });
    run("jumps", cloud, frames, ownership, [&](std::size_t, const Point& p, int) {
      return random() % 20 ? p : Point(coordinate(random), coordinate(random));
    });
    run("an explosion", cloud, frames, ownership, [](std::size_t, const Point& p, int) {
      return Point(10 + 1.1 * (p.x() - 10), 10 + 1.1 * (p.y() - 10));
    });
  }
  Points block;
  for (int i = 0; i < 400; ++i)
    block.push_back(Point(0.5 + i % 18 + 0.01 * std::sin(i), 0.5 + i / 18));
  Dam_break dam_break(block);
  run("a dam break", block, 5 * frames, {},
      [&](std::size_t i, const Point&, int frame) { return dam_break.position(i, frame); });
  run("a rank that owns all", cloud, 2, {on_first, no_balance}, at_rest);
  run("points in turn", cloud, 2, {in_turn, no_balance}, at_rest);
  refuse_bad_input();
}

const Theme theme("distributed_motion", run_theme);

} // namespace distributed_motion
