// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Random programs that move, insert and remove points in periodic space of three dimensions, and
// deform its cell.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PERIODIC_SPACE_OPERATIONS_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PERIODIC_SPACE_OPERATIONS_H

#include "periodic_space_oracle.h"
#include "space_operations.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_cell_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace periodic_space_operations {

using Cell = CGAL::Periodic_cell_3;
using Coordinates = Cell::Coordinates;

// Where points are, and what happens to them.
struct Setting
{
  Cell cell{1, 1, 1};   // in the beginning
  double scale = 1;     // of everything
  double grid = 0;      // if not 0, points are on its multiples: on spheres, planes and each other
  int far = 2;          // images of points are so many cells away
  int meetings = 12;    // one in so many points comes to an image of another one
  bool deforms = false; // the cell, in most operations
  bool walls = false;   // most points are on walls across the last axes, of a cell along the others
};

// A triangulation, the points and the cell that it should have, and what happens to all of them.
template <class Dynamic, class Random = std::mt19937_64>
class Program
{
public:
  using Point = typename Dynamic::Point;

  Program(const Random& random, const Setting& setting)
    : m_random(random)
    , m_setting(setting)
    , m_cell(first_cell())
    , m_dt(m_cell)
  {
  }

  const Dynamic& triangulation() const { return m_dt; }
  const std::map<std::size_t, Point>& points() const { return m_points; }
  const space_operations::Counts& counts() const { return m_counts; }

  // By exact fractions. Cost: some 50 microseconds a point.
  void expect_exact() const { periodic_space_oracle::expect_exact(m_dt, m_points, m_cell); }

  // As a fresh triangulation of these points, ties included; of points that coincide, the
  // representatives are enough.
  void expect_as_fresh() const
  {
    EXPECT_TRUE(m_dt.is_certified());
    EXPECT_TRUE(m_dt.is_valid(true));
    ASSERT_EQ(m_dt.number_of_points(), m_points.size());
    std::vector<Point> points;
    std::vector<std::size_t> ids;
    for (const auto& [id, point] : m_points) {
      EXPECT_EQ(m_dt.point(id), point);
      if (m_dt.representative(id) == id) {
        ids.push_back(id);
        points.push_back(point);
      }
    }
    EXPECT_EQ(m_dt.number_of_vertices(), ids.size());
    const Dynamic fresh(points, m_cell);
    EXPECT_EQ(fresh.number_of_vertices(), ids.size());
    EXPECT_EQ(fresh.number_of_edges(), m_dt.number_of_edges());
    std::set<std::array<periodic_space_oracle::Site, 4>> expected;
    for (auto sites : periodic_space_oracle::cells_of(fresh)) {
      for (auto& site : sites)
        site.first = ids.at(site.first);
      periodic_space_oracle::normalize(sites);
      expected.insert(sites);
    }
    EXPECT_EQ(periodic_space_oracle::cells_of(m_dt), expected);
  }

  void do_something()
  {
    switch (m_setting.deforms && number_below(3) > 0 ? 5 : number_below(17)) {
    case 0:
      return insert(1 + number_below(1 + m_points.size() / 4));
    case 1:
      return remove(number_below(1 + m_points.size() / 4));
    case 2:
      return insert(1);
    case 3:
      return remove(1);
    case 4:
      return move_some();
    case 5:
    case 6:
    case 7:
      return change_cell();
    case 8:
      return go_on_with_a_copy();
    case 9:
      return glide();
    default:
      return move_all();
    }
  }

  void insert(std::size_t number)
  {
    std::vector<Point> points;
    for (std::size_t i = 0; i < number; ++i)
      points.push_back(anywhere());
    insert(points);
  }

  // A crystal that fills the cell, of a slab or a wire up to the scale: `side` unit cells along
  // each vector, of a cubic lattice and, for the other kinds, of points in the middle of its facets
  // or in that of its cells.
  void insert_crystal(std::size_t side, std::size_t kind)
  {
    static const std::vector<std::vector<Coordinates>> bases = {
        {{0, 0, 0}},
        {{0, 0, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}},
        {{0, 0, 0}, {0.5, 0.5, 0.5}}};
    std::vector<Point> points;
    for (std::size_t i = 0; i < side * side * side; ++i)
      for (const Coordinates& x : bases.at(kind)) {
        const std::size_t n[] = {i / side / side, i / side % side, i % side};
        Coordinates p{0, 0, 0};
        for (std::size_t j = 0; j < 3; ++j)
          for (std::size_t k = 0; k < 3; ++k)
            p[k] += (double(n[j]) + x[j]) / double(side) * vector(j)[k];
        points.emplace_back(p[0], p[1], p[2]);
      }
    insert(points);
  }

  void remove(std::size_t number)
  {
    std::vector<std::size_t> ids;
    while (ids.size() < number && !m_points.empty()) {
      ids.push_back(some_id());
      m_points.erase(ids.back());
    }
    const auto report = m_dt.remove(ids);
    m_counts.add(report);
    EXPECT_EQ(report.removed, ids.size());
  }

private:
  using Position = Coordinates;

