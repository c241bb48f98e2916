// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Sections of triangles and tetrahedra by the plane z = 0.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_BENCHMARK_MANUAL_FIGURES_SECTION_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_BENCHMARK_MANUAL_FIGURES_SECTION_H

#include "Panel.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <vector>

namespace manual_figures {

using Place = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

inline Point cut(const Place& p, const Place& q)
{
  const double part = p.z() / (p.z() - q.z());
  return {p.x() + part * (q.x() - p.x()), p.y() + part * (q.y() - p.y())};
}

// Where the plane cuts the edges of a simplex, in the order around its section: from one vertex
// below to all above, from the next one back. Empty if it does not.
template <std::size_t size>
std::vector<Point> section(const std::array<Place, size>& simplex)
{
  std::vector<Place> low, high;
  for (const Place& p : simplex) {
    (p.z() < 0 ? low : high).push_back(p);
  }
  std::vector<Point> corners;
  for (std::size_t i = 0; i < low.size(); ++i) {
    for (std::size_t j = 0; j < high.size(); ++j) {
      const std::size_t turned = i % 2 == 0 ? j : high.size() - 1 - j;
      corners.push_back(cut(low[i], high[turned]));
    }
  }
  return corners;
}

} // namespace manual_figures

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_BENCHMARK_MANUAL_FIGURES_SECTION_H
