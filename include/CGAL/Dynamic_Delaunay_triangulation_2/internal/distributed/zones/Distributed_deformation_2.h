// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_DEFORMATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_DEFORMATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_question_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Two vectors that are deformed with a periodic space. In the plane they are always the same.
using Basis_2 = std::array<Position_2, 2>;
constexpr Basis_2 unit_basis{{{1, 0}, {0, 1}}};

// The linear map, in rounded arithmetic, that takes a basis as it is now to what it was then.
//
// x' = a x + b y is two products and a sum, and off by at most 2^-52 (|a x| + |b y|), second order
// left aside; compilers may fuse them in one place and not in another. Where nothing is stretched
// by more than 2, x' and y' are off by less than 2^-50 (|x| + |y|). So the images of all places of
// a box, wherever in the program they are computed, are less than 2^-48 of the largest |x| + |y|
// outside of the box around those of its corners. Without deformation the map changes no number.
class Distributed_deformation_2
{
public:
  Distributed_deformation_2() = default;
  Distributed_deformation_2(const Basis_2& now, const Basis_2& then)
  {
    if (are_equal(now[0], then[0]) && are_equal(now[1], then[1]))
      return;
    const double d = determinant(now);
    const auto row = [&](double to_first, double to_second) {
      return Position_2{(to_first * now[1].y - to_second * now[0].y) / d,
                        (to_second * now[0].x - to_first * now[1].x) / d};
    };
    m_x = row(then[0].x, then[1].x);
    m_y = row(then[0].y, then[1].y);
  }

  friend bool operator==(const Distributed_deformation_2& d, const Distributed_deformation_2& e)
  {
    return are_equal(d.m_x, e.m_x) && are_equal(d.m_y, e.m_y);
  }

  Position_2 operator()(double x, double y) const
  {
    return {m_x.x * x + m_x.y * y, m_y.x * x + m_y.y * y};
  }

  // A box around the computed images of all places of `box`, which is finite and not empty.
  Box_2 operator()(const Box_2& box) const
  {
    if (is_none())
      return box;
    Box_2 around;
    for (const double x : {box.x_low, box.x_high})
      for (const double y : {box.y_low, box.y_high}) {
        around.add((*this)(x, y));
      }
    return around.enlarged(0x1p-48 * (box.largest_x() + box.largest_y()));
  }

  Distributed_deformation_2 inverse() const
  {
    Distributed_deformation_2 back;
    const double d = m_x.x * m_y.y - m_x.y * m_y.x;
    back.m_x = {m_y.y / d, -m_x.y / d};
    back.m_y = {-m_y.x / d, m_x.x / d};
    return back;
  }

  bool is_none() const { return *this == Distributed_deformation_2(); }

  // The largest factor by which the map stretches the larger coordinate of a vector, up to
  // rounding.
  double largest_growth() const
  {
    return (std::max)(std::abs(m_x.x) + std::abs(m_x.y), std::abs(m_y.x) + std::abs(m_y.y));
  }

  // s^2 + t^2, where s and t are the largest and the least factor by which vectors are stretched.
  double sum_of_squares() const
  {
    return m_x.x * m_x.x + m_x.y * m_x.y + m_y.x * m_y.x + m_y.y * m_y.y;
  }

  // (s / t)^2. With S = s^2 + t^2 and D = s t, s^2 is the larger root of z^2 - S z + D^2.
  double squared_distortion() const
  {
    const double sum = sum_of_squares(), product = std::abs(m_x.x * m_y.y - m_x.y * m_y.x);
    const double root = std::sqrt((std::max)(sum * sum - 4 * product * product, 0.0));
    const double largest = (sum + root) / (2 * product);
    return largest * largest;
  }

private:
  static bool are_equal(const Position_2& p, const Position_2& q)
  {
    return p.x == q.x && p.y == q.y;
  }
  static double determinant(const Basis_2& b) { return b[0].x * b[1].y - b[0].y * b[1].x; }

  Position_2 m_x{1, 0}, m_y{0, 1}; // the factors of x and y in x', and in y'
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_DEFORMATION_2_H
