// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED_UPDATES_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED_UPDATES_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

// Include this header in exactly one source file of a program that defines
// CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED in all its files. It compiles for all of them what
// updates need in the plane and in periodic space, with the usual kernel and no other choices.
// CMake's target `Dynamic_Delaunay_triangulation_2::compiled` does that.
#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED
#error                                                                                             \
    "compiled_updates.h is for programs that define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED in all files"
#endif

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

CGAL_DYNAMIC_DELAUNAY_COMPILE_UPDATE(
    Dynamic_Delaunay_triangulation_2<Exact_predicates_inexact_constructions_kernel>);
CGAL_DYNAMIC_DELAUNAY_COMPILE_UPDATE(
    Dynamic_periodic_Delaunay_triangulation_2<Exact_predicates_inexact_constructions_kernel>);

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED_UPDATES_H
