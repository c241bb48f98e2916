// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_CLASSIFIER_CHOICE_H
#define RUN_CLASSIFIER_CHOICE_H

#include "Number_argument.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <sstream>
#include <stdexcept>
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

struct Classifier_choice
{
  std::string name;
  bool is_exact;
  std::optional<double> parameter;
  std::vector<Classifier_choice> parts{}; // FIRST and SECOND of a refined one

  bool uses_chance() const
  {
    return name == "random" || std::any_of(parts.begin(), parts.end(),
                                           [](const auto& part) { return part.uses_chance(); });
  }

  // What stands after the colon, if anything does.
  std::string parameter_text() const
  {
    if (!parts.empty()) {
      return parts.front().text() + '+' + parts.back().text();
    }
    std::ostringstream text;
    if (parameter) {
      text << *parameter;
    }
    return text.str();
  }

  std::string text() const
  {
    const std::string after_colon = parameter_text();
    return after_colon.empty() ? name : name + ':' + after_colon;
  }
};

inline const std::vector<Classifier_kind>& classifier_kinds()
{
  const auto from_0_to_1 = [](const char* letter, double usual) {
    return Classifier_parameter{letter, usual, {0.0, 1.0}};
  };
  static const std::vector<Classifier_kind> kinds = {
      {"circumcircle", true, std::nullopt},
      {"safe_region", true, std::nullopt},
      {"point_distance", false, from_0_to_1("X", 0.7)},
      {"inflation_aware", false, from_0_to_1("X", 0.7)},
      {"voronoi_circumcenter", false, std::nullopt},
      {"voronoi_circumcenter_estimated", false, std::nullopt},
      {"voronoi_edge_length", false, from_0_to_1("X", 1.0)},
      {"nearly_delaunay", false, from_0_to_1("EPS", 0.05)},
      {"random", false, from_0_to_1("P", 0.0025)}};
  return kinds;
}

// "circumcircle, point_distance:X (X from 0 to 1, default 0.7), ..."
inline std::string classifier_list()
{
  std::ostringstream list;
  const char* separator = "";
  for (const Classifier_kind& kind : classifier_kinds()) {
    list << separator << kind.name;
    if (const auto& parameter = kind.parameter) {
      list << ':' << parameter->letter << " (" << parameter->letter << ' '
           << parameter->range.text() << ", default " << parameter->usual << ')';
    }
    separator = ", ";
  }
  list << ", refined:FIRST+SECOND (two of these)";
  return list.str();
}

inline std::optional<double> classifier_parameter(const Classifier_kind& kind,
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

inline Classifier_choice classifier_choice(const std::string& text);

// From FIRST+SECOND. A number may hold a plus sign (1e+0), a name does not start with a digit.
inline Classifier_choice refined_choice(const std::string& text)
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

// From NAME or NAME:PARAMETER.
inline Classifier_choice classifier_choice(const std::string& text)
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

} // namespace run

#endif // RUN_CLASSIFIER_CHOICE_H
