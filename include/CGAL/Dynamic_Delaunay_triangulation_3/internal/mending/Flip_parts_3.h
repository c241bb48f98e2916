// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_FLIP_PARTS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_FLIP_PARTS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Divided_list.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Lawson_flips_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Spatial_parts_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_pass_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Cells of a part of so many that threads test by exact signs: each takes some 50 nanoseconds, so
// that few ones are shared, too.
template <class Parts>
std::size_t least_tested_3(std::size_t cells)
{
  constexpr std::size_t most = (std::max)(Parts::usual_size / 16, std::size_t(1));
  return cells < 2 * Parts::least_shared * most ? (std::max)(most / 2, std::size_t(1)) : most;
}

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
  template <class Element>
  using Divided_list = Dynamic_Delaunay_triangulations_2::internal::Divided_list<Element>;

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
        cells.size(), least_tested_3<Parts>(cells.size()),
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
        m_state, m_state.positions, divisions(), [&] { return flips.open_facets().finite.size(); },
        [&](const Division& parts) { run_in_parts(flips, parts); });
    std::vector<Facet> facets;
    facets.swap(flips.open_facets().finite);
    flips.run(); // what parts have left of the hull
    flips.run(facets.data(), facets.size());
  }

private:
  void run_in_parts(Flips& flips, const Division& parts) const
  {
    Divided_list<Facet> seeds;
    divide(parts, flips, seeds);
    std::vector<Flips> of_parts(parts.number(), Flips(m_state));
    m_state.arrays.template begin_parts<typename State::Parts>(
        parts.number(),
        [&](std::size_t part) { return few_cells + seeds.size(part) / seeds_of_new_cell; });
    Parts::run_long(parts.number(), [&](std::size_t part) {
      of_parts[part].begin_part(parts, part);
      of_parts[part].run(seeds.begin(part), seeds.size(part));
    });
    m_state.arrays.end_parts();
    for (const Flips& of_part : of_parts)
      flips.append_left(of_part);
  }

  // Divides the finite facets by the parts that have all vertices of both cells there. Others
  // remain open.
  void divide(const Division& parts, Flips& flips, Divided_list<Facet>& seeds) const
  {
    std::vector<Facet>& facets = flips.open_facets().finite;
    const std::size_t none = parts.number();
    seeds.template divide<Parts>(facets, none + 1, [&](std::size_t i) {
      flips.prefetch_ahead(facets.data(), facets.size(), i);
      return flips.is_there(facets[i]) ? part_of(parts, facets[i].corner) : none;
    });
    facets.assign(seeds.begin(none), seeds.end(none));
  }

  std::size_t part_of(const Division& parts, Corner_index k) const
  {
    const Vertex_index apex = m_state.arrays.apex(k);
    if (apex == infinite_index)
      return parts.number();
    const std::size_t part = parts.part_of(apex);
    for (const Vertex_index v : m_state.arrays.vertices(Arrays::cell_of(k)))
      if (!parts.has(part, v))
        return parts.number();
    return part;
  }

  // Of 10,000 points too many facets are at borders: one thread would take a tenth longer.
  std::vector<typename Division::Numbers> divisions() const
  {
    constexpr std::size_t few_cells_in_all = 4 * Parts::least_shared * Parts::usual_size;
    if (m_state.arrays.number_of_cells() < few_cells_in_all)
      return {};
    return {{3, 3, 3}, {2, 2, 2}};
  }

  // Cells that are reserved for a part: it drops about as many as it makes.
  static constexpr std::size_t few_cells = 8, seeds_of_new_cell = 8;

  State& m_state;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_FLIP_PARTS_3_H
