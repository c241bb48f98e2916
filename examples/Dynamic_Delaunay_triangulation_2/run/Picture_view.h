// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_PICTURE_VIEW_H
#define RUN_PICTURE_VIEW_H

#include "../scenario/Motion.h"
#include "Bounds.h"

#include <algorithm>

namespace run {

// Which part of the plane a picture shows, and where in it a point is: y goes up, as in the plane.
class Picture_view
{
public:
  explicit Picture_view(const Bounds& bounds)
    : m_low(bounds.low)
    , m_high(bounds.high)
  {
    const double side = (std::max)(m_high.x - m_low.x, m_high.y - m_low.y);
    m_scale = side > 0.0 ? longer_side / side : 1.0;
  }

  double x(const scenario::Point& p) const { return margin + m_scale * (p.x - m_low.x); }
  double y(const scenario::Point& p) const { return margin + m_scale * (m_high.y - p.y); }
  double width() const { return 2.0 * margin + m_scale * (m_high.x - m_low.x); }
  double height() const { return 2.0 * margin + m_scale * (m_high.y - m_low.y); }

private:
  static constexpr double longer_side = 960.0;
  static constexpr double margin = 20.0;

  scenario::Point m_low;
  scenario::Point m_high;
  double m_scale;
};

} // namespace run

#endif // RUN_PICTURE_VIEW_H
