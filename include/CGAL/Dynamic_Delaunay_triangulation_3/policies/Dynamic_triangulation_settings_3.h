// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_POLICIES_DYNAMIC_TRIANGULATION_SETTINGS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_POLICIES_DYNAMIC_TRIANGULATION_SETTINGS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Dynamic_triangulation_options_2.h>

#include <cstddef>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The parts that a triangulation of points in space works with, in one object. A program sets those
that it wants, and leaves the others at their defaults. `Dynamic_Delaunay_triangulation_3::Settings`
is this type for a triangulation.

\tparam UpdatePolicy, Visitor as those of `Dynamic_Delaunay_triangulation_3`. One without a default
  constructor has to be given when the settings are created.
*/
template <class UpdatePolicy, class Visitor>
struct Dynamic_triangulation_settings_3
{
  /// takes these parts, and the defaults of the others. A policy alone converts to settings.
  Dynamic_triangulation_settings_3(UpdatePolicy p = UpdatePolicy(), Visitor v = Visitor())
    : policy(std::move(p))
    , visitor(std::move(v))
  {
  }

  /// the update policy.
  UpdatePolicy policy;
  /// the visitor.
  Visitor visitor;
};

namespace Dynamic_Delaunay_triangulations_3::internal {

// Refuses what is no option of a triangulation in space, and options that are given twice.
template <class... Options>
struct Options_check_3
{
  template <template <class> class Kind>
  static constexpr std::size_t number =
      Dynamic_Delaunay_triangulations_2::internal::number_of_options<Kind, Options...>;

  static_assert(number<With_policy_2> + number<With_visitor_2> + number<With_concurrency_2> ==
                    sizeof...(Options),
                "after the traits, a triangulation in space takes the options With_policy_2<>, "
                "With_visitor_2<> and With_concurrency_2<>, and nothing else");
  static_assert(number<With_policy_2> <= 1 && number<With_visitor_2> <= 1 &&
                    number<With_concurrency_2> <= 1,
                "an option of a triangulation is given twice");
  static constexpr bool is_right = true;
};

} // namespace Dynamic_Delaunay_triangulations_3::internal
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_POLICIES_DYNAMIC_TRIANGULATION_SETTINGS_3_H
