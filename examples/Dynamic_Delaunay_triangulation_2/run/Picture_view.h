// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_PICTURE_VIEW_H
#define RUN_PICTURE_VIEW_H

#include "../scenario/Motion.h"
#include "../scenario/Scenario_description.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace run {

// Which part of the plane a picture shows, and where in it a point is: y goes up, as in the plane.
class Picture_view
{
public:
  Picture_view(const scenario::Point& low, const scenario::Point& high)
    : m_low(low)
    , m_high(high)
  {
    const double side = std::max(high.x - low.x, high.y - low.y);
    m_scale = side > 0.0 ? longer_side / side : 1.0;
  }

  explicit Picture_view(const scenario::Box& box)
    : Picture_view({0.0, 0.0}, {box.width, box.height})
  {
  }

  // All points; the origin if there are none.
  explicit Picture_view(const std::vector<scenario::Point>& points)
    : Picture_view(corner(points, [](double a, double b) { return std::min(a, b); }),
                   corner(points, [](double a, double b) { return std::max(a, b); }))
  {
  }

  double x(const scenario::Point& p) const { return margin + m_scale * (p.x - m_low.x); }
  double y(const scenario::Point& p) const { return margin + m_scale * (m_high.y - p.y); }
  double width() const { return 2.0 * margin + m_scale * (m_high.x - m_low.x); }
  double height() const { return 2.0 * margin + m_scale * (m_high.y - m_low.y); }

private:
  static constexpr double longer_side = 960.0;
  static constexpr double margin = 20.0;

  template <class Choose>
  static scenario::Point corner(const std::vector<scenario::Point>& points, Choose choose)
  {
    scenario::Point corner = points.empty() ? scenario::Point{0.0, 0.0} : points.front();
    for (const scenario::Point& point : points) {
      corner = {choose(corner.x, point.x), choose(corner.y, point.y)};
    }
    return corner;
  }

  scenario::Point m_low;
  scenario::Point m_high;
  double m_scale;
};

} // namespace run

#endif // RUN_PICTURE_VIEW_H
