// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PERIODIC_GHOST_REBUILD_H
#define PERIODIC_GHOST_REBUILD_H

#include "../common/Contest.h"
#include "../common/Fastest_static.h"
#include "scenario_runner/Recorded_motion.h"
#include "Wrapped_motion.h"

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace periodic {

using Dynamic_periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<run::Kernel>;

// The radius of the largest circle without points, rounded: such a circle is the circumcircle of a
// face, as there is no border.
inline double largest_empty_circle(const Dynamic_periodic& triangulation)
{
  double largest = 0.0;
  triangulation.for_each_face([&](const std::array<std::size_t, 3>& ids,
                                  const std::array<CGAL::Periodic_shift_2, 3>& shifts) {
    const auto u = triangulation.vector(ids[0], ids[1], shifts[1]);
    const auto v = triangulation.vector(ids[0], ids[2], shifts[2]);
    const double squared_sides = u.squared_length() * v.squared_length() * (v - u).squared_length();
    const double area = (u.x() * v.y() - u.y() * v.x()) / 2.0;
    largest = (std::max)(largest, std::sqrt(squared_sides) / (4.0 * area));
  });
  return largest;
}

// What a program does whose triangulation knows no periodic space: it triangulates the points of
// the square and ghosts, their images in a margin around the square, in the plane. Its faces whose
// circumcenters lie in the square are then those of the periodic triangulation, each once.
//
// A margin of R is enough if no circle of a radius above R is empty of points and images:
//
// - A periodic face has one image whose circumcenter is in the square. Its corners are at a
//   distance of at most R from there, so they are points or ghosts, and its circle is empty: it is
//   a face of the plane.
// - Let a face of the plane have its circumcenter in the square. With a radius above R some image
//   would be within R of the center, so it would be in the margin, and in the circle: a
//   contradiction. A circle of a radius of at most R reaches no farther than the margin, so it is
//   empty of all images too.
//
// R is known before the frame is triangulated. A circle that is empty now was empty in the last
// frame but for an outer ring as wide as the longest move, so R is at most the radius of the last
// frame's largest empty circle plus the longest move.
//
// Besides what Fastest_static leaves out, this finds the margin, the ghosts and their positions
// outside of the timing. The images are rounded, so where points are nearly on a circle the result
// need not be the triangulation of the exact ones.
class Ghost_rebuild
{
public:
  // To be called for the first frame, which is not timed.
  void follow(const Wrapped_motion& motion, double largest_empty_circle)
  {
    copy(motion, largest_empty_circle);
    m_static.follow(m_frame);
  }

  // To be called before a frame is timed. `largest_empty_circle`: the radius in the frame before.
  void prepare(const Wrapped_motion& motion, double largest_empty_circle)
  {
    copy(motion, largest_empty_circle);
    m_static.prepare(m_frame);
  }

  double time() { return m_static.time_ordered(); }

  // The number of points and ghosts.
  std::size_t number_of_points() const { return m_frame.points.size(); }

  // The faces whose circumcenters are in the square.
  std::size_t number_of_faces() const
  {
    const auto is_inside = [this](double x) { return x >= 0.0 && x < m_side; };
    const run::Static_triangulation& triangulation = m_static.ordered();
    std::size_t faces = 0;
    for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end();
         ++face) {
      const Point center = triangulation.dual(face);
      faces += is_inside(center.x()) && is_inside(center.y()) ? 1 : 0;
    }
    return faces;
  }

private:
  struct Copy
  {
    std::int64_t id;
    scenario::Point point;
  };

  void copy(const Wrapped_motion& motion, double largest_empty_circle)
  {
    constexpr double rounding = 1e-9; // far above the rounding of the radius, and negligible
    m_side = motion.side();
    const double margin = (1.0 + rounding) * (largest_empty_circle + motion.longest_move());
    common::require(margin < m_side, "ghosts would be needed from beyond the next images");
    m_copies.clear();
    for (std::size_t i = 0; i != motion.wrapped().size(); ++i) {
      for (const double x : {-m_side, 0.0, m_side}) {
        for (const double y : {-m_side, 0.0, m_side}) {
          add_copy(motion, i, x, y, margin);
        }
      }
    }
    std::sort(m_copies.begin(), m_copies.end(),
              [](const Copy& a, const Copy& b) { return a.id < b.id; });
    m_frame.ids.clear();
    m_frame.points.clear();
    for (const Copy& copy : m_copies) {
      m_frame.ids.push_back(copy.id);
      m_frame.points.push_back(copy.point);
    }
  }

  void add_copy(const Wrapped_motion& motion, std::size_t i, double dx, double dy, double margin)
  {
    const auto is_near = [&](double x) { return x >= -margin && x <= m_side + margin; };
    const Point& wrapped = motion.wrapped()[i];
    const scenario::Point point{wrapped.x() + dx, wrapped.y() + dy};
    if (is_near(point.x) && is_near(point.y)) {
      const Point& unwrapped = motion.unwrapped()[i];
      const std::int64_t cell =
          cells(point.x - unwrapped.x()) * most_cells + cells(point.y - unwrapped.y());
      const auto points = static_cast<std::int64_t>(motion.wrapped().size());
      m_copies.push_back({cell * points + static_cast<std::int64_t>(i), point});
    }
  }

  // How many cells away an image is from its point that is never wrapped. So images keep their ids,
  // and their places in the order, where points are wrapped.
  std::int64_t cells(double distance) const
  {
    const std::int64_t cells = std::llround(distance / m_side) + most_cells / 2;
    common::require(cells >= 0 && cells < most_cells, "a point has gone too far");
    return cells;
  }

  static constexpr std::int64_t most_cells = 1 << 16;

  double m_side = 0.0;
  std::vector<Copy> m_copies;
  scenario::Recorded_frame m_frame;
  common::Fastest_static m_static;
};

} // namespace periodic

#endif // PERIODIC_GHOST_REBUILD_H
