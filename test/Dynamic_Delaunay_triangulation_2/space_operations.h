// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Random programs that move, insert and remove points in space.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SPACE_OPERATIONS_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SPACE_OPERATIONS_H

#include "space_oracle.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <sstream>
#include <utility>
#include <vector>

namespace space_operations {

// What updates have done, from their reports.
struct Counts
{
  void add(const CGAL::Update_report_3& report)
  {
    ++calls;
    flips += report.flips;
    held += report.held;
    relocated += report.relocated;
    merged += report.merged;
    parted += report.parted;
    rebuilds += report.rebuilt();
  }

  std::size_t calls = 0, flips = 0, held = 0, relocated = 0, merged = 0, parted = 0, rebuilds = 0;
};

// A triangulation in space, the points that it should have, and what happens to both.
template <class Dynamic, class Random = std::mt19937_64>
class Program
{
public:
  using Point = typename Dynamic::Point;

  // Points in a cube of this extent, or in a slab of this thickness; with a grid, on its multiples,
  // where many are on spheres, planes and each other.
  Program(std::uint64_t seed, double extent = 1, double grid = 0, double thickness = 1)
    : Program(Random(seed), extent, grid, thickness)
  {
  }

  // As a generator of random numbers decides.
  explicit Program(const Random& random, double extent = 1, double grid = 0, double thickness = 1)
    : m_random(random)
    , m_extent(extent)
    , m_grid(grid)
    , m_thickness(thickness)
  {
  }

  const Dynamic& triangulation() const { return m_triangulation; }
  const std::map<std::size_t, Point>& points() const { return m_points; }
  const Counts& counts() const { return m_counts; }

  // Goes on with a triangulation that another one has written.
  void interrupt()
  {
    std::stringstream file;
    file << m_triangulation;
    m_triangulation = Dynamic();
    ASSERT_TRUE(file >> m_triangulation);
  }

  void insert(std::size_t number)
  {
    std::vector<Point> points;
    for (std::size_t i = 0; i < number; ++i)
      points.push_back(anywhere());
    std::vector<std::size_t> ids;
    const auto report =
        m_triangulation.insert(points.begin(), points.end(), std::back_inserter(ids));
    m_counts.add(report);
    EXPECT_EQ(report.inserted, number);
    ASSERT_EQ(ids.size(), number);
    for (std::size_t i = 0; i < number; ++i)
      ASSERT_TRUE(m_points.emplace(ids[i], points[i]).second);
  }

  void remove(std::size_t number)
  {
    std::vector<std::size_t> ids;
    for (; ids.size() < number && !m_points.empty();) {
      const std::size_t id = some_id();
      ids.push_back(id);
      m_points.erase(id);
    }
    const auto report = m_triangulation.remove(ids.begin(), ids.end());
    m_counts.add(report);
    EXPECT_EQ(report.removed, ids.size());
  }

  void move_one()
  {
    if (m_points.empty())
      return;
    const std::size_t id = some_id();
    m_points[id] = anywhere();
    m_counts.add(m_triangulation.move(id, m_points[id]));
  }

  // Several at once, some of them to where others were.
  void move_some()
  {
    std::vector<std::pair<std::size_t, Point>> movers;
    for (auto& [id, point] : m_points)
      if (number_below(4) == 0) {
        const Point target = number_below(2) == 0 ? anywhere() : m_points[some_id()];
        movers.emplace_back(id, target);
        point = target;
      }
    const auto report = m_triangulation.move(movers.begin(), movers.end());
    m_counts.add(report);
    EXPECT_TRUE(report.certified);
  }

  // Several at once, most of them within the cells around them.
  void move_some_a_little()
  {
    static constexpr double steps[] = {1e-6, 0.01, 0.1, 0.3};
    const double step = steps[number_below(4)] * m_extent / std::cbrt(double(m_points.size() + 1));
    std::vector<std::pair<std::size_t, Point>> movers;
    for (auto& [id, point] : m_points)
      if (number_below(12) == 0) {
        const Position p = shaken(position_of(point), step);
        movers.emplace_back(id, point = Point(p.x, p.y, p.z));
      }
    const auto report = m_triangulation.move(movers);
    m_counts.add(report);
    EXPECT_TRUE(report.certified);
  }

