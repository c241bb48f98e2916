// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_BOUNDED_CELLS_H
#define BINDINGS_BOUNDED_CELLS_H

#include "bindings/Array_reading.h"
#include "bindings/Subject.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_cells_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_gradients_2.h>

#include <cstddef>
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
  CGAL::Bounded_voronoi_cells_2 cells{};
  std::vector<std::size_t> ids{}; // of all rows
  Integers rows{};                // of all ids
  Array points{};
  std::optional<Cell> cell{};
};

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

// `cells` has the domain, if there is one.
template <class Dynamic>
Bounded_cells compute_bounded_cells(const Dynamic& dt, const Row_numbers& rows,
                                    CGAL::Bounded_voronoi_cells_2 cells, const Radii& radii)
{
  Bounded_cells bounded;
  bounded.cells = std::move(cells);
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    bounded.rows.push_back(rows[id]);
    if (dt.has_id(id) || !rows.are_dense()) {
      bounded.ids.push_back(id);
    }
  }
  if (const double* const radius = std::get_if<double>(&radii)) {
    bounded.cells.compute(dt, *radius);
  } else {
    const Rows& numbers = std::get<Rows>(radii);
    check_number(numbers.size, "radii", bounded.ids.size(), "rows");
    bounded.cells.compute(dt, by_ids(numbers, bounded));
  }
  check_length(bounded.cells.pieces().size());
  bounded.points = point_array(dt, rows);
  return bounded;
}

template <class Dynamic>
CGAL::Bounded_voronoi_gradients_2
compute_bounded_gradients(const Dynamic& dt, const Bounded_cells& bounded, const Rows& area_weights,
                          const Rows& length_weights)
{
  check_number(area_weights.size, "weights of areas", bounded.ids.size(), "rows");
  check_number(length_weights.size, "weights of lengths", bounded.cells.pieces().size(), "pieces");
  Doubles by_pieces;
  for (std::size_t i = 0; i < length_weights.size; ++i) {
    by_pieces.push_back(length_weights.at<double>(i, 0));
  }
  CGAL::Bounded_voronoi_gradients_2 gradients;
  gradients.compute(dt, bounded.cells, by_ids(area_weights, bounded), by_pieces);
  return gradients;
}

} // namespace bindings

#endif // BINDINGS_BOUNDED_CELLS_H
