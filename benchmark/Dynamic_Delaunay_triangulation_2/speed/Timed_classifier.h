// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_TIMED_CLASSIFIER_H
#define SPEED_TIMED_CLASSIFIER_H

#include "Phase_marks.h"

#include <CGAL/Circumcircle_classifier_2.h>

namespace speed {

// The default classifier, timed. It derives, so that whatever else the triangulation looks for in a
// classifier is found here if and only if it is there.
class Timed_classifier : public CGAL::Circumcircle_classifier_2
{
public:
  explicit Timed_classifier(Phase_marks& marks)
    : m_marks(&marks)
  {
  }

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    m_marks->classify([&] { CGAL::Circumcircle_classifier_2::operator()(frame, classified); });
  }

private:
  Phase_marks* m_marks;
};

} // namespace speed

#endif // SPEED_TIMED_CLASSIFIER_H
