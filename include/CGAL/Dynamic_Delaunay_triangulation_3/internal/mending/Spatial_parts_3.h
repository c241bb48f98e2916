// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_SPATIAL_PARTS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_SPATIAL_PARTS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Parts of a triangulation in which threads can flip at the same time. Each finite vertex belongs
// to the part where it is; no vertex moves meanwhile. On a torus the place of a vertex says what
// part all its images belong to.
//
// Each thread examines facets whose three vertices are in its part, and flips those for which all
// vertices of the cells that a flip replaces are. What it reads and writes are cells at such
// facets, so cells with three or four corners in the part, of which each belongs to one part alone,
// and what is stored at vertices of the part. All other cells do not change at all.
//
// Space is cut into slabs with equal numbers of vertices, each slab into columns, and each column
// into blocks. A part depends on positions alone: numbers of vertices and cells, which follow a
// curve, do so for a shorter time, because streams of points mix them. With two blocks in a row the
// borders are elsewhere than with three, so that little is left at the borders of both.
template <class Positions>
class Spatial_parts_3
{
public:
  static constexpr std::size_t most_in_row = 3;

  Spatial_parts_3(const Positions& positions, std::size_t in_row)
    : m_positions(positions)
    , m_in_row(in_row)
  {
    std::vector<Coordinates> some = sample();
    cut(some.data(), some.size(), 0, 0);
    for (std::size_t part = 0; part < number(); ++part)
      m_boxes.push_back(box_of(part));
  }

  std::size_t number() const { return m_in_row * m_in_row * m_in_row; }

  // Of a finite vertex.
  std::size_t part_of(Vertex_index v) const
  {
    const Position_3& p = m_positions.position(v);
    const std::size_t slab = m_slabs.interval(p.x);
    const std::size_t column = m_in_row * slab + m_columns[slab].interval(p.y);
    return m_in_row * column + m_blocks[column].interval(p.z);
  }
  bool has(std::size_t part, Vertex_index v) const
  {
    const Position_3& p = m_positions.position(v); // NaN, if v is the infinite vertex
    const Box& box = m_boxes[part];
    return ((p.x >= box.low.x) & (p.y >= box.low.y) & (p.z >= box.low.z) & (p.x < box.high.x) &
            (p.y < box.high.y) & (p.z < box.high.z)) != 0;
  }

private:
  using Coordinates = Few<double, 3>;

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // Where a row is cut.
  struct Cuts
  {
    Cuts() { at.fill(infinity); }
    double low(std::size_t i) const { return i == 0 ? -infinity : at[i - 1]; }
    double high(std::size_t i) const { return i < at.size() ? at[i] : infinity; }
    std::size_t interval(double x) const // without branches, which would be mispredicted
    {
      std::size_t number = 0;
      for (const double cut : at)
        number += std::size_t(x >= cut);
      return number;
    }
    std::array<double, most_in_row - 1> at;
  };

  struct Box
  {
    Position_3 low, high;
  };

  Box box_of(std::size_t part) const
  {
    const std::size_t column = part / m_in_row, slab = column / m_in_row;
    const std::size_t x = slab, y = column % m_in_row, z = part % m_in_row;
    const Cuts &in_slab = m_columns[slab], &in_column = m_blocks[column];
    return {{m_slabs.low(x), in_slab.low(y), in_column.low(z)},
            {m_slabs.high(x), in_slab.high(y), in_column.high(z)}};
  }

  // So many say well enough where to cut.
  std::vector<Coordinates> sample() const
  {
    constexpr std::size_t most = 512;
    const std::size_t vertices = m_positions.number() - 1;
    const std::size_t number = (std::min)(most, vertices);
    std::vector<Coordinates> some;
    for (std::size_t i = 0; i < number; ++i) {
      const Position_3& p = m_positions.position(Vertex_index(1 + vertices * i / number));
      some.push_back({p.x, p.y, p.z});
    }
    return some;
  }

  // Cuts along an axis, then each piece along the next one. `row` is the number of what is cut.
  void cut(Coordinates* some, std::size_t number, int axis, std::size_t row)
  {
    Cuts& cuts = axis == 0 ? m_slabs : axis == 1 ? m_columns[row] : m_blocks[row];
    const auto is_before = [=](const Coordinates& p, const Coordinates& q) {
      return p[axis] < q[axis];
    };
    for (std::size_t i = 0; i < m_in_row; ++i) {
      const std::size_t first = number * i / m_in_row, beyond = number * (i + 1) / m_in_row;
      if (beyond < number) {
        std::nth_element(some + first, some + beyond, some + number, is_before);
        cuts.at[i] = some[beyond][axis];
      }
      if (axis < 2)
        cut(some + first, beyond - first, axis + 1, m_in_row * row + i);
    }
  }

  const Positions& m_positions;
  const std::size_t m_in_row; // blocks in a column, columns in a slab, and slabs
  Cuts m_slabs;
  std::array<Cuts, most_in_row> m_columns;
  std::array<Cuts, most_in_row * most_in_row> m_blocks;
  std::vector<Box> m_boxes; // of the parts
};

// Calls f(parts) for three blocks in a row, and then for two, as long as threads would gain by
// sharing so many pieces of work, pieces(), each of which takes as long as a facet. `least_times`
// says how many times more cells there have to be than in a pass that threads share. So that
// depends on the triangulation alone.
template <class State, class Pieces, class Function>
void divide_while_worth(const State& state, const typename State::Positions& positions,
                        std::size_t least_times, const Pieces& pieces, const Function& f)
{
  using Parts = typename State::Exact_parts;
  using Division = Spatial_parts_3<typename State::Positions>;
  constexpr std::size_t least = (std::max)(Parts::usual_size / 64, std::size_t(1)); // of a part
  if (state.arrays.number_of_cells() < least_times * Parts::least_shared * Parts::usual_size)
    return;
  for (std::size_t in_row = Division::most_in_row; in_row > 1; --in_row) {
    if (pieces() < least * in_row * in_row * in_row)
      return;
    f(Division(positions, in_row));
  }
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_SPATIAL_PARTS_3_H
