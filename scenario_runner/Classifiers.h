// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_CLASSIFIERS_H
#define SCENARIO_RUNNER_CLASSIFIERS_H

#include "scenario_runner/Number_text.h"
#include "scenario_runner/Text_input.h"

#include <CGAL/Circumcircle_classifier_2.h>
#include <CGAL/Estimated_voronoi_circumcenter_classifier_2.h>
#include <CGAL/Inflation_aware_classifier_2.h>
#include <CGAL/inform_classifier.h>
#include <CGAL/Nearly_delaunay_classifier_2.h>
#include <CGAL/Point_distance_classifier_2.h>
#include <CGAL/Random_classifier_2.h>
#include <CGAL/Refined_classifier_2.h>
#include <CGAL/Safe_region_classifier_2.h>
#include <CGAL/Voronoi_circumcenter_classifier_2.h>
#include <CGAL/Voronoi_edge_length_classifier_2.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
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

// One of several classifiers, chosen while the program runs; exact if all of them are. The
// triangulation is then compiled once for all of them; a program that knows its classifier names it
// directly.
template <class... Classifiers>
class Any_classifier
{
public:
  static constexpr bool is_exact = (Classifiers::is_exact && ...);

  template <class Classifier>
  static constexpr bool has()
  {
    return (std::is_same_v<Classifier, Classifiers> || ...);
  }

  Any_classifier() = default;

  template <class Classifier>
  explicit Any_classifier(Classifier classifier)
    : m_classifier(std::move(classifier))
  {
  }

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    std::visit([&](auto& classifier) { classifier(frame, classified); }, m_classifier);
  }

  template <class Frame>
  void after_update(const Frame& frame)
  {
    std::visit([&](auto& classifier) { CGAL::inform_classifier(classifier, frame); }, m_classifier);
  }

protected:
  std::variant<Classifiers...> m_classifier;
};

// The same for classifiers all of which decide edge by edge.
template <class... Classifiers>
class Any_edge_classifier : public Any_classifier<Classifiers...>
{
public:
  using Any_classifier<Classifiers...>::Any_classifier;

  template <class Frame>
  bool names_edge(const Frame& frame, typename Frame::Index e) const
  {
    return std::visit([&](const auto& classifier) { return classifier.names_edge(frame, e); },
                      this->m_classifier);
  }
};

// What a classifier needs beyond its choice.
struct Classifier_settings
{
  unsigned threads; // of the circumcircle classifier
  std::uint64_t seed;
};

// Calls `use(classifier)` with the one that was chosen, which is no refined one.
template <class Use>
auto with_classifier(const Classifier_choice& choice, const Classifier_settings& settings, Use use)
{
  const std::string& name = choice.name;
  if (name == "safe_region") {
    return use(CGAL::Safe_region_classifier_2());
  }
  if (name == "point_distance") {
    return use(CGAL::Point_distance_classifier_2(*choice.parameter));
  }
  if (name == "inflation_aware") {
    return use(CGAL::Inflation_aware_classifier_2(*choice.parameter));
  }
  if (name == "voronoi_circumcenter") {
    return use(CGAL::Voronoi_circumcenter_classifier_2());
  }
  if (name == "voronoi_circumcenter_estimated") {
    return use(CGAL::Estimated_voronoi_circumcenter_classifier_2());
  }
  if (name == "voronoi_edge_length") {
    return use(CGAL::Voronoi_edge_length_classifier_2(*choice.parameter));
  }
  if (name == "nearly_delaunay") {
    return use(CGAL::Nearly_delaunay_classifier_2(*choice.parameter));
  }
  if (name == "random") {
    return use(CGAL::Random_classifier_2(*choice.parameter, settings.seed));
  }
  return use(CGAL::Circumcircle_classifier_2(settings.threads));
}

// Any of `Part`, or one of it refined by another one: by one of `Edge_part`, all of which decide
// edge by edge, if the other one is there.
template <class Part, class Edge_part>
struct Classifier_family
{
  using Refined = CGAL::Refined_classifier_2<Part, Part>;
  using Refined_by_edges = CGAL::Refined_classifier_2<Part, Edge_part>;
  using Classifier = Any_classifier<Part, Refined, Refined_by_edges>;

  static Classifier make(const Classifier_choice& choice, const Classifier_settings& settings)
  {
    if (choice.parts.empty()) {
      return Classifier(make_part(choice, settings));
    }
    const Part first = make_part(choice.parts.front(), settings);
    return with_classifier(choice.parts.back(), settings, [&](const auto& second) {
      if constexpr (Edge_part::template has<std::decay_t<decltype(second)>>()) {
        return Classifier(Refined_by_edges(first, Edge_part(second)));
      } else {
        return Classifier(Refined(first, part_of(second)));
      }
    });
  }

private:
  static Part make_part(const Classifier_choice& choice, const Classifier_settings& settings)
  {
    return with_classifier(choice, settings,
                           [](const auto& classifier) { return part_of(classifier); });
  }

  template <class Chosen>
  static Part part_of(const Chosen& chosen)
  {
    if constexpr (Part::template has<Chosen>()) {
      return Part(chosen);
    } else {
      throw std::logic_error("an exact classifier was to be made of a heuristic one");
    }
  }
};

using Exact_classifiers = Classifier_family<
    Any_classifier<CGAL::Circumcircle_classifier_2, CGAL::Safe_region_classifier_2>,
    Any_edge_classifier<CGAL::Circumcircle_classifier_2>>;

using All_classifiers = Classifier_family<
    Any_classifier<CGAL::Circumcircle_classifier_2, CGAL::Safe_region_classifier_2,
                   CGAL::Point_distance_classifier_2, CGAL::Inflation_aware_classifier_2,
                   CGAL::Voronoi_circumcenter_classifier_2,
                   CGAL::Estimated_voronoi_circumcenter_classifier_2,
                   CGAL::Voronoi_edge_length_classifier_2, CGAL::Nearly_delaunay_classifier_2,
                   CGAL::Random_classifier_2>,
    Any_edge_classifier<CGAL::Circumcircle_classifier_2, CGAL::Voronoi_circumcenter_classifier_2,
                        CGAL::Estimated_voronoi_circumcenter_classifier_2,
                        CGAL::Voronoi_edge_length_classifier_2,
                        CGAL::Nearly_delaunay_classifier_2>>;

} // namespace run

#endif // SCENARIO_RUNNER_CLASSIFIERS_H
