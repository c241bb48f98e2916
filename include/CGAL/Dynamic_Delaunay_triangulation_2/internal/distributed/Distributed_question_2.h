// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_QUESTION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_QUESTION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A closed box. By default it is empty.
struct Box_2
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  double x_low = infinity, y_low = infinity, x_high = -infinity, y_high = -infinity;

  static Box_2 of_everything() { return {-infinity, -infinity, infinity, infinity}; }

  friend bool operator==(const Box_2& b, const Box_2& c)
  {
    return b.x_low == c.x_low && b.y_low == c.y_low && b.x_high == c.x_high && b.y_high == c.y_high;
  }
  bool is_empty() const { return !(x_low <= x_high && y_low <= y_high); }
  double width() const { return x_high - x_low; }
  double height() const { return y_high - y_low; }
  double longer_side() const { return (std::max)(width(), height()); }
  // The largest absolute values of coordinates.
  double largest_x() const { return (std::max)(std::abs(x_low), std::abs(x_high)); }
  double largest_y() const { return (std::max)(std::abs(y_low), std::abs(y_high)); }

  void add(const Position_2& p)
  {
    x_low = (std::min)(x_low, p.x), y_low = (std::min)(y_low, p.y);
    x_high = (std::max)(x_high, p.x), y_high = (std::max)(y_high, p.y);
  }
  bool meets(const Box_2& b) const
  {
    return x_low <= b.x_high && b.x_low <= x_high && y_low <= b.y_high && b.y_low <= y_high;
  }
  bool contains(double x, double y) const
  {
    return x_low <= x && x <= x_high && y_low <= y && y <= y_high;
  }
  Box_2 common_part(const Box_2& b) const
  {
    return {(std::max)(x_low, b.x_low), (std::max)(y_low, b.y_low), (std::min)(x_high, b.x_high),
            (std::min)(y_high, b.y_high)};
  }
  Box_2 enlarged(double by) const { return {x_low - by, y_low - by, x_high + by, y_high + by}; }
  Box_2 moved(const Position_2& v) const
  {
    return {x_low + v.x, y_low + v.y, x_high + v.x, y_high + v.y};
  }
  double squared_distance(double x, double y) const
  {
    const double dx = (std::max)({x_low - x, x - x_high, 0.0});
    const double dy = (std::max)({y_low - y, y - y_high, 0.0});
    return dx * dx + dy * dy;
  }
};

// A question: which points are in a region, the closed disk of a face, the open half-plane beyond
// an edge of the hull, or anywhere? `x`, `y` is an owned corner: answers begin with points near it.
struct Distributed_question_2
{
  enum Kind : std::int64_t { CIRCLE, HALF_PLANE, EVERYTHING };

  Kind kind;
  std::array<double, 6> corners;
  double x, y;

  friend bool operator<(const Distributed_question_2& q, const Distributed_question_2& r)
  {
    return std::make_pair(q.kind, q.corners) < std::make_pair(r.kind, r.corners);
  }

  Position_2 corner(std::size_t i) const { return {corners[2 * i], corners[2 * i + 1]}; }

  // The question moved by -v. \pre This moves the corners exactly.
  Distributed_question_2 moved_back(const Position_2& v) const
  {
    const auto& [ax, ay, bx, by, cx, cy] = corners;
    return {kind, {ax - v.x, ay - v.y, bx - v.x, by - v.y, cx - v.x, cy - v.y}, x - v.x, y - v.y};
  }

  template <class Kernel>
  bool contains(double px, double py) const
  {
    using Point = typename Kernel::Point_2;
    const auto point = [&](std::size_t i) { return Point(corners[2 * i], corners[2 * i + 1]); };
    const Kernel kernel;
    switch (kind) {
    case CIRCLE:
      return kernel.side_of_oriented_circle_2_object()(point(0), point(1), point(2),
                                                       Point(px, py)) != ON_NEGATIVE_SIDE;
    case HALF_PLANE:
      return kernel.orientation_2_object()(point(0), point(1), Point(px, py)) == LEFT_TURN;
    default:
      return true;
    }
  }

  // False only if the region contains no place in the box.
  template <class Kernel>
  bool may_meet(const Box_2& box) const
  {
    if (box.is_empty())
      return false;
    switch (kind) {
    case CIRCLE:
      return disk_may_meet(box);
    case HALF_PLANE:
      return contains<Kernel>(box.x_low, box.y_low) || contains<Kernel>(box.x_low, box.y_high) ||
             contains<Kernel>(box.x_high, box.y_low) || contains<Kernel>(box.x_high, box.y_high);
    default:
      return true;
    }
  }

  // A box around the region.
  Box_2 box() const { return kind == CIRCLE ? box_of_disk() : Box_2::of_everything(); }

