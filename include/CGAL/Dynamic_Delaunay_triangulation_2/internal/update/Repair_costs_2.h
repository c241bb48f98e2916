// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REPAIR_COSTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REPAIR_COSTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// What an update may spend on mending before a rebuild is cheaper. Costs are counted, not measured
// as time, so equal input gives equal results. The unit is a sixteenth of the cost of a rebuild per
// vertex, some 15 nanoseconds.
class Repair_budget_2
{
public:
  static constexpr std::size_t rebuilt_vertex = 16;
  static constexpr std::size_t flip = 20;
  static constexpr std::size_t spliced_vertex = 32;
  static constexpr std::size_t relocation = 240;
  static constexpr std::size_t step_of_a_walk = 2;
  static constexpr std::size_t look_for_jumpers = 8; // per edge
  // The cost of mending around an open edge, with all flips and splices. Random clouds are mended
  // and rebuilt in the same time if an eighth of their edges is open.
  static constexpr std::size_t open_edge = 36;

  // Allows the cost of two rebuilds, for repairs without a better estimate.
  void start_generously(std::size_t vertices)
  {
    m_left = least + 2 * rebuilt_vertex * vertices;
    m_spent = 0;
  }

  // Sets the budget when the number of open edges is known: a quarter more than mending should
  // cost, an eighth of a rebuild, and a constant for small triangulations, whose rebuild costs next
  // to nothing. All but the constant is at most one rebuild: the worst case costs as much as two.
  void start(std::size_t vertices, std::size_t open_edges)
  {
    const std::size_t rebuild = rebuilt_vertex * vertices;
    m_left = least + (std::min)(rebuild / 8 + open_edge * open_edges * 5 / 4, rebuild);
  }

  // Whether a rebuild is expected to cost less than mending the open edges and inserting or
  // removing `changes` points. Mending is dearer beyond the second-level cache.
  static bool is_rebuild_cheaper(std::size_t vertices, std::size_t open_edges,
                                 std::size_t changes = 0)
  {
    constexpr std::size_t max_vertices_in_cache = 4096;
    const std::size_t price = vertices < max_vertices_in_cache ? 27 : 24; // in halves of a unit
    return 2 * (open_edge * open_edges + relocation / 2 * changes) > price * vertices;
  }

  void allow(std::size_t cost) { m_left += cost; }
  void spend(std::size_t cost)
  {
    m_left -= (std::min)(cost, m_left);
    m_spent += cost;
  }
  // Whether mending has cost as much as a rebuild, plus a constant for small triangulations.
  bool has_spent_a_rebuild(std::size_t vertices) const
  {
    return m_spent >= least / 4 + rebuilt_vertex * vertices;
  }
  std::size_t left() const { return m_left; }
  bool is_spent() const { return m_left == 0; }

private:
  static constexpr std::size_t least = 4000;

  std::size_t m_left = 0, m_spent = 0;
};

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
  // tried once in a while: the sooner, the more it could save. At a share of an eighth it saves
  // nothing, because mending then takes as long as a rebuild.
  void record_not_tried()
  {
    constexpr std::size_t eighth = all / 8;
    if (!has_failed_recently())
      return;
    const std::size_t saved = m_hopeless_share < eighth ? (eighth - m_hopeless_share) / 7 : 0;
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

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REPAIR_COSTS_2_H
