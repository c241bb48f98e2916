// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_SPACE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_SPACE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_certificate_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_insertion_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_removal_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_triangulator_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/walls/Torus_hull_view_3.h>

#include <string_view>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// A torus, a slab or a wire: what an update does there.
template <class Traits, class ConcurrencyTag>
struct Torus_space_3
{
  static constexpr std::string_view name = "Dynamic_periodic_Delaunay_triangulation_3";

  using State = Torus_state_3<Traits, ConcurrencyTag>;
  using Insertion = Torus_insertion_3<State>;
  using Removal = Torus_removal_3<State>;
  using Static = Torus_triangulator_3<State>;
  using Proof = Torus_certificate_3<State>;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_SPACE_3_H
