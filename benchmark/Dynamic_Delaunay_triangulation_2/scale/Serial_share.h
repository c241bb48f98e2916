// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCALE_SERIAL_SHARE_H
#define SCALE_SERIAL_SHARE_H

#include "../common/Contest.h"
#include "../common/Csv_file.h"
#include "../common/Statistics.h"
#include "../common/Table.h"
#include "Part_log.h"
#include "Scale_motion.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Circumcircle_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Hold_and_flip_repair_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace scale {

// The default choices, which tell the log which phase begins. They derive, so that the
// triangulation finds the same in them.
class Logging_policy
{
public:
  explicit Logging_policy(const bool& is_rebuild_demanded)
    : m_is_rebuild_demanded(&is_rebuild_demanded)
  {
  }

  template <class Frame>
  bool wants_rebuild(const Frame&) const
  {
    Part_log::instance().enter(*m_is_rebuild_demanded ? Part_log::REST : Part_log::DECIDE);
    return *m_is_rebuild_demanded;
  }
  template <class Frame>
  void after_update(const Frame&, const CGAL::Update_report_2&) const
  {
  }

private:
  const bool* m_is_rebuild_demanded;
};

struct Logging_classifier : CGAL::Circumcircle_classifier_2
{
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    Part_log::instance().enter(Part_log::CLASSIFY);
    CGAL::Circumcircle_classifier_2::operator()(frame, classified);
    Part_log::instance().enter(Part_log::REST);
  }
};

struct Logging_repair : CGAL::Hold_and_flip_repair_2
{
  template <class Mender>
  void operator()(Mender& mender) const
  {
    Logging_mender<Mender> logging{mender};
    CGAL::Hold_and_flip_repair_2::operator()(logging);
  }

private:
  template <class Mender>
  struct Logging_mender
  {
    Mender& mender;

    bool is_rebuild_cheaper() const { return mender.is_rebuild_cheaper(); }
    bool can_hold() const { return mender.can_hold(); }
    bool is_done() const { return mender.is_done(); }
    void limit_cost() { mender.limit_cost(); }
    void rebuild(CGAL::Rebuild_reason_2 reason) { mender.rebuild(reason); }
    void splice_open(unsigned padding) { mender.splice_open(padding); }
    void hold()
    {
      log(Part_log::HOLD, [&] { mender.hold(); });
    }
    void flip()
    {
      log(Part_log::FLIP, [&] { mender.flip(); });
    }
    void release()
    {
      log(Part_log::RELEASE, [&] { mender.release(); });
    }

    template <class Work>
    void log(Part_log::Phase phase, const Work& work)
    {
      Part_log::instance().enter(phase);
      work();
      Part_log::instance().enter(Part_log::REST);
    }
  };
};

template <template <class, class, class...> class Triangulation>
using Measured =
    Triangulation<run::Kernel, Logging_classifier, CGAL::With_repair_2<Logging_repair>,
                  CGAL::With_policy_2<Logging_policy>, CGAL::With_concurrency_2<Measured_tag>>;

struct Measured_in_the_plane
{
  using Dynamic = Measured<CGAL::Dynamic_Delaunay_triangulation_2>;

  static Dynamic build(const Points& points, const Dynamic::Settings& settings)
  {
    return Dynamic(points.begin(), points.end(), settings);
  }
};

struct Measured_in_a_cell
{
  using Dynamic = Measured<CGAL::Dynamic_periodic_Delaunay_triangulation_2>;

  static Dynamic build(const Points& points, const Dynamic::Settings& settings)
  {
    const double side = std::sqrt(static_cast<double>(points.size()));
    return Dynamic(points.begin(), points.end(), CGAL::Periodic_cell_2(side, side), settings);
  }
};

// Writes, for each phase of a frame, how much of its time one thread spends outside of what threads
// can share, and what that leaves to gain.
class Serial_table
{
public:
  static constexpr std::array<std::size_t, 4> threads{2, 4, 16, 64};

  explicit Serial_table(std::ostream& out)
    : m_table(out, 34,
              {{"ns", 9, 2},
               {"serial", 9, 2},
               {"share", 8, 3},
               {"x2", 7, 2},
               {"x4", 7, 2},
               {"x16", 7, 2},
               {"x64", 7, 2}})
  {
    m_table.write_head("ns a point, one thread");
  }

  // `frames` are alike; the table has the medians.
  void write(const std::string& name, std::size_t points,
             const std::vector<Part_log::Entries>& frames)
  {
    write_row(name, points, frames, all_phases);
    for (std::size_t phase = 0; phase != Part_log::number_of_phases; ++phase) {
      if (median_of(frames, [&](const auto& entries) { return entries[phase].total; }) > 0.0) {
        write_row(std::string("  ") + Part_log::names[phase], points, frames, phase);
      }
    }
  }

private:
  static constexpr std::size_t all_phases = Part_log::number_of_phases;

