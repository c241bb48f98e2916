// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_ALWAYS_DYNAMIC_POLICY_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_ALWAYS_DYNAMIC_POLICY_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Policies

The default: every frame is classified and repaired. A repair may still rebuild.

Cost: none.

\cgalModels{DelaunayUpdatePolicy_2}
*/
class Always_dynamic_policy_2
{
public:
  /// returns false.
  template <class Frame>
  bool wants_rebuild(const Frame&) const
  {
    return false;
  }

  /// does nothing.
  template <class Frame, class Report>
  void after_update(const Frame&, const Report&) const
  {
  }
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_ALWAYS_DYNAMIC_POLICY_2_H
