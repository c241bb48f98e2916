// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_PASS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_PASS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_predicates_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_pass_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// What the tests of a pass read: cells, positions, and the translations by small shifts.
class Torus_view_3
{
public:
  using Cell = Torus_cell_3;

  template <class State>
  explicit Torus_view_3(const State& state)
    : m_cells(state.arrays.cells())
    , m_positions(state.positions.data())
    , m_translations(state.torus.small_translations())
    , m_squared_error(state.squared_error)
  {
  }

  const Cell& cell(Index c) const { return m_cells[c]; }
  const Cell* cells() const { return m_cells; }
  const Position_3& position(Vertex_index v) const { return m_positions[v]; }
  double squared_error() const { return m_squared_error; }

  // Whether a cell's vertices, or those beyond its facets, have shifts: all that is asked of each
  // cell. How large they are is asked of those alone that have some: so a pass takes 8.8 instead of
  // 10.0 nanoseconds a cell.
  BOOST_FORCEINLINE static bool has_shifts(const Cell& cell)
  {
    std::array<std::uint64_t, 4> codes; // eight in four words
    std::memcpy(codes.data(), &cell.shifts, sizeof(cell.shifts));
    std::memcpy(codes.data() + 2, &cell.beyond, sizeof(cell.beyond));
    return (codes[0] | codes[1] | codes[2] | codes[3]) != 0;
  }
  // Whether the table has the translations of all of these.
  BOOST_FORCEINLINE static bool has_small_shifts(const Cell& cell)
  {
    int beyond_table = 0;
    for (int i = 0; i < 4; ++i)
      beyond_table |= Small_translations_3::bits_beyond_table(cell.shifts[i]) |
                      Small_translations_3::bits_beyond_table(cell.beyond[i]);
    return beyond_table == 0;
  }

  // The vertices of a cell have the places from 0 to 3, and those beyond its facets from 4 to 7.
  BOOST_FORCEINLINE Vertex_index vertex(const Cell& cell, int place) const
  {
    if (place < 4)
      return cell.vertices[place];
    const Index k = cell.mirrors[place - 4];
    return m_cells[k / 4].vertices[k % 4];
  }
  // The numbers of translations by small shifts, of a cell's places.
  using Numbers = Few<unsigned, 8>;
  BOOST_FORCEINLINE static Numbers translations_of(const Cell& cell)
  {
    Numbers numbers;
    std::memcpy(numbers.begin(), &cell.shifts, sizeof(cell.shifts));
    std::memcpy(numbers.begin() + 4, &cell.beyond, sizeof(cell.beyond));
    for (unsigned& number : numbers) // by instructions that compute all at once
      number = Small_translations_3::place(number);
    return numbers;
  }
  // The image of a place, for lanes.
  BOOST_FORCEINLINE Translated_3 image(const Cell& cell, const Numbers& numbers, int place) const
  {
    return {&m_positions[vertex(cell, place)], &m_translations.at(numbers[place])};
  }

  // Whether a finite cell has large shifts only because infinite vertices are beyond its facets.
  bool is_beneath_hull(const Cell& cell) const
  {
    Cell other = cell;
    for (int i = 0; i < 4; ++i)
      if (vertex(cell, 4 + i) == infinite_index)
        other.beyond[i] = Torus_shift_3();
    return has_small_shifts(other);
  }
  // As `image`, of such a cell; infinite vertices are nowhere, as in open space.
  BOOST_FORCEINLINE Translated_3 image_beneath_hull(const Cell& cell, const Numbers& numbers,
                                                    int place) const
  {
    if (place >= 4 && vertex(cell, place) == infinite_index)
      return {&m_positions[Vertex_index(infinite_index)], &m_translations.at(0)};
    return image(cell, numbers, place);
  }

private:
  const Cell* m_cells;
  const Position_3* m_positions;
  const Small_translations_3& m_translations;
  double m_squared_error;
};

// Cells that wait until all lanes have one.
class Waiting_cells_3
{
public:
  static constexpr std::size_t block = 64; // cells that come before others are tested
  static constexpr int most_lanes = 8;

