// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SPACE_MOTION_RUN_3_H
#define SCENARIO_RUNNER_SPACE_MOTION_RUN_3_H

#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Method_choice.h"
#include "scenario_runner/space/Motion_3.h"
#include "scenario_runner/space/Static_triangulation_3.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_dynamic_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_static_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Chosen_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Key_frame_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_population_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace run {

using Any_policy_3 = CGAL::Chosen_policy_2<CGAL::Always_dynamic_policy_2,
                                           CGAL::Always_static_policy_2, CGAL::Key_frame_policy_2>;

// \throws std::invalid_argument for a policy that is for the plane alone
Any_policy_3 make_policy_3(const Policy_choice& choice);

using Dynamic_3 =
    CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel,
                                           CGAL::With_concurrency_2<Concurrency_tag>,
                                           CGAL::With_policy_2<Any_policy_3>>;

struct Frame_record_3 : Frame_facts
{
  CGAL::Update_report_3 update{};
};

// The triangulation of a motion in space, from its first frame on. If points come and go, it knows
// them by the motion's ids, otherwise by their places.
class Kept_motion_3
{
public:
  Kept_motion_3(const scenario::Motion_3& motion, const Any_policy_3& policy);

  CGAL::Update_report_3 update(const scenario::Motion_3& motion);

  const Dynamic_3& triangulation() const
  {
    return m_population ? m_population->triangulation() : *m_triangulation;
  }
  // The id in the triangulation of the point in this place of the motion.
  std::size_t id(const scenario::Motion_3& motion, std::size_t place) const
  {
    return m_population ? m_population->id(motion.ids()[place]) : place;
  }

  // To be called, outside of the timing, before place() if points have come or gone.
  void find_places(const scenario::Motion_3& motion);

  // The place in the motion of the point with this id in the triangulation.
  std::uint32_t place(std::size_t id) const { return m_places[id]; }

private:
  CGAL::Update_report_3 update_population(const scenario::Motion_3& motion);

  // exactly one of them exists
  std::optional<Dynamic_3> m_triangulation;
  std::optional<CGAL::Dynamic_population_3<Dynamic_3, std::int64_t>> m_population;
  std::vector<std::uint32_t> m_places; // by the triangulation's ids
};

// Lets a motion in space run and keeps its triangulation: times every frame against the static
// opponents, and checks the result by exact predicates outside of the timing.
class Motion_run_3
{
public:
  using Record = Frame_record_3;
  // The places in the motion of the corners of a cell.
  using Shown_cell_3 = std::array<std::uint32_t, 4>;

  explicit Motion_run_3(scenario::Motion_3& motion, const Any_policy_3& policy = Any_policy_3());

  void check_first_frame();

  // Goes to the next frame, times all contestants there, and checks what came out. False at the end
  // of the motion.
  bool advance();

  const scenario::Motion_3& motion() const { return m_motion; }
  const Frame_record_3& record() const { return m_record; }
  const Dynamic_3& triangulation() const { return m_kept.triangulation(); }

  // The finite cells. Of points that coincide the first one is a corner.
  std::vector<Shown_cell_3> cells() const;

  // The id in the triangulation of the point in this place of the motion.
  std::size_t id(std::size_t place) const { return m_kept.id(m_motion, place); }

private:
  const scenario::Neighbor_edges& neighbors();
  void begin_frame();
  void check_coordinates() const;
  void time_all();
  void time_dynamic();
  void check();
  template <class Work>
  void with_frame_in_message(const Work& work) const;

  scenario::Motion_3& m_motion;
  Frame_record_3 m_record;
  Kept_motion_3 m_kept;
  Static_opponents_3 m_opponents;
  scenario::Neighbor_edges m_neighbors;
};

} // namespace run

#endif // SCENARIO_RUNNER_SPACE_MOTION_RUN_3_H
