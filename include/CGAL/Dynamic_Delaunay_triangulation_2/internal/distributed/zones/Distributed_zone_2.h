// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_ZONE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_ZONE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_question_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_deformation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The region in which a rank is to hold all points: some cells of a square grid, most of them
// within a box; others are listed. Senders and the rank itself compute the same cells from the same
// coordinates, and the cell of a place depends monotonically on its coordinates, rounding included.
// So if all cells between those of a box's corners are in the zone, all places in the box are.
//
// In a periodic space a zone is deformed with the cell: the grid stays that of the time when the
// zone was made, and places are mapped to where they were then, by the same map on all ranks. Tests
// of a box use a box around the computed images of its places.
//
// Accuracy. A zone is deformed while the map stretches nothing by more than 2, neither back nor
// forth. Then the zone has coordinates of at most 2^26 cells (`zone_around_faces()` sees to that),
// and the map is off by less than 2^-23 cells. Without deformation the map changes nothing. Within
// the box, columns and rows, before rounding down, are off by less than 2^-40 besides.
class Distributed_zone_2
{
public:
  static constexpr long most_cells = 512; // along an axis

  Distributed_zone_2() = default;

  // A zone without cells yet, in a space with this basis. \pre `box` has at most `most_cells` cells
  // of this size along each axis.
  Distributed_zone_2(const Box_2& box, double cell_size, const Basis_2& basis = unit_basis)
    : m_basis(basis)
    , m_x(box.x_low)
    , m_y(box.y_low)
    , m_scale(1 / cell_size)
    , m_columns(long(box.width() / cell_size) + 1)
    , m_rows(long(box.height() / cell_size) + 1)
    , m_cells(std::size_t(m_columns) * std::size_t(m_rows), 0)
  {
    deform(Distributed_deformation_2());
  }

  bool is_empty() const { return m_cells.empty(); }
  double cell_size() const { return 1 / m_scale; }
  const Distributed_deformation_2& deformation() const { return m_deformation; }

  // Deforms the zone with the space, whose basis is now `basis`. Empties it if that is too much.
  void follow(const Basis_2& basis)
  {
    const Distributed_deformation_2 back(basis, m_basis), forth(m_basis, basis);
    if (back.sum_of_squares() <= 4 && forth.sum_of_squares() <= 4)
      deform(back);
    else
      *this = Distributed_zone_2();
  }

  // Takes over the deformation or the end of `read`, the zone that was read from this one's words.
  // All ranks deform that by the same code; rounded elsewhere this zone might end at another time.
  // True if anything has changed.
  bool follow(const Distributed_zone_2& read)
  {
    if (is_empty() || (!read.is_empty() && read.m_deformation == m_deformation))
      return false;
    if (read.is_empty())
      *this = Distributed_zone_2();
    else
      deform(read.m_deformation);
    return true;
  }

  bool contains(double x, double y) const { return !is_empty() && contains(cell_of(x, y)); }

  // A distance, in each coordinate, up to which all places around (x, y) are in the zone; 0 if a
  // quick test finds none.
  double depth_around(double x, double y) const
  {
    const Cell c = cell_of(x, y);
    return (std::max)(layers(c.column, c.row) - 1, 0) * m_layer_depth;
  }

  // False only if no place in the box is in the zone. \pre The zone was read from words.
  bool may_meet(const Box_2& box) const
  {
    if (box.is_empty())
      return false;
    const auto [low, high] = cells_around(box);
    return low.column <= m_last.column && low.row <= m_last.row && high.column >= m_first.column &&
           high.row >= m_first.row;
  }

  // BLOCKS: squares of cells, numbered in rows, that are complete within the box; deformed with it

  static constexpr long cells_per_block = 4; // along an axis

  long block_columns() const { return m_columns / cells_per_block; }
  long block_rows() const { return m_rows / cells_per_block; }

  // The number of the block of a place; if it is in none, how many blocks there are.
  std::uint32_t block(double x, double y) const
  {
    const double scale = m_scale / double(cells_per_block);
    const Position_2 p = m_deformation(x, y);
    const double column = (p.x - m_x) * scale, row = (p.y - m_y) * scale;
    const bool is_in_one =
        column >= 0 && column < double(block_columns()) && row >= 0 && row < double(block_rows());
    return std::uint32_t(is_in_one ? std::int32_t(row) * block_columns() + std::int32_t(column)
                                   : block_rows() * block_columns());
  }
  // Whether all cells of a block, and `around` more in each direction, are in the zone.
  bool is_deep_block(long column, long row, long around) const
  {
    constexpr long last = cells_per_block - 1;
    const Cell low{column * cells_per_block - around, row * cells_per_block - around};
    const Cell high{low.column + last + 2 * around, low.row + last + 2 * around};
    return is_in_box(low) && is_in_box(high) && are_all_cells(low, high);
  }

