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

  static constexpr std::size_t max_vertices_in_cache = 1 << 15;

  // A rebuild passes over the memory once; mending jumps through it, and beyond the second-level
  // cache takes half as long again.
  static std::size_t rebuild(std::size_t vertices)
  {
    return vertices < max_vertices_in_cache ? rebuilt_vertex * vertices
                                            : rebuilt_vertex * vertices * 2 / 3;
  }

  // Points that come or go among so many vertices. Where all points rest, a rebuild takes as long
  // as a change of 23 percent of 1,000 or 10,000 points, or of 13 percent of 100,000.
  static std::size_t changes(std::size_t number, std::size_t vertices)
  {
    constexpr std::size_t in_cache = 34, beyond = 41;
    return number * (vertices < max_vertices_in_cache ? in_cache : beyond);
  }

  // In how many steps to take a frame after which so many edges are broken. Each step is a pass
  // over all edges. But many small steps hold fewer vertices than a large one, and for a shorter
  // time: of 10,000 points two steps save a tenth at 0.1 spacings, three a fifth at 0.15.
  static unsigned steps(std::size_t broken, std::size_t edges)
  {
    return 12 * broken < edges ? 1 : 6 * broken < edges ? 2 : 7 * broken < 2 * edges ? 3 : 4;
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
  // but the constant is at most one rebuild: the worst case costs as much as two. If this is one of
  // several equal steps, it is at most this part of a rebuild and an eighth, and the worst case of
  // four steps costs as much as two rebuilds and a half.
  void start(std::size_t rebuild, std::size_t mending, unsigned steps)
  {
    const std::size_t most = steps == 1 ? rebuild : rebuild / steps + rebuild / 8;
    m_left = least + (std::min)(rebuild / 8 + mending * 5 / 4, most);
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

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_COST_MODEL_2_H
