// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_PASS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_PASS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_predicates_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_pass_3.h>

#include <array>
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
  BOOST_FORCEINLINE bool is_without_shifts(const Cell& cell) const
  {
    int codes = 0;
    for (int i = 0; i < 4; ++i) {
      const Index k = cell.mirrors[i];
      codes |= cell.shifts[i].code | (m_cells[k / 4].shifts[k % 4] + cell.translations[i]).code;
    }
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

template <int lanes, class Point_at>
BOOST_FORCEINLINE void append_unproved_in_torus(const Few<Cell_index, lanes>& some,
                                                const Point_at& point_at, double squared_error,
                                                std::vector<Cell_index>& unproved)
{
  const auto points = [&](int place) CGAL_DYNAMIC_DELAUNAY_INLINE {
    return points_in_lanes<lanes>(
        [&](int i) CGAL_DYNAMIC_DELAUNAY_INLINE -> decltype(auto) { return point_at(i, place); });
  };
  const auto a = points(0);
  const Torus_filter_in_lanes_3<Lanes<lanes>> filter(points(1) - a, points(2) - a, points(3) - a,
                                                     Lanes<lanes>(squared_error));
  auto are_unproved = filter.may_be_inverted();
  for (int place = 4; place < 8; ++place)
    are_unproved = are_unproved | filter.may_be_inside(points(place) - a);
  if (const unsigned answers = Dynamic_Delaunay_triangulations_2::internal::bits(are_unproved))
    for (int i = 0; i < lanes; ++i)
      if (answers >> i & 1)
        unproved.push_back(some[i]);
}

// Tests the cells from `first` to before `beyond`. Cells without shifts, most of them, read
// positions from where they are; those of others are translated.
template <int lanes>
BOOST_FORCEINLINE void append_unproved_in_lanes(const Torus_view_3& view, std::size_t first,
                                                std::size_t beyond,
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
      const Torus_view_3::Cell& other = view.cell(k / 4);
      images[i] = view.image(cell.vertices[i], cell.shifts[i]);
      images[i + 4] = view.image(other.vertices[k % 4], other.shifts[k % 4] + cell.translations[i]);
      are_small = are_small && images[i].translation && images[i + 4].translation;
    }
    if (are_small)
      shifted.cells[shifted.number++] = c;
    else
      unproved.push_back(c);
  };
  for (Cell_index c(first); c < beyond; ++c) {
    const Torus_view_3::Cell& cell = view.cell(c);
    if (c + ahead < beyond)
      for (const Corner_index k : view.cell(c + Index(ahead)).mirrors)
        prefetch(view.cells() + k / 4);
    if (view.is_without_shifts(cell)) {
      plain[number++] = c;
      if (number == lanes) {
        append_unproved_in_torus<lanes>(plain, plain_at, view.squared_error(), unproved);
        number = 0;
      }
      continue;
    }
    append_shifted(c);
    if (shifted.number == lanes) {
      append_unproved_in_torus<lanes>(shifted.cells, shifted_at, view.squared_error(), unproved);
      shifted.number = 0;
    }
  }
  for (int i = 0; i < number; ++i)
    append_unproved_in_torus<1>(
        {plain[i]}, [&](int, int place) -> const Position_3& { return plain_at(i, place); },
        view.squared_error(), unproved);
  for (int i = 0; i < shifted.number; ++i)
    append_unproved_in_torus<1>(
        {shifted.cells[i]},
        [&](int, int place) -> const Translated_3& { return shifted_at(i, place); },
        view.squared_error(), unproved);
}

// Finds the cells that floating point does not prove positive with legal facets, on threads; each
// facet is tested from both of its cells.
template <class Traits, class ConcurrencyTag>
void find_unproved(const Torus_state_3<Traits, ConcurrencyTag>& state, Unproved_cells_3& cells)
{
  using Parts = typename Torus_state_3<Traits, ConcurrencyTag>::Parts;
  std::vector<Cell_index>& unproved = cells.finite;
  unproved.clear();
  const Torus_view_3 view(state);
  std::array<std::vector<Cell_index>, Parts::max_parts> lists;
  const std::size_t number = state.arrays.number_of_cells(), parts = Parts::number(number);
  Parts::for_each(number, [&](std::size_t part, std::size_t first, std::size_t beyond) {
    std::vector<Cell_index>& list = parts == 1 ? unproved : lists[part];
    call_with_lanes([&, first, beyond](auto lanes) CGAL_DYNAMIC_DELAUNAY_INLINE {
      append_unproved_in_lanes<lanes>(view, first, beyond, list);
    });
  });
  for (std::size_t part = 0; part < parts && parts > 1; ++part)
    unproved.insert(unproved.end(), lists[part].begin(), lists[part].end());
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_PASS_3_H
