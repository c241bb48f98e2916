// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_ANY_POLICY_H
#define RUN_ANY_POLICY_H

#include "Policy_choice.h"

#include <CGAL/Always_dynamic_policy_2.h>
#include <CGAL/Always_static_policy_2.h>
#include <CGAL/Hybrid_policy_2.h>
#include <CGAL/Key_frame_policy_2.h>

#include <utility>
#include <variant>

namespace run {

// One of the policies, chosen while the program runs.
class Any_policy
{
public:
  Any_policy() = default;

  template <class Policy>
  explicit Any_policy(Policy policy)
    : m_policy(std::move(policy))
  {
  }

  template <class Frame>
  bool wants_rebuild(const Frame& frame)
  {
    return std::visit([&](auto& policy) { return policy.wants_rebuild(frame); }, m_policy);
  }

  template <class Frame>
  void after_update(const Frame& frame, const CGAL::Update_report_2& report)
  {
    std::visit([&](auto& policy) { policy.after_update(frame, report); }, m_policy);
  }

private:
  std::variant<CGAL::Always_dynamic_policy_2, CGAL::Always_static_policy_2, CGAL::Hybrid_policy_2,
               CGAL::Key_frame_policy_2>
      m_policy;
};

inline Any_policy make_policy(const Policy_choice& choice)
{
  if (choice.name == "always_static") {
    return Any_policy(CGAL::Always_static_policy_2());
  }
  if (choice.name == "hybrid") {
    return Any_policy(CGAL::Hybrid_policy_2());
  }
  if (choice.name == "key_frames") {
    return Any_policy(CGAL::Key_frame_policy_2(*choice.parameter));
  }
  return Any_policy(CGAL::Always_dynamic_policy_2());
}

} // namespace run

#endif // RUN_ANY_POLICY_H
