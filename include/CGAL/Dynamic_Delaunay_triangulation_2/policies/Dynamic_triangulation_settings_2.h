// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_DYNAMIC_TRIANGULATION_SETTINGS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_DYNAMIC_TRIANGULATION_SETTINGS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>

#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The parts that a triangulation works with, in one object. A program sets those that it wants, and
leaves the others at their defaults. `Dynamic_Delaunay_triangulation_2::Settings` is this type for a
triangulation:

\snippet Dynamic_Delaunay_triangulation_2/interface_tour.cpp choices

\tparam Classifier, Repair, UpdatePolicy, Visitor as those of `Dynamic_Delaunay_triangulation_2`.
  One without a default constructor has to be given when the settings are created.
*/
template <class Classifier, class Repair, class UpdatePolicy, class Visitor>
struct Dynamic_triangulation_settings_2
{
  /// takes these parts, and the defaults of the others. A classifier alone, or what converts to it,
  /// converts to settings.
#ifdef DOXYGEN_RUNNING
  Dynamic_triangulation_settings_2(Classifier c = Classifier(),
#else
  template <class Given = Classifier,
            class = std::enable_if_t<std::is_convertible_v<Given, Classifier>>>
  Dynamic_triangulation_settings_2(Given c = Given(),
#endif
                                   Repair r = Repair(), Static_engines_2 e = Static_engines_2(),
                                   UpdatePolicy p = UpdatePolicy(), Visitor v = Visitor())
    : classifier(std::move(c))
    , repair(std::move(r))
    , engines(e)
    , policy(std::move(p))
    , visitor(std::move(v))
  {
  }

  /// the classifier.
  Classifier classifier;
  /// the repair.
  Repair repair;
  /// the engines that triangulate from scratch.
  Static_engines_2 engines;
  /// the update policy.
  UpdatePolicy policy;
  /// the visitor.
  Visitor visitor;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_DYNAMIC_TRIANGULATION_SETTINGS_2_H
