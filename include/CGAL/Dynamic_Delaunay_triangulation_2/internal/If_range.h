// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IF_RANGE_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IF_RANGE_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <iterator>
#include <utility>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// A type, if Range has begin() and end().
template <class Range>
using If_range = decltype(std::begin(std::declval<const Range&>()));

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IF_RANGE_H
