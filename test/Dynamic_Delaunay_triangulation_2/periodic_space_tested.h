// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PERIODIC_SPACE_TESTED_H
#define PERIODIC_SPACE_TESTED_H

#include "periodic_space_oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_update_visitor_base_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

// What tests of tori, slabs and wires in space have in common.
namespace periodic_space_tested {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Dynamic = CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel>;
using Point = Dynamic::Point;
using Points = std::vector<Point>;
using Cell = CGAL::Periodic_cell_3;
using Coordinates = Cell::Coordinates;
using periodic_space_oracle::cells_of;
using periodic_space_oracle::Shift;
using periodic_space_oracle::Site;

inline std::map<std::size_t, Point> by_id(const Points& points)
{
  std::map<std::size_t, Point> result;
  for (std::size_t id = 0; id < points.size(); ++id)
    result.emplace(id, points[id]);
  return result;
}

inline void expect_exact(const Dynamic& dt, const Points& points, const Cell& cell)
{
  periodic_space_oracle::expect_exact(dt, by_id(points), cell);
}

// Follows the facets that come and go.
struct Facets_visitor : CGAL::Delaunay_update_visitor_base_3
{
  using Facet = std::vector<int>; // ids and shifts

  static Facet facet(const std::array<std::size_t, 3>& ids, const std::array<Shift, 3>& shifts)
  {
    Facet numbers;
    for (std::size_t i = 0; i < 3; ++i) {
      numbers.push_back(int(ids[i]));
      numbers.insert(numbers.end(), shifts[i].begin(), shifts[i].end());
    }
    return numbers;
  }
  template <class Dynamic>
  void after_facet_removal(const Dynamic&, const std::array<std::size_t, 3>& ids,
                           const std::array<Shift, 3>& shifts)
  {
    EXPECT_EQ(facets.erase(facet(ids, shifts)), 1u);
  }
  template <class Dynamic>
  void after_facet_creation(const Dynamic&, const std::array<std::size_t, 3>& ids,
                            const std::array<Shift, 3>& shifts)
  {
    EXPECT_TRUE(facets.insert(facet(ids, shifts)).second);
  }

  std::set<Facet> facets;
};

} // namespace periodic_space_tested

#endif // PERIODIC_SPACE_TESTED_H
