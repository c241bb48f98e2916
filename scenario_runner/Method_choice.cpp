// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Method_choice.h"

#include "scenario_runner/Classifiers.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Repairs_and_policies.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>

namespace run {

namespace {

template <class Classifier>
Classifier_kind kind_of(const Named_classifier<Classifier>& named)
{
  if (named.parameter == nullptr) {
    return {named.name, Classifier::is_exact, std::nullopt};
  }
  constexpr scenario::Range range{0.0, 1.0}; // of all parameters
  const double usual = (Classifier().*named.parameter)();
  return {named.name, Classifier::is_exact, Classifier_parameter{named.letter, usual, range}};
}

std::optional<double> classifier_parameter(const Classifier_kind& kind,
                                           const std::optional<std::string>& text)
{
  if (!kind.parameter && text) {
    throw std::invalid_argument(kind.name + " takes no parameter; there are " + classifier_list());
  }
  if (!kind.parameter) {
    return std::nullopt;
  }
  try {
    return text ? number_argument(*text, kind.parameter->range) : kind.parameter->usual;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("the parameter of " + kind.name + ": " + error.what());
  }
}

// From FIRST+SECOND. A number may hold a plus sign (1e+0), a name does not start with a digit.
Classifier_choice refined_choice(const std::string& text)
{
  std::size_t plus = text.find('+');
  while (plus != std::string::npos && plus + 1 < text.size() &&
         std::isdigit(static_cast<unsigned char>(text[plus + 1]))) {
    plus = text.find('+', plus + 1);
  }
  if (plus == std::string::npos) {
    throw std::invalid_argument("refined takes two classifiers, refined:FIRST+SECOND; there are " +
                                classifier_list());
  }
  const Classifier_choice first = classifier_choice(text.substr(0, plus));
  const Classifier_choice second = classifier_choice(text.substr(plus + 1));
  if (!first.parts.empty() || !second.parts.empty()) {
    throw std::invalid_argument("refined takes no refined classifier; there are " +
                                classifier_list());
  }
  return {"refined", first.is_exact && second.is_exact, std::nullopt, {first, second}};
}

struct Named_repair
{
  const char* name;
  Any_repair (*make)(unsigned padding);
};

// The default first.
const std::array<Named_repair, 5> named_repairs = {
    {{"hold_and_flip",
      [](unsigned padding) { return Any_repair(CGAL::Hold_and_flip_repair_2(padding)); }},
     {"splice", [](unsigned padding) { return Any_repair(CGAL::Border_splice_repair_2(padding)); }},
     {"flip", [](unsigned) { return Any_repair(CGAL::Flip_repair_2()); }},
     {"relocate", [](unsigned) { return Any_repair(CGAL::Relocation_repair_2()); }},
     {"rebuild", [](unsigned) { return Any_repair(CGAL::Rebuild_repair_2()); }}}};

constexpr unsigned max_key_frame_distance = 1'000'000;

[[noreturn]] void fail_unknown(const std::string& what, const std::string& name,
                               const std::string& known)
{
  throw std::invalid_argument("there is no " + what + " '" + name + "'; there are " + known);
}

} // namespace

const std::vector<Classifier_kind>& classifier_kinds()
{
  static const std::vector<Classifier_kind> kinds = std::apply(
      [](const auto&... named) { return std::vector<Classifier_kind>{kind_of(named)...}; },
      named_classifiers);
  return kinds;
}

bool Classifier_choice::uses_chance() const
{
  return name == "random" || std::any_of(parts.begin(), parts.end(),
                                         [](const auto& part) { return part.uses_chance(); });
}

std::string Classifier_choice::parameter_text() const
{
  if (!parts.empty()) {
    return parts.front().text() + '+' + parts.back().text();
  }
  return parameter ? number_text(*parameter, 6) : "";
}

std::string Classifier_choice::text() const
{
  const std::string after_colon = parameter_text();
  return after_colon.empty() ? name : name + ':' + after_colon;
}

std::string classifier_list()
{
  std::string list;
  for (const Classifier_kind& kind : classifier_kinds()) {
    list += kind.name;
    if (const auto& parameter = kind.parameter) {
      list += ':' + parameter->letter + " (" + parameter->letter + ' ' + parameter->range.text() +
              ", default " + number_text(parameter->usual, 6) + ')';
    }
    list += ", ";
  }
  return list + "refined:FIRST+SECOND (two of these)";
}

Classifier_choice classifier_choice(const std::string& text)
{
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const auto parameter =
      colon == std::string::npos ? std::nullopt : std::optional(text.substr(colon + 1));
  if (name == "refined") {
    return refined_choice(parameter.value_or(""));
  }
  for (const Classifier_kind& kind : classifier_kinds()) {
    if (kind.name == name) {
      return {name, kind.is_exact, classifier_parameter(kind, parameter)};
    }
  }
  throw std::invalid_argument("there is no classifier '" + name + "'; there are " +
                              classifier_list());
}

const std::vector<std::string>& repair_names()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Named_repair& repair : named_repairs) {
      all.push_back(repair.name);
    }
    return all;
  }();
  return names;
}

std::string usual_repair(const Classifier_choice& classifier)
{
  const bool needs_flips = classifier.is_exact || classifier.name == "nearly_delaunay";
  return needs_flips ? "hold_and_flip" : "splice";
}

Any_repair make_repair(const std::string& name, unsigned padding)
{
  for (const Named_repair& repair : named_repairs) {
    if (repair.name == name) {
      return repair.make(padding);
    }
  }
  fail_unknown("repair", name, scenario::joined(repair_names()));
}

std::string policy_list()
{
  return "always_dynamic, always_static, hybrid, key_frames:K (K from 1 to " +
         std::to_string(max_key_frame_distance) + ", default " +
         std::to_string(CGAL::Key_frame_policy_2().k()) + ')';
}

Policy_choice policy_choice(const std::string& text)
{
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const bool has_parameter = colon != std::string::npos;
  if (name == "key_frames" && has_parameter) {
    try {
      return {name, static_cast<unsigned>(
                        count_argument(text.substr(colon + 1), 1, max_key_frame_distance))};
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(std::string("the parameter of key_frames: ") + error.what());
    }
  }
  if (name == "key_frames") {
    return {name, CGAL::Key_frame_policy_2().k()};
  }
  if (name != "always_dynamic" && name != "always_static" && name != "hybrid") {
    fail_unknown("policy", name, policy_list());
  }
  if (has_parameter) {
    throw std::invalid_argument(name + " takes no parameter; there are " + policy_list());
  }
  return {name};
}

Any_policy make_policy(const Policy_choice& choice)
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

const std::vector<std::pair<std::string, CGAL::Static_engine_2>>& engines()
{
  static const std::vector<std::pair<std::string, CGAL::Static_engine_2>> all = {
      {"guibas_stolfi", CGAL::Static_engine_2::GUIBAS_STOLFI},
      {"insertion", CGAL::Static_engine_2::INSERTION},
      {"bowyer_watson", CGAL::Static_engine_2::BOWYER_WATSON}};
  return all;
}

std::vector<std::string> engine_names()
{
  std::vector<std::string> names;
  for (const auto& [name, engine] : engines()) {
    names.push_back(name);
  }
  return names;
}

CGAL::Static_engines_2 engines_named(const std::string& name)
{
  for (const auto& [its_name, engine] : engines()) {
    if (its_name == name) {
      return {engine, engine};
    }
  }
  fail_unknown("engine", name, scenario::joined(engine_names()));
}

} // namespace run
