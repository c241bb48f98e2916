// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A cloud over several ranks, with any motions, populations and distributions. Each frame is
// compared with one process.

#ifndef DISTRIBUTED_ANY_RUN_H
#define DISTRIBUTED_ANY_RUN_H

#include "distributed_decisions.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

class Any_run : private Decided_run
{
public:
  using Decided_run::Decided_run;

  // Begins with up to `most_points` points.
  void run(double most_points)
  {
    const std::size_t n = std::size_t(std::exp(uniform(0, std::log(most_points))));
    m_lattice = one_in(3) ? 1.0 : one_in(4) ? 0.25 : 0;
    m_is_circle = one_in(8);
    m_side = std::sqrt(double(n)) * uniform(0.5, 2);
    follow<Distributed>(
        n, 8, [this] { return add_point(); },
        [this](Distributed& dt, int kind) { move(dt, kind); });
  }

private:
  void move(Distributed& dt, int kind)
  {
    const double spread = std::exp(uniform(-8, 1)), turn = uniform(-0.5, 0.5);
    for (auto& [id, p] : m_population) {
      const double x = p.x() - m_side / 2, y = p.y() - m_side / 2;
      if (kind == 3 && !one_in(10))
        continue; // a few jump
      if (kind == 3)
        p = place();
      else if (kind == 4) // an explosion, or a collapse
        p = snapped(m_side / 2 + (1 + turn) * x, m_side / 2 + (1 + turn) * y);
      else if (kind == 5) // a turn
        p = snapped(m_side / 2 + std::cos(turn) * x - std::sin(turn) * y,
                    m_side / 2 + std::sin(turn) * x + std::cos(turn) * y);
      else if (kind == 6) // shear
        p = snapped(p.x() + turn * y, p.y());
      else // Brownian motion
        p = snapped(p.x() + uniform(-spread, spread), p.y() + uniform(-spread, spread));
    }
    update(dt, m_population);
  }

  Population::iterator add_point()
  {
    const Id id = next_id();
    const bool coincides = !m_population.empty() && one_in(20);
    return m_population.emplace(id, coincides ? m_population.begin()->second : place()).first;
  }

  Point place()
  {
    if (m_is_circle)
      return place_on_circle();
    const double x = uniform(0, m_side);
    return snapped(x, uniform(0, m_side));
  }
  // One of 36 places with whole coordinates.
  Point place_on_circle()
  {
    const std::array<std::array<double, 2>, 5> places{
        {{65, 0}, {63, 16}, {60, 25}, {56, 33}, {52, 39}}};
    const auto [x, y] = places[m_decisions.below(places.size())];
    const double signed_x = one_in(2) ? x : -x, signed_y = one_in(2) ? y : -y;
    return one_in(2) ? Point(signed_x, signed_y) : Point(signed_y, signed_x);
  }
  Point snapped(double x, double y) const
  {
    return m_lattice > 0
               ? Point(m_lattice * std::round(x / m_lattice), m_lattice * std::round(y / m_lattice))
               : Point(x, y);
  }

  double m_lattice = 0, m_side = 1;
  bool m_is_circle = false;
};

#endif // DISTRIBUTED_ANY_RUN_H