  // Adds a cell if it is of the kind, without a branch, which would be mispredicted.
  BOOST_FORCEINLINE void add_if(bool is_of_kind, Cell_index c)
  {
    m_cells[m_number] = c;
    m_number += std::size_t(is_of_kind);
  }
  // Calls f(cells) for as many at once as there are lanes, and keeps the rest.
  template <int lanes, class Function>
  BOOST_FORCEINLINE void take(const Function& f)
  {
    static_assert(lanes <= most_lanes);
    std::size_t taken = 0;
    for (; taken + lanes <= m_number; taken += lanes) {
      Few<Cell_index, lanes> some{};
      for (int i = 0; i < lanes; ++i)
        some[i] = m_cells[taken + std::size_t(i)];
      f(some);
    }
    std::copy(m_cells.begin() + std::ptrdiff_t(taken), m_cells.begin() + std::ptrdiff_t(m_number),
              m_cells.begin());
    m_number -= taken;
  }

private:
  std::array<Cell_index, block + most_lanes> m_cells{}; // of those that are kept, fewer than lanes
  std::size_t m_number = 0;
};

template <int lanes, class Point_at, class Learned>
BOOST_FORCEINLINE void append_unproved_in_torus(const Few<Cell_index, lanes>& some,
                                                const Point_at& point_at, double squared_error,
                                                const Learned& learned,
                                                std::vector<Cell_index>& unproved)
{
  const auto corners = [&](int place) CGAL_DYNAMIC_DELAUNAY_INLINE {
    return points_in_lanes<lanes>(
        [&](int i) CGAL_DYNAMIC_DELAUNAY_INLINE -> decltype(auto) { return point_at(i, place); });
  };
  const auto beyond = [&](int place) CGAL_DYNAMIC_DELAUNAY_INLINE { return corners(4 + place); };
  test_in_lanes<Torus_filter_in_lanes_3<Lanes<lanes>>>(some, corners, beyond, learned, unproved,
                                                       Lanes<lanes>(squared_error));
}

// The same of cells with shifts: image(cell, numbers, place) is a vertex where it is seen.
template <int lanes, class Image, class Learned>
BOOST_FORCEINLINE void append_unproved_of_images(const Torus_view_3& view,
                                                 const Few<Cell_index, lanes>& some,
                                                 const Image& image, const Learned& learned,
                                                 std::vector<Cell_index>& unproved)
{
  Few<Torus_view_3::Numbers, lanes> numbers;
  for (int i = 0; i < lanes; ++i)
    numbers[i] = view.translations_of(view.cell(some[i]));
  append_unproved_in_torus(
      some,
      [&](int i, int place)
          CGAL_DYNAMIC_DELAUNAY_INLINE { return image(view.cell(some[i]), numbers[i], place); },
      view.squared_error(), learned, unproved);
}

// Tests so many cells, the i-th of which is cell_at(i). Cells without shifts, most of them, read
// positions from where they are; those of others are translated. A block of cells is sorted before
// its cells are tested, so that the two kinds of tests do not alternate. Cells with large shifts
// are not tested, but listed.
template <int lanes, class Cell_at, class Learned>
BOOST_FORCEINLINE void append_unproved_in_lanes(const Torus_view_3& view, std::size_t cells,
                                                const Cell_at& cell_at, const Learned& learned,
                                                std::vector<Cell_index>& unproved,
                                                std::vector<Cell_index>& large)
{
  using Dynamic_Delaunay_triangulations_2::internal::prefetch;
  constexpr std::size_t ahead = 16;
  Waiting_cells_3 plain, others, shifted;
  const auto test_plain = [&](const auto& some) CGAL_DYNAMIC_DELAUNAY_INLINE {
    append_unproved_in_torus(
        some,
        [&](int i, int place) CGAL_DYNAMIC_DELAUNAY_INLINE -> const Position_3& {
          return view.position(view.vertex(view.cell(some[i]), place));
        },
        view.squared_error(), learned, unproved);
  };
  const auto test_shifted = [&](const auto& some) CGAL_DYNAMIC_DELAUNAY_INLINE {
    append_unproved_of_images(
        view, some,
        [&](const auto& cell, const auto& numbers, int place)
            CGAL_DYNAMIC_DELAUNAY_INLINE { return view.image(cell, numbers, place); },
        learned, unproved);
  };
  const auto sort_by_size = [&](const Few<Cell_index, 1>& some) CGAL_DYNAMIC_DELAUNAY_INLINE {
    const bool is_small = view.has_small_shifts(view.cell(some[0]));
    shifted.add_if(is_small, some[0]);
    if (!is_small)
      large.push_back(some[0]);
  };
  for (std::size_t n = 0; n < cells;) {
    const std::size_t beyond = (std::min)(n + Waiting_cells_3::block, cells);
    for (; n < beyond; ++n) {
      if (n + 2 * ahead < cells)
        prefetch(view.cells() + cell_at(n + 2 * ahead));
      if (n + ahead < cells)
        for (const Corner_index k : view.cell(cell_at(n + ahead)).mirrors)
          prefetch(view.cells() + k / 4);
      const Cell_index c = cell_at(n);
      const bool is_plain = !view.has_shifts(view.cell(c));
      plain.add_if(is_plain, c);
      others.add_if(!is_plain, c);
    }
    others.template take<1>(sort_by_size);
    plain.template take<lanes>(test_plain);
    shifted.template take<lanes>(test_shifted);
  }
  plain.template take<1>(test_plain);
  shifted.template take<1>(test_shifted);
}

