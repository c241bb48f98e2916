// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_SPATIAL_PARTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_SPATIAL_PARTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_parts_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Parts of a triangulation in which threads can take vertices out and put others in, at the same
// time. Each vertex belongs to the part where it is, whatever its number is: new vertices have the
// last numbers, wherever they are. No vertex moves meanwhile.
//
// A thread replaces faces whose vertices are all in its part by such faces. What
// `Topology_parts_2` says of flips is true of this: only one part changes the data at edges with
// both ends in it, and in faces with all vertices in it, and other data do not change at all. So a
// thread reads, besides that, only the vertices of faces at edges with both ends in its part.
//
// Parts are stretches of a Hilbert curve through the cells of a grid, with equal numbers of the
// given positions. So they depend on these alone.
template <class State>
class Spatial_parts_2
{
public:
  static constexpr std::size_t max_number = 32;

  // The borders of parts in different rounds have little in common.
  Spatial_parts_2(const State& state, const Position_vector& positions, std::size_t parts,
                  unsigned round)
    : m_state(state)
  {
    lay_grid(positions, round);
    std::array<std::uint32_t, cells> number{};
    std::size_t all = 0;
    for (std::size_t i = 0; i < positions.size(); i += stride(positions), ++all)
      ++number[cell(positions[i])];
    static const Curve curve;
    std::size_t sum = 0, part = 0;
    for (const std::uint16_t c : curve.cells_along) {
      while ((part + 1) * (all + 1) <= sum * parts)
        ++part;
      m_part[c] = std::uint8_t(part);
      sum += number[c];
    }
  }

  // The part of a position as in State::position_in_order().
  std::size_t part_of(const Position_2& p) const { return m_part[cell(p)]; }

  bool has_vertex(std::size_t part, Vertex_index v) const
  {
    return v != infinite_index &&
           part_of(m_state.position_in_order(m_state.positions()[v])) == part;
  }

  // Whether v and all its neighbors belong to the part.
  bool has_star(std::size_t part, Vertex_index v) const
  {
    bool has = has_vertex(part, v);
    if (has)
      m_state.arrays().for_each_neighbor(v,
                                         [&](Vertex_index w) { has = has && has_vertex(part, w); });
    return has;
  }

private:
  static constexpr unsigned digits = 6; // of a cell's coordinates
  static constexpr std::uint32_t side = 1 << digits, cells = side * side;

  struct Curve
  {
    Curve()
    {
      const Hilbert_curve_2 curve;
      constexpr unsigned low = 16 - digits;
      for (std::uint32_t c = 0; c < cells; ++c)
        cells_along[curve.place(c % side << low, c / side << low) >> (2 * low)] = std::uint16_t(c);
    }
    std::array<std::uint16_t, cells> cells_along;
  };

  // The curve has its longest borders in the middle. In later rounds that is elsewhere.
  void lay_grid(const Position_vector& positions, unsigned round)
  {
    Position_2 low = positions.front(), high = low;
    for (std::size_t i = 0; i < positions.size(); i += stride(positions)) {
      const Position_2& p = positions[i];
      low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y)};
      high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y)};
    }
    const double extent = (std::max)(high.x - low.x, high.y - low.y), shift = 0.37 * round * extent;
    const double scale = side / (extent + shift);
    m_scale = std::isfinite(scale) ? scale : 0;
    m_low = {low.x - shift, low.y - shift};
  }

  // Looks at some thousands of the positions.
  static std::size_t stride(const Position_vector& positions)
  {
    return 1 + positions.size() / 8192;
  }

  std::size_t cell(const Position_2& p) const
  {
    return side * digit((p.y - m_low.y) * m_scale) + digit((p.x - m_low.x) * m_scale);
  }
  // Any number, NaN too, gives a cell.
  static std::size_t digit(double x)
  {
    return std::size_t((std::min)((std::max)(0., x), double(side - 1)));
  }

  const State& m_state;
  Position_2 m_low;
  double m_scale;
  std::array<std::uint8_t, cells> m_part;
};

// Calls work(topology) for the parts of a triangulation, if threads would gain by sharing so many
// `pieces()` of work, the i-th of them at vertex(i). If much is left then, calls it again for other
// parts, which have equal numbers of the pieces that are left, so that their borders are elsewhere.
// Those are fewer, because they consist of blocks: of 32 parts, 18 percent of the borders between
// blocks are borders between parts, of 8 parts 9.
template <class State, class Pieces, class Vertex_of, class Work>
void work_in_divisions(const State& state, const Pieces& pieces, const Vertex_of& vertex,
                       const Work& work)
{
  if (!Topology_parts_2::are_worth(state, pieces()))
    return;
  const Topology_parts_2 topology(state);
  work(topology);
  const std::size_t left = pieces();
  if (!Topology_parts_2::are_worth(state, 2 * left)) // each takes longer than most did
    return;
  constexpr std::size_t most = 256; // are looked at
  const auto position = [&](Vertex_index v) {
    return state.position_in_order(state.positions()[v]);
  };
  Position_vector positions;
  for (std::size_t i = 0; i < left; i += 1 + left / most)
    positions.push_back(position(vertex(i)));
  const std::size_t number = (std::max)(topology.number() / 4, State::Parts::least_shared);
  const Spatial_parts_2<State> parts(state, positions, number, 1);
  work(topology.template divided_anew<typename State::Parts>(
      number, [&](Vertex_index v) { return parts.part_of(position(v)); }));
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_SPATIAL_PARTS_2_H
