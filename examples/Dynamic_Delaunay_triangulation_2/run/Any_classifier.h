// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_ANY_CLASSIFIER_H
#define RUN_ANY_CLASSIFIER_H

#include "Classifier_choice.h"

#include <CGAL/Circumcircle_classifier_2.h>
#include <CGAL/Point_distance_classifier_2.h>
#include <CGAL/Random_classifier_2.h>

#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>

namespace run {

// One of several classifiers, chosen while the program runs. The triangulation is then compiled
// once for all of them; a program that knows its classifier names it directly.
template <class... Classifiers>
class Any_classifier
{
public:
  static constexpr bool is_exact = (Classifiers::is_exact && ...);
  static_assert(((Classifiers::is_exact == is_exact) && ...), "all exact, or all heuristic");

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
    std::visit([&](auto& classifier) { inform(classifier, frame, 0); }, m_classifier);
  }

private:
  template <class Classifier, class Frame>
  static auto inform(Classifier& classifier, const Frame& frame, int)
      -> decltype(classifier.after_update(frame))
  {
    classifier.after_update(frame);
  }

  // For classifiers that do not want to know.
  template <class Classifier, class Frame>
  static void inform(Classifier&, const Frame&, long)
  {
  }

  std::variant<Classifiers...> m_classifier;
};

using Exact_classifier = Any_classifier<CGAL::Circumcircle_classifier_2>;
using Heuristic_classifier =
    Any_classifier<CGAL::Point_distance_classifier_2, CGAL::Random_classifier_2>;

inline Exact_classifier make_exact_classifier(unsigned threads)
{
  return Exact_classifier(CGAL::Circumcircle_classifier_2(threads));
}

inline Heuristic_classifier make_heuristic_classifier(const Classifier_choice& choice,
                                                      std::uint64_t seed)
{
  if (choice.name == "random") {
    return Heuristic_classifier(CGAL::Random_classifier_2(*choice.parameter, seed));
  }
  return Heuristic_classifier(CGAL::Point_distance_classifier_2(*choice.parameter));
}

} // namespace run

#endif // RUN_ANY_CLASSIFIER_H
