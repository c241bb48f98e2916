// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_INFORM_CLASSIFIER_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_INFORM_CLASSIFIER_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <type_traits>
#include <utility>

namespace CGAL {

/// \cond
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

template <class Classifier, class Frame, class = void>
struct Wants_to_be_informed : std::false_type
{
};
template <class Classifier, class Frame>
struct Wants_to_be_informed<
    Classifier, Frame,
    std::void_t<decltype(std::declval<Classifier&>().after_update(std::declval<const Frame&>()))>>
  : std::true_type
{
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
/// \endcond

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

calls the classifier's `after_update(frame)`, which is optional in `DelaunayClassifier_2`, if it has
one. For classifiers that ask other classifiers.
*/
template <class Classifier, class Frame>
void inform_classifier(Classifier& classifier, const Frame& frame)
{
  using namespace Dynamic_Delaunay_triangulations_2::internal;
  if constexpr (Wants_to_be_informed<Classifier, Frame>::value)
    classifier.after_update(frame);
}

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_INFORM_CLASSIFIER_H
