// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VORONOI_TISSUE_DISPLACEMENTS_H
#define VORONOI_TISSUE_DISPLACEMENTS_H

#include "Voronoi_tissue.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tissue {

// How far the cells have gone since an object of this class was made. The drift of all of them
// together is left out: it is that of their mean crawling, and no sign of a fluid.
class Displacements
{
  using Point = Voronoi_tissue::Point;
  using Vector = Voronoi_tissue::Kernel::Vector_2;

public:
  explicit Displacements(const Voronoi_tissue& tissue)
    : m_start(tissue.positions())
    , m_neighbors(m_start.size())
  {
    for (std::size_t i = 0; i < m_start.size(); ++i)
      tissue.triangulation().for_each_neighbor(
          i, [&](std::size_t j, const auto&) { m_neighbors[i].push_back(j); });
  }

  double mean_square(const std::vector<Point>& positions) const
  {
    const Vector drift = mean(positions);
    double sum = 0;
    for (std::size_t i = 0; i < m_start.size(); ++i)
      sum += (displacement(positions, i) - drift).squared_length();
    return sum / double(m_start.size());
  }

  // The mean squared displacement relative to that of the cells that were neighbors at the start.
  double cage_relative_mean_square(const std::vector<Point>& positions) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < m_start.size(); ++i) {
      Vector of_cage(0, 0);
      for (const std::size_t j : m_neighbors[i])
        of_cage += displacement(positions, j) / double(m_neighbors[i].size());
      sum += (displacement(positions, i) - of_cage).squared_length();
    }
    return sum / double(m_start.size());
  }

  // The share of cells that are still within half a cell of where they were.
  double self_overlap(const std::vector<Point>& positions) const
  {
    const Vector drift = mean(positions);
    std::size_t staying = 0;
    for (std::size_t i = 0; i < m_start.size(); ++i)
      staying += (displacement(positions, i) - drift).squared_length() < 0.25;
    return double(staying) / double(m_start.size());
  }

private:
  Vector displacement(const std::vector<Point>& positions, std::size_t i) const
  {
    return positions[i] - m_start[i];
  }

  Vector mean(const std::vector<Point>& positions) const
  {
    Vector sum(0, 0);
    for (std::size_t i = 0; i < m_start.size(); ++i)
      sum += displacement(positions, i);
    return sum / double(m_start.size());
  }

  std::vector<Point> m_start;
  std::vector<std::vector<std::size_t>> m_neighbors;
};

} // namespace tissue

#endif // VORONOI_TISSUE_DISPLACEMENTS_H
