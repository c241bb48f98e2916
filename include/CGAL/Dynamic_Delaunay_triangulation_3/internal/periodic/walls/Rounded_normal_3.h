// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WALLS_ROUNDED_NORMAL_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WALLS_ROUNDED_NORMAL_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>

#include <cmath>
#include <limits>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The unit vector along v x w, rounded, with a bound of the length by which it is off, if v and w,
// differences of doubles, are off by up to E before these are rounded.
//
// Let u = 2^-53. A component of v x w, as in `Cell_filter_3.h`, has 4 roundings: as a vector its
// error is below 4' sqrt(2) |v| |w| < 5.7 u |v| |w|. E adds at most E (|v| + |w| + E). Let h be the
// sum, and c the result. The unit vectors along c and along the exact product differ by 2 h / |c|
// at most. To divide by the length of c, with 3 + 1 roundings in its square and its root, then one
// each in the inverse and the product, is a relative error below 6 u. The factors below are larger,
// so that their own roundings do not matter.
//
// Where the square of c underflows or overflows, the bound is infinite.
struct Rounded_normal_3
{
  static Rounded_normal_3 of(const Position_3& v, const Position_3& w, double error)
  {
    const Position_3 c{v.y * w.z - v.z * w.y, v.z * w.x - v.x * w.z, v.x * w.y - v.y * w.x};
    const double square = squared_length(c), length = std::sqrt(square);
    if (!(square > 1e-290 && square < std::numeric_limits<double>::infinity()))
      return {};
    const double vv = std::sqrt(squared_length(v)), ww = std::sqrt(squared_length(w));
    const double h = 0x1p-50 * vv * ww + error * (vv + ww + error);
    return {(1 / length) * c, 0x1p-50 + 2.1 * h / length};
  }

  Position_3 direction{0, 0, 0};
  double error = std::numeric_limits<double>::infinity();
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WALLS_ROUNDED_NORMAL_3_H
