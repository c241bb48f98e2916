// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_SETUP_H
#define RANDOM_OPERATIONS_SETUP_H

#include "Decisions.h"
#include "Families.h"
#include "scenario_runner/Method_choice.h"
#include "scenario_runner/Repairs_and_policies.h"
#include "Trial.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace random_operations {

// What names the points of a trial.
enum class Naming { IDS, INT64, UINT64, UINT8 };

// What a trial runs with.
struct Setup : Surroundings
{
  run::Classifier_choice classifier;
  std::string repair;
  unsigned padding = 1;
  run::Policy_choice policy;
  std::string engine;
  bool is_predictive = false; // the point distance classifier
  int divisor = 1;            // of all coordinates; with 3 they are no doubles
  Naming naming = Naming::IDS;
  std::uint64_t seed = 0;

  std::string classifier_name() const
  {
    return is_predictive ? "predictive_point_distance" : classifier.name;
  }

  std::string text() const
  {
    return std::string(constructs_exactly ? "EPECK" : "EPICK") + ", " +
           (is_predictive ? "predictive_" : "") + classifier.text() + ", " + repair +
           " with padding " + std::to_string(padding) + ", " + policy.text() + ", " + engine +
           ", up to " + std::to_string(max_points) + " points";
  }
};

inline std::string with_parameter(const run::Classifier_kind& kind, Decisions& decisions)
{
  static const std::vector<std::string> absurd = {"0", "1", "1e-300", "0.5", "0.9999999999999999"};
  static const std::vector<std::string> sensible = {"0.7", "0.9", "0.3", "0.05", "0.95"};
  if (!kind.parameter || decisions.one_in(4)) {
    return kind.name;
  }
  return kind.name + ':' + decisions.any_of(decisions.one_in(2) ? absurd : sensible);
}

inline std::string any_classifier(Decisions& decisions)
{
  const auto& kinds = run::classifier_kinds();
  if (decisions.below(10) < 4) { // circumcircle and safe_region
    return kinds[decisions.below(2)].name;
  }
  const std::string first = with_parameter(decisions.any_of(kinds), decisions);
  return decisions.one_in(4)
             ? "refined:" + first + '+' + with_parameter(decisions.any_of(kinds), decisions)
             : first;
}

inline void choose_method(Setup& setup, Decisions& decisions)
{
  constexpr unsigned max_padding = 3;
  static const std::vector<std::string> policies = {"always_static", "hybrid", "key_frames:1",
                                                    "key_frames:3", "key_frames:10"};
  setup.classifier = run::classifier_choice(any_classifier(decisions));
  setup.is_predictive = setup.classifier.name == "point_distance" && decisions.one_in(3);
  setup.repair = decisions.one_in(2) ? run::usual_repair(setup.classifier)
                                     : decisions.any_of(run::repair_names());
  setup.padding = decisions.one_in(2) ? 1 : unsigned(decisions.below(max_padding + 1));
  setup.policy =
      run::policy_choice(decisions.one_in(6) ? decisions.any_of(policies) : "always_dynamic");
  setup.engine =
      decisions.one_in(4) ? decisions.any_of(run::engine_names()) : run::engine_names().front();
}

inline Field any_field(Numbers numbers, Decisions& decisions)
{
  constexpr int largest_exponent = 149, largest_offset = 60; // of 10, of 2
  Field field;
  field.extent = decisions.one_in(3) ? decisions.whole(1, 4) : decisions.whole(5, 20);
  if (numbers != Numbers::ORDINARY) {
    field.unit = std::pow(10.0, decisions.whole(-largest_exponent, largest_exponent - 20));
  }
  if (numbers == Numbers::HUGE_OFFSET) {
    field.unit = decisions.one_in(2) ? 1.0 : field.unit;
    field.offset_x = std::ldexp(field.unit, decisions.whole(20, largest_offset));
    field.offset_y = std::ldexp(field.unit, decisions.whole(0, largest_offset));
  }
  return field;
}

// Often few points, which lead to degenerate cases; but small triangulations are often rebuilt.
inline std::size_t any_size(std::size_t max_points, Decisions& decisions)
{
  const std::vector<std::size_t> parts = {15, 6, 3, 2, 1, 1};
  const std::size_t most = std::max<std::size_t>(1, max_points / decisions.any_of(parts));
  return most - decisions.below(most / 2 + 1);
}

inline Setup any_setup(const Family& family, Decisions& decisions)
{
  constexpr std::size_t max_points_constructed_exactly = 12, max_points_with_small_names = 200;
  Setup setup;
  choose_method(setup, decisions);
  setup.field = any_field(decisions.any_of(family.numbers), decisions);
  setup.max_points = any_size(family.max_points, decisions);
  setup.seed = decisions.below(1000);
  setup.constructs_exactly = decisions.one_in(25);
  if (setup.constructs_exactly) {
    setup.divisor = decisions.one_in(2) ? 3 : 1;
    setup.max_points = (std::min)(setup.max_points, max_points_constructed_exactly);
  }
  if (family.has_names || decisions.one_in(8)) {
    setup.naming = static_cast<Naming>(1 + decisions.below(3));
  }
  if (setup.naming == Naming::UINT8) {
    setup.max_points = (std::min)(setup.max_points, max_points_with_small_names);
  }
  return setup;
}

} // namespace random_operations

#endif // RANDOM_OPERATIONS_SETUP_H
