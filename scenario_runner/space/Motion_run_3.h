// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SPACE_MOTION_RUN_3_H
#define SCENARIO_RUNNER_SPACE_MOTION_RUN_3_H

#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Method_choice.h"
#include "scenario_runner/space/Motion_3.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/Update_report_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL {
class Voronoi_cell_measures_3;
} // namespace CGAL

namespace run {

struct Frame_record_3 : Frame_facts
{
  CGAL::Update_report_3 update{};
};

// The places in the motion of the corners of a cell, and in periodic space their images.
struct Shown_cell_3
{
  std::array<std::uint32_t, 4> places;
  std::array<scenario::Shift_3, 4> shifts;
};

// Of the Voronoi cell of a point.
struct Measured_cell_3
{
  double volume;
  double surface_area;
  std::size_t contacts;
};

// Lets a motion in space run and keeps its triangulation: times every frame against the static
// opponents, and checks the result by exact predicates outside of the timing.
class Motion_run_3
{
public:
  using Record = Frame_record_3;

  explicit Motion_run_3(scenario::Motion_3& motion)
    : m_motion(motion)
  {
  }
  Motion_run_3(const Motion_run_3&) = delete;
  Motion_run_3& operator=(const Motion_run_3&) = delete;
  virtual ~Motion_run_3() = default;

  void check_first_frame();

  // Goes to the next frame, times all contestants there, and checks what came out. False at the end
  // of the motion.
  bool advance();

  const scenario::Motion_3& motion() const { return m_motion; }
  const Frame_record_3& record() const { return m_record; }

  // The finite cells. Of points that coincide the first one is a corner.
  virtual std::vector<Shown_cell_3> cells() const = 0;

  // Those of all points, in the order of the motion: as far as they are in the motion's box, if it
  // has one, else whole ones, which may be infinite in open space. `measures` keeps its memory.
  virtual std::vector<Measured_cell_3>
  measured_cells(CGAL::Voronoi_cell_measures_3& measures) const = 0;

protected:
  // `triangulate()` makes the triangulation of the first frame.
  template <class Triangulate>
  void start(const Triangulate& triangulate);

private:
  template <class Work>
  void with_frame_in_message(const Work& work) const;

  // Pairs of places.
  virtual void list_neighbors(scenario::Neighbor_edges& neighbors) const = 0;
  virtual CGAL::Update_report_3 update() = 0;
  // After points have come or gone, outside of the timing.
  virtual void find_places() = 0;
  virtual bool is_certified() const = 0;
  virtual bool is_valid() const = 0;
  virtual void prepare_opponents() = 0;
  virtual double time_insert() = 0;
  virtual double time_fastest() = 0;

  const scenario::Neighbor_edges& neighbors();
  void begin_frame();
  void check_coordinates() const;
  void time_all();
  void check();

  scenario::Motion_3& m_motion;
  Frame_record_3 m_record;
  scenario::Neighbor_edges m_neighbors;
};

// In open space, or in periodic space if the motion has a cell.
// \throws std::invalid_argument for a policy that is for the plane alone
std::unique_ptr<Motion_run_3> make_motion_run_3(scenario::Motion_3& motion,
                                                const Policy_choice& policy);

} // namespace run

#endif // SCENARIO_RUNNER_SPACE_MOTION_RUN_3_H
