// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_SCENARIO_RUN_H
#define RUN_SCENARIO_RUN_H

#include "../scenario/Motion.h"
#include "Any_policy.h"
#include "Any_repair.h"
#include "Frame_record.h"
#include "Kernel.h"
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
    , m_repair(repair)
    , m_engines(engines)
  {
    with_frame_in_message([&] {
      prepare();
      construct(classifier, policy);
      m_opponents.time_insert();
      check();
    });
  }

  // False at the end of the motion.
  bool advance()
  {
    ++m_record.frame;
    bool is_there = false;
    with_frame_in_message([&] {
      is_there = m_motion.advance(neighbors());
      if (is_there) {
        prepare();
        time_all();
        check();
      }
    });
    return is_there;
  }

  const scenario::Motion& motion() const { return m_motion; }
  const Dynamic& triangulation() const { return *m_triangulation; }
  const Frame_record& record() const { return m_record; }

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

  const scenario::Neighbor_edges& neighbors()
  {
    m_neighbors.clear();
    if (m_motion.uses_neighbors()) {
      m_triangulation->for_each_edge([this](std::size_t i, std::size_t j) {
        m_neighbors.emplace_back(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
      });
    }
    return m_neighbors;
  }

  void prepare()
  {
    check_coordinates();
    m_record.time = m_motion.time();
    m_record.points = m_motion.points().size();
    m_record.population_changed = m_motion.population_changed();
    m_record.update = {};
    m_opponents.prepare(m_motion.points(), m_record.population_changed);
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
        m_record.nanoseconds.dynamic =
            m_record.population_changed ? time_construction() : time_update();
        break;
      case 1:
        m_record.nanoseconds.static_insert = m_opponents.time_insert();
        break;
      default:
        m_record.nanoseconds.static_fastest = m_opponents.time_fastest();
      }
    }
  }

  double time_update()
  {
    const auto& points = m_motion.points();
    return nanoseconds_of([&] {
      m_record.update = m_triangulation->update(points.begin(), points.end(), Point_map());
    });
  }

  double time_construction()
  {
    const Classifier classifier = m_triangulation->classifier();
    const Any_policy policy = m_triangulation->policy();
    m_triangulation.reset();
    return nanoseconds_of([&] { construct(classifier, policy); });
  }

  void construct(const Classifier& classifier, const Any_policy& policy)
  {
    const auto& points = m_motion.points();
    m_triangulation.emplace(points.begin(), points.end(), Point_map(), classifier, m_repair,
                            m_engines, policy);
  }

  void check()
  {
    // before certify(): what claims to be certified is checked for it too
    if (!m_triangulation->is_valid()) {
      throw std::runtime_error("the triangulation is not valid");
    }
    m_record.certified = m_triangulation->certify();
    m_record.validity = CGAL::delaunay_agreement(*m_triangulation, m_opponents.reference())
                            .matthews_correlation_coefficient();
  }

  scenario::Motion& m_motion;
  Any_repair m_repair;
  CGAL::Static_engines_2 m_engines;
  std::optional<Dynamic> m_triangulation;
  Static_opponents m_opponents;
  scenario::Neighbor_edges m_neighbors;
  Frame_record m_record;
};

} // namespace run

#endif // RUN_SCENARIO_RUN_H
