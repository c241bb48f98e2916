// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_CLASSIFIERS_H
#define SCENARIO_RUNNER_CLASSIFIERS_H

#include "scenario_runner/Method_choice.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Circumcircle_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Dynamic_classification_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Estimated_voronoi_circumcenter_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Inflation_aware_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Nearly_delaunay_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Refined_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Safe_region_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Voronoi_circumcenter_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Voronoi_edge_length_classifier_2.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace run {

// A classifier and its name; and, if it has one, its parameter.
template <class Classifier_>
struct Named_classifier
{
  using Classifier = Classifier_;

  const char* name;
  const char* letter = nullptr;
  double (Classifier::*parameter)() const = nullptr;
};

// All classifiers that can be chosen. Their classes know whether they are exact, and the defaults.
inline constexpr std::tuple named_classifiers = {
    Named_classifier<CGAL::Circumcircle_classifier_2>{"circumcircle"},
    Named_classifier<CGAL::Safe_region_classifier_2>{"safe_region"},
    Named_classifier<CGAL::Point_distance_classifier_2>{"point_distance", "X",
                                                        &CGAL::Point_distance_classifier_2::x},
    Named_classifier<CGAL::Inflation_aware_classifier_2>{"inflation_aware", "X",
                                                         &CGAL::Inflation_aware_classifier_2::x},
    Named_classifier<CGAL::Voronoi_circumcenter_classifier_2>{"voronoi_circumcenter"},
    Named_classifier<CGAL::Estimated_voronoi_circumcenter_classifier_2>{
        "voronoi_circumcenter_estimated"},
    Named_classifier<CGAL::Voronoi_edge_length_classifier_2>{
        "voronoi_edge_length", "X", &CGAL::Voronoi_edge_length_classifier_2::x},
    Named_classifier<CGAL::Nearly_delaunay_classifier_2>{"nearly_delaunay", "EPS",
                                                         &CGAL::Nearly_delaunay_classifier_2::eps},
    Named_classifier<CGAL::Random_classifier_2>{"random", "P", &CGAL::Random_classifier_2::p}};

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

// One of several classifiers all of which decide edge by edge.
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
  std::uint64_t seed;
};

template <class Classifier>
Classifier make_classifier(const Classifier_choice& choice, const Classifier_settings& settings)
{
  if constexpr (std::is_same_v<Classifier, CGAL::Random_classifier_2>) {
    return Classifier(*choice.parameter, settings.seed);
  } else if constexpr (std::is_constructible_v<Classifier, double>) {
    return Classifier(*choice.parameter);
  } else {
    return Classifier();
  }
}

// Calls `use(classifier)` with the chosen classifier, which must not be a refined one.
template <std::size_t i = 0, class Use>
auto with_classifier(const Classifier_choice& choice, const Classifier_settings& settings, Use use)
{
  constexpr auto named = std::get<i>(named_classifiers);
  constexpr bool is_last = i + 1 == std::tuple_size_v<decltype(named_classifiers)>;
  if constexpr (!is_last) {
    if (choice.name != named.name) {
      return with_classifier<i + 1>(choice, settings, use);
    }
  }
  return use(make_classifier<typename decltype(named)::Classifier>(choice, settings));
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

template <class... Named>
Any_classifier<typename Named::Classifier...> any_of(const std::tuple<Named...>&);

using All_classifiers = Classifier_family<
    decltype(any_of(named_classifiers)),
    Any_edge_classifier<CGAL::Circumcircle_classifier_2, CGAL::Voronoi_circumcenter_classifier_2,
                        CGAL::Estimated_voronoi_circumcenter_classifier_2,
                        CGAL::Voronoi_edge_length_classifier_2,
                        CGAL::Nearly_delaunay_classifier_2>>;

} // namespace run

#endif // SCENARIO_RUNNER_CLASSIFIERS_H
