// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_CELLS_IN_DOMAINS_H
#define SCENARIO_RUNNER_CELLS_IN_DOMAINS_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_cells_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cells_in_domain_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>

namespace run {

// Cells that end at radii only or in a convex domain, and those in any domain.
using Cells_in_domains =
    std::variant<CGAL::Bounded_voronoi_cells_2, CGAL::Voronoi_cells_in_domain_2>;

using Cell_rule = CGAL::Voronoi_cells_in_domain_2::Rule;

// The rule of a name on the command line.
// \throws std::invalid_argument
inline Cell_rule cell_rule(const std::string& name)
{
  if (name == "whole") {
    return Cell_rule::WHOLE;
  }
  if (name == "connected") {
    return Cell_rule::CONNECTED;
  }
  if (name == "visible") {
    return Cell_rule::VISIBLE;
  }
  throw std::invalid_argument("the rule is '" + name +
                              "', allowed are whole, connected and visible");
}

// `radii` is one for all, or has one for each id.
template <class Dynamic, class Radii>
void compute_cells(Cells_in_domains& cells, const Dynamic& dt, const Radii& radii)
{
  const auto compute = [&](auto& these) {
    using These = std::decay_t<decltype(these)>;
    if constexpr (Dynamic::Frame::is_periodic &&
                  std::is_same_v<These, CGAL::Voronoi_cells_in_domain_2>) {
      throw CGAL::Domain_error_2(0, "there is none in periodic space");
    } else {
      these.compute(dt, radii);
    }
  };
  std::visit(compute, cells);
}

// The place in `pieces()` where the pieces of an id begin; behind the last id, where all end.
inline std::size_t first_piece(const CGAL::Bounded_voronoi_cells_2& cells, std::size_t id)
{
  return cells.first_pieces()[id];
}
inline std::size_t first_piece(const CGAL::Voronoi_cells_in_domain_2& cells, std::size_t id)
{
  return cells.first_pieces()[cells.first_rings()[id]];
}

} // namespace run

#endif // SCENARIO_RUNNER_CELLS_IN_DOMAINS_H
