// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GROWING_TISSUE_CELL_NEIGHBORS_H
#define GROWING_TISSUE_CELL_NEIGHBORS_H

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

// Which cells are next to each other. Nothing of CGAL is included here, so a program that includes
// this compiles as fast as any other; the one file that pays for CGAL is Cell_neighbors.cpp.
class Cell_neighbors
{
public:
  using Pair = std::array<std::size_t, 2>;

  Cell_neighbors();
  ~Cell_neighbors();

  // Adds a cell, and returns its id: the smallest that is free.
  std::size_t insert(double x, double y);
  void remove(std::size_t id);

  // Moves cell i to (x[i], y[i]). The places of free ids are ignored.
  void update(const std::vector<double>& x, const std::vector<double>& y);

  // All pairs of neighbors, by their ids.
  const std::vector<Pair>& pairs();

  bool is_certified() const;

private:
  struct Triangulation;
  std::unique_ptr<Triangulation> m_triangulation;
  std::vector<Pair> m_pairs;
};

#endif // GROWING_TISSUE_CELL_NEIGHBORS_H
