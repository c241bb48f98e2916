// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SAFE_EDGES_SCHEDULE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SAFE_EDGES_SCHEDULE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <algorithm>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// When to take references for Safe_edges_2, and how many edges may be tight then. Taking them costs
// as much as some ten frames. The first attempts allow for few tight edges; each that is left
// behind too soon is followed by one with twice as many, and when even many do not help, by a rest,
// the longer the more often this has happened. References that hold for long are taken anew with
// half as many tight edges.
class Safe_edges_schedule_2
{
public:
  // One edge in so many may be tight.
  unsigned share() const { return m_share; }

  // Whether the next update may end with new references.
  bool is_near() const { return m_rest == 0; }

  // After each update: whether it is time, if the present references hold or do not.
  bool is_due(bool they_hold)
  {
    if (they_hold)
      return ++m_held >= m_long && refine();
    adapt_rest();
    if (m_rest > 0) {
      --m_rest;
      return false;
    }
    m_was_due = true;
    return true;
  }

private:
  static constexpr unsigned smallest_share = 16, largest_share = 64;
  static constexpr unsigned min_rest = 8, max_rest = 256;
  static constexpr unsigned frames_worth_it = 64;

  bool refine()
  {
    if (m_share == largest_share)
      return false;
    m_share *= 2;
    m_held = 0;
    m_is_refined = true;
    return true;
  }

  // The last references, which do not hold any more, or never did.
  void adapt_rest()
  {
    if (!m_was_due)
      return;
    m_was_due = false;
    if (m_held >= frames_worth_it) {
      m_rest = m_next_rest = min_rest;
    } else if (m_is_refined) {
      m_share /= 2;
      m_long *= 2;
      m_rest = 0;
    } else if (m_share > smallest_share) {
      m_share /= 2;
      m_rest = min_rest;
    } else {
      m_share = largest_share;
      m_next_rest = (std::min)(2 * m_next_rest, max_rest);
      m_rest = m_next_rest;
    }
    m_is_refined = false;
    m_held = 0;
  }

  unsigned m_share = largest_share;
  unsigned m_rest = 4; // frames
  unsigned m_next_rest = min_rest;
  unsigned m_held = 0; // frames
  unsigned m_long = 512;
  bool m_was_due = false;
  bool m_is_refined = false;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SAFE_EDGES_SCHEDULE_2_H
