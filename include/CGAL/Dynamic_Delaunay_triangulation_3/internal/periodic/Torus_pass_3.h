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
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// What the tests of a pass read: cells, positions, and the translations of small shifts.
class Torus_view_3
{
public:
  using Cell = Torus_cell_3;

  template <class State>
  explicit Torus_view_3(const State& state)
    : m_cells(state.arrays.cells())
    , m_positions(state.positions.data())
    , m_torus(state.torus)
    , m_squared_error(state.squared_error)
  {
    for (int x = 0; x < side; ++x)
      for (int y = 0; y < side; ++y)
        for (int z = 0; z < side; ++z)
          m_translations[std::size_t(x + side * (y + side * z))] =
              m_torus.combination(Multiples_3{x - side / 2, y - side / 2, z - side / 2});
  }

  const Cell& cell(Index c) const { return m_cells[c]; }
  const Cell* cells() const { return m_cells; }
  const Position_3& position(Vertex_index v) const { return m_positions[v]; }
  double squared_error() const { return m_squared_error; }

  // Whether all images of a cell's vertices and of those beyond its facets have the shift 0.
  BOOST_FORCEINLINE static bool is_without_shifts(const Cell& cell)
  {
    int codes = 0;
    for (int i = 0; i < 4; ++i)
      codes |= cell.shifts[i].code | cell.beyond[i].code;
    return codes == 0;
  }

  // An image, for lanes. Without a translation if its shift is large.
  BOOST_FORCEINLINE Translated_3 image(Vertex_index v, Torus_shift_3 shift) const
  {
    constexpr int middle = side / 2 * (1 + (1 << 10) + (1 << 20)), low = side - 1;
    const int code = shift.code + middle;
    const bool is_small = (code & ~(low | low << 10 | low << 20)) == 0;
    const std::size_t number =
        std::size_t((code & low) | (code >> 10 & low) << bits | (code >> 20 & low) << 2 * bits);
    return {&m_positions[v], is_small ? &m_translations[number] : nullptr};
  }

private:
  static constexpr int bits = 3, side = 1 << bits;

  const Cell* m_cells;
  const Position_3* m_positions;
  const Torus_3& m_torus;
  double m_squared_error;
  std::array<Position_3, side * side * side> m_translations; // from -4 to 3
};

// Cells that are tested at once, with the images of their vertices and of those beyond their
// facets.
template <int lanes>
struct Torus_group_3
{
  Few<Cell_index, lanes> cells;
  Few<Few<Translated_3, 8>, lanes> images;
  int number = 0;
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

// Tests so many cells, the i-th of which is cell_at(i). Cells without shifts, most of them, read
// positions from where they are; those of others are translated.
template <int lanes, class Cell_at, class Learned>
BOOST_FORCEINLINE void append_unproved_in_lanes(const Torus_view_3& view, std::size_t cells,
                                                const Cell_at& cell_at, const Learned& learned,
                                                std::vector<Cell_index>& unproved)
{
  using Dynamic_Delaunay_triangulations_2::internal::prefetch;
  constexpr std::size_t ahead = 16;
  Few<Cell_index, lanes> plain{};
  Torus_group_3<lanes> shifted;
  int number = 0;
  const auto plain_at = [&](int i, int place) CGAL_DYNAMIC_DELAUNAY_INLINE -> const Position_3& {
    const Torus_view_3::Cell& cell = view.cell(plain[i]);
    if (place < 4)
      return view.position(cell.vertices[place]);
    const Index k = cell.mirrors[place - 4];
    return view.position(view.cell(k / 4).vertices[k % 4]);
  };
  const auto shifted_at =
      [&](int i, int place)
          CGAL_DYNAMIC_DELAUNAY_INLINE -> const Translated_3& { return shifted.images[i][place]; };
  // cells with large shifts are left to exact predicates
  const auto append_shifted = [&](Cell_index c) CGAL_DYNAMIC_DELAUNAY_INLINE {
    const Torus_view_3::Cell& cell = view.cell(c);
    Few<Translated_3, 8>& images = shifted.images[shifted.number];
    bool are_small = true;
    for (int i = 0; i < 4; ++i) {
      const Index k = cell.mirrors[i];
      images[i] = view.image(cell.vertices[i], cell.shifts[i]);
      images[i + 4] = view.image(view.cell(k / 4).vertices[k % 4], cell.beyond[i]);
      are_small = are_small && images[i].translation && images[i + 4].translation;
    }
    if (are_small)
      shifted.cells[shifted.number++] = c;
    else
      unproved.push_back(c);
  };
  for (std::size_t n = 0; n < cells; ++n) {
    const Cell_index c = cell_at(n);
    const Torus_view_3::Cell& cell = view.cell(c);
    if (n + 2 * ahead < cells)
      prefetch(view.cells() + cell_at(n + 2 * ahead));
    if (n + ahead < cells)
      for (const Corner_index k : view.cell(cell_at(n + ahead)).mirrors)
        prefetch(view.cells() + k / 4);
    if (view.is_without_shifts(cell)) {
      plain[number++] = c;
      if (number == lanes) {
        append_unproved_in_torus<lanes>(plain, plain_at, view.squared_error(), learned, unproved);
        number = 0;
      }
      continue;
    }
    append_shifted(c);
    if (shifted.number == lanes) {
      append_unproved_in_torus<lanes>(shifted.cells, shifted_at, view.squared_error(), learned,
                                      unproved);
      shifted.number = 0;
    }
  }
  for (int i = 0; i < number; ++i)
    append_unproved_in_torus<1>(
        {plain[i]}, [&](int, int place) -> const Position_3& { return plain_at(i, place); },
        view.squared_error(), learned, unproved);
  for (int i = 0; i < shifted.number; ++i)
    append_unproved_in_torus<1>(
        {shifted.cells[i]},
        [&](int, int place) -> const Translated_3& { return shifted_at(i, place); },
        view.squared_error(), learned, unproved);
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
    call_with_lanes([&](auto lanes) CGAL_DYNAMIC_DELAUNAY_INLINE {
      append_unproved_in_lanes<lanes>(m_view, number, cell_at, learned, unproved.finite);
    });
    // which cells are tested at once depends on those that are left out
    std::sort(unproved.finite.begin(), unproved.finite.end());
  }

private:
  Torus_view_3 m_view;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_PASS_3_H