  // A box around all places in the zone. \pre The zone was read from words.
  Box_2 bounds() const
  {
    if (m_first.column > m_last.column)
      return Box_2();
    const double size = cell_size(); // one cell more on each side, for rounding
    return m_deformation.inverse()(
        Box_2{m_x + double(m_first.column - 1) * size, m_y + double(m_first.row - 1) * size,
              m_x + double(m_last.column + 2) * size, m_y + double(m_last.row + 2) * size});
  }

  // A quick test: true only if all places in the box are in the zone.
  bool covers(const Box_2& box) const
  {
    if (!(box.width() < Box_2::infinity && box.height() < Box_2::infinity))
      return false;
    const auto [low, high] = cells_around(box);
    if (is_in_box(low) && is_in_box(high))
      return are_all_cells(low, high);
    const long number = (high.column - low.column + 1) * (high.row - low.row + 1);
    if (number > most_single_cells)
      return false;
    for (long row = low.row; row <= high.row; ++row)
      for (long column = low.column; column <= high.column; ++column)
        if (!contains(Cell{column, row}))
          return false;
    return true;
  }

  // Adds all cells that the box meets; beyond the grid's box only if they are few. \pre The zone is
  // not deformed yet.
  void add(const Box_2& box)
  {
    const Cell low{column_of(box.x_low), row_of(box.y_low)};
    const Cell high{column_of(box.x_high), row_of(box.y_high)};
    if (!is_in_box(low) || !is_in_box(high))
      list(low, high);
    const long left = (std::max)(low.column, 0L), right = (std::min)(high.column, m_columns - 1);
    const long upper = (std::min)(high.row, m_rows - 1);
    for (long row = (std::max)(low.row, 0L); row <= upper && left <= right; ++row)
      std::fill(m_cells.begin() + std::ptrdiff_t(cell(left, row)),
                m_cells.begin() + std::ptrdiff_t(cell(right, row)) + 1, std::uint8_t(1));
  }

  // Call it after the last `add()`, before any test.
  void sum_up()
  {
    std::sort(m_listed.begin(), m_listed.end());
    m_listed.erase(std::unique(m_listed.begin(), m_listed.end()), m_listed.end());
    m_sums.assign(std::size_t(m_columns + 1) * std::size_t(m_rows + 1), 0);
    for (long row = 0; row < m_rows; ++row) {
      std::uint32_t in_row = 0;
      for (long column = 0; column < m_columns; ++column) {
        in_row += m_cells[cell(column, row)];
        m_sums[corner(column + 1, row + 1)] = sum(column + 1, row) + in_row;
      }
    }
    find_layers();
  }

  // The zone as words; the cells in the box are lengths of runs of equal ones.
  std::vector<std::uint64_t> to_words() const
  {
    const Numbers numbers{m_basis[0].x, m_basis[0].y, m_basis[1].x, m_basis[1].y,
                          m_x,          m_y,          m_scale};
    std::vector<std::uint64_t> words(numbers.size());
    std::memcpy(words.data(), numbers.data(), sizeof(numbers));
    words.push_back(std::uint64_t(m_columns));
    words.push_back(std::uint64_t(m_rows));
    words.push_back(m_listed.size());
    words.insert(words.end(), m_listed.begin(), m_listed.end());
    for (std::size_t first = 0; first < m_cells.size();) {
      std::size_t beyond = first;
      while (beyond < m_cells.size() && m_cells[beyond] == m_cells[first])
        ++beyond;
      words.push_back((beyond - first) << 1 | m_cells[first]);
      first = beyond;
    }
    return words;
  }

  // Reads a zone, not deformed yet. Its only tests are `contains()`, `may_meet()` and `bounds()`.
  template <class Iterator>
  static Distributed_zone_2 of_words(Iterator words, Iterator beyond)
  {
    Distributed_zone_2 zone;
    Numbers numbers;
    for (double& number : numbers) {
      const std::uint64_t word = *words++;
      std::memcpy(&number, &word, sizeof(number));
    }
    zone.m_basis = {{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}}};
    zone.m_x = numbers[4], zone.m_y = numbers[5], zone.m_scale = numbers[6];
    zone.m_columns = long(*words++);
    zone.m_rows = long(*words++);
    const auto listed = std::ptrdiff_t(*words++);
    zone.m_listed.assign(words, words + listed);
    for (words += listed; words != beyond; ++words)
      zone.m_cells.insert(zone.m_cells.end(), *words >> 1, std::uint8_t(*words & 1));
    zone.find_bounds();
    return zone;
  }

