// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_CALM_FRAMES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_CALM_FRAMES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_pass_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Flat_walls_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Hull_pass_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The pass of a frame: it leaves out the cells that are safe, as long as that pays.
//
// Each cell that a pass proves gets a slack, by which all points may move before it has to be
// tested again; the longest way of all points in each frame, relative to their mean motion, is
// taken off. What changes a cell or a neighbor of it makes it unsafe, and so does what moves a
// vertex beside frames (`Cell_arrays_3`). So a safe cell is one that the pass would prove, and
// leaving it out changes no result. Infinite cells get theirs from `Hull_pass_3`, and those on flat
// walls keep it while their vertices stay on these.
//
// To test a cell here and there, and to learn its slack, takes two to three times as long as to
// test it in turn. So slacks are learned where a sample tells that less than three in ten cells
// will have to be tested, and given up where two in five are. Steps of 0.0003 mean spacings take
// 0.6 of the time of a pass over all cells then, steps of 0.00001 a fifth.
template <class State>
class Calm_frames_3
{
  using Positions = typename State::Positions;

public:
  // Of all vertices, and of what signs depend on beside them.
  struct Motion
  {
    Position_3 mean, old_origin;
    bool is_whole; // whether all there is has moved with them, not a periodic cell as well
  };

  // Finds what floating point does not prove in a frame in which vertices have moved from
  // `previous`, and the infinite cells that hull_pass() has to look at.
  void find_unproved(State& state, const Positions& previous, const Motion& motion,
                     Unproved_cells_3& unproved)
  {
    Safe_cells_3& safe_cells = state.arrays.safe_cells();
    const bool is_possible = state.positions_are_exact && motion.is_whole;
    const double error = Pass_view_3<State>::error_of(state);
    const Position_3& mean = motion.mean;
    // slacks keep twice the room that the filter asks for; an origin that has stayed behind, for
    // vertices that were held, is not in them
    if (!is_possible || error > 1.5 * m_error || !is_same(motion.old_origin, m_origin))
      safe_cells.stop();
    m_origin = state.origin;
    const bool is_due = is_possible && !safe_cells.is_on() && is_rested();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double way = is_due || safe_cells.is_on() ? longest_way(state, previous, mean) : infinity;
    m_way = way;
    if (!(way < infinity))
      safe_cells.stop();
    else if (is_due)
      start_if_calm(state, way);
    if (!safe_cells.is_on()) {
      internal::find_unproved(state, unproved);
      return;
    }
    follow_walls(state, previous);
    safe_cells.advance(way);
    const std::size_t tested = find_unproved_unless_safe(state, unproved);
    if (5 * tested <= 2 * std::size_t(state.arrays.number_of_cells()))
      m_next_rest = shortest_rest;
    else if (m_is_going_on)
      give_up(safe_cells);
    m_is_going_on = true;
  }

  // What tests infinite cells in this frame. Each thread needs one of its own.
  Hull_pass_3<State> hull_pass(const State& state) const
  {
    return {state, m_walls, m_way < std::numeric_limits<double>::infinity()};
  }

  // How far a vertex or the origin has gone in this frame at most, relative to the mean motion.
  double way() const { return m_way; }

private:
  static constexpr std::size_t sample = 64;                        // cells
  static constexpr unsigned shortest_rest = 4, longest_rest = 256; // frames
  static constexpr unsigned frames_to_new_walls = 16;

  bool is_rested()
  {
    if (m_rest == 0)
      return true;
    --m_rest;
    return false;
  }
  void give_up(Safe_cells_3& safe_cells)
  {
    safe_cells.stop();
    rest();
  }
  void rest()
  {
    m_rest = m_next_rest;
    m_next_rest = (std::min)(2 * m_next_rest, longest_rest);
  }

