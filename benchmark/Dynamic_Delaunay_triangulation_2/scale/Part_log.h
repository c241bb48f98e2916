// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCALE_PART_LOG_H
#define SCALE_PART_LOG_H

#include "../common/Thread_time.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Part_runner.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <queue>
#include <string_view>
#include <utility>
#include <vector>

namespace scale {

// How one thread has spent its time: in parts that threads could share, each on its own, and
// elsewhere, phase by phase. Nanoseconds of the processor, which other programs do not disturb.
class Part_log
{
public:
  enum Phase { READ, DECIDE, CLASSIFY, EXAMINE, HOLD, FLIP, RELEASE, REST, number_of_phases };
  static constexpr std::array<const char*, number_of_phases> names = {
      "read", "decide", "classify", "examine", "hold", "flip", "release", "rest"};

  struct Entry
  {
    double total = 0.0;
    std::vector<std::vector<double>> runs{}; // the parts of each piece of work that can be shared

    double serial() const
    {
      double time = total;
      for (const std::vector<double>& parts : runs) {
        for (const double part : parts) {
          time -= part;
        }
      }
      return time;
    }

    // With so many threads, each of which takes the next part as soon as it is free. Waking them
    // up, and sharing caches and memory, is not in it.
    double with(std::size_t threads) const
    {
      double time = serial();
      for (const std::vector<double>& parts : runs) {
        time += end_of(parts, threads);
      }
      return time;
    }
  };
  using Entries = std::array<Entry, number_of_phases>;

  void start(Phase phase)
  {
    m_entries = Entries();
    m_phase = phase;
    m_begin = common::thread_nanoseconds();
  }

  // Ends the phase, and begins another one.
  void enter(Phase phase)
  {
    const double end = common::thread_nanoseconds();
    m_entries[m_phase].total += end - m_begin;
    m_begin = end;
    m_phase = phase;
  }

  void enter(std::string_view name)
  {
    enter(static_cast<Phase>(std::find(names.begin(), names.end(), name) - names.begin()));
  }

  const Entries& finish()
  {
    enter(m_phase);
    return m_entries;
  }

  // Does all parts of some work. Reads the clock between two parts once, which may be a call of the
  // system of a microsecond: read at both ends of each part, it was most of what seemed serial in
  // calm frames.
  template <class Function>
  void run(std::size_t parts, const Function& f)
  {
    std::vector<double> times(parts);
    double begin = common::thread_nanoseconds();
    for (double& time : times) {
      f(static_cast<std::size_t>(&time - times.data()));
      const double end = common::thread_nanoseconds();
      time = end - begin;
      begin = end;
    }
    m_entries[m_phase].runs.push_back(std::move(times));
  }

  // What the tag below writes to.
  static Part_log& instance()
  {
    static Part_log log;
    return log;
  }

private:
  static double end_of(const std::vector<double>& parts, std::size_t threads)
  {
    std::priority_queue<double, std::vector<double>, std::greater<double>> free_at(
        std::greater<double>(), std::vector<double>(threads, 0.0));
    double end = 0.0;
    for (const double part : parts) {
      const double done = free_at.top() + part;
      free_at.pop();
      free_at.push(done);
      end = (std::max)(end, done);
    }
    return end;
  }

  Entries m_entries;
  Phase m_phase = REST;
  double m_begin = 0.0;
};

// Divides work as for threads, and measures the parts.
struct Measured_tag : CGAL::Parallel_tag
{
};

} // namespace scale

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

template <>
struct Phase_log<scale::Measured_tag>
{
  static void enter(const char* name) { scale::Part_log::instance().enter(name); }
};

template <>
class Part_runner<scale::Measured_tag>
{
public:
  static constexpr bool is_parallel = true;

  static std::size_t most_workers() { return std::size_t(-1); }

  template <class Function>
  static void run(std::size_t parts, std::size_t workers, const Function& f)
  {
    if (workers > 1) {
      return scale::Part_log::instance().run(parts, f);
    }
    for (std::size_t part = 0; part != parts; ++part) {
      f(part);
    }
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // SCALE_PART_LOG_H
