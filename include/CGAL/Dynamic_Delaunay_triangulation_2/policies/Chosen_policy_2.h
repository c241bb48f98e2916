// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_CHOSEN_POLICY_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_CHOSEN_POLICY_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Policies

One of several update policies, chosen while a program runs. It does what the chosen one does.

\tparam Policies models of `DelaunayUpdatePolicy_2`, all different; the first one is the default

\cgalModels{DelaunayUpdatePolicy_2}

\sa `Chosen_classifier_2`
*/
template <class... Policies>
class Chosen_policy_2
{
public:
  /// whether `Policy` can be chosen.
  template <class Policy>
  static constexpr bool can_be = (std::is_same_v<Policy, Policies> || ...);

  /// chooses the first policy, with its default parameters.
  Chosen_policy_2() = default;

  /// chooses this policy.
  /// \pre `can_be<Policy>`
  template <class Policy, class = std::enable_if_t<can_be<Policy>>>
  Chosen_policy_2(Policy policy)
    : m_policy(std::move(policy))
  {
  }

  /// whether the chosen policy wants a rebuild.
  template <class Frame>
  bool wants_rebuild(const Frame& frame)
  {
    return std::visit([&](auto& chosen) { return chosen.wants_rebuild(frame); }, m_policy);
  }

  /// informs the chosen policy.
  template <class Frame, class Report>
  void after_update(const Frame& frame, const Report& report)
  {
    std::visit([&](auto& chosen) { chosen.after_update(frame, report); }, m_policy);
  }

private:
  std::variant<Policies...> m_policy;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_CHOSEN_POLICY_2_H
