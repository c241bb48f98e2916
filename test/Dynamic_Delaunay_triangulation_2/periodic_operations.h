// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Random calls of a periodic triangulation: points come, go, move, jump, meet and are wrapped, and
// the cell changes.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PERIODIC_OPERATIONS_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PERIODIC_OPERATIONS_H

#include "random_points.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_cell_2.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <vector>

template <class Point>
void move_randomly(std::mt19937_64& random, std::vector<Point>& points, double step)
{
  std::normal_distribution<double> normal(0, step);
  for (Point& p : points) {
    const double x = p.x() + normal(random);
    p = Point(x, p.y() + normal(random));
  }
}

template <class Point>
Point image(const Point& p, const CGAL::Periodic_cell_2& cell, int i, int j)
{
  return Point(p.x() + i * cell.ax() + j * cell.bx(), p.y() + i * cell.ay() + j * cell.by());
}

// Of a triangulation, or of what has its functions `cell()`, `number_of_ids()`,
// `number_of_points()`, `point()`, `insert()`, `remove()`, `move()` and `update()`.
template <class Triangulation>
class Random_operations
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  using Cell = CGAL::Periodic_cell_2;

public:
  // Starts without points; about as many as the limit come.
  Random_operations(std::uint64_t seed, std::size_t limit)
    : m_random(seed)
    , m_is_slab(seed % 4 == 0)
    , m_pt(random_cell())
    , m_limit(limit)
  {
  }

  Triangulation& triangulation() { return m_pt; }

  // Any call for one point, or for all.
  void step()
  {
    const auto kind = m_random() % 10;
    if (m_points.empty() || kind < 2 || (m_limit > 100 && kind == 3)) {
      const Point p = random_point();
      const std::size_t id = m_pt.insert(p);
      ASSERT_TRUE(m_points.emplace(id, p).second);
    } else if (kind < 4 || m_points.size() > m_limit) {
      const std::size_t id = random_id();
      m_pt.remove(id);
      m_points.erase(id);
    } else if (kind < 6) {
      const std::size_t id = random_id();
      m_points[id] = m_random() % 2 == 0 ? random_point() : moved(m_points[id], 0.1);
      m_pt.move(id, m_points[id]);
    } else {
      if (m_points.size() < 3 && m_random() % 4 == 0)
        m_limit = 1 + m_random() % (m_limit > 100 ? 200 : 40);
      update(kind);
    }
  }

  // Several points at once.
  void insert(std::size_t number)
  {
    std::vector<Point> points;
    while (points.size() < number)
      points.push_back(random_point());
    std::vector<std::size_t> ids;
    m_pt.insert(points.begin(), points.end(), std::back_inserter(ids));
    ASSERT_EQ(ids.size(), number);
    for (std::size_t i = 0; i < number; ++i)
      ASSERT_TRUE(m_points.emplace(ids[i], points[i]).second);
  }

  // A point goes to where another one is, or an image of it.
  void meet()
  {
    const std::size_t id = random_id();
    m_points[id] = random_image(m_points[random_id()], m_pt.cell());
    m_pt.move(id, m_points[id]);
  }

  // A frame in which most points shake and some jump, maybe with another cell.
  void shake()
  {
    const double step = std::pow(10.0, random_between(m_random, -4, 0));
    update(m_random() % 3 == 0 ? next_cell() : m_pt.cell(), [&](const Point& p) {
      return m_random() % 10 == 0 ? random_point() : m_random() % 3 == 0 ? p : moved(p, step);
    });
  }

  // Expects all points where they went.
  void expect_points() const
  {
    ASSERT_EQ(m_pt.number_of_points(), m_points.size());
    for (const auto& [id, p] : m_points)
      ASSERT_EQ(m_pt.point(id), p);
  }

private:
  double side() const { return 3; }

  Cell random_cell()
  {
    if (m_is_slab)
      return Cell::slab(random_between(m_random, -4, 4), m_random() % 2 == 0 ? 0 : side());
    if (m_random() % 2 == 0)
      return Cell(side(), side());
    return Cell(side(), random_between(m_random, -1, 1), random_between(m_random, -4, 4),
                side() * random_between(m_random, 0.3, 1));
  }

  Point random_point()
  {
    const double grid = m_random() % 2 == 0 ? 0.25 : 0;
    const double extent = m_random() % 8 == 0 ? 50 : side();
    return random_points(m_random, 1, extent, grid)[0];
  }

  std::size_t random_id()
  {
    auto it = m_points.begin();
    std::advance(it, m_random() % m_points.size());
    return it->first;
  }

  Point moved(const Point& p, double step)
  {
    std::vector<Point> one{p};
    move_randomly(m_random, one, step);
    return one[0];
  }

  // One of the next ones, along a slab.
  Point random_image(const Point& p, const Cell& cell)
  {
    return image(p, cell, int(m_random() % 3) - 1, m_is_slab ? 0 : int(m_random() % 3) - 1);
  }

  void update(std::uint64_t kind)
  {
    const double step = std::pow(10.0, random_between(m_random, -4, 0));
    update(kind == 8 ? next_cell() : m_pt.cell(), [&](const Point& p) {
      if (kind == 9)
        return m_random() % 10 == 0 ? random_point() : p;
      return m_random() % 3 == 0 ? moved(p, step) : p;
    });
  }

  // Moves each point p to `next_place(p)`, or to an image of that.
  template <class Next_place>
  void update(const Cell& cell, const Next_place& next_place)
  {
    std::vector<Point> next(m_pt.number_of_ids());
    for (auto& [id, p] : m_points) {
      p = next_place(p);
      if (m_random() % 5 == 0)
        p = random_image(p, cell);
      next[id] = p;
    }
    m_pt.update(next, cell);
  }

  Cell next_cell()
  {
    const Cell& cell = m_pt.cell();
    return m_random() % 4 == 0 ? random_cell()
           : m_is_slab         ? Cell::slab(cell.ax() * 1.02, cell.ay())
                       : Cell(cell.ax() * 1.02, cell.ay(), cell.bx() + 0.1, cell.by() * 0.99);
  }

  std::mt19937_64 m_random;
  bool m_is_slab;
  Triangulation m_pt;
  std::map<std::size_t, Point> m_points;
  std::size_t m_limit;
};

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PERIODIC_OPERATIONS_H
