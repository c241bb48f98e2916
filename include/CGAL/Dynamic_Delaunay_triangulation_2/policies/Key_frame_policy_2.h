// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_KEY_FRAME_POLICY_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_KEY_FRAME_POLICY_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Policies

Rebuilds every `k`-th frame after construction, the *key frames* (thesis 7.2.6). The frames in
between are classified and repaired. So an edge that a heuristic classifier has missed stays wrong
for less than `k` frames, and the triangulation is certified at every key frame. With an exact
classifier this policy has no advantage.

Cost: none of its own.

\cgalModels{DelaunayUpdatePolicy_2}
*/
class Key_frame_policy_2
{
public:
  /// \param k the distance between key frames, from 1 to 1000000.
  /// \throws Parameter_error_2 if `k` is out of this range.
  explicit Key_frame_policy_2(unsigned k = 10)
    : m_k(k)
  {
    constexpr unsigned largest_k = 1000000;
    if (k < 1 || k > largest_k)
      throw Parameter_error_2("the parameter k of key_frames", k, 1, largest_k);
  }

  /// the parameter.
  unsigned k() const { return m_k; }

  /// whether this is a key frame.
  template <class Frame>
  bool wants_rebuild(const Frame&) const
  {
    return m_frames_since + 1 == m_k;
  }

  /// counts frames, also those that were rebuilt without asking.
  template <class Frame, class Report>
  void after_update(const Frame&, const Report&)
  {
    m_frames_since = (m_frames_since + 1) % m_k;
  }

private:
  unsigned m_k;
  unsigned m_frames_since = 0; // the last key frame
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_KEY_FRAME_POLICY_2_H
