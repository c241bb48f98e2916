// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_USUAL_REPAIR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_USUAL_REPAIR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Border_splice_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_and_splice_repair_2.h>

#include <type_traits>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The repair that is used with a classifier if the user chooses none.
template <class Classifier, class = void>
struct Usual_repair_2
{
  using type =
      std::conditional_t<Classifier::is_exact, Flip_and_splice_repair_2, Border_splice_repair_2>;
};
template <class Classifier>
struct Usual_repair_2<Classifier, std::void_t<typename Classifier::Usual_repair>>
{
  using type = typename Classifier::Usual_repair;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_USUAL_REPAIR_2_H
