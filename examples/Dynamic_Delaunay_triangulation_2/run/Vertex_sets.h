// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_VERTEX_SETS_H
#define RUN_VERTEX_SETS_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace run {

// The sets of thesis 4.1.3, by the numbers that files have for them.
enum class Vertex_set : std::uint8_t { none, border, padded, classified };

// Of each vertex of a run's frame. A rebuild gives vertices other numbers than those under which
// they were classified; then all are in none.
template <class Run>
std::vector<Vertex_set> sets_of_vertices(const Run& run)
{
  const auto& triangulation = run.triangulation();
  std::vector<Vertex_set> sets(triangulation.number_of_vertices() + 1, Vertex_set::none);
  if (run.record().update.rebuilt()) {
    return sets;
  }
  for (const auto v : triangulation.border_vertices()) {
    sets[v] = Vertex_set::border;
  }
  for (const auto v : triangulation.padded_vertices()) {
    sets[v] = Vertex_set::padded;
  }
  for (const auto v : triangulation.classified_vertices()) {
    sets[v] = Vertex_set::classified;
  }
  return sets;
}

// Of each point, in the order of the motion, as numbers.
template <class Run>
std::vector<unsigned> sets_of_points(const Run& run)
{
  const std::vector<Vertex_set> sets_of_its_vertices = sets_of_vertices(run);
  std::vector<unsigned> sets;
  for (std::size_t place = 0; place != run.motion().points().size(); ++place) {
    sets.push_back(static_cast<unsigned>(sets_of_its_vertices[run.vertex(place)]));
  }
  return sets;
}

} // namespace run

#endif // RUN_VERTEX_SETS_H
