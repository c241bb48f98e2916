// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ALWAYS_STATIC_POLICY_2_H
#define CGAL_ALWAYS_STATIC_POLICY_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Update_report_2.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Policies

Every frame is rebuilt, and so certified, whatever the classifier is: what the dynamic way is held
against.

Cost: none of its own.

\cgalModels{DelaunayUpdatePolicy_2}
*/
class Always_static_policy_2
{
public:
  /// always.
  template <class Frame>
  bool wants_rebuild(const Frame&) const
  {
    return true;
  }

  /// nothing to learn.
  template <class Frame>
  void after_update(const Frame&, const Update_report_2&) const
  {
  }
};

} // namespace CGAL

#endif // CGAL_ALWAYS_STATIC_POLICY_2_H
