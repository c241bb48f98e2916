// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_ANY_CLASSIFIER_H
#define RUN_ANY_CLASSIFIER_H

#include "Classifier_choice.h"

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

#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace run {

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

#endif // RUN_ANY_CLASSIFIER_H
