// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_CHOSEN_CLASSIFIER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_CHOSEN_CLASSIFIER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_classification_2.h>

#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

One of several classifiers, chosen while a program runs: by a name that a user has typed, say. It
does what the chosen one does. The triangulation is then compiled once for all of them, and what is
chosen costs nothing that can be measured, since a classifier is called once in a frame.

Whether it is exact is known only while the program runs, so `is_exact` is a function. An update
then uses `Repair_by_exactness_2` by default.

\tparam Classifiers models of `DelaunayClassifier_2`, all different; the first one is the default

\cgalModels{DelaunayClassifier_2}

\sa `Chosen_repair_2`, `Chosen_policy_2`
*/
template <class... Classifiers>
class Chosen_classifier_2
{
public:
  /// whether `Classifier` can be chosen.
  template <class Classifier>
  static constexpr bool can_be = (std::is_same_v<Classifier, Classifiers> || ...);

  /// chooses the first classifier, with its default parameters.
  Chosen_classifier_2() = default;

  /// chooses this classifier.
  /// \pre `can_be<Classifier>`
  template <class Classifier, class = std::enable_if_t<can_be<Classifier>>>
  Chosen_classifier_2(Classifier classifier)
    : m_classifier(std::move(classifier))
  {
  }

  /// the chosen classifier, or null if it is one of another type.
  template <class Classifier>
  const Classifier* get_if() const
  {
    return std::get_if<Classifier>(&m_classifier);
  }

  /// whether the chosen classifier is exact.
  bool is_exact() const
  {
    return std::visit([](const auto& chosen) { return is_classifier_exact(chosen); }, m_classifier);
  }

  /// classifies.
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    std::visit([&](auto& chosen) { chosen(frame, classified); }, m_classifier);
  }

  /// informs the chosen classifier.
  template <class Frame>
  void after_update(const Frame& frame)
  {
    std::visit([&](auto& chosen) { inform_classifier(chosen, frame); }, m_classifier);
  }

  /// whether the chosen classifier names edge `e`. Exists if all `Classifiers` have this function.
  template <class Frame>
  auto names_edge(const Frame& frame, typename Frame::Edge_index e) const
#ifndef DOXYGEN_RUNNING
      -> std::enable_if_t<
          (Dynamic_Delaunay_triangulations_2::internal::Has_names_edge<Classifiers, Frame>::value &&
           ...),
          bool>
#endif
  {
    return std::visit([&](const auto& chosen) { return chosen.names_edge(frame, e); },
                      m_classifier);
  }

private:
  std::variant<Classifiers...> m_classifier;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_CHOSEN_CLASSIFIER_2_H
