// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_ACCEPTS_INEXACT_PREDICATES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_ACCEPTS_INEXACT_PREDICATES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <type_traits>

namespace CGAL {

namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Whether a CGAL kernel computes with rounded numbers and does not filter its predicates.
template <class Kernel, class = void>
struct Rounds_predicates_2 : std::false_type
{
};
template <class Kernel>
struct Rounds_predicates_2<Kernel, std::void_t<decltype(Kernel::Has_filtered_predicates)>>
  : std::bool_constant<std::is_floating_point_v<typename Kernel::FT> &&
                       !bool(Kernel::Has_filtered_predicates)>
{
};

// Whether traits, or the kernel that they name as CGAL's projection traits do, round predicates.
template <class Traits, class = void>
struct Are_known_to_be_inexact_2 : Rounds_predicates_2<Traits>
{
};
template <class Traits>
struct Are_known_to_be_inexact_2<Traits, std::void_t<typename Traits::Rp>>
  : Rounds_predicates_2<typename Traits::Rp>
{
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Whether a `Dynamic_Delaunay_triangulation_2` may have traits whose predicates are known to be
inexact, such as `Simple_cartesian<double>`. By default it may not, and does not compile. To allow
such traits, specialize this variable template as `true` for them. The triangulation is then *never*
certified, and every function that needs a certificate, such as
`Dynamic_Delaunay_triangulation_2::triangulation()`, throws `Uncertified_triangulation_error_2`.
*/
template <class Traits>
constexpr bool accepts_inexact_predicates_2 = false;

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_ACCEPTS_INEXACT_PREDICATES_2_H
