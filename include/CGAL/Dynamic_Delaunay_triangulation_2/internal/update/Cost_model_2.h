// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_COST_MODEL_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_COST_MODEL_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The prices of all that an update may do. Costs are counted, not measured as time, so equal input
// gives equal results. The unit is a sixteenth of the cost of a rebuild per vertex in the plane,
// some 25 nanoseconds. `./dev bench rough_frames` measures what the prices are fitted to: the time
// of an update and of a rebuild, beside the number of open edges.
struct Cost_model_2
{
  static constexpr std::size_t rebuilt_vertex = 16;
  static constexpr std::size_t flip = 5;
  static constexpr std::size_t held_vertex = 40;
  static constexpr std::size_t spliced_vertex = 32;
  static constexpr std::size_t insertion = 36;
  static constexpr std::size_t removal = 36;
  static constexpr std::size_t relocation = insertion + removal;
  static constexpr std::size_t step_of_a_walk = 2;

  // Mending around an open edge, with all that follows from it. If a face at the edge may be
  // inverted, vertices are held there. Brownian motion of steps from 0.03 to 0.2 spacings takes
  // just as long as these prices say, within a tenth. There a held vertex goes with some three
  // uncertain edges; one that jumps among others at rest has a dozen alone, and costs no more.
  static constexpr std::size_t illegal_edge = 9;
  static constexpr std::size_t uncertain_edge = 49;
  static constexpr std::size_t least_uncertain_edge = 12;
  static constexpr std::size_t mended_vertex = 139; // a held one, with all that follows

  // A rebuild passes over the memory once; mending jumps through it, and beyond the second-level
  // cache takes half as long again.
  static std::size_t rebuild(std::size_t vertices)
  {
    constexpr std::size_t max_vertices_in_cache = 1 << 15;
    return vertices < max_vertices_in_cache ? rebuilt_vertex * vertices
                                            : rebuilt_vertex * vertices * 2 / 3;
  }

  static std::size_t mending(std::size_t illegal_edges, std::size_t uncertain_edges)
  {
    return illegal_edge * illegal_edges + uncertain_edge * uncertain_edges;
  }
  static std::size_t least_of_mending(std::size_t illegal_edges, std::size_t uncertain_edges)
  {
    return illegal_edge * illegal_edges + least_uncertain_edge * uncertain_edges;
  }
};

// What an update may spend on mending before a rebuild is cheaper.
class Repair_budget_2
{
public:
  // Allows the cost of two rebuilds, for repairs without a better estimate.
  void start_generously(std::size_t rebuild)
  {
    m_left = least + 2 * rebuild;
    m_spent = 0;
  }

  // Sets the budget when it is known what mending should cost: a quarter more than that, an eighth
  // of a rebuild, and a constant for small triangulations, whose rebuild costs next to nothing. All
  // but the constant is at most one rebuild: the worst case costs as much as two.
  void start(std::size_t rebuild, std::size_t mending)
  {
    m_left = least + (std::min)(rebuild / 8 + mending * 5 / 4, rebuild);
  }

  void allow(std::size_t cost) { m_left += cost; }
  void spend(std::size_t cost)
  {
    m_left -= (std::min)(cost, m_left);
    m_spent += cost;
  }
  // Whether mending has cost as much as a rebuild, plus a constant for small triangulations.
  bool has_spent(std::size_t rebuild) const { return m_spent >= least / 4 + rebuild; }
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

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_COST_MODEL_2_H
