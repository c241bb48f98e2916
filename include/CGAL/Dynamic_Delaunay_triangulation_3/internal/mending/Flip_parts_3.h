// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_FLIP_PARTS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_FLIP_PARTS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Lawson_flips_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Spatial_parts_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_pass_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Cells of a part of those that a thread tests by exact signs: each takes some 50 nanoseconds.
template <class Parts>
constexpr std::size_t least_tested_3 = (std::max)(Parts::usual_size / 16, std::size_t(1));

// Flips many open facets: first those of the hull, then finite ones in parts that threads share,
// then in other parts what these have left at their borders, and at last, in turn, what is left
// there. All this depends on the triangulation alone, so that equal input gives equal cells on any
// number of threads.
template <class State>
class Flip_parts_3
{
  using Arrays = typename State::Arrays;
  using Flips = Lawson_flips_3<State>;
  using Facet = typename Flips::Facet;
  using Parts = typename State::Exact_parts;
  using Division = typename Flips::Division;

public:
  explicit Flip_parts_3(State& state)
    : m_state(state)
  {
  }

  // Opens the facets of cells, those that exist, opposite to corners that `is_wanted` says, on
  // threads.
  template <class Predicate>
  void open(Flips& flips, const std::vector<Cell_index>& cells, const Predicate& is_wanted) const
  {
    append_by_parts<Parts>(
        cells.size(), least_tested_3<Parts>,
        [&](std::size_t i, std::size_t beyond, typename Flips::Open_facets& facets) {
          const typename Flips::Signs signs(m_state);
          for (; i < beyond; ++i) {
            prefetch_around(m_state, cells, i);
            if (!m_state.arrays.is_free(cells[i]))
              flips.append_doubtful(signs, cells[i], is_wanted, facets);
          }
        },
        flips.open_facets());
  }
  void open(Flips& flips, const std::vector<Cell_index>& cells) const
  {
    open(flips, cells, [](Corner_index) { return true; });
  }

  // Flips until no facet is open.
  void run(Flips& flips) const
  {
    flips.run_at_hull();
    divide_while_worth(
        m_state, m_state.positions, parts_of_facets,
        [&] { return flips.open_facets().finite.size(); },
        [&](const Division& parts) { run_in_parts(flips, parts); });
    std::vector<Facet> facets;
    facets.swap(flips.open_facets().finite);
    flips.run(facets);
  }

private:
  void run_in_parts(Flips& flips, const Division& parts) const
  {
    const std::vector<std::vector<Facet>> seeds = divide(parts, flips);
    std::vector<Flips> of_parts(parts.number(), Flips(m_state));
    m_state.arrays.begin_parts(parts.number(), [&](std::size_t part) {
      return few_cells + seeds[part].size() / seeds_of_new_cell;
    });
    Parts::run(parts.number(), [&](std::size_t part) {
      of_parts[part].begin_part(parts, part);
      of_parts[part].run(seeds[part]);
    });
    m_state.arrays.end_parts();
    for (const Flips& of_part : of_parts)
      flips.append_left(of_part);
  }

  // Takes the facets of each part, which has all vertices of both cells there; others remain open.
  std::vector<std::vector<Facet>> divide(const Division& parts, Flips& flips) const
  {
    constexpr std::size_t least = (std::max)(Parts::usual_size / 8, std::size_t(1));
    std::vector<Facet>& facets = flips.open_facets().finite;
    std::vector<std::uint8_t> part_of_facet(facets.size());
    Parts::for_each(facets.size(), least, [&](std::size_t, std::size_t i, std::size_t beyond) {
      for (; i < beyond; ++i) {
        flips.prefetch_ahead(facets, i);
        part_of_facet[i] = flips.is_there(facets[i]) ? part_of(parts, facets[i].corner) : none;
      }
    });
    std::vector<std::vector<Facet>> of_parts(parts.number());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < facets.size(); ++i)
      if (part_of_facet[i] != none)
        of_parts[part_of_facet[i]].push_back(facets[i]);
      else
        facets[kept++] = facets[i];
    facets.resize(kept);
    return of_parts;
  }

  std::uint8_t part_of(const Division& parts, Corner_index k) const
  {
    const Vertex_index apex = m_state.arrays.apex(k);
    if (apex == infinite_index)
      return none;
    const std::size_t part = parts.part_of(apex);
    for (const Vertex_index v : m_state.arrays.vertices(Arrays::cell_of(k)))
      if (!parts.has(part, v))
        return none;
    return std::uint8_t(part);
  }

  // Of 10,000 points more than half of the facets are at borders: one thread would take a third
  // longer.
  static constexpr std::size_t parts_of_facets = 4;

  static constexpr std::uint8_t none = 255; // more than there are parts

  // Cells that are reserved for a part: it drops about as many as it makes.
  static constexpr std::size_t few_cells = 8, seeds_of_new_cell = 8;

  State& m_state;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_FLIP_PARTS_3_H
