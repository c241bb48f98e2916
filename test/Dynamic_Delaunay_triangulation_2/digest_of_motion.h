// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A number that stands for all that a motion leads to, bit by bit, so that processors can be
// compared. Nothing in it is computed by a library, which may round differently elsewhere.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_DIGEST_OF_MOTION_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_DIGEST_OF_MOTION_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

// Of numbers in their order, by Fowler, Noll and Vo's function FNV-1a.
class Digest
{
public:
  void add(std::uint64_t number)
  {
    for (int byte = 0; byte < 8; ++byte)
      m_value = (m_value ^ (number >> 8 * byte & 255)) * 1099511628211u;
  }
  void add(double number)
  {
    std::uint64_t bits = 0; // of NaN, whose bits are the processor's
    if (!std::isnan(number))
      std::memcpy(&bits, &number, sizeof(bits));
    add(bits);
  }

  std::uint64_t value() const { return m_value; }

private:
  std::uint64_t m_value = 14695981039346656037u;
};

// Points that go to and fro, slowly at first: exact multiples of 2^-20.
class Exact_steps
{
public:
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

  std::vector<Point> start(std::size_t number, int side)
  {
    std::vector<Point> points;
    for (std::size_t i = 0; i < number; ++i) {
      const double x = side * part();
      points.emplace_back(x, side * part());
    }
    return points;
  }

  void move(std::vector<Point>& points, int frame)
  {
    const double step = frame % 20 < 15 ? 0x1p-8 : 0x1p-3;
    for (Point& p : points) {
      const double dx = step * (part() - 0.5), dy = step * (part() - 0.5);
      p = Point(p.x() + dx, p.y() + dy);
    }
  }

private:
  double part() { return double(m_random() >> 44) * 0x1p-20; }

  std::mt19937_64 m_random{1};
};

// Adds an update, and the corners and limits of every edge after it.
template <class Slacks, class Report, class Frame>
void add_frame(Digest& digest, const Report& report, const Frame& frame)
{
  digest.add(std::uint64_t(report.flips));
  digest.add(std::uint64_t(report.rebuilt()));
  for (typename Frame::Edge_index e(0); e < frame.number_of_edges(); ++e) {
    const auto& edge = frame.edge(e);
    for (const auto v : {edge.source, edge.target, edge.left, edge.right})
      digest.add(std::uint64_t(v));
    digest.add(Slacks::value(frame, e));
    digest.add(Slacks::tolerance(frame, e, frame.positions()));
  }
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_DIGEST_OF_MOTION_H
