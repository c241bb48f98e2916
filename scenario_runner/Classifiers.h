// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_CLASSIFIERS_H
#define SCENARIO_RUNNER_CLASSIFIERS_H

#include "scenario_runner/Method_choice.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Chosen_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Circumcircle_classifier_2.h>
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
#include <string>
#include <tuple>
#include <type_traits>
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

// What a classifier needs beyond its choice.
struct Classifier_settings
{
  std::uint64_t seed;
};

template <class Classifier>
Classifier make_named_classifier(const Classifier_choice& choice,
                                 const Classifier_settings& settings)
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
  return use(make_named_classifier<typename decltype(named)::Classifier>(choice, settings));
}

template <class... Named>
CGAL::Chosen_classifier_2<typename Named::Classifier...> any_of(const std::tuple<Named...>&);

// Any classifier that has a name.
using Named_choice = decltype(any_of(named_classifiers));
// Any of those that decide edge by edge.
using Edge_choice = CGAL::Chosen_classifier_2<
    CGAL::Circumcircle_classifier_2, CGAL::Voronoi_circumcenter_classifier_2,
    CGAL::Estimated_voronoi_circumcenter_classifier_2, CGAL::Voronoi_edge_length_classifier_2,
    CGAL::Nearly_delaunay_classifier_2>;
using Refined = CGAL::Refined_classifier_2<Named_choice, Named_choice>;
using Refined_by_edges = CGAL::Refined_classifier_2<Named_choice, Edge_choice>;

// Any classifier that can be chosen.
using Any_classifier = CGAL::Chosen_classifier_2<Named_choice, Refined, Refined_by_edges>;

inline Any_classifier make_classifier(const Classifier_choice& choice,
                                      const Classifier_settings& settings)
{
  const auto make_named = [&](const Classifier_choice& named) {
    return with_classifier(named, settings,
                           [](const auto& classifier) { return Named_choice(classifier); });
  };
  if (choice.parts.empty()) {
    return make_named(choice);
  }
  const Named_choice first = make_named(choice.parts.front());
  return with_classifier(choice.parts.back(), settings, [&](const auto& second) -> Any_classifier {
    if constexpr (Edge_choice::can_be<std::decay_t<decltype(second)>>) {
      return Refined_by_edges(first, second);
    } else {
      return Refined(first, second);
    }
  });
}

} // namespace run

#endif // SCENARIO_RUNNER_CLASSIFIERS_H