  template <class Value>
  static double median_of(const std::vector<Part_log::Entries>& frames, const Value& value)
  {
    return common::median(common::values_of(frames, value));
  }

  // The sum of a figure over the phases of a frame, or that of one phase.
  template <class Figure>
  static double sum(const Part_log::Entries& entries, std::size_t phase, const Figure& figure)
  {
    double total = 0.0;
    for (std::size_t i = 0; i != entries.size(); ++i) {
      total += phase == all_phases || phase == i ? figure(entries[i]) : 0.0;
    }
    return total;
  }

  void write_row(const std::string& name, std::size_t points,
                 const std::vector<Part_log::Entries>& frames, std::size_t phase)
  {
    const auto median_sum = [&](const auto& figure) {
      return median_of(frames, [&](const auto& entries) { return sum(entries, phase, figure); });
    };
    const auto number = static_cast<double>(points);
    const double total = median_sum([](const auto& entry) { return entry.total; });
    const double serial = median_sum([](const auto& entry) { return entry.serial(); });
    std::array<double, threads.size()> gains{};
    for (std::size_t i = 0; i != gains.size(); ++i) {
      gains[i] = total / median_sum([&](const auto& entry) { return entry.with(threads[i]); });
    }
    m_table.write_row(name, total / number, serial / number, serial / total, gains[0], gains[1],
                      gains[2], gains[3]);
  }

  common::Table m_table;
};

// Measures frames, rebuilds, changes of the population, and the construction.
template <class Space>
class Serial_run
{
public:
  Serial_run(std::size_t points, std::size_t frames)
    : m_motion(points)
    , m_frames(frames)
  {
  }

  std::vector<Part_log::Entries> construct()
  {
    std::vector<Part_log::Entries> logs;
    for (std::size_t i = 0; i != m_frames; ++i) {
      Part_log::instance().start(Part_log::REST);
      const auto dynamic = Space::build(m_motion.points(), settings());
      logs.push_back(Part_log::instance().finish());
    }
    return logs;
  }

  std::vector<Part_log::Entries> follow(const Motion_kind& kind)
  {
    m_is_rebuild_demanded = kind.rebuilds;
    auto logs = repeat([&](Dynamic& dynamic) {
      m_motion.advance(kind);
      const Points& points = m_motion.points();
      Part_log::instance().start(Part_log::READ);
      dynamic.update(points.begin(), points.end());
    });
    m_is_rebuild_demanded = false;
    return logs;
  }

  // So many percent of the points, a divisor of 100, leave, and as many come elsewhere.
  std::vector<Part_log::Entries> exchange(std::size_t percent)
  {
    const std::size_t number = m_motion.points().size();
    const double side = std::sqrt(static_cast<double>(number));
    std::size_t first = 0;
    return repeat([&](Dynamic& dynamic) {
      std::vector<std::size_t> ids;
      Points coming;
      const std::size_t stride = 100 / percent;
      for (std::size_t id = first++ % stride; id < number; id += stride) {
        ids.push_back(id);
        const double x = m_random.uniform(0.0, side);
        coming.push_back({x, m_random.uniform(0.0, side)});
      }
      Part_log::instance().start(Part_log::REST);
      dynamic.remove(ids);
      dynamic.insert(coming);
    });
  }

private:
  using Dynamic = typename Space::Dynamic;

  // Calls change(triangulation), which starts the log, some times.
  template <class Change>
  std::vector<Part_log::Entries> repeat(const Change& change)
  {
    constexpr std::size_t warm_up = 2;
    std::vector<Part_log::Entries> logs;
    Dynamic dynamic = Space::build(m_motion.points(), settings());
    for (std::size_t frame = 0; frame != warm_up + m_frames; ++frame) {
      change(dynamic);
      const Part_log::Entries& entries = Part_log::instance().finish();
      if (frame >= warm_up) {
        logs.push_back(entries);
      }
      common::require(dynamic.is_certified(), "the triangulation is not certified");
    }
    return logs;
  }

  typename Dynamic::Settings settings() const
  {
    return {Logging_classifier(), Logging_repair(), {}, Logging_policy(m_is_rebuild_demanded)};
  }

  scenario::Random_source m_random{2};
  Scale_motion m_motion;
  std::size_t m_frames;
  bool m_is_rebuild_demanded = false;
};

} // namespace scale

#endif // SCALE_SERIAL_SHARE_H
