// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_GHOST_OPPONENTS_H
#define SCENARIO_RUNNER_GHOST_OPPONENTS_H

#include "scenario_runner/Cell.h"
#include "scenario_runner/Lattice_window.h"
#include "scenario_runner/Periodic_faces.h"
#include "scenario_runner/Static_triangulation.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace run {

// The opponents in periodic space: CGAL's triangulations of the plane, of the points and ghosts,
// their images in a margin around the cell. They find all faces if the margin is as wide as the
// radius of the largest empty circle of the frame. The margin is that radius of the frame before
// plus a quarter; agreement() finds out whether it was enough.
//
// Besides what Static_opponents leave out, the ghosts and their order are found outside of the
// timing. The images are rounded, so where points are nearly on a circle the result need not be the
// triangulation of the exact ones.
class Ghost_opponents
{
public:
  void prepare(const std::vector<scenario::Point>& points, const scenario::Cell& cell);

  double time_insert() { return m_static.time_insert(); }
  double time_fastest() { return m_static.time_fastest(); }

  // How far the faces agree with those of time_insert(), as the Matthews correlation coefficient of
  // their edges; or if they do not, with those of triangulations with margins that are twice as
  // wide each time, up to one that is enough whatever the points are. `representatives` has, for
  // each point, the place of the point that stands for it in `faces`: another one if they coincide.
  double agreement(std::vector<Periodic_face> faces,
                   const std::vector<std::uint32_t>& representatives);

private:
  std::vector<Periodic_face> proved_faces(const Static_triangulation& triangulation,
                                          std::vector<Image> images, double margin,
                                          const std::vector<std::uint32_t>& representatives);
  bool is_complete(const std::vector<Periodic_face>& faces,
                   const std::vector<std::uint32_t>& representatives) const;
  bool is_rounded_line(const Periodic_face& face) const;
  std::vector<Periodic_face> faces_with(double margin,
                                        const std::vector<std::uint32_t>& representatives);
  double first_margin() const;

  std::vector<scenario::Point> m_points;
  std::optional<scenario::Cell> m_cell;
  std::optional<Lattice_window> m_window;
  std::vector<Image> m_images;
  double m_margin = 0.0;             // of this frame
  std::optional<double> m_largest{}; // empty circle of the frame that was checked last
  Static_opponents m_static;
};

} // namespace run

#endif // SCENARIO_RUNNER_GHOST_OPPONENTS_H
