// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_SEQUENCE_RUN_H
#define ANY_MOTION_SEQUENCE_RUN_H

#include "../common/Contest.h"
#include "../common/Fastest_static.h"
#include "../common/Statistics.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Scenario_run.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace any_motion {

// Times in nanoseconds.
struct Frame_figures
{
  std::size_t frame = 0;
  std::size_t points = 0;
  double dynamic = 0.0;
  double insert = 0.0;
  double ordered = 0.0;
  double sorted = 0.0;
  CGAL::Update_report_2 report{};

  double fastest_static() const { return (std::min)({insert, ordered, sorted}); }
  double ratio() const { return dynamic / fastest_static(); }
};

// The figures of all measured frames of a sequence, at least one.
struct Sequence_figures
{
  std::string kind;
  std::string group;
  std::vector<Frame_figures> frames{};
  bool was_cut_short = false;

  // The number of points; of a changing population the median over the frames.
  std::size_t points() const
  {
    return static_cast<std::size_t>(
        common::median(common::values_of(frames, &Frame_figures::points)));
  }

  std::vector<double> ratios() const { return common::values_of(frames, &Frame_figures::ratio); }
  double median_ratio() const { return common::median(ratios()); }
  double worst_ratio() const { return common::largest(ratios()); }

  // The mean over frames of a count in the reports.
  double mean(std::size_t CGAL::Update_report_2::*count) const
  {
    return common::mean(
        common::values_of(frames, [&](const Frame_figures& frame) { return frame.report.*count; }));
  }

  std::size_t rebuilds() const
  {
    return static_cast<std::size_t>(
        std::count_if(frames.begin(), frames.end(),
                      [](const Frame_figures& frame) { return frame.report.rebuilt(); }));
  }
};

// The ratios above which a median, or a single frame, is slower than it should be.
constexpr double slow_median = 1.05, slow_frame = 1.3;

inline bool is_slow(const Sequence_figures& figures)
{
  return figures.median_ratio() > slow_median || figures.worst_ratio() > slow_frame;
}

struct Sequence_settings
{
  std::size_t warm_up = 2;                 // updates before the first one that is measured
  std::size_t repetitions = 2;             // at most, of a sequence that seems slow
  std::size_t max_checked_points = 10'000; // whose frames are compared with fresh ones
  double time_limit = 2.0;                 // seconds: a longer frame is the last one
};

// Follows a sequence of frames from its start.
class Sequence_run
{
public:
  Sequence_run(const scenario::Recording& recording, const Sequence_settings& settings)
    : m_recording(recording)
    , m_settings(settings)
    , m_motion("", recording)
    , m_kept(m_motion, Dynamic())
  {
    m_static.follow(recording.front());
  }

  // `figures` get the frames. A check compares every frame with a fresh triangulation.
  // \throws std::runtime_error if anything is wrong.
  void run(Sequence_figures& figures, bool is_checked)
  {
    for (std::size_t i = 1; i != m_recording.size() && !figures.was_cut_short; ++i) {
      m_motion.advance({});
      m_figures = {};
      m_figures.frame = i;
      m_figures.points = m_recording[i].points.size();
      const bool is_warm = i > m_settings.warm_up;
      if (is_warm ? measure() : follow()) {
        figures.frames.push_back(m_figures);
        if (is_checked && m_figures.points <= m_settings.max_checked_points) {
          common::require_equal(m_kept.triangulation(), m_static.reference(), common::in_frame(i));
        }
      }
      figures.was_cut_short = is_too_slow();
    }
  }

private:
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<run::Kernel>;

  bool measure()
  {
    m_static.prepare(current());
    common::in_turn(m_figures.frame, 2, [this](std::size_t contestant) {
      contestant == 0 ? time_dynamic() : time_static();
    });
    check_certificate();
    return true;
  }

  // Updates in a frame of the warm-up. True if it was so slow that it is measured nevertheless.
  bool follow()
  {
    time_dynamic();
    check_certificate();
    if (!is_too_slow()) {
      m_static.follow(current());
      return false;
    }
    m_static.prepare(current());
    time_static();
    return true;
  }

  void time_dynamic()
  {
    m_figures.dynamic =
        common::thread_nanoseconds_of([this] { m_figures.report = m_kept.update(m_motion); });
  }

  void time_static()
  {
    m_figures.insert = m_static.time_insert();
    m_figures.ordered = m_static.time_ordered();
    m_figures.sorted = m_static.time_sorted();
  }

  bool is_too_slow() const
  {
    const double slowest = (std::max)(m_figures.dynamic, m_figures.insert);
    return slowest > 1e9 * m_settings.time_limit;
  }

  const scenario::Recorded_frame& current() const { return m_recording[m_figures.frame]; }

  void check_certificate() const
  {
    common::require(m_figures.report.certified && m_kept.triangulation().is_certified(),
                    common::in_frame(m_figures.frame) + "the triangulation is not certified");
  }

  const scenario::Recording& m_recording;
  Sequence_settings m_settings;
  scenario::Recorded_motion m_motion;
  run::Kept_triangulation<Dynamic> m_kept;
  common::Fastest_static m_static;
  Frame_figures m_figures;
};

// Keeps the repetition with the smallest ratio of each frame.
inline void keep_the_best(Sequence_figures& best, const Sequence_figures& repeated)
{
  const std::size_t frames = (std::min)(best.frames.size(), repeated.frames.size());
  for (std::size_t i = 0; i != frames; ++i) {
    if (repeated.frames[i].frame == best.frames[i].frame &&
        repeated.frames[i].ratio() < best.frames[i].ratio()) {
      best.frames[i] = repeated.frames[i];
    }
  }
}

// A sequence that seems slow may have been disturbed: it is repeated, from the same start and with
// the same frames, unless it was cut short, and so is slow beyond doubt.
inline Sequence_figures measured(const scenario::Recording& recording,
                                 const Sequence_settings& settings)
{
  Sequence_figures best;
  Sequence_run(recording, settings).run(best, true);
  if (best.frames.empty()) {
    throw std::runtime_error("there are no frames after " + std::to_string(settings.warm_up) +
                             " to warm up");
  }
  for (std::size_t i = 0; i != settings.repetitions && !best.was_cut_short && is_slow(best); ++i) {
    Sequence_figures repeated;
    Sequence_run(recording, settings).run(repeated, false);
    keep_the_best(best, repeated);
  }
  return best;
}

} // namespace any_motion

#endif // ANY_MOTION_SEQUENCE_RUN_H
