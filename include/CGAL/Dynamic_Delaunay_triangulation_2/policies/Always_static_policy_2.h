// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_ALWAYS_STATIC_POLICY_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_ALWAYS_STATIC_POLICY_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Policies

Rebuilds every frame, and so certifies it, whatever the classifier is. Serves as the baseline for
dynamic updates.

Cost: none of its own.

\cgalModels{DelaunayUpdatePolicy_2}
*/
class Always_static_policy_2
{
public:
  /// returns true.
  template <class Frame>
  bool wants_rebuild(const Frame&) const
  {
    return true;
  }

  /// does nothing.
  template <class Frame, class Report>
  void after_update(const Frame&, const Report&) const
  {
  }
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_ALWAYS_STATIC_POLICY_2_H