// Tests cells beneath the hull of a slab or a wire.
template <int lanes, class Learned>
BOOST_FORCEINLINE void
append_unproved_beneath_hull(const Torus_view_3& view, const std::vector<Cell_index>& cells,
                             const Learned& learned, std::vector<Cell_index>& unproved)
{
  const auto test = [&](const auto& some) CGAL_DYNAMIC_DELAUNAY_INLINE {
    append_unproved_of_images(
        view, some,
        [&](const auto& cell, const auto& numbers, int place)
            CGAL_DYNAMIC_DELAUNAY_INLINE { return view.image_beneath_hull(cell, numbers, place); },
        learned, unproved);
  };
  Waiting_cells_3 waiting;
  for (const Cell_index c : cells) {
    waiting.add_if(true, c);
    waiting.template take<lanes>(test);
  }
  waiting.template take<1>(test);
}

// What a pass over a torus reads.
template <class Traits, class ConcurrencyTag>
class Pass_view_3<Torus_state_3<Traits, ConcurrencyTag>>
{
public:
  explicit Pass_view_3(const Torus_state_3<Traits, ConcurrencyTag>& state)
    : m_view(state)
  {
  }
  static double error_of(const Torus_state_3<Traits, ConcurrencyTag>& state)
  {
    return std::sqrt(state.squared_error) * (1 + 0x1p-50);
  }

  template <class Cell_at, class Learned>
  void append_unproved(std::size_t number, const Cell_at& cell_at, const Learned& learned,
                       Unproved_cells_3& unproved) const
  {
    std::vector<Cell_index> large;
    call_with_lanes([&](auto lanes) CGAL_DYNAMIC_DELAUNAY_INLINE {
      append_unproved_in_lanes<lanes>(m_view, number, cell_at, learned, unproved.finite, large);
    });
    if (!large.empty())
      append_unproved_of_large(large, learned, unproved);
    // which cells are tested at once depends on those that are left out
    std::sort(unproved.finite.begin(), unproved.finite.end());
  }

private:
  // Exact predicates have to look at cells with large shifts, but for those beneath the hull.
  template <class Learned>
  void append_unproved_of_large(const std::vector<Cell_index>& large, const Learned& learned,
                                Unproved_cells_3& unproved) const
  {
    std::vector<Cell_index> beneath_hull;
    for (const Cell_index c : large)
      (has_infinite(m_view.cell(c).vertices)    ? unproved.infinite
       : m_view.is_beneath_hull(m_view.cell(c)) ? beneath_hull
                                                : unproved.finite)
          .push_back(c);
    call_with_lanes([&](auto lanes) CGAL_DYNAMIC_DELAUNAY_INLINE {
      append_unproved_beneath_hull<lanes>(m_view, beneath_hull, learned, unproved.finite);
    });
  }

  Torus_view_3 m_view;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_PASS_3_H
