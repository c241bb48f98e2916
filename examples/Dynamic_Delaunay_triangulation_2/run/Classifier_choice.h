// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_CLASSIFIER_CHOICE_H
#define RUN_CLASSIFIER_CHOICE_H

#include "Number_argument.h"

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
};

inline const std::vector<Classifier_kind>& classifier_kinds()
{
  static const std::vector<Classifier_kind> kinds = {
      {"circumcircle", true, std::nullopt},
      {"point_distance", false, Classifier_parameter{"X", 0.7, {0.0, 1.0}}},
      {"random", false, Classifier_parameter{"P", 0.0025, {0.0, 1.0}}}};
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

// From NAME or NAME:PARAMETER.
inline Classifier_choice classifier_choice(const std::string& text)
{
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const auto parameter =
      colon == std::string::npos ? std::nullopt : std::optional(text.substr(colon + 1));
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
