// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_BOUNDED_CELLS_H
#define BINDINGS_BOUNDED_CELLS_H

#include "bindings/common/Array_reading.h"
#include "bindings/common/Subject.h"
#include "scenario_runner/Cells_in_domains.h"

#include <CGAL/convexity_check_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_gradients_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace bindings {

// Voronoi cells that end at radii or at the walls of a domain, of a moment, and what it takes to
// show them by rows.
struct Bounded_cells
{
  run::Cells_in_domains cells{};
  bool are_walls_reversed = false; // the numbers of walls
  std::vector<std::size_t> ids{};  // of all rows
  Integers rows{};                 // of all ids
  Array points{};
  std::optional<Cell> cell{};
};

using Corner = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Corners = std::vector<Corner>; // of a ring

// Cells in a domain whose outer boundary comes first, turned as it may be. By the rule that counts
// all, those of a convex one are such that have gradients and a surface.
inline Bounded_cells cells_in_domain(std::vector<Corners> rings, run::Cell_rule rule)
{
  Bounded_cells bounded;
  Corners& outer = rings.front();
  const bool is_finite = std::all_of(outer.begin(), outer.end(), [](const Corner& corner) {
    return std::isfinite(corner.x()) && std::isfinite(corner.y());
  });
  if (rings.size() == 1 && rule == run::Cell_rule::WHOLE && is_finite && outer.size() > 2) {
    bounded.are_walls_reversed = CGAL::is_cw_strongly_convex_2(outer.begin(), outer.end());
    if (bounded.are_walls_reversed) {
      std::reverse(outer.begin(), outer.end());
    }
    if (CGAL::is_ccw_strongly_convex_2(outer.begin(), outer.end())) {
      std::get<CGAL::Bounded_voronoi_cells_2>(bounded.cells).set_domain(outer.begin(), outer.end());
      return bounded;
    }
  }
  using Polygon = CGAL::Polygon_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
  CGAL::Polygon_with_holes_2<CGAL::Exact_predicates_inexact_constructions_kernel> domain(
      Polygon(outer.begin(), outer.end()));
  for (std::size_t i = 1; i < rings.size(); ++i) {
    domain.add_hole(Polygon(rings[i].begin(), rings[i].end()));
  }
  bounded.cells = CGAL::Voronoi_cells_in_domain_2(domain, rule);
  return bounded;
}

inline void check_number(std::size_t given, const char* what, std::size_t expected,
                         const char* of_what)
{
  if (given != expected) {
    throw std::invalid_argument("there are " + std::to_string(given) + ' ' + what + " and " +
                                std::to_string(expected) + ' ' + of_what +
                                ": there must be as many");
  }
}

// What rows have, by ids. Ids without a row have 0.
inline Doubles by_ids(const Rows& numbers, const Bounded_cells& bounded)
{
  Doubles result(bounded.rows.size());
  for (std::size_t row = 0; row < bounded.ids.size(); ++row) {
    result[bounded.ids[row]] = numbers.at<double>(row, 0);
  }
  return result;
}

// `bounded` has the domain, if there is one; without `knows_all_domains` it is convex.
template <bool knows_all_domains, class Dynamic>
Bounded_cells compute_bounded_cells(const Dynamic& dt, const Row_numbers& rows,
                                    Bounded_cells bounded, const Radii& radii)
{
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    bounded.rows.push_back(rows[id]);
    if (dt.has_id(id) || !rows.are_dense()) {
      bounded.ids.push_back(id);
    }
  }
  const auto compute = [&](const auto& its_radii) {
    if constexpr (knows_all_domains) {
      run::compute_cells(bounded.cells, dt, its_radii);
    } else {
      std::get<CGAL::Bounded_voronoi_cells_2>(bounded.cells).compute(dt, its_radii);
    }
  };
  if (const double* const radius = std::get_if<double>(&radii)) {
    compute(*radius);
  } else {
    const Rows& numbers = std::get<Rows>(radii);
    check_number(numbers.size, "radii", bounded.ids.size(), "rows");
    compute(by_ids(numbers, bounded));
  }
  std::visit([](const auto& cells) { check_length(cells.pieces().size()); }, bounded.cells);
  bounded.points = point_array(dt, rows);
  return bounded;
}

