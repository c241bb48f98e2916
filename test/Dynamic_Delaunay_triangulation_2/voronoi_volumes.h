// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What volumes of Voronoi cells in space have to be when they are computed alone.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VORONOI_VOLUMES_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VORONOI_VOLUMES_H

#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_volumes_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace voronoi_volumes {

// Those that measures have, to these digits, up to a largest one: cells near a hull that is nearly
// flat may have corners as far away as points are close to a plane.
template <class Triangulation>
void expect_measured(const Triangulation& dt, const CGAL::Voronoi_cell_measures_3& measures,
                     double accuracy, double largest = std::numeric_limits<double>::infinity())
{
  CGAL::Voronoi_cell_volumes_3 volumes;
  volumes.compute(dt);
  ASSERT_EQ(volumes.number_of_ids(), dt.number_of_ids());
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    const double expected = measures.volumes()[id];
    if (std::isinf(expected)) {
      ASSERT_EQ(volumes.volumes()[id], expected) << "id " << id;
    } else if (expected < largest) {
      ASSERT_NEAR(volumes.volumes()[id], expected, accuracy * expected) << "id " << id;
    }
  }
}

} // namespace voronoi_volumes

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VORONOI_VOLUMES_H