  std::size_t number_below(std::size_t n)
  {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(m_random);
  }
  double between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(m_random);
  }

  Cell first_cell() const
  {
    std::array<Coordinates, 3> v{m_setting.cell.a(), m_setting.cell.b(), m_setting.cell.c()};
    for (Coordinates& vector : v)
      for (double& x : vector)
        x *= m_setting.scale;
    return cell_of(v);
  }
  Cell cell_of(const std::array<Coordinates, 3>& v) const
  {
    return m_setting.cell.is_wire()   ? Cell(v[0])
           : m_setting.cell.is_slab() ? Cell(v[0], v[1])
                                      : Cell(v[0], v[1], v[2]);
  }
  std::size_t vectors() const { return std::size_t(m_setting.cell.dimension()); }
  // The volume of the cell, of a slab its area times the scale, of a wire its length times the
  // square of that.
  double size() const
  {
    return m_cell.dimension() == 3 ? m_cell.volume()
                                   : std::abs(determinant(vector(0), vector(1), vector(2)));
  }
  // A vector of the cell, or across it, as long as the scale.
  Coordinates vector(std::size_t i) const
  {
    Coordinates v = m_cell.vector(i);
    for (double& x : v)
      x *= i < vectors() ? 1 : m_setting.scale;
    return v;
  }

  double on_grid(double x) const
  {
    const double grid = m_setting.grid * m_setting.scale;
    return grid > 0 ? std::round(x / grid) * grid : x;
  }
  Point point_at(const Position& p) const
  {
    const auto at = [&](std::size_t axis) {
      const double x = on_grid(p[axis]);
      return m_setting.walls && axis >= vectors() ? std::clamp(x, 0.0, m_setting.scale) : x;
    };
    return Point(at(0), at(1), at(2));
  }
  Point anywhere()
  {
    if (!m_points.empty() && number_below(std::size_t(m_setting.meetings)) == 0)
      return image(m_points[some_id()]);
    const double s = m_setting.scale;
    const double x = between(-s, 2 * s), y = between(-s, 2 * s), z = between(-s, 2 * s);
    const Point p = point_at({x, y, z});
    return m_setting.far > 2 ? image(p) : p;
  }
  // Rounded: so it may be next to an image. The point itself where that is too far away.
  Point image(const Point& p)
  {
    Position x{p.x(), p.y(), p.z()};
    for (std::size_t i = 0; i < vectors(); ++i) {
      const double multiple =
          double(number_below(std::size_t(2 * m_setting.far + 1))) - double(m_setting.far);
      for (std::size_t k = 0; k < 3; ++k)
        x[k] += multiple * m_cell.vector(i)[k];
    }
    const Point q(x[0], x[1], x[2]);
    return is_far(q) ? p : q;
  }
  std::size_t some_id()
  {
    return std::next(m_points.begin(), std::ptrdiff_t(number_below(m_points.size())))->first;
  }

  void insert(const std::vector<Point>& points)
  {
    std::vector<std::size_t> ids;
    m_counts.add(m_dt.insert(points.begin(), points.end(), std::back_inserter(ids)));
    ASSERT_EQ(ids.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      ASSERT_TRUE(m_points.emplace(ids[i], points[i]).second);
  }

  void move_some()
  {
    std::vector<std::pair<std::size_t, Point>> movers;
    const std::size_t share = 1 + number_below(12);
    for (auto& [id, point] : m_points)
      if (number_below(share) == 0) {
        point = anywhere();
        movers.emplace_back(id, point);
      }
    const auto report = m_dt.move(movers);
    m_counts.add(report);
    EXPECT_TRUE(report.certified);
  }

  void go_on_with_a_copy()
  {
    Dynamic copy(m_dt);
    copy.swap(m_dt);
    EXPECT_TRUE(m_dt.certify());
    EXPECT_EQ(m_dt.mend().flips, 0u);
  }

  template <class Motion>
  void update(const Motion& motion)
  {
    std::vector<Point> points(m_dt.number_of_ids(), Point(0, 0, 0));
    for (auto& [id, point] : m_points)
      points[id] = point = motion(id, point);
    const auto report = number_below(2) == 0 ? m_dt.update(points, m_cell)
                                             : m_dt.update(points.begin(), points.end(), m_cell);
    m_counts.add(report);
    EXPECT_TRUE(report.certified);
  }

  void move_all()
  {
    static constexpr double steps[] = {0, 1e-6, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.3, 1};
    const double spacing = std::cbrt(size() / double(m_points.size() + 1));
    const double step = steps[number_below(9)] * spacing, s = m_setting.scale;
    std::normal_distribution<double> normal;
    const double x = between(-s, s), y = between(-s, s), z = between(-s, s);
    const bool drifts = number_below(4) == 0, cross = number_below(8) == 0;
    const bool wraps = number_below(3) == 0, jumps = number_below(4) == 0;
    const bool meet = number_below(6) == 0;
    const Point place = anywhere();
    update([&](std::size_t id, const Point& p) {
      if (jumps && number_below(20) == 0)
        return anywhere();
      if (meet && number_below(10) == 0)
        return image(place);
      const double share = drifts ? 1 : cross ? (id % 2 == 0 ? 0.5 : -0.5) : 0;
      const double dx = step * normal(m_random), dy = step * normal(m_random);
      const Point moved = point_at({p.x() + dx + share * x, p.y() + dy + share * y,
                                    p.z() + step * normal(m_random) + share * z});
      if (is_far(moved)) // comes back
        return point_at({x, y, z});
      return wraps && number_below(3) == 0 ? image(moved) : moved;
    });
  }
  // Some calm frames. What is on a wall nearly always stays there.
  void glide()
  {
    constexpr int frames = 12;
    const double step = 1e-5 * std::cbrt(size() / double(m_points.size() + 1));
    std::normal_distribution<double> normal(0, step);
    for (int frame = 0; frame < frames; ++frame)
      update([&](std::size_t, const Point& p) {
        Position moved{p.x(), p.y(), p.z()};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const bool is_on_wall = m_setting.walls && axis >= vectors() &&
                                  (moved[axis] == 0 || moved[axis] == m_setting.scale);
          if (!is_on_wall || number_below(64) == 0)
            moved[axis] += normal(m_random);
        }
        const Point q = point_at(moved);
        return is_far(q) ? p : q;
      });
  }
  bool is_far(const Point& p) const
  {
    const Coordinates a = vector(0), b = vector(1), c = vector(2);
    const Coordinates x{p.x(), p.y(), p.z()};
    const double share = (std::max)({std::abs(determinant(x, b, c)), std::abs(determinant(a, x, c)),
                                     std::abs(determinant(a, b, x))});
    return share > (100 + 4.0 * m_setting.far) * size();
  }
  static double determinant(const Coordinates& a, const Coordinates& b, const Coordinates& c)
  {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }

  // Deforms the cell, with the points or without them, or takes other vectors for its lattice.
  void change_cell()
  {
    std::array<Coordinates, 3> v{m_cell.a(), m_cell.b(), m_cell.c()};
    const std::size_t n = vectors(), i = number_below(n);
    const std::size_t j = n == 1 ? 0 : (i + 1 + number_below(n - 1)) % n;
    const bool carries = number_below(4) > 0;
    const double grid = m_setting.grid;
    double strain = 0;
    std::array<double, 3> factors{1, 1, 1};
    switch (number_below(4)) {
    case 0: // another basis
      for (std::size_t k = 0; n > 1 && k < 3; ++k)
        v[i][k] += carries ? v[j][k] : -v[j][k];
      break;
    case 1: // a mirrored one
      std::swap(v[i], v[j]);
      for (std::size_t k = 0; n == 1 && k < 3; ++k)
        v[i][k] = -v[i][k];
      break;
    case 2: // shear
      strain = grid > 0 ? grid : between(-0.3, 0.3);
      break;
    default: // expansion or contraction
      for (double& factor : factors)
        factor = grid > 0 ? 1 + double(number_below(2)) : between(0.6, 1.6);
    }
    const auto deformed = [&](const Position& p) {
      return Position{p[0] * factors[0] + strain * p[1] * factors[1], p[1] * factors[1],
                      p[2] * factors[2]};
    };
    for (Coordinates& vector : v)
      vector = deformed(vector);
    double largest = 0, smallest = 1e300;
    for (std::size_t k = 0; k < n; ++k) {
      const Coordinates& vector = v[k];
      const double length =
          std::sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
      largest = (std::max)(largest, length);
      smallest = (std::min)(smallest, length);
    }
    const Cell first = first_cell();
    double usual = 0;
    for (std::size_t k = 0; k < n; ++k)
      usual = (std::max)(usual, std::sqrt(first.vector(k)[0] * first.vector(k)[0] +
                                          first.vector(k)[1] * first.vector(k)[1] +
                                          first.vector(k)[2] * first.vector(k)[2]));
    if (largest > 10 * usual || smallest < 0.02 * m_setting.scale) { // begins anew
      v = {first.a(), first.b(), first.c()};
      strain = 0;
      factors = {1, 1, 1};
    }
    m_cell = cell_of(v);
    update([&](std::size_t, const Point& p) {
      const Point moved = carries ? point_at(deformed({p.x(), p.y(), p.z()})) : p;
      return is_far(moved) ? point_at({0, 0, 0}) : moved;
    });
  }

  Random m_random;
  Setting m_setting;
  Cell m_cell;
  Dynamic m_dt;
  space_operations::Counts m_counts;
  std::map<std::size_t, Point> m_points;
};

} // namespace periodic_space_operations

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PERIODIC_SPACE_OPERATIONS_H
