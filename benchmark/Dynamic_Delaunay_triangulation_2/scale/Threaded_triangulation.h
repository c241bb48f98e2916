// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCALE_THREADED_TRIANGULATION_H
#define SCALE_THREADED_TRIANGULATION_H

#include "../common/Contest.h"
#include "../common/Timed_phases.h"
#include "Scale_motion.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Default.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_cell_2.h>
#include <CGAL/tags.h>

#include <cmath>
#include <optional>

namespace scale {

// Nanoseconds.
struct Frame_times
{
  double total = 0.0;
  common::Phase_times phases{};
  CGAL::Update_report_2 update{};
};

// An update policy that rebuilds when the benchmark wants it, and notes when it was asked.
class Rebuild_on_demand
{
public:
  Rebuild_on_demand(common::Phase_marks& marks, const bool& is_demanded)
    : m_marks(&marks)
    , m_is_demanded(&is_demanded)
  {
  }

  template <class Frame>
  bool wants_rebuild(const Frame&) const
  {
    m_marks->ask_policy();
    return *m_is_demanded;
  }

  template <class Frame>
  void after_update(const Frame&, const CGAL::Update_report_2&) const
  {
  }

private:
  common::Phase_marks* m_marks;
  const bool* m_is_demanded;
};

// The spaces in which points may be, each with its type of triangulation.
struct In_the_plane
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<
      run::Kernel, common::Timed_classifier, CGAL::With_repair_2<common::Timed_repair>,
      CGAL::With_policy_2<Rebuild_on_demand>, CGAL::With_concurrency_2<CGAL::Parallel_tag>>;

  static void build(std::optional<Dynamic>& dynamic, const Points& points,
                    const Dynamic::Settings& settings)
  {
    dynamic.emplace(points.begin(), points.end(), settings);
  }

  static void require_right(const Dynamic& dynamic, const Points& points)
  {
    common::require_equal(dynamic, run::Static_triangulation(points.begin(), points.end()));
  }
};

// In a square with an area of one for each point.
struct In_a_cell
{
  using Dynamic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<
      run::Kernel, common::Timed_classifier, CGAL::With_repair_2<common::Timed_repair>,
      CGAL::With_policy_2<Rebuild_on_demand>, CGAL::With_concurrency_2<CGAL::Parallel_tag>>;

  static void build(std::optional<Dynamic>& dynamic, const Points& points,
                    const Dynamic::Settings& settings)
  {
    const double side = std::sqrt(static_cast<double>(points.size()));
    dynamic.emplace(points.begin(), points.end(), CGAL::Periodic_cell_2(side, side), settings);
  }

  // Checks all conditions of a triangulation from scratch in exact arithmetic.
  static void require_right(const Dynamic& dynamic, const Points&)
  {
    common::require(dynamic.is_valid(), "the triangulation is not valid");
  }
};

// An exact triangulation all of whose work may use `threads` threads.
template <class Space>
class Threaded_triangulation
{
public:
  using Dynamic = typename Space::Dynamic;

  explicit Threaded_triangulation(unsigned threads)
    : m_threads(threads)
  {
  }
  Threaded_triangulation(const Threaded_triangulation&) = delete;
  Threaded_triangulation& operator=(const Threaded_triangulation&) = delete;

  // Nanoseconds.
  double build(const Points& points)
  {
    const typename Dynamic::Settings settings{common::Timed_classifier(m_marks),
                                              common::Timed_repair(m_marks),
                                              {},
                                              Rebuild_on_demand(m_marks, m_is_rebuild_demanded)};
    return run::nanoseconds_of(
        [&] { m_threads.execute([&] { Space::build(m_dynamic, points, settings); }); });
  }

  Frame_times update(const Points& points, bool is_rebuild_demanded)
  {
    m_is_rebuild_demanded = is_rebuild_demanded;
    Frame_times times;
    times.total = run::nanoseconds_of([&] {
      m_threads.execute([&] {
        m_marks.start();
        times.update = m_dynamic->update(points.begin(), points.end());
      });
    });
    times.phases = m_marks.times(times.total);
    common::require(m_dynamic->is_certified(), "the triangulation is not certified");
    return times;
  }

  void clear() { m_dynamic.reset(); }

  const Dynamic& dynamic() const { return *m_dynamic; }

private:
  run::Threads m_threads;
  common::Phase_marks m_marks;
  bool m_is_rebuild_demanded = false;
  std::optional<Dynamic> m_dynamic;
};

} // namespace scale

#endif // SCALE_THREADED_TRIANGULATION_H
