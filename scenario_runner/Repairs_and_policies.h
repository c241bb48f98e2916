// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_REPAIRS_AND_POLICIES_H
#define SCENARIO_RUNNER_REPAIRS_AND_POLICIES_H

#include "scenario_runner/Method_choice.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_dynamic_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_static_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Hybrid_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Key_frame_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Border_splice_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Hold_and_flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Rebuild_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Relocation_repair_2.h>

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace run {

// One of the repairs, chosen while the program runs.
class Any_repair
{
public:
  Any_repair() = default;

  template <class Repair>
  explicit Any_repair(Repair repair)
    : m_repair(std::move(repair))
  {
  }

  template <class Mender>
  void operator()(Mender& mender) const
  {
    std::visit([&](const auto& repair) { repair(mender); }, m_repair);
  }

private:
  std::variant<CGAL::Hold_and_flip_repair_2, CGAL::Border_splice_repair_2, CGAL::Flip_repair_2,
               CGAL::Relocation_repair_2, CGAL::Rebuild_repair_2>
      m_repair;
};

Any_repair make_repair(const std::string& name, unsigned padding);

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

Any_policy make_policy(const Policy_choice& choice);

// What triangulates anew, the default first.
const std::vector<std::pair<std::string, CGAL::Static_engine_2>>& engines();

// Triangulates both the whole and regions.
CGAL::Static_engines_2 engines_named(const std::string& name);

} // namespace run

#endif // SCENARIO_RUNNER_REPAIRS_AND_POLICIES_H
