// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPACE_FRAME_CASES_H
#define SPACE_FRAME_CASES_H

#include "../common/Statistics.h"
#include "../common/Table.h"
#include "Space_points.h"
#include "Static_ways.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_population_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace space {

// What happened in the frames of a case: one row of the table.
class Frame_figures
{
public:
  explicit Frame_figures(std::size_t points)
    : m_points(points)
  {
  }

  template <class Update, class Insert_sorted>
  void add_frame(const Points& points, const Update& update, const Insert_sorted& sorted)
  {
    CGAL::Update_report_3 report;
    m_updates.push_back(nanoseconds(m_points, [&] { report = update(); }));
    m_ranges.push_back(nanoseconds(m_points, [&] { insert_range(points); }));
    m_sorted.push_back(nanoseconds(m_points, sorted));
    m_fastest.push_back((std::min)(m_ranges.back(), m_sorted.back()));
    m_flips += double(report.flips);
    m_held += double(report.held);
    m_relocated += double(report.relocated);
    m_rebuilds += report.rebuilt();
  }

  void write_row(common::Table& table, const std::string& name) const
  {
    const double frames = double(m_updates.size()), all = double(m_points) * frames;
    table.write_row("  " + name, common::median(m_updates), common::largest(m_updates),
                    common::median(m_ranges), common::median(m_sorted),
                    common::median_ratio(m_fastest, m_updates), m_flips / all, 100 * m_held / all,
                    m_relocated / frames, 100 * m_rebuilds / frames);
  }

private:
  std::size_t m_points;
  std::vector<double> m_updates, m_ranges, m_sorted, m_fastest;
  double m_flips = 0, m_held = 0, m_relocated = 0, m_rebuilds = 0;
};

inline common::Table frame_table()
{
  return common::Table(std::cout, 24,
                       {{"update", 9, 0},
                        {"worst", 9, 0},
                        {"insert", 9, 0},
                        {"sorted", 9, 0},
                        {"/fastest", 10, 2},
                        {"flips", 8, 3},
                        {"held %", 8, 3},
                        {"relocated", 11, 2},
                        {"rebuilds %", 12, 0}});
}

inline void write_motion(common::Table& table, const std::string& kind, std::size_t n, double step,
                         int frames)
{
  std::mt19937_64 random(1);
  Points points = points_of(kind, n, random);
  Dynamic dt(points);
  Frame_figures figures(points.size());
  for (int frame = 0; frame != frames; ++frame) {
    move(kind, step, points, random);
    figures.add_frame(
        points, [&] { return dt.update(points); }, [&] { insert_sorted(points); });
  }
  check(dt, points);
  figures.write_row(table, kind + ' ' + common::cell(step, 4));
}

// Points at rest, of which some leave and as many come in each frame, anywhere. Newcomers are last
// in a frame, as their ids are the largest ones.
class Visited_cloud
{
public:
  using Frame = std::vector<std::pair<int, Point>>;

  Visited_cloud(std::size_t n, std::mt19937_64& random)
    : m_random(random)
    , m_place(0, std::cbrt(double(n)))
  {
    for (const Point& p : points_of("poisson", n, random)) {
      m_frame.emplace_back(m_next++, p);
    }
  }

  void exchange(std::size_t number)
  {
    Frame stayers;
    std::sample(m_frame.begin(), m_frame.end(), std::back_inserter(stayers),
                m_frame.size() - number, m_random); // keeps the order
    m_frame.swap(stayers);
    m_sorted = points();
    CGAL::spatial_sort(m_sorted.begin(), m_sorted.end());
    m_newcomers.clear();
    for (std::size_t i = 0; i != number; ++i) {
      const double x = m_place(m_random), y = m_place(m_random);
      m_newcomers.emplace_back(x, y, m_place(m_random));
      m_frame.emplace_back(m_next++, m_newcomers.back());
    }
  }

  const Frame& frame() const { return m_frame; }
  // Those that were there in the frame before, along a curve.
  const Points& sorted() const { return m_sorted; }
  Points& newcomers() { return m_newcomers; }

  Points points() const
  {
    Points points;
    for (const auto& member : m_frame) {
      points.push_back(member.second);
    }
    return points;
  }

private:
  std::mt19937_64& m_random;
  std::uniform_real_distribution<double> m_place;
  Frame m_frame;
  int m_next = 0;
  Points m_sorted, m_newcomers;
};

inline void write_population(common::Table& table, std::size_t n, double share, int frames)
{
  std::mt19937_64 random(1);
  Visited_cloud cloud(n, random);
  CGAL::Dynamic_population_3<Dynamic, int> population;
  population.update(cloud.frame());
  Frame_figures figures(n);
  for (int frame = 0; frame != frames; ++frame) {
    cloud.exchange(std::size_t(share * double(n)));
    figures.add_frame(
        cloud.points(), [&] { return population.update(cloud.frame()); },
        [&] { insert_sorted(cloud.sorted(), cloud.newcomers()); });
  }
  check(population.triangulation(), cloud.points());
  figures.write_row(table, "population " + common::cell(share, 2));
}

inline void write_construction(common::Table& table, std::size_t n)
{
  std::mt19937_64 random(1);
  Points points = points_of("poisson", n, random);
  std::shuffle(points.begin(), points.end(), random);
  std::vector<double> own, others;
  for (int i = 0; i != 5; ++i) {
    own.push_back(nanoseconds(n, [&] { const Dynamic dt(points); }));
    others.push_back(nanoseconds(n, [&] { insert_range(points); }));
  }
  table.write_row("  construction", common::median(own), common::largest(own),
                  common::median(others), 0.0, common::median_ratio(others, own), 0.0, 0.0, 0.0,
                  0.0);
}

} // namespace space

#endif // SPACE_FRAME_CASES_H
