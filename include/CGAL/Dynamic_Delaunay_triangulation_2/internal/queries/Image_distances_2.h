// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_IMAGE_DISTANCES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_IMAGE_DISTANCES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>
#include <CGAL/Periodic_cell_2.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Compares the distances of images from one place exactly: in doubles, and without rounding where
// that is undecided.
//
// With u = 2^-53, the vector v to an image is computed with errors of at most E = 4u m in each
// coordinate, where m is the largest sum of absolute values in it, as in Torus_2. So |v|^2 is off
// by at most 2 (|x| + |y|) E + 2 E^2, and computed with a further relative error of 2u. `error`
// includes 8u times the value: the remaining 6u cover the sum or difference that makes an end of
// the interval, and the factor 2.1 instead of 2 covers the rounding of `error` itself. Underflow
// takes less than 1e-300. If something overflows, nothing is decided.
class Image_distances_2
{
public:
  Image_distances_2(const Torus_2& torus, const Position_2& from)
    : m_torus(torus)
    , m_from(from)
  {
  }

  // Computed in plain floating point.
  double approximate_square(const Image_2& p) const { return Square(*this, p).value; }

  Comparison_result compare(const Image_2& p, const Image_2& q) const
  {
    const Comparison_result result = filtered(Square(*this, p), Square(*this, q));
    return result != EQUAL ? result : CGAL::compare(exact_square(p), exact_square(q));
  }

  Comparison_result compare_square(const Image_2& p, double square) const
  {
    const Comparison_result result = filtered(Square(*this, p), Square(square));
    return result != EQUAL ? result : CGAL::compare(exact_square(p), Torus_2::Exact(square));
  }

private:
  struct Square
  {
    explicit Square(double exact)
      : value(exact)
    {
    }
    Square(const Image_distances_2& distances, const Image_2& p)
    {
      double m = 0;
      const auto [x, y] = distances.m_torus.vector({distances.m_from, no_shift}, p, m);
      const double e = Torus_2::error_factor * m;
      value = x * x + y * y;
      error = 2.1 * e * (std::abs(x) + std::abs(y) + e) + 0x1p-50 * value + 1e-300;
    }
    double value, error = 0;
  };

  // EQUAL if undecided.
  static Comparison_result filtered(const Square& s, const Square& t)
  {
    return s.value + s.error < t.value - t.error   ? SMALLER
           : t.value + t.error < s.value - s.error ? LARGER
                                                   : EQUAL;
  }

  BOOST_NOINLINE Torus_2::Exact exact_square(const Image_2& p) const
  {
    const Torus_2::Exact_vector v(m_torus, {m_from, no_shift}, p);
    return v.x * v.x + v.y * v.y;
  }

  const Torus_2& m_torus;
  const Position_2 m_from;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_IMAGE_DISTANCES_2_H
