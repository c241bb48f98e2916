// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REPAIR_EXPERIENCE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REPAIR_EXPERIENCE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// What the last frames have taught: the share of broken edges from which on mending was in vain.
// The cost of an edge depends on the motion, which no fixed price can reflect, but the next frame
// is mostly like the last one. Shares are in 65536ths of all edges.
class Repair_experience_2
{
public:
  static constexpr std::size_t all = 65536;

  // Whether mending was in vain lately. Then it pays to sample edges before anything is done.
  bool has_failed_recently() const { return m_hopeless_share < all; }

  // Whether mending looks vain by the broken share of a sample, which may err by a quarter.
  bool is_hopeless(std::size_t sampled, std::size_t broken) const
  {
    return has_failed_recently() && broken > 0 &&
           share(broken, sampled) * 4 >= m_hopeless_share * 3;
  }

  // Notes that mending `open` edges was given up, or has cost as much as a rebuild. If very few
  // were open, trying again is cheap, so the share never gets very small.
  void record_failure(std::size_t open, std::size_t edges)
  {
    constexpr std::size_t next_to_nothing = all / 32;
    m_hopeless_share =
        (std::min)(m_hopeless_share, (std::max)(share(open, edges), next_to_nothing));
  }

  // Notes that a sample has decided against mending. The share slowly grows, so that mending is
  // tried once in a while: the sooner, the more it could save. At a share of a fifth it saves
  // nothing, because mending Brownian motion then takes as long as a rebuild.
  void record_not_tried()
  {
    constexpr std::size_t fifth = all / 5;
    if (!has_failed_recently())
      return;
    const std::size_t saved = m_hopeless_share < fifth ? (fifth - m_hopeless_share) / 7 : 0;
    const std::size_t step = (std::max)(saved, m_hopeless_share / 64 + 1);
    m_hopeless_share = (std::min)(m_hopeless_share + step, all - 1);
  }

  void record_success(std::size_t open, std::size_t edges)
  {
    const std::size_t mended = share(open, edges);
    if (2 * mended < m_hopeless_share)
      m_hopeless_share = all;
    else
      m_hopeless_share = (std::max)(m_hopeless_share, (std::min)(mended + mended / 8, all - 1));
  }

  // For checkpoints. `all` if nothing was in vain.
  std::size_t hopeless_share() const { return m_hopeless_share; }
  void restore(std::size_t hopeless_share) { m_hopeless_share = hopeless_share; }

private:
  // In 65536ths, from 1 to all - 1.
  static std::size_t share(std::size_t part, std::size_t whole)
  {
    return part >= whole ? all - 1 : 1 + part * (all - 2) / whole;
  }

  std::size_t m_hopeless_share = all;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REPAIR_EXPERIENCE_2_H
