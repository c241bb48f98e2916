// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_METHOD_CHOICE_H
#define SCENARIO_RUNNER_METHOD_CHOICE_H

#include "scenario_runner/Text_input.h"

#include <optional>
#include <string>
#include <vector>

namespace run {

struct Classifier_parameter
{
  std::string letter;
  double usual;
  scenario::Range range;
};

struct Classifier_kind
{
  std::string name;
  bool is_exact;
  std::optional<Classifier_parameter> parameter;
};

// Of the table in Classifiers.h.
const std::vector<Classifier_kind>& classifier_kinds();

struct Classifier_choice
{
  std::string name;
  bool is_exact;
  std::optional<double> parameter;
  std::vector<Classifier_choice> parts{}; // FIRST and SECOND of a refined one

  bool uses_chance() const;
  std::string parameter_text() const; // what stands after the colon, if anything does
  std::string text() const;
};

// "circumcircle, point_distance:X (X from 0 to 1, default 0.7), ..."
std::string classifier_list();

// From NAME or NAME:PARAMETER.
// \throws std::invalid_argument
Classifier_choice classifier_choice(const std::string& text);

const std::vector<std::string>& repair_names();
std::string usual_repair(const Classifier_choice& classifier);

struct Policy_choice
{
  std::string name;
  std::optional<unsigned> parameter{}; // of key_frames

  std::string text() const { return parameter ? name + ':' + std::to_string(*parameter) : name; }
};

std::string policy_list();

// From NAME or NAME:PARAMETER.
// \throws std::invalid_argument
Policy_choice policy_choice(const std::string& text);

// What triangulates anew, the default first.
std::vector<std::string> engine_names();

} // namespace run

#endif // SCENARIO_RUNNER_METHOD_CHOICE_H
