// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_IS_LISTENING_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_IS_LISTENING_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <type_traits>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

template <class Visitor, class = void>
constexpr bool says_whether_it_listens = false;
template <class Visitor>
constexpr bool says_whether_it_listens<
    Visitor, std::void_t<decltype(std::declval<const Visitor&>().is_listening())>> = true;

// Whether a visitor is told of what changes: not the default one, and none that does not want to.
template <class Default_visitor, class Visitor>
bool is_listening([[maybe_unused]] const Visitor& visitor)
{
  if constexpr (std::is_same_v<Visitor, Default_visitor>)
    return false;
  else if constexpr (says_whether_it_listens<Visitor>)
    return visitor.is_listening();
  else
    return true;
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_IS_LISTENING_H
