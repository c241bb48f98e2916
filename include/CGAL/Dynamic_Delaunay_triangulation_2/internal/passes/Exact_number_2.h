// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_EXACT_NUMBER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_EXACT_NUMBER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/Number_types/internal/Exact_type_selector.h>

#include <type_traits>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The number type in which coordinates are added, multiplied and divided without rounding: FT
// itself if it is exact, otherwise rational numbers.
template <class FT>
struct Exact_number_2
{
  using Type = std::conditional_t<Algebraic_structure_traits<FT>::Is_exact::value, FT,
                                  typename CGAL::internal::Exact_field_selector<double>::Type>;
  static Type of(const FT& x) { return Type(x); }
};

// Lazy numbers are replaced by exact ones: their approximations by doubles may have few digits, and
// lazy evaluation would gain nothing.
template <class ET>
struct Exact_number_2<Lazy_exact_nt<ET>>
{
  using Type = ET;
  static const Type& of(const Lazy_exact_nt<ET>& x) { return x.exact(); }
};

template <class Number>
struct Exact_vector_2
{
  Number x, y;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_EXACT_NUMBER_2_H
