// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_REPAIRS_AND_POLICIES_H
#define SCENARIO_RUNNER_REPAIRS_AND_POLICIES_H

#include "scenario_runner/Classifiers.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Scenario_file.h"
#include "scenario_runner/Text_input.h"

#include <CGAL/Always_dynamic_policy_2.h>
#include <CGAL/Always_static_policy_2.h>
#include <CGAL/Border_splice_repair_2.h>
#include <CGAL/Flip_and_splice_repair_2.h>
#include <CGAL/Flip_repair_2.h>
#include <CGAL/Hybrid_policy_2.h>
#include <CGAL/Key_frame_policy_2.h>
#include <CGAL/Rebuild_repair_2.h>
#include <CGAL/Relocation_repair_2.h>
#include <CGAL/Static_engine_2.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
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
  std::variant<CGAL::Flip_and_splice_repair_2, CGAL::Border_splice_repair_2, CGAL::Flip_repair_2,
               CGAL::Relocation_repair_2, CGAL::Rebuild_repair_2>
      m_repair;
};

inline const std::vector<std::string>& repair_names()
{
  static const std::vector<std::string> names = {"flip_and_splice", "splice", "flip", "relocate",
                                                 "rebuild"};
  return names;
}

inline std::string usual_repair(const Classifier_choice& classifier)
{
  const bool needs_flips = classifier.is_exact || classifier.name == "nearly_delaunay";
  return needs_flips ? "flip_and_splice" : "splice";
}

inline void check_repair_name(const std::string& name)
{
  const auto& names = repair_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw std::invalid_argument("there is no repair '" + name + "'; there are " +
                                scenario::joined(names));
  }
}

inline Any_repair make_repair(const std::string& name, unsigned padding)
{
  if (name == "splice") {
    return Any_repair(CGAL::Border_splice_repair_2(padding));
  }
  if (name == "flip") {
    return Any_repair(CGAL::Flip_repair_2());
  }
  if (name == "relocate") {
    return Any_repair(CGAL::Relocation_repair_2());
  }
  if (name == "rebuild") {
    return Any_repair(CGAL::Rebuild_repair_2());
  }
  return Any_repair(CGAL::Flip_and_splice_repair_2(padding));
}

struct Policy_choice
{
  std::string name;
  std::optional<unsigned> parameter{}; // of key_frames

  std::string text() const { return parameter ? name + ':' + std::to_string(*parameter) : name; }
};

inline constexpr unsigned usual_key_frame_distance = 10;
inline constexpr unsigned max_key_frame_distance = 1'000'000;

inline std::string policy_list()
{
  return "always_dynamic, always_static, hybrid, key_frames:K (K from 1 to " +
         std::to_string(max_key_frame_distance) + ", default " +
         std::to_string(usual_key_frame_distance) + ')';
}

inline unsigned key_frame_distance(const std::string& text)
{
  try {
    return static_cast<unsigned>(count_argument(text, 1, max_key_frame_distance));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string("the parameter of key_frames: ") + error.what());
  }
}

// From NAME or NAME:PARAMETER.
inline Policy_choice policy_choice(const std::string& text)
{
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const auto parameter =
      colon == std::string::npos ? std::nullopt : std::optional(text.substr(colon + 1));
  if (name == "key_frames") {
    return {name, parameter ? key_frame_distance(*parameter) : usual_key_frame_distance};
  }
  if (name != "always_dynamic" && name != "always_static" && name != "hybrid") {
    throw std::invalid_argument("there is no policy '" + name + "'; there are " + policy_list());
  }
  if (parameter) {
    throw std::invalid_argument(name + " takes no parameter; there are " + policy_list());
  }
  return {name};
}

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

// What triangulates anew, the default first.
inline const std::vector<std::pair<std::string, CGAL::Static_engine_2>>& engines()
{
  static const std::vector<std::pair<std::string, CGAL::Static_engine_2>> all = {
      {"guibas_stolfi", CGAL::Static_engine_2::GUIBAS_STOLFI},
      {"insertion", CGAL::Static_engine_2::INSERTION},
      {"bowyer_watson", CGAL::Static_engine_2::BOWYER_WATSON}};
  return all;
}

inline std::vector<std::string> engine_names()
{
  std::vector<std::string> names;
  for (const auto& [name, engine] : engines()) {
    names.push_back(name);
  }
  return names;
}

// The same one for the whole and for regions.
inline CGAL::Static_engines_2 engines_named(const std::string& name)
{
  for (const auto& [its_name, engine] : engines()) {
    if (its_name == name) {
      return {engine, engine};
    }
  }
  throw std::invalid_argument("there is no engine '" + name + "'; there are " +
                              scenario::joined(engine_names()));
}

} // namespace run

#endif // SCENARIO_RUNNER_REPAIRS_AND_POLICIES_H
