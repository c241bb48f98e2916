// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Cell_neighbors.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/range/irange.hpp>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Cell_neighbors::Triangulation
{
  CGAL::Dynamic_Delaunay_triangulation_2<Kernel> cells;
};

Cell_neighbors::Cell_neighbors()
  : m_triangulation(std::make_unique<Triangulation>())
{
}

Cell_neighbors::~Cell_neighbors() = default;

std::size_t Cell_neighbors::insert(double x, double y)
{
  return m_triangulation->cells.insert(Kernel::Point_2(x, y));
}

void Cell_neighbors::remove(std::size_t id)
{
  m_triangulation->cells.remove(id);
}

void Cell_neighbors::update(const std::vector<double>& x, const std::vector<double>& y)
{
  const auto position = boost::make_function_property_map<std::size_t>(
      [&](std::size_t i) { return Kernel::Point_2(x[i], y[i]); });
  m_triangulation->cells.update(boost::irange<std::size_t>(0, x.size()), position);
}

const std::vector<Cell_neighbors::Pair>& Cell_neighbors::pairs()
{
  m_pairs.clear();
  m_triangulation->cells.for_each_edge([this](std::size_t i, std::size_t j) {
    m_pairs.push_back({i, j});
  });
  return m_pairs;
}

bool Cell_neighbors::is_certified() const
{
  return m_triangulation->cells.is_certified();
}
