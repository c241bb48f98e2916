// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_TIMED_REPAIR_H
#define SPEED_TIMED_REPAIR_H

#include "Phase_marks.h"

#include <CGAL/Flip_and_splice_repair_2.h>

namespace speed {

// The default repair of exact use, timed.
class Timed_repair : public CGAL::Flip_and_splice_repair_2
{
public:
  explicit Timed_repair(Phase_marks& marks)
    : m_marks(&marks)
  {
  }

  template <class Mender>
  void operator()(Mender& mender) const
  {
    m_marks->repair([&] { CGAL::Flip_and_splice_repair_2::operator()(mender); });
  }

private:
  Phase_marks* m_marks;
};

} // namespace speed

#endif // SPEED_TIMED_REPAIR_H