  // Cells of vertices that have left a wall are no longer safe.
  void follow_walls(State& state, const Positions& previous)
  {
    if (!m_is_going_on) // they have just been found
      return;
    typename State::Arrays& arrays = state.arrays;
    if (m_walls.follow(state, previous, m_left)) {
      for (const Vertex_index v : m_left) {
        find_star(arrays, v, state.marks, m_star);
        arrays.forget_safe_cells(m_star);
      }
    } else {
      for (Cell_index c(0); c < arrays.number_of_cells(); ++c)
        if (arrays.is_infinite(c))
          arrays.safe_cells().forget(c);
    }
    if (++m_frames % frames_to_new_walls == 0)
      m_walls.find(state);
  }

  // How long the longest way is, at least. Each coordinate of a difference of two positions and the
  // mean is off by 2.1 units in the last place of itself, and 1.1 of the mean's; the origin, which
  // goes with the mean, by one in that of its own.
  static double longest_way(const State& state, const Positions& previous, const Position_3& mean)
  {
    using Parts = typename State::Parts;
    const std::size_t vertices = state.number_of_vertices();
    std::array<double, Parts::max_parts> squares{};
    Parts::for_each(vertices, [&](std::size_t part, std::size_t first, std::size_t beyond) {
      double largest = 0;
      for (Vertex_index v(first + 1); v <= beyond; ++v) {
        const double square =
            squared_length(state.positions.position(v) - previous.position(v) - mean);
        largest = (std::max)(square, largest); // one instruction
      }
      squares[part] = largest;
    });
    double largest = 0;
    for (const double square : squares)
      largest = square <= largest ? largest : square;
    // squares below 1e-300 may have underflowed
    return std::sqrt(largest) * (1 + 0x1p-48) + 0x1p-51 * std::sqrt(squared_length(mean)) +
           0x1p-52 * std::sqrt(squared_length(state.origin)) + 1e-140 +
           Pass_view_3<State>::error_of(state);
  }

  // Learns slacks of all cells in this frame, if a sample of them tells that few will have to be
  // tested in the next ones.
  void start_if_calm(State& state, double way)
  {
    m_walls.clear();
    m_walls.find(state);
    std::vector<double> slacks = sampled_slacks(state);
    double tested = 0;
    for (const double slack : slacks)
      tested += slack > way ? way / slack : 1;
    std::nth_element(slacks.begin(), slacks.begin() + sample / 2, slacks.end());
    if (10 * tested < 3 * sample && slacks[sample / 2] > 1e-100) {
      state.arrays.safe_cells().start(state.arrays.number_of_cells(), slacks[sample / 2]);
      m_error = Pass_view_3<State>::error_of(state);
      m_is_going_on = false;
    } else {
      rest();
    }
  }
  std::vector<double> sampled_slacks(const State& state) const
  {
    std::vector<double> slacks;
    Unproved_cells_3 unproved;
    const std::size_t cells = state.arrays.number_of_cells();
    const Pass_view_3<State> view(state);
    const auto append = [&](Cell_index, double slack) { slacks.push_back(slack); };
    view.append_unproved(
        sample, [cells](std::size_t n) { return Cell_index(cells * n / sample); },
        Slacks_learned_3(view.error_of(state), append), unproved);
    const Hull_pass_3<State> hull(state, m_walls, true);
    for (const Cell_index c : unproved.infinite)
      slacks.push_back(hull.answer(c).lasting_slack());
    slacks.resize(sample, 0); // also those with large shifts
    return slacks;
  }

  unsigned m_rest = 1, m_next_rest = shortest_rest; // frames
  bool m_is_going_on = false;                       // not in the first frame
  double m_error = 0;                               // of rounded vectors in the first frame
  Position_3 m_origin{0, 0, 0};                     // of the last frame
  double m_way = 0;                                 // infinite if it is unknown
  Flat_walls_3<State> m_walls;                      // while slacks are kept
  unsigned m_frames = 0;                            // since then
  std::vector<Vertex_index> m_left;
  std::vector<Cell_index> m_star;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_CALM_FRAMES_3_H