  // A box around the disk. With e = 2^-53 the sides u and v from one corner are off by e times
  // themselves, so that D = u x v is off by less than 8 e |u||v|. Where |u|^2 + |v|^2 is at most
  // 2^12 D, the error is 2^-38 D. The radius is |u||v||u - v| / 2D; the numerators of the
  // circumcenter are off by less than 16 e |u||v| (|u| + |v|), and |u| + |v| is at most four radii:
  // so the circumcenter is off by less than 2^-34 radii. 2^-30 radii cover that, the rounding of
  // the radius, and second order; 2^-50 of the coordinates cover the last sums. Within the limits
  // of |u|^2 + |v|^2 nothing overflows, and what underflows is smaller than these by far.
  Box_2 box_of_disk() const
  {
    const Position_2 p = corner(0), u = corner(1) - p, v = corner(2) - p;
    const double squares = dot(u, u) + dot(v, v), doubled_area = cross(u, v);
    if (!(squares > 0x1p-200 && squares < 0x1p200 && squares <= 0x1p12 * doubled_area))
      return Box_2::of_everything();
    const Position_2 c = circumcenter(u, v);
    const double radius = std::sqrt(dot(c, c)) * (1 + 0x1p-30);
    const double cx = p.x + c.x, cy = p.y + c.y;
    const double pad_x = radius + 0x1p-50 * (std::abs(p.x) + radius);
    const double pad_y = radius + 0x1p-50 * (std::abs(p.y) + radius);
    return {cx - pad_x, cy - pad_y, cx + pad_x, cy + pad_y};
  }

  // A quick test: true only if the disk's diameter is at most `diameter`. The disk's diameter is
  // |u||v||u - v| / D; where |u|^2 + |v|^2 is at most 2^12 D, all parts are accurate to 2^-38, and
  // 2^-20 covers their product.
  bool is_narrow(double diameter) const
  {
    const Position_2 p = corner(0), u = corner(1) - p, v = corner(2) - p;
    const double uu = dot(u, u), vv = dot(v, v), doubled_area = cross(u, v);
    const double most = doubled_area * diameter * (1 - 0x1p-20);
    return uu + vv > 0x1p-200 && uu + vv < 0x1p200 && uu + vv <= 0x1p12 * doubled_area &&
           uu * vv * squared_distance(u, v) <= most * most;
  }

private:
  // With w the vector from the first corner, u and v those to the others, A = u x v > 0, and
  // N = (|u|^2 v_y - |v|^2 u_y, |v|^2 u_x - |u|^2 v_x), the closed disk is where
  // g(w) = A |w|^2 - N w <= 0: g vanishes at 0, u and v. It is a sum of a function of w_x and one
  // of w_y, so its lowest value in a box is the sum of their lowest values.
  //
  // Errors, with e = 2^-53 and the lengths |.| replaced by sums of absolute values, which are not
  // smaller: A is off by less than 5 e |u||v|, each part of N by less than 9 e |u||v|(|u| + |v|).
  // With W the largest |w| in the box, g is off by less than 9 e |u||v| W (W + |u| + |v|) for its
  // coefficients, 3 e of that scale for the ends of the box, and 8 e for its evaluation; the place
  // of the lowest value is off by 4 e of itself, which changes that value in second order. The pad
  // is 2^-46 = 128 e of this scale. Where a part might over- or underflow nothing is proved.
  bool disk_may_meet(const Box_2& box) const
  {
    const Position_2 p = corner(0), u = corner(1) - p, v = corner(2) - p;
    const Box_2 w{box.x_low - p.x, box.y_low - p.y, box.x_high - p.x, box.y_high - p.y};
    const double length_u = std::abs(u.x) + std::abs(u.y);
    const double length_v = std::abs(v.x) + std::abs(v.y);
    const double reach = w.largest_x() + w.largest_y();
    const double shortest = (std::min)(length_u, length_v);
    const double longest = (std::max)({length_u, length_v, reach});
    if (!(shortest > 0x1p-200 && longest < 0x1p200))
      return true;
    const double uu = dot(u, u), vv = dot(v, v), area = cross(u, v);
    const double lowest = lowest_value(area, uu * v.y - vv * u.y, w.x_low, w.x_high) +
                          lowest_value(area, vv * u.x - uu * v.x, w.y_low, w.y_high);
    return !(lowest > 0x1p-46 * (length_u * length_v) * reach * (reach + length_u + length_v));
  }

  // The lowest value of a t^2 - n t for t from `low` to `high`.
  static double lowest_value(double a, double n, double low, double high)
  {
    const auto value = [&](double t) { return (a * t - n) * t; };
    double lowest = (std::min)(value(low), value(high));
    if (a > 0)
      lowest = (std::min)(lowest, value((std::min)((std::max)(n / (2 * a), low), high)));
    return lowest;
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_QUESTION_2_H