  // One frame of some motion.
  void move_all()
  {
    static constexpr double steps[] = {0, 1e-4, 0.001, 0.01, 0.03, 0.1, 0.3, 1};
    const double spacing = m_extent / std::cbrt(double(m_points.size() + 1));
    const double step = steps[number_below(8)] * spacing;
    switch (number_below(9)) {
    case 0: // drift
      return update([&, x = between(-2, 2) * m_extent](Position p) {
        return shaken({p.x + x, p.y + x / 3, p.z}, step / 10);
      });
    case 1: // expansion or contraction
      return update([&, factor = between(0.5, 1.5)](Position p) {
        return shaken({p.x * factor, p.y * factor, p.z * factor}, step / 10);
      });
    case 2: // rotation
      return update([&, angle = between(0, 1) * step / m_extent](Position p) {
        const double c = std::cos(angle), s = std::sin(angle);
        return shaken({c * p.x - s * p.y, s * p.x + c * p.y, p.z}, step / 10);
      });
    case 3: // shear
      return update([&, strain = step / m_extent](Position p) {
        return Position{p.x + strain * p.z, p.y, p.z};
      });
    case 4: // streams that cross
      return update([&](Position p) {
        return shaken({p.x + (number_below(2) == 0 ? step : -step), p.y, p.z}, step / 10);
      });
    case 5: // some jump
      return update([&](Position p) {
        return number_below(20) == 0 ? position_of(anywhere()) : shaken(p, step);
      });
    case 6: // some go to one place
      return update([&, target = position_of(anywhere())](Position p) {
        return number_below(10) == 0 ? target : shaken(p, step);
      });
    case 7: // all into a plane, seldom
      if (number_below(8) == 0)
        return update([&](Position p) { return Position{p.x, p.y, 0}; });
      [[fallthrough]];
    default:
      return update([&](Position p) { return shaken(p, step); });
    }
  }

  void do_something()
  {
    switch (number_below(13)) {
    case 0:
      return insert(1 + number_below(1 + m_points.size() / 4));
    case 1:
      return remove(number_below(1 + m_points.size() / 4));
    case 2:
      return insert(1);
    case 3:
      return remove(1);
    case 4:
      return move_one();
    case 5:
      return glide();
    default:
      return move_all();
    }
  }

  // Some calm frames in a box, with points on its walls at times, where these nearly always stay.
  void glide()
  {
    constexpr int frames = 12;
    const double step = 1e-5 * m_extent / std::cbrt(double(m_points.size() + 1));
    const bool has_walls = number_below(2) == 0;
    std::normal_distribution<double> normal(0, step);
    for (int frame = 0; frame < frames; ++frame)
      update([&](Position p) {
        for (double* const x : {&p.x, &p.y, &p.z}) {
          if (has_walls && (frame == 0 ? number_below(6) == 0 : *x < 0 || *x > m_extent))
            *x = *x < m_extent / 2 ? 0 : m_extent;
          const bool is_on_wall = has_walls && (*x == 0 || *x == m_extent);
          if (!is_on_wall || number_below(64) == 0)
            *x = on_grid(*x + normal(m_random));
        }
        return p;
      });
  }

private:
  struct Position
  {
    double x, y, z;
  };

  std::size_t number_below(std::size_t n)
  {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(m_random);
  }
  double between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(m_random);
  }
  double coordinate()
  {
    const double x = between(0, m_extent);
    return on_grid(x);
  }
  double on_grid(double x) const { return m_grid > 0 ? std::floor(x / m_grid) * m_grid : x; }
  Point anywhere()
  {
    const double x = coordinate(), y = coordinate();
    return Point(x, y, m_thickness * coordinate());
  }
  std::size_t some_id()
  {
    return std::next(m_points.begin(), std::ptrdiff_t(number_below(m_points.size())))->first;
  }
  static Position position_of(const Point& p)
  {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }
  Position shaken(const Position& p, double step)
  {
    std::normal_distribution<double> normal(0, step > 0 ? step : 1);
    if (step == 0)
      return p;
    const double x = p.x + normal(m_random), y = p.y + normal(m_random);
    return {on_grid(x), on_grid(y), on_grid(p.z + m_thickness * normal(m_random))};
  }

  template <class Motion>
  void update(const Motion& motion)
  {
    std::vector<Point> frame(m_triangulation.number_of_ids(), Point(0, 0, 0));
    for (auto& [id, point] : m_points) {
      const Position p = motion(position_of(point));
      frame[id] = point = Point(p.x, p.y, p.z);
    }
    const auto report = m_triangulation.update(frame);
    m_counts.add(report);
    EXPECT_TRUE(report.certified);
  }

  Random m_random;
  double m_extent, m_grid, m_thickness;
  Counts m_counts;
  Dynamic m_triangulation;
  std::map<std::size_t, Point> m_points;
};

} // namespace space_operations

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SPACE_OPERATIONS_H
