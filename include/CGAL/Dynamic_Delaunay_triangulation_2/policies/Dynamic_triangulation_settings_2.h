// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_DYNAMIC_TRIANGULATION_SETTINGS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_DYNAMIC_TRIANGULATION_SETTINGS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The parts that a triangulation works with, in one object. A program sets those that it wants, and
leaves the others at their defaults. `Dynamic_Delaunay_triangulation_2::Settings` is this type for a
triangulation:

\snippet Dynamic_Delaunay_triangulation_2/interface_tour.cpp choices

\tparam Classifier, Repair, UpdatePolicy, Visitor as those of `Dynamic_Delaunay_triangulation_2`.
  One without a default constructor has to be given when the settings are created, in the order of
  the members: `Settings settings{classifier, repair, engines, policy, visitor}`.
*/
template <class Classifier, class Repair, class UpdatePolicy, class Visitor>
struct Dynamic_triangulation_settings_2
{
  /// the classifier.
  Classifier classifier = Classifier();
  /// the repair.
  Repair repair = Repair();
  /// the engines that triangulate from scratch.
  Static_engines_2 engines = Static_engines_2();
  /// the update policy.
  UpdatePolicy policy = UpdatePolicy();
  /// the visitor.
  Visitor visitor = Visitor();
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_DYNAMIC_TRIANGULATION_SETTINGS_2_H
