// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_CHOSEN_REBUILDS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_CHOSEN_REBUILDS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/views/Dynamic_frame_3.h>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Which frames the user's policy wants to be rebuilt. It is called once in a frame, as a function:
// so the kernel does not depend on its type.
template <class State>
class Chosen_rebuilds_3
{
public:
  using Frame = Dynamic_frame_3<State>;

  // None.
  Chosen_rebuilds_3()
    : m_policy(nullptr)
    , m_wants_rebuild([](void*, const Frame&) { return false; })
  {
  }
  template <class Policy>
  explicit Chosen_rebuilds_3(Policy& policy)
    : m_policy(&policy)
    , m_wants_rebuild([](void* p, const Frame& frame) -> bool {
      return static_cast<Policy*>(p)->wants_rebuild(frame);
    })
  {
  }

  bool include(const Frame& frame) const { return m_wants_rebuild(m_policy, frame); }

private:
  void* m_policy;
  bool (*m_wants_rebuild)(void*, const Frame&);
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_CHOSEN_REBUILDS_3_H