private:
  struct Cell
  {
    long column, row;
  };
  using Numbers = std::array<double, 7>; // the vectors of the basis, x, y and the scale

  void deform(const Distributed_deformation_2& deformation)
  {
    m_deformation = deformation;
    m_layer_depth = 1 / m_scale / m_deformation.largest_growth() * (1 - 0x1p-16);
  }

  static constexpr long most_single_cells = 64; // that are looked at one by one
  static constexpr long no_cell = (std::numeric_limits<long>::max)();

  // Rounds down, within limits: the column or row of a cell, also beyond the box.
  static long place(double t)
  {
    constexpr double limit = 0x1p30;
    const double within = (std::min)((std::max)(t, -limit), limit);
    const long truncated = long(within); // std::floor() is slow without SSE4.1
    return truncated - (double(truncated) > within);
  }
  long column_of(double x) const { return place((x - m_x) * m_scale); }
  long row_of(double y) const { return place((y - m_y) * m_scale); }
  Cell cell_of(double x, double y) const
  {
    const Position_2 p = m_deformation(x, y);
    return {column_of(p.x), row_of(p.y)};
  }
  // Two cells between which the cells of all places in a box are.
  std::pair<Cell, Cell> cells_around(const Box_2& box) const
  {
    const Box_2 around = m_deformation(box);
    return {{column_of(around.x_low), row_of(around.y_low)},
            {column_of(around.x_high), row_of(around.y_high)}};
  }
  bool is_in_box(Cell c) const
  {
    return c.column >= 0 && c.column < m_columns && c.row >= 0 && c.row < m_rows;
  }
  bool are_all_cells(Cell low, Cell high) const // both in the box
  {
    return sum(high.column + 1, high.row + 1) - sum(low.column, high.row + 1) -
               sum(high.column + 1, low.row) + sum(low.column, low.row) ==
           std::uint32_t((high.column - low.column + 1) * (high.row - low.row + 1));
  }
  bool contains(Cell c) const
  {
    return is_in_box(c) ? m_cells[cell(c.column, c.row)] != 0
                        : std::binary_search(m_listed.begin(), m_listed.end(), packed(c));
  }
  static std::uint64_t packed(Cell c)
  {
    return std::uint64_t(std::uint32_t(c.row)) << 32 | std::uint32_t(c.column);
  }
  void list(Cell low, Cell high)
  {
    if ((high.column - low.column + 1) * (high.row - low.row + 1) > most_single_cells)
      return;
    for (long row = low.row; row <= high.row; ++row)
      for (long column = low.column; column <= high.column; ++column)
        if (!is_in_box({column, row}))
          m_listed.push_back(packed({column, row}));
  }
  // Computes chessboard distances in two passes: A. Rosenfeld and J. L. Pfaltz, Distance functions
  // on digital pictures, 1968.
  void find_layers()
  {
    m_layers.assign(m_cells.size(), 0);
    for (long row = 0; row < m_rows; ++row)
      for (long column = 0; column < m_columns; ++column)
        if (m_cells[cell(column, row)] != 0)
          m_layers[cell(column, row)] =
              one_more((std::min)({layers(column - 1, row), layers(column - 1, row - 1),
                                   layers(column, row - 1), layers(column + 1, row - 1)}));
    for (long row = m_rows; row-- > 0;)
      for (long column = m_columns; column-- > 0;)
        m_layers[cell(column, row)] = (std::min)(
            layers(column, row),
            one_more((std::min)({layers(column + 1, row), layers(column + 1, row + 1),
                                 layers(column, row + 1), layers(column - 1, row + 1)})));
  }
  std::uint8_t layers(long column, long row) const
  {
    return is_in_box({column, row}) ? m_layers[cell(column, row)] : std::uint8_t(0);
  }
  static std::uint8_t one_more(std::uint8_t layers)
  {
    return std::uint8_t(layers + (layers < (std::numeric_limits<std::uint8_t>::max)()));
  }
  void find_bounds()
  {
    for (long row = 0; row < m_rows; ++row)
      for (long column = 0; column < m_columns; ++column)
        if (m_cells[cell(column, row)] != 0)
          widen({column, row});
    for (const std::uint64_t listed : m_listed)
      widen({std::int32_t(std::uint32_t(listed)), std::int32_t(listed >> 32)});
  }
  void widen(Cell c)
  {
    m_first = {(std::min)(m_first.column, c.column), (std::min)(m_first.row, c.row)};
    m_last = {(std::max)(m_last.column, c.column), (std::max)(m_last.row, c.row)};
  }
  std::size_t cell(long column, long row) const { return std::size_t(row * m_columns + column); }
  std::size_t corner(long column, long row) const
  {
    return std::size_t(row * (m_columns + 1) + column);
  }
  std::uint32_t sum(long column, long row) const { return m_sums[corner(column, row)]; }

  Basis_2 m_basis = unit_basis;            // when the zone was made
  Distributed_deformation_2 m_deformation; // from now to then
  double m_x = 0, m_y = 0, m_scale = 1;
  double m_layer_depth = 0; // how much depth a layer of cells adds, not rounded up
  long m_columns = 0, m_rows = 0;
  std::vector<std::uint8_t> m_cells;   // of the box
  std::vector<std::uint8_t> m_layers;  // of the box: distances to cells outside of zone or box
  std::vector<std::uint64_t> m_listed; // cells beyond the box, ascending
  std::vector<std::uint32_t> m_sums;   // of the cells to the left of and below each corner
  Cell m_first = {no_cell, no_cell};   // the least and, below, the largest column and row
  Cell m_last = {-no_cell, -no_cell};
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_ZONE_2_H
