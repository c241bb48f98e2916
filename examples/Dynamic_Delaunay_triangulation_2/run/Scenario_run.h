// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_SCENARIO_RUN_H
#define RUN_SCENARIO_RUN_H

#include "../scenario/Motion.h"
#include "Any_policy.h"
#include "Any_repair.h"
#include "Frame_record.h"
#include "Kept_triangulation.h"
#include "Kernel.h"
#include "Neighbor_reader.h"
#include "Static_opponents.h"
#include "Stopwatch.h"

#include <CGAL/delaunay_agreement.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace run {

// Lets a motion run and keeps its triangulation: times every frame against the static opponents,
// and checks the result outside of the timing.
template <class Classifier>
class Scenario_run
{
public:
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel, Classifier, Any_repair,
                                                         CGAL::Default, Any_policy>;

  Scenario_run(scenario::Motion& motion, const Classifier& classifier, const Any_repair& repair,
               const CGAL::Static_engines_2& engines, const Any_policy& policy)
    : m_motion(motion)
  {
    with_frame_in_message([&] {
      begin_frame();
      m_kept.emplace(motion, Dynamic(classifier, repair, engines, policy));
    });
  }

  void check_first_frame()
  {
    with_frame_in_message([this] {
      m_opponents.prepare(m_motion.points(), m_record.population_changed);
      m_opponents.time_insert();
      check();
    });
  }

  // Goes to the next frame, times everybody there, and checks what came out. False at the end of
  // the motion.
  bool advance()
  {
    const bool is_there = measure();
    if (is_there) {
      with_frame_in_message([this] { check(); });
    }
    return is_there;
  }

  // The same without the checks, where they would take longer than all else.
  bool measure()
  {
    return go_on([this] {
      m_opponents.prepare(m_motion.points(), m_record.population_changed);
      time_all();
    });
  }

  // The same without the checks and the opponents, on the way to the frames that count. Their order
  // for the opponents comes from the frame before the next one that is measured, if `is_last`.
  bool follow(bool is_last)
  {
    return go_on([this, is_last] {
      time_dynamic();
      if (is_last) {
        m_opponents.prepare(m_motion.points(), m_record.population_changed);
      }
    });
  }

  const scenario::Motion& motion() const { return m_motion; }
  const Dynamic& triangulation() const { return m_kept->triangulation(); }
  const Frame_record& record() const { return m_record; }

  // The vertex, in the frame of the triangulation, of the point in this place of the motion.
  auto vertex(std::size_t place) const
  {
    using Index = typename Dynamic::Frame::Index;
    return triangulation().frame().vertex(static_cast<Index>(m_kept->id(m_motion, place)));
  }

private:
  template <class Work>
  void with_frame_in_message(Work work) const
  {
    try {
      work();
    } catch (const std::exception& error) {
      throw std::runtime_error("frame " + std::to_string(m_record.frame) + ": " + error.what());
    }
  }

  template <class Work>
  bool go_on(Work work)
  {
    ++m_record.frame;
    bool is_there = false;
    with_frame_in_message([&] {
      is_there = m_motion.advance(m_neighbors(m_motion, triangulation()));
      if (is_there) {
        begin_frame();
        work();
      }
    });
    return is_there;
  }

  void begin_frame()
  {
    check_coordinates();
    m_record.time = m_motion.time();
    m_record.points = m_motion.points().size();
    m_record.population_changed = m_motion.population_changed();
    m_record.update = {};
  }

  // CGAL's static triangulation may never end on a coordinate that is no number.
  void check_coordinates() const
  {
    for (std::size_t i = 0; i != m_motion.points().size(); ++i) {
      const scenario::Point& point = m_motion.points()[i];
      if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
        throw std::runtime_error("the point with id " + std::to_string(m_motion.ids()[i]) +
                                 " has left all bounds; a smaller time step may keep it");
      }
    }
  }

  // The order rotates: whoever comes first warms the caches for the others.
  void time_all()
  {
    constexpr std::size_t contestants = 3;
    for (std::size_t i = 0; i != contestants; ++i) {
      switch ((m_record.frame + i) % contestants) {
      case 0:
        time_dynamic();
        break;
      case 1:
        m_record.nanoseconds.static_insert = m_opponents.time_insert();
        break;
      default:
        m_record.nanoseconds.static_fastest = m_opponents.time_fastest();
      }
    }
  }

  void time_dynamic()
  {
    m_record.nanoseconds.dynamic =
        nanoseconds_of([this] { m_record.update = m_kept->update(m_motion); });
  }

  void check()
  {
    // before certify(): what claims to be certified is checked for it too
    if (!triangulation().is_valid()) {
      throw std::runtime_error("the triangulation is not valid");
    }
    m_record.certified = m_kept->certify();
    m_record.validity = CGAL::delaunay_agreement(triangulation(), m_opponents.reference())
                            .matthews_correlation_coefficient();
  }

  scenario::Motion& m_motion;
  std::optional<Kept_triangulation<Dynamic>> m_kept;
  Static_opponents m_opponents;
  Neighbor_reader m_neighbors;
  Frame_record m_record;
};

} // namespace run

#endif // RUN_SCENARIO_RUN_H
