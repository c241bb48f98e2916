// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_SPATIAL_PARTS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_SPATIAL_PARTS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Parts of a triangulation in which threads can flip at the same time. Each finite vertex belongs
// to the part where it is; no vertex moves meanwhile. On a torus the place of a vertex says what
// part all its images belong to. The infinite vertex belongs to all parts.
//
// Each thread examines facets whose three vertices are in its part, and flips those for which all
// vertices of the cells that a flip replaces are. What it reads and writes are cells at such
// facets, so cells with three or four corners in the part, and what is stored at finite vertices of
// the part. Each of these cells belongs to one part alone: it has four vertices, or if one of them
// is the infinite one, three others, of which two are in the part. All other cells do not change at
// all.
//
// Space is cut into slabs with equal numbers of vertices, each slab into columns, and each column
// into blocks; or some of these are whole. A part depends on positions alone: numbers of vertices
// and cells, which follow a curve, do so for a shorter time, because streams of points mix them.
// With two blocks in a row the borders are elsewhere than with three, or than with a single one, so
// that little is left at the borders of both.
template <class Positions, class Parts>
class Spatial_parts_3
{
public:
  static constexpr std::size_t most_in_row = 3;

  // How many slabs, columns in a slab, and blocks in a column.
  using Numbers = Few<std::size_t, 3>;

  Spatial_parts_3(const Positions& positions, const Numbers& numbers)
    : m_positions(positions)
    , m_numbers(numbers)
  {
    std::vector<Coordinates> some = sample();
    cut(some.data(), some.size(), 0, 0);
    for (std::size_t part = 0; part < number(); ++part)
      m_boxes.push_back(box_of(part));
    m_part.resize(positions.number());
    Parts::for_each_element(positions.number(), Parts::size_for(8), [this](std::size_t i) {
      const Vertex_index v(i);
      m_part[v] = v == infinite_index ? of_all : std::uint8_t(find_part(m_positions.position(v)));
    });
  }

  static std::size_t number(const Numbers& numbers) { return numbers[0] * numbers[1] * numbers[2]; }
  std::size_t number() const { return number(m_numbers); }

  // Of a finite vertex.
  std::size_t part_of(Vertex_index v) const { return m_part[v]; }
  bool has(std::size_t part, Vertex_index v) const
  {
    return (int(m_part[v] == part) | int(v == infinite_index)) != 0;
  }
  // Whether all finite vertices of a cell, and most likely their neighbors, belong to the part: a
  // box around the cell that is three times as long does.
  bool has_around(std::size_t part, const Vertices_3& vertices) const
  {
    Position_3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
    for (const Vertex_index v : vertices)
      if (v != infinite_index) {
        const Position_3& p = m_positions.position(v);
        low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y), (std::min)(low.z, p.z)};
        high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y), (std::max)(high.z, p.z)};
      }
    const Position_3 size = high - low;
    const double margin = (std::max)({size.x, size.y, size.z});
    const Box& box = m_boxes[part];
    return low.x - margin >= box.low.x && low.y - margin >= box.low.y &&
           low.z - margin >= box.low.z && high.x + margin < box.high.x &&
           high.y + margin < box.high.y && high.z + margin < box.high.z;
  }

private:
  using Coordinates = Few<double, 3>;

  static constexpr std::uint8_t of_all = 255; // the infinite vertex

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

  std::size_t find_part(const Position_3& p) const
  {
    const std::size_t slab = m_slabs.interval(p.x);
    const std::size_t column = m_numbers[1] * slab + m_columns[slab].interval(p.y);
    return m_numbers[2] * column + m_blocks[column].interval(p.z);
  }

  Box box_of(std::size_t part) const
  {
    const std::size_t column = part / m_numbers[2], slab = column / m_numbers[1];
    const std::size_t x = slab, y = column % m_numbers[1], z = part % m_numbers[2];
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
    const std::size_t pieces = m_numbers[axis];
    for (std::size_t i = 0; i < pieces; ++i) {
      const std::size_t first = number * i / pieces, beyond = number * (i + 1) / pieces;
      if (beyond < number) {
        std::nth_element(some + first, some + beyond, some + number, is_before);
        cuts.at[i] = some[beyond][axis];
      }
      if (axis < 2)
        cut(some + first, beyond - first, axis + 1, pieces * row + i);
    }
  }

  const Positions& m_positions;
  const Numbers m_numbers;
  Cuts m_slabs;
  std::array<Cuts, most_in_row> m_columns;
  std::array<Cuts, most_in_row * most_in_row> m_blocks;
  std::vector<Box> m_boxes; // of the parts
  Dynamic_Delaunay_triangulations_2::internal::Uninitialized_column<Vertex_index, std::uint8_t>
      m_part;
};

// Calls f(parts) for some divisions, one after the other, as long as threads would gain by sharing
// so many pieces of work, pieces(), each of which takes as long as a facet. All that depends on the
// triangulation alone.
template <class State, class Divisions, class Pieces, class Function>
void divide_while_worth(const State& state, const typename State::Positions& positions,
                        const Divisions& divisions, const Pieces& pieces, const Function& f)
{
  using Parts = typename State::Exact_parts;
  using Division = Spatial_parts_3<typename State::Positions, Parts>;
  constexpr std::size_t least = (std::max)(Parts::usual_size / 64, std::size_t(1)); // of a part
  if (state.arrays.number_of_cells() < Parts::least_shared * Parts::usual_size)
    return;
  for (const typename Division::Numbers& numbers : divisions) {
    if (pieces() < least * (std::max)(Division::number(numbers), Parts::least_shared))
      return;
    f(Division(positions, numbers));
  }
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_SPATIAL_PARTS_3_H
