// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPACE_THREAD_CASES_H
#define SPACE_THREAD_CASES_H

#include "../common/Statistics.h"
#include "../common/Table.h"
#include "Periodic_cases.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Threads.h"
#include "Space_points.h"
#include "Static_ways.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace space {

#ifdef CGAL_LINKED_WITH_TBB

inline unsigned most_threads()
{
  return unsigned(tbb::this_task_arena::max_concurrency());
}

// Points in open space.
struct In_open_space
{
  template <class Concurrency_tag>
  using Triangulation =
      CGAL::Dynamic_Delaunay_triangulation_3<Kernel, CGAL::With_concurrency_2<Concurrency_tag>>;

  template <class Concurrency_tag>
  static Triangulation<Concurrency_tag> triangulated(const Points& points)
  {
    return Triangulation<Concurrency_tag>(points);
  }
  static void insert_by_cgal(const Points& points) { insert_range_by_threads(points); }
  static bool is_right(const Triangulation<CGAL::Parallel_tag>& dt, const Points& points)
  {
    check(dt, points);
    return true;
  }
};

// In a cube that is repeated in all directions. CGAL inserts there by one thread.
struct In_periodic_space
{
  template <class Concurrency_tag>
  using Triangulation =
      CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel,
                                                      CGAL::With_concurrency_2<Concurrency_tag>>;

  static double edge(const Points& points) { return std::cbrt(double(points.size())); }
  template <class Concurrency_tag>
  static Triangulation<Concurrency_tag> triangulated(const Points& points)
  {
    return Triangulation<Concurrency_tag>(points, cell_of("cube", edge(points)));
  }
  static void insert_by_cgal(const Points& points) { insert_periodic(points, edge(points)); }
  static bool is_right(const Triangulation<CGAL::Parallel_tag>& dt, const Points& points)
  {
    return dt.is_valid(true) && dt.number_of_vertices() == points.size();
  }
};

// The same frames for one triangulation, in bursts: one update right after the other, as in a
// program that does nothing else.
template <class Space, class Concurrency_tag>
class Followed_burst
{
public:
  Followed_burst(const Points& points, unsigned threads)
    : m_threads(threads)
    , m_dynamic(m_threads.execute([&] { return Space::template triangulated<Tag>(points); }))
  {
  }

  void follow(const std::vector<Points>& frames)
  {
    for (const Points& points : frames) {
      const double time = run::nanoseconds_of(
          [&] { m_threads.execute([&] { m_report = m_dynamic.update(points); }); });
      if (&points != &frames.front()) { // which finds everything cold
        m_times.push_back(time / double(points.size()));
      }
    }
  }

  const std::vector<double>& times() const { return m_times; }
  const CGAL::Update_report_3& report() const { return m_report; }
  const auto& triangulation() const { return m_dynamic; }

private:
  using Tag = Concurrency_tag;

  run::Threads m_threads;
  typename Space::template Triangulation<Tag> m_dynamic;
  CGAL::Update_report_3 m_report;
  std::vector<double> m_times;
};

inline std::vector<common::Column> thread_columns()
{
  return {{"sequential", 12, 0}, {"one", 9, 0},  {"threads", 9, 0},
          {"worst", 9, 0},       {"/one", 9, 2}, {"/sequential", 13, 2}};
}
inline common::Table thread_table()
{
  return common::Table(std::cout, 24, thread_columns());
}
inline common::Table construction_table()
{
  std::vector<common::Column> columns = thread_columns();
  columns.insert(columns.end(), {{"CGAL", 9, 0}, {"/CGAL", 9, 2}});
  return common::Table(std::cout, 24, columns);
}

// Constructors of each kind, in turns.
template <class Space>
class Constructions
{
public:
  Constructions(const Points& points, unsigned threads)
    : m_points(points)
    , m_one(1)
    , m_all(threads)
  {
  }

  void measure()
  {
    using CGAL::Parallel_tag;
    add(m_sequential, [&] { Space::template triangulated<CGAL::Sequential_tag>(m_points); });
    add(m_by_one,
        [&] { m_one.execute([&] { Space::template triangulated<Parallel_tag>(m_points); }); });
    add(m_by_all,
        [&] { m_all.execute([&] { Space::template triangulated<Parallel_tag>(m_points); }); });
    add(m_by_cgal, [&] { m_all.execute([&] { Space::insert_by_cgal(m_points); }); });
  }
  void write_row(common::Table& table, const std::string& kind) const
  {
    table.write_row("  " + kind, common::median(m_sequential), common::median(m_by_one),
                    common::median(m_by_all), common::largest(m_by_all),
                    common::median_ratio(m_by_one, m_by_all),
                    common::median_ratio(m_sequential, m_by_all), common::median(m_by_cgal),
                    common::median_ratio(m_by_cgal, m_by_all));
  }

private:
  using Times = std::vector<double>;

  template <class Work>
  void add(Times& times, const Work& work)
  {
    times.push_back(run::nanoseconds_of(work) / double(m_points.size()));
  }

  const Points& m_points;
  run::Threads m_one, m_all;
  Times m_sequential, m_by_one, m_by_all, m_by_cgal;
};

template <class Space>
void write_construction_by_threads(common::Table& table, const std::string& kind, std::size_t n,
                                   unsigned threads)
{
  std::mt19937_64 random(1);
  Points points = points_of("poisson", n, random);
  std::shuffle(points.begin(), points.end(), random);
  Constructions<Space> constructions(points, threads);
  for (int i = 0; i != 7; ++i) {
    constructions.measure();
  }
  constructions.write_row(table, kind);
}

template <class Space>
void write_threads(common::Table& table, const std::string& kind, std::size_t n, double step,
                   unsigned threads, int frames)
{
  constexpr std::size_t burst = 5;
  std::mt19937_64 random(1);
  Points points = points_of("poisson", n, random);
  Followed_burst<Space, CGAL::Sequential_tag> sequential(points, 1);
  Followed_burst<Space, CGAL::Parallel_tag> one(points, 1), all(points, threads);
  for (int frame = 0; frame < frames; frame += int(burst) - 1) {
    std::vector<Points> next;
    for (std::size_t i = 0; i != burst; ++i) {
      move("poisson", step, points, random);
      next.push_back(points);
    }
    sequential.follow(next);
    one.follow(next);
    all.follow(next);
  }
  for (const std::size_t flips : {one.report().flips, all.report().flips}) {
    if (flips != sequential.report().flips) {
      throw std::runtime_error("threads have done something else");
    }
  }
  if (!Space::is_right(all.triangulation(), points)) {
    throw std::runtime_error("a triangulation by threads is wrong");
  }
  table.write_row("  " + kind + ' ' + common::cell(step, 4), common::median(sequential.times()),
                  common::median(one.times()), common::median(all.times()),
                  common::largest(all.times()), common::median_ratio(one.times(), all.times()),
                  common::median_ratio(sequential.times(), all.times()));
}

#endif // CGAL_LINKED_WITH_TBB

} // namespace space

#endif // SPACE_THREAD_CASES_H
