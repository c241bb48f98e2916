// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A cloud in a periodic cell over several ranks, with any motions, deformations, populations and
// distributions. Each frame is compared with one process.

#ifndef DISTRIBUTED_PERIODIC_ANY_RUN_H
#define DISTRIBUTED_PERIODIC_ANY_RUN_H

#include "distributed_decisions.h"
#include "distributed_periodic_oracle.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

class Any_periodic_run : private Decided_run
{
public:
  using Decided_run::Decided_run;

  // Begins with up to `most_points` points.
  void run(double most_points)
  {
    const std::size_t n = std::size_t(std::exp(uniform(0, std::log(most_points))));
    m_is_lattice = one_in(3);
    const double size = std::sqrt(double(n)) * uniform(0.5, 2);
    m_vectors = {rounded(size * uniform(0.5, 2)), 0, rounded(size * uniform(-1, 1)),
                 rounded(size * uniform(0.5, 2))};
    if (!is_cell())
      m_vectors = {4, 0, 0, 4};
    follow<Distributed_periodic>(
        n, 9, [this] { return add_point(); },
        [this](Distributed_periodic& dt, int kind) {
          kind < 5 ? move(dt, kind) : deform(dt, kind);
        },
        cell());
  }

private:
  using Vectors = std::array<double, 4>;

  void move(Distributed_periodic& dt, int kind)
  {
    const double spread = std::exp(uniform(-8, 1));
    for (auto& [id, p] : m_population) {
      if (kind == 3 && one_in(10)) // a few jump, or are given by other images
        p = one_in(2) ? place() : any_image(p);
      else if (kind == 4) // Brownian motion
        p = snapped(p.x() + uniform(-spread, spread), p.y() + uniform(-spread, spread));
    }
    update(dt, m_population);
  }

  // Changes the cell; points follow it, or stay where they are.
  void deform(Distributed_periodic& dt, int kind)
  {
    const Vectors before = m_vectors;
    const double part = std::exp(uniform(-6, 0)) * (one_in(2) ? 1 : -1);
    auto& [ax, ay, bx, by] = m_vectors;
    if (kind == 5) // shear
      bx = rounded(bx + part * by), ax = rounded(ax + part * ay);
    else if (kind == 6) // stretching
      ax = rounded(ax * (1 + part)), bx = rounded(bx * (1 + part)), by = rounded(by / (1 + part));
    else if (kind == 7) // other vectors of the same lattice
      bx += ax, by += ay;
    else if (kind == 8)
      std::swap(ax, bx), std::swap(ay, by);
    else // any other cell
      for (double& x : m_vectors)
        x = rounded(x + uniform(-1, 1));
    if (!is_cell())
      m_vectors = before;
    if (one_in(2) && kind != 7 && kind != 8)
      take_along(before);
    update(dt, m_population, cell());
  }

  void take_along(const Vectors& before)
  {
    const auto [ax, ay, bx, by] = before;
    const double d = ax * by - ay * bx;
    for (auto& [id, p] : m_population) {
      const double s = (p.x() * by - p.y() * bx) / d, t = (p.y() * ax - p.x() * ay) / d;
      p = snapped(s * m_vectors[0] + t * m_vectors[2], s * m_vectors[1] + t * m_vectors[3]);
    }
  }

  Population::iterator add_point()
  {
    const Id id = next_id();
    const bool coincides = !m_population.empty() && one_in(20);
    const Point p = coincides ? moved(m_population.begin()->second, whole(0, 2), 1) : place();
    return m_population.emplace(id, p).first;
  }

  Cell cell() const { return Cell(m_vectors[0], m_vectors[1], m_vectors[2], m_vectors[3]); }
  // Neither flat nor far too thin.
  bool is_cell() const
  {
    const auto [ax, ay, bx, by] = m_vectors;
    const double lengths = std::abs(ax) + std::abs(ay) + std::abs(bx) + std::abs(by);
    return lengths < 1000 && std::abs(ax * by - ay * bx) > 0.01 * lengths;
  }
  Point moved(const Point& p, int i, int j) const
  {
    return Point(p.x() + (i * m_vectors[0] + j * m_vectors[2]),
                 p.y() + (i * m_vectors[1] + j * m_vectors[3]));
  }
  Point any_image(const Point& p)
  {
    const int i = whole(-4, 4);
    return moved(p, i, whole(-4, 4));
  }
  Point place()
  {
    const double s = uniform(-1, 2), t = uniform(-1, 2);
    return snapped(s * m_vectors[0] + t * m_vectors[2], s * m_vectors[1] + t * m_vectors[3]);
  }
  double rounded(double x) const { return m_is_lattice ? std::round(x) : x; }
  Point snapped(double x, double y) const { return Point(rounded(x), rounded(y)); }

  bool m_is_lattice = false;
  Vectors m_vectors{};
};

#endif // DISTRIBUTED_PERIODIC_ANY_RUN_H
