// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The package as it is compiled by compilers without vectors.

#define CGAL_DYNAMIC_DELAUNAY_NO_SIMD
#include "oracle.h"

#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_LANES
#error "CGAL_DYNAMIC_DELAUNAY_NO_SIMD is to leave the vectors out"
#endif

namespace {

TEST(Plain_pass, keeps_clouds_exact_without_vectors)
{
  for (const double step : {1e-3, 0.05, 1.}) {
    SCOPED_TRACE(testing::Message() << "step " << step);
    Cloud<Epick> cloud(1);
    auto points = cloud.uniform(400);
    CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
    for (int frame = 0; frame < 15; ++frame) {
      cloud.shake(points, step);
      dt.update(points.begin(), points.end());
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    }
  }
}

} // namespace
