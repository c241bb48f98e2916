// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PERIODIC_CHANNEL_RUN_H
#define PERIODIC_CHANNEL_RUN_H

#include "../common/Contest.h"
#include "../common/Fastest_static.h"
#include "Wrapped_motion.h"

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace periodic {

// Points that diffuse in a slab between two walls, which turn them back. In one triangulation the
// walls are rows of points, of which the upper one slides; the other one has no points for them.
class Channel_run
{
public:
  Channel_run(std::size_t points, double step, std::uint64_t seed)
    : m_motion(points, step, seed)
    , m_slide(step)
    , m_open(places(), slab())
    , m_walled(places_and_walls(), slab())
  {
  }

  // Nanoseconds a point in each frame, without walls and with them.
  std::array<std::vector<double>, 2> run(std::size_t frames)
  {
    std::array<std::vector<double>, 2> times;
    for (m_frame = 1; m_frame <= frames; ++m_frame) {
      m_motion.advance();
      const std::array<Points, 2> points{places(), places_and_walls()};
      common::in_turn(m_frame, 2, [&](std::size_t i) {
        times[i].push_back(
            common::thread_nanoseconds_of([&] { (i == 0 ? m_open : m_walled).update(points[i]); }) /
            static_cast<double>(points[i].size()));
      });
      common::require(m_open.is_certified() && m_walled.is_certified(),
                      common::in_frame(m_frame) + "a slab is not certified");
    }
    common::require(m_open.is_valid() && m_walled.is_valid(), "a slab is not valid");
    return times;
  }

private:
  CGAL::Periodic_cell_2 slab() const { return CGAL::Periodic_cell_2::slab(m_motion.side(), 0.0); }

  // The points of the motion, folded into the slab between height 0 and that of the square.
  Points places() const
  {
    const double side = m_motion.side();
    Points places = m_motion.wrapped();
    for (std::size_t i = 0; i != places.size(); ++i) {
      const double y = m_motion.unwrapped()[i].y();
      const double rest = y - 2.0 * side * std::floor(y / (2.0 * side));
      places[i] = Point(places[i].x(), rest < side ? rest : 2.0 * side - rest);
    }
    return places;
  }

  Points places_and_walls() const
  {
    Points places = this->places();
    const double side = m_motion.side(), distance = 0.5;
    const auto in_a_row = static_cast<std::size_t>(side);
    for (std::size_t i = 0; i != in_a_row; ++i) {
      const double x = side * static_cast<double>(i) / static_cast<double>(in_a_row);
      const double slid = x + m_slide * static_cast<double>(m_frame);
      places.emplace_back(x, -distance);
      places.emplace_back(slid - side * std::floor(slid / side), side + distance);
    }
    return places;
  }

  Wrapped_motion m_motion;
  double m_slide; // in a frame
  std::size_t m_frame = 0;
  CGAL::Dynamic_periodic_Delaunay_triangulation_2<run::Kernel> m_open, m_walled;
};

} // namespace periodic

#endif // PERIODIC_CHANNEL_RUN_H