// They are such that have gradients.
template <class Dynamic>
CGAL::Bounded_voronoi_gradients_2
compute_bounded_gradients(const Dynamic& dt, const Bounded_cells& bounded, const Rows& area_weights,
                          const Rows& length_weights)
{
  check_number(area_weights.size, "weights of areas", bounded.ids.size(), "rows");
  const auto& cells = std::get<CGAL::Bounded_voronoi_cells_2>(bounded.cells);
  check_number(length_weights.size, "weights of lengths", cells.pieces().size(), "pieces");
  Doubles by_pieces;
  for (std::size_t i = 0; i < length_weights.size; ++i) {
    by_pieces.push_back(length_weights.at<double>(i, 0));
  }
  CGAL::Bounded_voronoi_gradients_2 gradients;
  gradients.compute(dt, cells, by_ids(area_weights, bounded), by_pieces);
  return gradients;
}

inline Array by_rows(const Bounded_cells& bounded, const Doubles& numbers)
{
  Doubles rows;
  rows.reserve(bounded.ids.size());
  for (const std::size_t id : bounded.ids) {
    rows.push_back(numbers[id]);
  }
  return {std::move(rows)};
}

inline Array by_rows(const Bounded_cells& bounded,
                     const std::vector<CGAL::Bounded_voronoi_cells_2::Position>& vectors)
{
  Doubles rows;
  rows.reserve(2 * bounded.ids.size());
  for (const std::size_t id : bounded.ids) {
    rows.insert(rows.end(), {vectors[id].x, vectors[id].y});
  }
  return {std::move(rows), {2}};
}

// By rows: radii, areas, perimeters, centroids, lengths of what is free, and on walls.
inline std::vector<Array> bounded_measure_arrays(const Bounded_cells& bounded)
{
  const auto arrays = [&](const auto& cells) -> std::vector<Array> {
    return {by_rows(bounded, cells.radii()),        by_rows(bounded, cells.areas()),
            by_rows(bounded, cells.perimeters()),   by_rows(bounded, cells.centroids()),
            by_rows(bounded, cells.free_lengths()), by_rows(bounded, cells.wall_lengths())};
  };
  return std::visit(arrays, bounded.cells);
}

// Of a domain that was given clockwise, walls are numbered as they were given.
inline std::size_t wall_as_given(const Bounded_cells& bounded, std::size_t wall)
{
  if (!bounded.are_walls_reversed) {
    return wall;
  }
  const std::size_t walls = std::get<CGAL::Bounded_voronoi_cells_2>(bounded.cells).domain().size();
  return (2 * walls - 2 - wall) % walls;
}

// Where those of each row begin; sides, others, shifts, both ends, lengths and angles.
inline std::vector<Array> bounded_piece_arrays(const Bounded_cells& bounded)
{
  using Cells = CGAL::Bounded_voronoi_cells_2;
  Integers begins, sides, others, shifts;
  Doubles starts, ends, lengths, angles;
  const auto read = [&](const auto& cells) {
    for (const std::size_t id : bounded.ids) {
      begins.push_back(std::int32_t(run::first_piece(cells, id)));
    }
    begins.push_back(std::int32_t(cells.pieces().size()));
    for (const Cells::Piece& piece : cells.pieces()) {
      const bool is_wall = piece.side == Cells::Side::WALL;
      sides.push_back(std::int32_t(piece.side));
      others.push_back(is_wall ? std::int32_t(wall_as_given(bounded, piece.other))
                               : bounded.rows[piece.other]);
      append(shifts, piece.shift);
      starts.insert(starts.end(), {piece.from.x, piece.from.y});
      ends.insert(ends.end(), {piece.to.x, piece.to.y});
      lengths.push_back(piece.length);
      angles.push_back(piece.angle);
    }
  };
  std::visit(read, bounded.cells);
  return {{std::move(begins)},      {std::move(sides)},       {std::move(others)},
          {std::move(shifts), {2}}, {std::move(starts), {2}}, {std::move(ends), {2}},
          {std::move(lengths)},     {std::move(angles)}};
}

} // namespace bindings

#endif // BINDINGS_BOUNDED_CELLS_H
